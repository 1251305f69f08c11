/* problem.c: see problem.h. */
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>

#include "problem.h"
#include "study/program/random.h"

void *need(void *p)
{
    if (!p) {
        fprintf(stderr, "out of memory\n");
        exit(70);
    }
    return p;
}

mpz_t *integers_new(size_t n)
{
    mpz_t *a = need(malloc((n ? n : 1) * sizeof *a));
    for (size_t i = 0; i < n; i++)
        mpz_init(a[i]);
    return a;
}

void integers_free(mpz_t *a, size_t n)
{
    for (size_t i = 0; a && i < n; i++)
        mpz_clear(a[i]);
    free(a);
}

fmb_system *system_of_dim(int dim)
{
    fmb_system *s = NULL;
    if (fmb_system_new(dim, NULL, &s) != FMB_OK)
        need(NULL);
    return s;
}

void system_add_row(fmb_system *s, mpz_t *a, fmb_rel rel)
{
    size_t n = (size_t)fmb_system_dim(s), terms = 0;
    mpq_t *coef = need(calloc(n + 1, sizeof *coef));
    int *var = need(calloc(n + 1, sizeof *var));
    for (size_t j = 0; j <= n; j++) {
        mpq_init(coef[j]);
        if (j == n || mpz_sgn(a[j]) != 0) {
            mpq_set_z(coef[terms], a[j]);
            var[terms++] = (int)j;
        }
    }
    if (fmb_system_add_q(s, terms - 1, var, coef, rel, coef[terms - 1]) != FMB_OK)
        need(NULL);
    for (size_t j = 0; j <= n; j++)
        mpq_clear(coef[j]);
    free(coef);
    free(var);
}

/* ---- reading --------------------------------------------------------------------------------- */

/* Row i of s with its denominators cleared. */
static void integer_row(const fmb_system *s, size_t i, mpz_t *a)
{
    size_t n = (size_t)fmb_system_dim(s), terms = fmb_system_terms(s, i);
    mpz_t common;
    mpq_t q;
    mpz_init(common);
    mpq_init(q);
    fmb_system_rhs_q(s, i, q);
    mpz_set(common, mpq_denref(q));
    for (size_t k = 0; k < terms; k++) {
        fmb_system_term_q(s, i, k, q);
        mpz_lcm(common, common, mpq_denref(q));
    }
    for (size_t k = 0; k <= terms; k++) {
        size_t j = k < terms ? (size_t)fmb_system_term_q(s, i, k, q) : n;
        if (k == terms)
            fmb_system_rhs_q(s, i, q);
        mpz_divexact(a[j], common, mpq_denref(q));
        mpz_mul(a[j], a[j], mpq_numref(q));
    }
    mpq_clear(q);
    mpz_clear(common);
}

/* Generator i of g with its denominators cleared. */
static void integer_generator(const fmb_generators *g, size_t i, mpz_t *a)
{
    int n = fmb_generators_dim(g);
    mpq_t q;
    mpq_init(q);
    mpz_set_ui(a[n], 1);
    for (int j = 0; j < n; j++) {
        fmb_generators_coordinate_q(g, i, j, q);
        mpz_lcm(a[n], a[n], mpq_denref(q));
    }
    for (int j = 0; j < n; j++) {
        fmb_generators_coordinate_q(g, i, j, q);
        mpz_divexact(a[j], a[n], mpq_denref(q));
        mpz_mul(a[j], a[j], mpq_numref(q));
    }
    if (fmb_generators_kind(g, i) != FMB_VERTEX)
        mpz_set_ui(a[n], 0);
    mpq_clear(q);
}

/* The comment lines "* NAME family=WORD" and "* keep K": K kept variables. */
static void read_comments(problem *p, FILE *in)
{
    char line[512];
    snprintf(p->family, sizeof p->family, "file");
    rewind(in);
    while (fgets(line, sizeof line, in)) {
        char *family = line[0] == '*' ? strstr(line, "family=") : NULL;
        int keep;
        if (family)
            (void)sscanf(family, "family=%15s", p->family);
        if (sscanf(line, "* keep %d", &keep) == 1 && keep >= 0 && keep <= p->n)
            p->keep = keep;
    }
}

