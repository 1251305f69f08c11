/* projection.h: projection problems by family, of the sizes that practice and the literature have.
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
    int keep; /* the first keep of its variables stay */
} study_projection;

/* The families, their names and what they are, a line each. */
int study_projections(void);
/* So many more come after these: they judged choices of ways, and now they are in the fit. */
int study_projections_apart(void);
/* And so many after those, that no fit has seen: they judge the choice. */
int study_projections_unseen(void);
const char *study_projection_name(int family);
const char *study_projection_about(int family);

/* [give] Errors: MEMORY. */
fmb_status study_projection_draw(int family, uint64_t seed, study_projection *out);

/* [give] The same, larger than usual: ten families have sizes that may grow, "control" by up to 2,
 * "relu" by up to 3, "union" by up to 5, "dense", "equal", "long", "parity", "sum",
 * "wide" and "zonotope" by up to 12. Of others it is the usual one. Errors: MEMORY. */
fmb_status study_projection_draw_larger(int family, uint64_t seed, int larger,
                                        study_projection *out);

#endif
