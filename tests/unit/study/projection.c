/* projection.c: families of projections: a seed determines the problem, some variables are kept and
 * some are not, and most problems are feasible, except in the family "none". */
#include <criterion/criterion.h>

#include <stdlib.h>
#include <string.h>

#include <fmb/fmb.h>

#include "study/program/projection.h"
#include "support.h"

static study_projection draw(int family, uint64_t seed)
{
    study_projection p;
    cr_assert_eq(study_projection_draw(family, seed, &p), FMB_OK);
    return p;
}

Test(projection, there_is_something_to_project)
{
    int known = study_projections(), unseen = known + study_projections_apart();
    for (int f = 0; f < unseen + study_projections_unseen(); f++) {
        if (f >= known && f < unseen)
            continue; /* of some of these most problems have no solution */
        const char *name = study_projection_name(f);
        int points = 0;
        for (uint64_t seed = 0; seed < 8; seed++) {
            study_projection p = draw(f, seed);
            cr_assert(p.keep > 0 && p.keep < fmb_system_dim(p.s), "%s", name);
            cr_assert_gt(fmb_system_rows(p.s), 0);
            points += support_proved_verdict(p.s) == FMB_FEASIBLE;
            fmb_system_free(p.s);
        }
        cr_assert(strcmp(name, "none") == 0 ? points == 0 : points >= 4, "%s: %d of 8", name,
                  points);
    }
}

static char *text_of(const fmb_system *s)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    cr_assert_eq(fmb_system_write(s, FMB_FORMAT_TEXT, out), FMB_OK);
    fclose(out);
    return text;
}

Test(projection, a_seed_is_a_problem)
{
    int all = study_projections() + study_projections_apart() + study_projections_unseen();
    for (int f = 0; f < all; f++) {
        char *text[3];
        for (int i = 0; i < 3; i++) {
            study_projection p = draw(f, i < 2 ? 5 : 6);
            text[i] = text_of(p.s);
            fmb_system_free(p.s);
        }
        cr_assert_str_eq(text[0], text[1]);
        cr_assert_str_neq(text[0], text[2], "%s", study_projection_name(f));
        for (int i = 0; i < 3; i++)
            free(text[i]);
    }
}

/* Of a family whose sizes may grow, the first seeds have more variables in all. */
Test(projection, larger_than_usual)
{
    for (int f = 0; f < study_projections(); f++) {
        int usual = 0, larger = 0;
        for (uint64_t seed = 0; seed < 8; seed++) {
            study_projection p = draw(f, seed), q;
            cr_assert_eq(study_projection_draw_larger(f, seed, 2, &q), FMB_OK);
            usual += fmb_system_dim(p.s);
            larger += fmb_system_dim(q.s);
            fmb_system_free(p.s);
            fmb_system_free(q.s);
        }
        static const char *const GROWS =
            " dense wide long equal relu zonotope parity union control ";
        char name[32];
        snprintf(name, sizeof name, " %s ", study_projection_name(f));
        cr_expect(!strstr(GROWS, name) || larger > usual, "%s: %d, %d", name, usual, larger);
    }
}
