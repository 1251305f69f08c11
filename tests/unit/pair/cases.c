/* cases.c: the recorded pairs of frames through fmb_pair_test, those whose numbers are doubles, and
 * the recorded hulls through stacked systems.
 */
#include <criterion/criterion.h>
#include <dirent.h>
#include <jansson.h>
#include <math.h>
#include <string.h>

#include <fmb/gmp.h>
#include <fmb/pair.h>

#include "property/random/rows.h"

enum { PATH = 1024, MOST_DIM = 3 };

static json_t *load(const char *name)
{
    char path[PATH];
    snprintf(path, sizeof path, "%s/geom/%s", CASES, name);
    return json_load_file(path, 0, NULL);
}

/* run(name) on every file of that beginning and end; false if the cases are absent. */
static bool each_file(const char *begin, const char *end, void run(const char *name))
{
    int files = 0;
    DIR *d = opendir(CASES "/geom");
    if (!d)
        return false;
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        size_t n = strlen(e->d_name);
        if (strncmp(e->d_name, begin, strlen(begin)) == 0 && n > strlen(end) &&
            strcmp(e->d_name + n - strlen(end), end) == 0) {
            run(e->d_name);
            files++;
        }
    }
    closedir(d);
    cr_expect(files > 2, "%d files", files);
    return true;
}

static void skip(void)
{
    cr_skip_test("no cases at " CASES);
}

/* ---- frames ---------------------------------------------------------------------------------- */

static json_t *answers;
static size_t doubles;

/* The answer about a line of a file. */
static const json_t *truth_of(const char *name, const char *id)
{
    char key[PATH];
    json_t *text = json_loads(id, JSON_DECODE_ANY, NULL);
    snprintf(key, sizeof key, "geom/%s#%s", name, json_string_value(text));
    json_decref(text);
    const json_t *truth = json_object_get(answers, key);
    cr_assert(truth, "%s", key);
    return truth;
}

static double largest(const fmb_frame *f)
{
    double most = 0;
    for (int j = 0; j < f->dim; j++) {
        double sum = fabs(f->origin[j]) + (f->speed ? fabs(f->speed[j]) : 0);
        for (int i = 0; i < f->naxes; i++)
            sum += fabs(f->axes[i * f->dim + j]);
        most = fmax(most, sum);
    }
    return most;
}

/* ends contain the recorded interval, and lie at most slack outside of it; slack 0: they are the
 * next doubles. */
static void check_interval(const char *id, const double *ends, const json_t *recorded, double slack)
{
    mpq_t end, exact;
    mpq_inits(end, exact, NULL);
    for (size_t side = 0; side < 2; side++) {
        double out = side == 0 ? -INFINITY : INFINITY, d = ends[side];
        mpq_set_str(exact, json_string_value(json_array_get(recorded, side)), 10);
        mpq_canonicalize(exact);
        mpq_set_d(end, d);
        int order = mpq_cmp(end, exact) * (side == 0 ? -1 : 1);
        cr_expect(order >= 0, "%s: %.17g is inside", id, d);
        mpq_set_d(end, slack > 0 ? d - copysign(slack, out) : nextafter(d, -out));
        int closer = mpq_cmp(end, exact) * (side == 0 ? -1 : 1);
        cr_expect(slack > 0 ? closer <= 0 : order == 0 || closer < 0, "%s: %.17g is far out", id,
                  d);
    }
    mpq_clears(end, exact, NULL);
}

/* What one kernel says of a line. */
static void ask(fmb_pair *k, const fmb_frame_line *line, int swap, const char *verdict,
                const json_t *bbox, bool tightest)
{
    fmb_verdict got;
    double world[MOST_DIM][2], inside[MOST_DIM][2], time[2], witness[MOST_DIM];
    fmb_pair_answers out = {.size = sizeof out, .verdict = &got};
    if (bbox) {
        out.world = &world[0][0];
        out.inside = &inside[0][0];
        out.time = time;
        out.witness = witness;
    }
    const fmb_frame *p = &line->frame[swap], *q = &line->frame[1 - swap];
    must(fmb_pair_test(k, 1, p, q, &out));
    cr_expect_eq(got, strcmp(verdict, "sat") == 0 ? FMB_FEASIBLE : FMB_INFEASIBLE, "%s", line->id);
    if (!bbox || got != FMB_FEASIBLE)
        return;
    double size = fmax(largest(p), largest(q)), slack = tightest ? 0 : 1e-12 * size;
    for (int j = 0; j < line->dim; j++) {
        check_interval(line->id, world[j], json_array_get(bbox, (size_t)j), slack);
        cr_expect(witness[j] >= world[j][0] - 1e-12 * size &&
                      witness[j] <= world[j][1] + 1e-12 * size,
                  "%s", line->id);
    }
    if (p->speed || q->speed)
        check_interval(line->id, time, json_array_get(bbox, (size_t)line->dim),
                       tightest ? 0 : 1e-12);
}

