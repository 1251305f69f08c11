/* ways_taken.c: which ways of a projection are tried first, and which next, for a problem of each
 * family, as recorded in ways_taken.txt. FMB_WRITE=FILE writes a new record. */
#include <criterion/criterion.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/fmb.h>

#include "must.h"
#include "solve/portfolio/selection.h"
#include "study/program/program.h"
#include "study/program/projection.h"
#include "support.h"

static const char *const ENGINE[FMB_ENGINES] = {
    [FMB_ENGINE_RAYS] = "rays",
    [FMB_ENGINE_ELIMINATION] = "pruned elimination",
    [FMB_ENGINE_QUERIES] = "queries",
};

/* First steps, and engines with the work that they are expected to take, the least first. */
static void tell_choice(FILE *out, const fmb_features *f)
{
    fmb_choice c = fmb_selection_of(f);
    fprintf(out, "    %s%s%s", c.verdict ? "verdict, " : "",
            c.recession ? "recession direction, " : "",
            c.bounded > 0 ? "bounded elimination, " : "");
    for (int n = 0; n < FMB_ENGINES; n++) {
        int next = 0;
        for (int k = 1; k < FMB_ENGINES; k++)
            if (c.work[k] < c.work[next])
                next = k;
        fprintf(out, "%s%s %.0f", n > 0 ? ", " : "", ENGINE[next], c.work[next]);
        c.work[next] = INFINITY;
    }
    fputc('\n', out);
}

/* Of the largest part that is left once cheap variables are gone. */
static void tell_largest_part(FILE *out, fmb_query *q, const int *place)
{
    fmb_reduced_part best = {.rest = false};
    for (int part = 0; part < q->parts.count; part++) {
        fmb_reduced_part reduced;
        bool feasible;
        must(fmb_reduced_part_open(&reduced, q, part, place, &feasible));
        if (feasible && reduced.rest && (!best.rest || reduced.e.live.size > best.e.live.size)) {
            if (best.rest)
                fmb_reduced_part_close(&best);
            best = reduced;
        } else {
            fmb_reduced_part_close(&reduced);
        }
    }
    if (!best.rest) {
        fputs("    cheap elimination leaves nothing\n", out);
        return;
    }
    fmb_features f = fmb_features_of(&best);
    tell_choice(out, &f);
    fmb_reduced_part_close(&best);
}

static void tell_way(FILE *out, int family, uint64_t seed, int digits)
{
    study_projection drawn;
    fmb_system *dressed = NULL;
    fmb_solver *v = NULL;
    fmb_query q;
    fmb_result r = {.size = sizeof r};
    must(study_projection_draw(family, seed, &drawn));
    if (digits > 0)
        must(study_system_fractions(drawn.s, digits, seed, &dressed));
    const fmb_system *s = dressed ? dressed : drawn.s;
    int dim = fmb_system_dim(s), *place = malloc((size_t)dim * sizeof *place);
    cr_assert_not_null(place);
    for (int j = 0; j < dim; j++)
        place[j] = j < drawn.keep ? j : -1;
    must(fmb_solver_new(NULL, NULL, &v));
    fmb_status st = fmb_query_begin(&q, v, s, "project");
    cr_assert_eq(st, FMB_OK);
    fprintf(out, "%s %" PRIu64 "%s: %d of %d variables, %zu rows\n", study_projection_name(family),
            seed, digits > 0 ? ", 9 digits" : "", drawn.keep, dim, fmb_system_rows(s));
    tell_largest_part(out, &q, place);
    must(fmb_query_end(&q, st, FMB_UNKNOWN, &r));
    fmb_solver_free(v);
    free(place);
    fmb_system_free(dressed);
    fmb_system_free(drawn.s);
}

/* A problem of each family, and of every other one with long numbers. */
static char *tell_all_ways(void)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    cr_assert_not_null(out);
    for (int f = 0; f < study_projections(); f++) {
        tell_way(out, f, 1, 0);
        if (f % 2 == 0)
            tell_way(out, f, 2, 9);
    }
    fclose(out);
    return text;
}

Test(ways_taken, are_those_written_down)
{
    const char *to = getenv("FMB_WRITE");
    char *told = tell_all_ways(), *known = calloc(1, strlen(told) + 2);
    FILE *file = fopen(to ? to : FMB_WAYS_TAKEN, to ? "w" : "r");
    cr_assert(known && file);
    if (to)
        cr_assert_geq(fputs(told, file), 0);
    else
        cr_assert_eq(fread(known, 1, strlen(told) + 1, file), strlen(told));
    fclose(file);
    cr_assert(to || strcmp(told, known) == 0,
              "other ways are taken: compare FMB_WRITE=FILE with %s", FMB_WAYS_TAKEN);
    free(known);
    free(told);
}
