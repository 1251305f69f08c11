/* tiny.c: the time of fmb_solve on tiny systems, against GLPK's simplex.
 *
 * All systems are built first, for both. A pass solves every system once, so that branch prediction
 * learns no answer; passes of the two alternate; the time is this thread's CPU time, the median of
 * several passes. fmb: one solver, default options, no evidence. GLPK: glp_simplex from a fresh
 * standard basis, messages off, no presolver; rows of one variable are column bounds, the fastest
 * form for GLPK. See README.md.
 */
#include <glpk.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/gmp.h>

#include "machine.h"
#include "shapes.h"

typedef struct item {
    char kind[16];
    fmb_system *s;
    glp_prob *lp;
    fmb_verdict ours, theirs;
} item;

typedef struct bench {
    item *list;
    size_t items;
    fmb_solver *solver;
} bench;

static void *need(void *p)
{
    if (!p) {
        fprintf(stderr, "out of memory\n");
        exit(70);
    }
    return p;
}

/* ---- GLPK's form ----------------------------------------------------------------------------- */

/* Narrow the bounds of column j by "a x_j <= b". */
static void narrow(glp_prob *lp, int j, double a, double b, bool equal)
{
    int type = glp_get_col_type(lp, j);
    double low = glp_get_col_lb(lp, j), high = glp_get_col_ub(lp, j), end = b / a;
    bool has_low = type == GLP_LO || type == GLP_DB || type == GLP_FX;
    bool has_high = type == GLP_UP || type == GLP_DB || type == GLP_FX;
    if ((a < 0 || equal) && (!has_low || end > low)) {
        low = end;
        has_low = true;
    }
    if ((a > 0 || equal) && (!has_high || end < high)) {
        high = end;
        has_high = true;
    }
    type = has_low && has_high ? (low < high ? GLP_DB : GLP_FX) : has_low ? GLP_LO : GLP_UP;
    glp_set_col_bnds(lp, j, type, low, high);
}

static void add_row(glp_prob *lp, const fmb_system *s, size_t i)
{
    int index[65];
    double value[65];
    size_t n = fmb_system_terms(s, i);
    bool equal = fmb_system_rel(s, i) == FMB_EQ;
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < n; k++) {
        index[k + 1] = fmb_system_term_q(s, i, k, q) + 1;
        value[k + 1] = mpq_get_d(q);
    }
    fmb_system_rhs_q(s, i, q);
    double b = mpq_get_d(q);
    mpq_clear(q);
    if (n == 1) {
        narrow(lp, index[1], value[1], b, equal);
        return;
    }
    int row = glp_add_rows(lp, 1);
    glp_set_mat_row(lp, row, (int)n, index, value);
    glp_set_row_bnds(lp, row, equal ? GLP_FX : GLP_UP, b, b);
}

static glp_prob *glpk_form(const fmb_system *s)
{
    glp_prob *lp = need(glp_create_prob());
    glp_add_cols(lp, fmb_system_dim(s));
    for (int j = 1; j <= fmb_system_dim(s); j++)
        glp_set_col_bnds(lp, j, GLP_FR, 0, 0);
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        add_row(lp, s, i);
    return lp;
}

/* ---- systems --------------------------------------------------------------------------------- */

static void add_item(bench *b, const char *kind, fmb_system *s)
{
    b->list = need(realloc(b->list, (b->items + 1) * sizeof *b->list));
    item *it = &b->list[b->items++];
    *it = (item){.s = need(s), .lp = glpk_form(s)};
    snprintf(it->kind, sizeof it->kind, "%s", kind);
}

#define MOST 64 /* variables */

