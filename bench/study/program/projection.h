/* projection.h: families of projection problems, of sizes as in practice and in the literature.
 *
 *   study_projection p;
 *   if (study_projection_draw(family, seed, &p) == FMB_OK) ... fmb_system_free(p.s);
 *
 * A seed draws sizes as well as numbers; the same seed gives the same problem for ever, on every
 * machine.
 */
#ifndef FMB_STUDY_PROJECTION_H
#define FMB_STUDY_PROJECTION_H

#include <fmb/fmb.h>

typedef struct study_projection {
    fmb_system *s;
    int keep; /* the first keep of its variables are kept */
} study_projection;

/* The families used for fitting: their number; names and descriptions of one line. */
int study_projections(void);
/* The number of families after these: they once judged choices of ways, now they are fitted. */
int study_projections_apart(void);
/* The number of the families after those, which no fit has used: they judge the choice. */
int study_projections_unseen(void);
const char *study_projection_name(int family);
const char *study_projection_about(int family);

/* [give] Errors: MEMORY. */
fmb_status study_projection_draw(int family, uint64_t seed, study_projection *out);

/* [give] Draws a larger problem: the sizes of ten families may grow, of "control" by up to 2,
 * "relu" by up to 3, "union" by up to 5, "dense", "equal", "long", "parity", "sum", "wide" and
 * "zonotope" by up to 12. Other families ignore `larger`. Errors: MEMORY. */
fmb_status study_projection_draw_larger(int family, uint64_t seed, int larger,
                                        study_projection *out);

#endif