/* "a/b/NAME.ine" */
static void set_name(char name[64], const char *path)
{
    const char *slash = strrchr(path, '/');
    snprintf(name, 64, "%s", slash ? slash + 1 : path);
    char *dot = strrchr(name, '.');
    if (dot)
        *dot = '\0';
}

void problem_of_system(problem *p, const char *name, fmb_system *s)
{
    *p = (problem){.n = fmb_system_dim(s), .m = fmb_system_rows(s), .system = s};
    p->keep = p->n;
    snprintf(p->name, sizeof p->name, "%s", name);
    p->rows = need(calloc(p->m + 1, sizeof *p->rows));
    for (size_t i = 0; i < p->m; i++) {
        p->rows[i] = (problem_row){integers_new((size_t)p->n + 1), fmb_system_rel(s, i)};
        integer_row(s, i, p->rows[i].a);
        p->equalities += p->rows[i].rel == FMB_EQ;
        p->strict |= p->rows[i].rel == FMB_LT;
    }
}

void problem_of_generators(problem *p, const char *name, fmb_generators *g)
{
    *p = (problem){.n = fmb_generators_dim(g), .m = fmb_generators_size(g), .generators = g};
    p->keep = p->n;
    snprintf(p->name, sizeof p->name, "%s", name);
    p->rows = need(calloc(p->m + 1, sizeof *p->rows));
    for (size_t i = 0; i < p->m; i++) {
        bool line = fmb_generators_kind(g, i) == FMB_LINE;
        p->rows[i] = (problem_row){integers_new((size_t)p->n + 1), line ? FMB_EQ : FMB_LE};
        integer_generator(g, i, p->rows[i].a);
        p->equalities += line;
    }
}

fmb_system *system_of_generators(const fmb_generators *g)
{
    int n = fmb_generators_dim(g);
    fmb_system *s = system_of_dim(n);
    mpz_t *a = integers_new((size_t)n + 1);
    for (size_t i = 0; i < fmb_generators_size(g); i++) {
        integer_generator(g, i, a);
        system_add_row(s, a, fmb_generators_kind(g, i) == FMB_LINE ? FMB_EQ : FMB_LE);
    }
    integers_free(a, (size_t)n + 1);
    return s;
}

bool problem_turn_over(problem *p)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_generators *g = NULL;
    fmb_result r = {.size = sizeof r};
    o.evidence = FMB_EVIDENCE_NONE;
    o.max_seconds = 10;
    if (p->generators)
        return true;
    if (fmb_solver_new(&o, NULL, &v) != FMB_OK || fmb_generate(v, p->system, &g, &r) != FMB_OK)
        need(NULL);
    fmb_solver_free(v);
    if (!g || r.stop != FMB_STOP_DONE) {
        fmb_generators_free(g);
        return false;
    }
    problem before = *p;
    problem_clear(p);
    problem_of_generators(p, before.name, g);
    memcpy(p->family, before.family, sizeof p->family);
    return true;
}

bool problem_read(problem *p, const char *path)
{
    FILE *in = fopen(path, "r");
    fmb_reader how = {.size = sizeof how, .format = fmb_format_of_name(path)};
    fmb_where where = {0};
    fmb_system *s = NULL;
    fmb_generators *g = NULL;
    const char *dot = strrchr(path, '.');
    bool points = dot && strcmp(dot, ".ext") == 0;
    if (!in || (points ? fmb_generators_read(in, &how, &g, &where)
                       : fmb_system_read(in, &how, &s, &where)) != FMB_OK) {
        fprintf(stderr, "%s:%ld:%ld: %s\n", path, where.line, where.column,
                in ? where.text : "cannot be opened");
        if (in)
            fclose(in);
        return false;
    }
    char name[sizeof p->name];
    set_name(name, path);
    if (points)
        problem_of_generators(p, name, g);
    else
        problem_of_system(p, name, s);
    read_comments(p, in);
    fclose(in);
    return true;
}

/* ---- variants -------------------------------------------------------------------------------- */