/* A variant of s: its rows and variables in an order that depends on k. */
static fmb_system *shuffle(const fmb_system *s, size_t k)
{
    size_t dim = (size_t)fmb_system_dim(s), rows = fmb_system_rows(s);
    fmb_system *out = NULL;
    mpq_t coef[MOST], b;
    int var[MOST];
    if (dim > MOST || fmb_system_new((int)dim, NULL, &out) != FMB_OK)
        need(NULL);
    for (size_t j = 0; j < dim; j++)
        mpq_init(coef[j]);
    mpq_init(b);
    for (size_t i = 0; i < rows; i++) {
        size_t from = (k % 2 ? i + k : rows - 1 - i + k) % rows, n = fmb_system_terms(s, from);
        for (size_t t = 0; t < n; t++)
            var[t] = (fmb_system_term_q(s, from, t, coef[t]) + (int)k) % (int)dim;
        fmb_system_rhs_q(s, from, b);
        if (fmb_system_add_q(out, n, var, coef, fmb_system_rel(s, from), b) != FMB_OK)
            need(NULL);
    }
    for (size_t j = 0; j < dim; j++)
        mpq_clear(coef[j]);
    mpq_clear(b);
    return out;
}

/* "dir/col_D3_CT_dyn_inf.ine" is of kind "file-D3-dyn", other names of kind "file". */
static void name_kind(const char *path, char kind[16])
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    bool moving = strstr(name, "_dyn") != NULL;
    if (strncmp(name, "col_D", 5) == 0 && name[5] >= '1' && name[5] <= '9')
        snprintf(kind, 16, "file-D%c-%s", name[5], moving ? "dyn" : "sta");
    else
        snprintf(kind, 16, "file");
}

#define VARIANTS 16

static void add_file(bench *b, const char *path)
{
    FILE *in = fopen(path, "r");
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_INE};
    fmb_where where;
    fmb_system *s = NULL;
    char kind[16];
    if (!in || fmb_system_read(in, &how, &s, &where) != FMB_OK) {
        fprintf(stderr, "%s: cannot be read\n", path);
        exit(66);
    }
    fclose(in);
    name_kind(path, kind);
    for (size_t k = 0; k < VARIANTS; k++)
        add_item(b, kind, shuffle(s, k));
    fmb_system_free(s);
}

static void add_pairs(bench *b, unsigned n)
{
    for (unsigned i = 0; i < n; i++) {
        char kind[16];
        fmb_system *s = shape_pair(i, kind);
        add_item(b, kind, s);
    }
}

/* ---- passes ---------------------------------------------------------------------------------- */

/* The items of a kind (NULL: all). */
typedef struct choice {
    item **list;
    size_t items;
} choice;

static choice choose(bench *b, const char *kind)
{
    choice c = {.list = need(calloc(b->items, sizeof *c.list))};
    for (size_t i = 0; i < b->items; i++)
        if (!kind || strcmp(kind, b->list[i].kind) == 0)
            c.list[c.items++] = &b->list[i];
    return c;
}

/* Seconds for one pass. */
static double pass_fmb(bench *b, const choice *c)
{
    double begin = thread_seconds();
    for (size_t i = 0; i < c->items; i++) {
        item *it = c->list[i];
        fmb_result r = {.size = sizeof r};
        if (fmb_solve(b->solver, it->s, &r) != FMB_OK)
            need(NULL);
        it->ours = r.verdict;
    }
    return thread_seconds() - begin;
}

static double pass_glpk(const choice *c)
{
    glp_smcp how;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.presolve = GLP_OFF;
    double begin = thread_seconds();
    for (size_t i = 0; i < c->items; i++) {
        item *it = c->list[i];
        glp_std_basis(it->lp);
        glp_simplex(it->lp, &how);
        int status = glp_get_status(it->lp);
        it->theirs = status == GLP_OPT      ? FMB_FEASIBLE
                     : status == GLP_NOFEAS ? FMB_INFEASIBLE
                                            : FMB_UNKNOWN;
    }
    return thread_seconds() - begin;
}

typedef struct line {
    size_t systems, feasible, unlike;
    double fmb, glpk; /* per system [s] */
} line;