static void check_line(const fmb_frame_line *line, const json_t *truth)
{
    for (int contact = 0; contact < 2; contact++)
        for (int method = FMB_PAIR_FMB; method <= FMB_PAIR_EXACT; method++)
            for (int tightest = 0; tightest < 2; tightest++) {
                fmb_pair_options o = {.size = sizeof o};
                fmb_pair *k = NULL;
                o.contact = (fmb_contact)contact;
                o.method = (fmb_pair_method)method;
                o.tightest = tightest != 0;
                must(fmb_pair_new(line->dim, &o, NULL, &k));
                const char *verdict =
                    json_string_value(json_object_get(truth, contact ? "open" : "closed"));
                for (int swap = 0; swap < 2; swap++)
                    ask(k, line, swap, verdict, contact ? NULL : json_object_get(truth, "bbox"),
                        o.tightest);
                fmb_pair_free(k);
            }
}

static void check_frames(const char *name)
{
    char path[PATH];
    fmb_frame_reader *r = NULL;
    const fmb_frame_line *line = NULL;
    snprintf(path, sizeof path, "%s/geom/%s", CASES, name);
    FILE *in = fopen(path, "rb");
    cr_assert(in, "%s", path);
    must(fmb_frame_reader_new(in, NULL, &r));
    for (must(fmb_frame_reader_next(r, &line, NULL)); line;
         must(fmb_frame_reader_next(r, &line, NULL))) {
        const json_t *truth = truth_of(name, line->id);
        if (line->are_doubles)
            check_line(line, truth);
        doubles += line->are_doubles;
    }
    fmb_frame_reader_free(r);
    fclose(in);
}

Test(cases, frames)
{
    answers = load("answers.json");
    if (!answers || !each_file("frames_", ".jsonl", check_frames))
        skip();
    cr_expect(doubles > 30, "%zu pairs in doubles", doubles);
    json_decref(answers);
}

/* ---- hulls ----------------------------------------------------------------------------------- */

/* [give] x = sum of multipliers times the points, multipliers >= 0 with sum 1; over x, then the
 * multipliers. */
static fmb_system *hull(const json_t *points, int dim)
{
    int n = (int)json_array_size(points), vars = dim + n;
    fmb_system *s = rows_none(vars);
    mpq_t *row = malloc((size_t)vars * sizeof *row), rhs;
    int *var = malloc((size_t)vars * sizeof *var);
    mpq_init(rhs);
    for (int v = 0; v < vars; v++) {
        mpq_init(row[v]);
        var[v] = v;
    }
    for (int j = 0; j < dim; j++) {
        for (int v = 0; v < dim; v++)
            mpq_set_si(row[v], v == j ? -1 : 0, 1);
        for (int k = 0; k < n; k++) {
            const json_t *point = json_array_get(points, (size_t)k);
            mpq_set_str(row[dim + k], json_string_value(json_array_get(point, (size_t)j)), 10);
            mpq_canonicalize(row[dim + k]);
        }
        must(fmb_system_add_q(s, (size_t)vars, var, row, FMB_EQ, rhs));
    }
    for (int v = 0; v < vars; v++)
        mpq_set_si(row[v], -1, 1);
    for (int k = 0; k < n; k++)
        must(fmb_system_add_q(s, 1, &var[dim + k], &row[dim + k], FMB_LE, rhs));
    mpq_set_si(rhs, -1, 1);
    must(fmb_system_add_q(s, (size_t)n, var + dim, row + dim, FMB_EQ, rhs));
    for (int v = 0; v < vars; v++)
        mpq_clear(row[v]);
    mpq_clear(rhs);
    free(row);
    free(var);
    return s;
}

/* The second hull behind the first: the same point, multipliers of its own. */
static fmb_verdict hulls_meet(const json_t *file)
{
    int dim = (int)json_integer_value(json_object_get(file, "dim"));
    fmb_system *s = hull(json_object_get(file, "P"), dim);
    fmb_system *q = hull(json_object_get(file, "Q"), dim);
    int *map = malloc((size_t)fmb_system_dim(q) * sizeof *map);
    for (int v = 0; v < fmb_system_dim(q); v++) {
        map[v] = v;
        if (v >= dim)
            must(fmb_system_add_variable(s, NULL, &map[v]));
    }
    must(fmb_system_join(s, q, map));
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result res = {.size = sizeof res};
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &res));
    fmb_solver_free(v);
    fmb_system_free(s);
    fmb_system_free(q);
    free(map);
    return res.verdict;
}

static void check_hulls(const char *name)
{
    char key[PATH];
    json_t *file = load(name);
    snprintf(key, sizeof key, "geom/%s", name);
    const json_t *truth = json_object_get(answers, key);
    cr_assert(file && truth, "%s", name);
    bool meet = strcmp(json_string_value(json_object_get(truth, "closed")), "sat") == 0;
    cr_expect_eq(hulls_meet(file), meet ? FMB_FEASIBLE : FMB_INFEASIBLE, "%s", name);
    json_decref(file);
}

Test(cases, hulls)
{
    answers = load("answers.json");
    if (!answers || !each_file("hulls_", ".json", check_hulls))
        skip();
    json_decref(answers);
}