/* Append row i of from to to, with the same numbers. */
static void append_row(fmb_system *to, const fmb_system *from, size_t i)
{
    size_t n = fmb_system_terms(from, i);
    mpq_t *q = need(calloc(n + 1, sizeof *q));
    int *var = need(calloc(n + 1, sizeof *var));
    for (size_t k = 0; k <= n; k++) {
        mpq_init(q[k]);
        if (k < n)
            var[k] = fmb_system_term_q(from, i, k, q[k]);
    }
    fmb_system_rhs_q(from, i, q[n]);
    if (fmb_system_add_q(to, n, var, q, fmb_system_rel(from, i), q[n]) != FMB_OK)
        need(NULL);
    for (size_t k = 0; k <= n; k++)
        mpq_clear(q[k]);
    free(q);
    free(var);
}

/* Copy the objective of a system. */
static void copy_objective(const fmb_system *from, fmb_system *to)
{
    size_t n = fmb_system_objective_terms(from);
    mpq_t *q = need(calloc(n + 1, sizeof *q));
    int *var = need(calloc(n + 1, sizeof *var));
    for (size_t k = 0; k <= n; k++) {
        mpq_init(q[k]);
        if (k < n)
            var[k] = fmb_system_objective_term_q(from, k, q[k]);
    }
    fmb_system_objective_constant_q(from, q[n]);
    fmb_objective_q o = {fmb_system_sense(from), n, var, q, q[n]};
    if (fmb_system_set_objective_q(to, &o) != FMB_OK)
        need(NULL);
    for (size_t k = 0; k <= n; k++)
        mpq_clear(q[k]);
    free(q);
    free(var);
}

/* Append row r to to as a generator. */
static void append_generator(fmb_generators *to, const problem_row *r)
{
    size_t n = (size_t)fmb_generators_dim(to);
    bool vertex = mpz_sgn(r->a[n]) > 0;
    mpq_t *q = need(calloc(n + 1, sizeof *q));
    for (size_t j = 0; j < n; j++) {
        mpq_init(q[j]);
        mpz_set(mpq_numref(q[j]), r->a[j]);
        if (vertex)
            mpz_set(mpq_denref(q[j]), r->a[n]);
        mpq_canonicalize(q[j]);
    }
    fmb_generator_kind kind = r->rel == FMB_EQ ? FMB_LINE : vertex ? FMB_VERTEX : FMB_RAY;
    if (fmb_generators_add_q(to, kind, q) != FMB_OK)
        need(NULL);
    for (size_t j = 0; j < n; j++)
        mpq_clear(q[j]);
    free(q);
}

void problem_variant(problem *v, const problem *p, unsigned number)
{
    size_t width = (size_t)p->n + 1, *order = need(calloc(p->m + 1, sizeof *order));
    study_random g = {number};
    *v = *p;
    for (size_t i = 0; i < p->m; i++) {
        size_t j = number ? (size_t)(study_random_next(&g) % (i + 1)) : i;
        order[i] = order[j];
        order[j] = i;
    }
    v->system = p->system ? system_of_dim(p->n) : NULL;
    v->generators = NULL;
    if (p->generators && fmb_generators_new(p->n, NULL, &v->generators) != FMB_OK)
        need(NULL);
    v->rows = need(calloc(p->m + 1, sizeof *v->rows));
    for (size_t i = 0; i < p->m; i++) {
        const problem_row *from = &p->rows[order[i]];
        v->rows[i] = (problem_row){integers_new(width), from->rel};
        for (size_t j = 0; j < width; j++)
            mpz_set(v->rows[i].a[j], from->a[j]);
        if (p->system)
            append_row(v->system, p->system, order[i]);
        else
            append_generator(v->generators, from);
    }
    if (p->system)
        copy_objective(p->system, v->system);
    free(order);
}

void problem_clear(problem *p)
{
    for (size_t i = 0; i < p->m; i++)
        integers_free(p->rows[i].a, (size_t)p->n + 1);
    free(p->rows);
    fmb_system_free(p->system);
    fmb_generators_free(p->generators);
}