static line measure(bench *b, const char *kind, int passes)
{
    line l = {0};
    double *fmb = need(calloc((size_t)passes, sizeof *fmb));
    double *glpk = need(calloc((size_t)passes, sizeof *glpk));
    choice c = choose(b, kind);
    pass_fmb(b, &c);
    pass_glpk(&c);
    for (int i = 0; i < passes; i++) {
        fmb[i] = pass_fmb(b, &c);
        glpk[i] = pass_glpk(&c);
    }
    l.systems = c.items;
    for (size_t i = 0; i < c.items; i++) {
        const item *it = c.list[i];
        l.feasible += it->ours == FMB_FEASIBLE;
        l.unlike += it->ours != it->theirs;
    }
    l.fmb = median(fmb, passes) / (double)(l.systems ? l.systems : 1);
    l.glpk = median(glpk, passes) / (double)(l.systems ? l.systems : 1);
    free(c.list);
    free(fmb);
    free(glpk);
    return l;
}

/* ---- report ---------------------------------------------------------------------------------- */

static void print_line(const char *kind, const line *l, bool json, bool first)
{
    if (json)
        printf("%s{\"kind\": \"%s\", \"systems\": %zu, \"feasible\": %zu, \"unlike\": %zu, "
               "\"fmb_us\": %.3f, \"glpk_us\": %.3f, \"ratio\": %.3f}",
               first ? "" : ",\n  ", kind, l->systems, l->feasible, l->unlike, 1e6 * l->fmb,
               1e6 * l->glpk, l->fmb / l->glpk);
    else
        printf("%-14s%9zu%10zu%8zu%10.2f%10.2f%8.2f\n", kind, l->systems, l->feasible, l->unlike,
               1e6 * l->fmb, 1e6 * l->glpk, l->fmb / l->glpk);
}

static void report(bench *b, int passes, bool json)
{
    if (json) {
        printf("{");
        print_machine_json(stdout);
        printf(", \"passes\": %d, \"lines\": [\n  ", passes);
    } else {
        printf("%-14s%9s%10s%8s%10s%10s%8s\n", "kind", "systems", "feasible", "unlike", "fmb us",
               "GLPK us", "ratio");
    }
    bool first = true;
    for (size_t i = 0; i < b->items; i++) {
        bool seen = false;
        for (size_t k = 0; k < i && !seen; k++)
            seen = strcmp(b->list[k].kind, b->list[i].kind) == 0;
        if (seen)
            continue;
        line l = measure(b, b->list[i].kind, passes);
        print_line(b->list[i].kind, &l, json, first);
        first = false;
    }
    line l = measure(b, NULL, passes);
    print_line("all", &l, json, first);
    if (json)
        printf("]}\n");
}

int main(int argc, char **argv)
{
    bench b = {0};
    fmb_options o = {.size = sizeof o};
    bool json = false;
    int passes = 9;
    unsigned pairs = 7168;
    o.evidence = FMB_EVIDENCE_NONE;
    if (fmb_solver_new(&o, NULL, &b.solver) != FMB_OK)
        need(NULL);
    glp_term_out(GLP_OFF);
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--json") == 0)
            json = true;
        else if (strncmp(argv[i], "--passes=", 9) == 0 && atoi(argv[i] + 9) > 0)
            passes = atoi(argv[i] + 9);
        else if (strncmp(argv[i], "--pairs=", 8) == 0 && atoi(argv[i] + 8) >= 0)
            pairs = (unsigned)atoi(argv[i] + 8);
        else if (argv[i][0] != '-')
            add_file(&b, argv[i]);
        else {
            fprintf(stderr, "usage: tiny [--json] [--passes=N] [--pairs=N] [FILE.ine...]\n");
            return 64;
        }
    }
    add_pairs(&b, pairs);
    report(&b, passes, json);
    for (size_t i = 0; i < b.items; i++) {
        fmb_system_free(b.list[i].s);
        glp_delete_prob(b.list[i].lp);
    }
    free(b.list);
    fmb_solver_free(b.solver);
    glp_free_env();
    return 0;
}
