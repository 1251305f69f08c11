/* as_glpk.c: our readers of MPS and LP files against GLPK's: every variable, row and bound of the
 * collected files, and of random ones, is the same as a double; mutated files never crash our
 * readers, and are read alike if both accept them. */
#include <criterion/criterion.h>
#include <dirent.h>
#include <glpk.h>
#include <math.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"
#include "random_program.h"
#include "support/support.h"

/* ---- GLPK ------------------------------------------------------------------------------------ */

static jmp_buf aborted;

static void leave(void *info)
{
    (void)info;
    longjmp(aborted, 1);
}

/* The text as GLPK can read it: without empty lines and OBJSENSE, and without markers, for
 * which it bounds by 1 even columns that have a lower bound; of LP without comments, which it
 * refuses behind a row. */
static void write_for_glpk(const char *text, size_t size, program_form form, FILE *out)
{
    bool sense = false;
    for (const char *p = text, *end = text + size; p < end;) {
        const char *eol = memchr(p, '\n', (size_t)(end - p));
        size_t n = eol ? (size_t)(eol - p) + 1 : (size_t)(end - p);
        const char *comment = form == LP ? memchr(p, '\\', n) : NULL;
        size_t kept = comment ? (size_t)(comment - p) : n;
        if (*p != ' ')
            sense = n > 8 && memcmp(p, "OBJSENSE", 8) == 0;
        if (form != LP && (sense || *p == '\n' || memmem(p, n, "'MARKER'", 8)))
            fputs("*\n", out);
        else
            fwrite(p, 1, kept, out);
        if (comment)
            fputc('\n', out);
        p += n;
    }
}

static glp_prob *glpk_of(const char *text, size_t size, program_form form)
{
    char path[32];
    FILE *f = tmpfile();
    cr_assert(f);
    write_for_glpk(text, size, form, f);
    rewind(f);
    snprintf(path, sizeof path, "/dev/fd/%d", fileno(f));
    glp_term_out(GLP_OFF);
    glp_prob *volatile p = glp_create_prob();
    if (setjmp(aborted)) {
        glp_free_env();
        fclose(f);
        return NULL;
    }
    glp_error_hook(leave, NULL);
    glp_mpscp how;
    glp_init_mpscp(&how);
    how.tol_mps = 0;
    int mps = form == MPS_FIXED ? GLP_MPS_DECK : GLP_MPS_FILE;
    int failed = form == LP ? glp_read_lp(p, NULL, path) : glp_read_mps(p, mps, &how, path);
    glp_error_hook(NULL, NULL);
    fclose(f);
    if (failed)
        glp_delete_prob(p);
    return failed ? NULL : p;
}

/* ---- equality -------------------------------------------------------------------------------- */

/* d is within ulps of q, 0.5 being the nearest double. */
static bool is_double_of(const mpq_t q, double d, double ulps)
{
    mpq_t e, most;
    mpq_inits(e, most, NULL);
    double step = nextafter(fabs(d), INFINITY) - fabs(d);
    mpq_set_d(e, d);
    mpq_sub(e, e, q);
    mpq_abs(e, e);
    mpq_set_d(most, step);
    mpq_t factor;
    mpq_init(factor);
    mpq_set_d(factor, ulps);
    mpq_mul(most, most, factor);
    bool near = mpq_cmp(e, most) <= 0;
    mpq_clears(e, most, factor, NULL);
    return near;
}

/* GLPK drops blanks inside names. */
static bool same_name(const char *ours, const char *theirs)
{
    for (; *ours; ours++)
        if (*ours != ' ' && *ours != *theirs++)
            return false;
    return !*theirs;
}

typedef struct walk {
    glp_prob *p;
    const fmb_system *s;
    size_t row; /* the next one of ours */
    char why[256];
} walk;

static bool differ(walk *w, const char *what, const char *where)
{
    snprintf(w->why, sizeof w->why, "%s of %s, row %zu", what, where ? where : "?", w->row + 1);
    return false;
}

/* Our next row is sign * terms <= sign * side, or = side. A side that GLPK has added up may be off
 * by more than half a unit in the last place. */
static bool is_next(walk *w, const char *name, const double *coef, int sign, fmb_rel rel,
                    double side, double ulps)
{
    mpq_t q;
    if (w->row >= fmb_system_rows(w->s))
        return differ(w, "missing row", name);
    mpq_init(q);
    bool same = fmb_system_rel(w->s, w->row) == rel;
    size_t terms = fmb_system_terms(w->s, w->row), given = 0;
    for (int j = 1; j <= glp_get_num_cols(w->p); j++)
        given += coef[j] != 0;
    same = same && terms == given;
    for (size_t k = 0; same && k < terms; k++) {
        int j = fmb_system_term_q(w->s, w->row, k, q);
        same = is_double_of(q, sign * coef[j + 1], 0.5);
    }
    fmb_system_rhs_q(w->s, w->row, q);
    same = same && is_double_of(q, sign * side, ulps);
    mpq_clear(q);
    w->row += same;
    return same ? true : differ(w, "another row", name);
}

static bool is_interval(walk *w, const char *name, const double *coef, int type, double low,
                        double high, double ulps)
{
    if (type == GLP_FX || (type == GLP_DB && low == high))
        return is_next(w, name, coef, 1, FMB_EQ, low, ulps);
    if ((type == GLP_LO || type == GLP_DB) && low > -1e30 &&
        !is_next(w, name, coef, -1, FMB_LE, low, ulps))
        return false;
    return (type != GLP_UP && type != GLP_DB) || high >= 1e30 ||
           is_next(w, name, coef, 1, FMB_LE, high, ulps);
}

static bool has_same_rows(walk *w, program_form form)
{
    int n = glp_get_num_cols(w->p);
    double *coef = calloc((size_t)n + 1, sizeof *coef), *value = malloc(((size_t)n + 1) * 8);
    int *index = malloc(((size_t)n + 1) * sizeof *index);
    bool same = true;
    for (int i = 1; same && i <= glp_get_num_rows(w->p); i++) {
        const char *name = glp_get_row_name(w->p, i);
        int type = glp_get_row_type(w->p, i), terms = glp_get_mat_row(w->p, i, index, value);
        if (type == GLP_FR)
            continue;
        memset(coef, 0, ((size_t)n + 1) * sizeof *coef);
        for (int k = 1; k <= terms; k++)
            coef[index[k]] = value[k];
        const char *label = w->row < fmb_system_rows(w->s) ? fmb_system_label(w->s, w->row) : NULL;
        if (label ? !same_name(label, name) : form != LP)
            same = differ(w, "name", name);
        same = same && is_interval(w, name, coef, type, glp_get_row_lb(w->p, i),
                                   glp_get_row_ub(w->p, i), type == GLP_DB ? 64 : 0.5);
    }
    for (int j = 1; same && j <= n; j++) {
        memset(coef, 0, ((size_t)n + 1) * sizeof *coef);
        coef[j] = 1;
        same = is_interval(w, glp_get_col_name(w->p, j), coef, glp_get_col_type(w->p, j),
                           glp_get_col_lb(w->p, j), glp_get_col_ub(w->p, j), 0.5);
        if (same && form != LP && glp_get_col_type(w->p, j) == GLP_LO &&
            glp_get_col_lb(w->p, j) == 0 && fmb_system_is_integer(w->s, j - 1))
            (void)is_next(w, "", coef, 1, FMB_LE, 1, 0.5); /* from a marker that GLPK did not see */
    }
    free(coef);
    free(value);
    free(index);
    return same && (w->row == fmb_system_rows(w->s) || differ(w, "more rows", NULL));
}

/* OBJSENSE is hidden from GLPK, which takes a right side of the objective for its constant; to us,
 * as to CPLEX, Gurobi and HiGHS, it is minus the constant. */
static bool has_same_objective(walk *w, program_form form)
{
    mpq_t q;
    mpq_init(q);
    bool max = glp_get_obj_dir(w->p) == GLP_MAX, same = true;
    if (form == LP && max != (fmb_system_sense(w->s) == FMB_SENSE_MAX))
        same = differ(w, "sense", "the objective");
    size_t terms = fmb_system_objective_terms(w->s), k = 0;
    for (int j = 1; same && j <= glp_get_num_cols(w->p); j++) {
        int next = fmb_system_objective_term_q(w->s, k, q);
        if (next != j - 1)
            mpq_set_ui(q, 0, 1);
        k += next == j - 1;
        same = is_double_of(q, glp_get_obj_coef(w->p, j), 0.5) ||
               differ(w, "objective", glp_get_col_name(w->p, j));
    }
    fmb_system_objective_constant_q(w->s, q);
    if (form != LP)
        mpq_neg(q, q);
    if (same && (k != terms || !is_double_of(q, glp_get_obj_coef(w->p, 0), 0.5)))
        same = differ(w, "constant", "the objective");
    mpq_clear(q);
    return same;
}

static bool is_same_program(walk *w, program_form form)
{
    if (glp_get_num_cols(w->p) != fmb_system_dim(w->s))
        return differ(w, "number", "columns");
    for (int j = 0; j < fmb_system_dim(w->s); j++) {
        const char *name = glp_get_col_name(w->p, j + 1);
        if (!same_name(fmb_system_name(w->s, j), name))
            return differ(w, "name", name);
        bool integer = glp_get_col_kind(w->p, j + 1) != GLP_CV;
        if (integer != fmb_system_is_integer(w->s, j) && (integer || form == LP))
            return differ(w, "integrality", name);
    }
    return has_same_objective(w, form) && has_same_rows(w, form);
}

static fmb_format format_of(program_form form)
{
    return form == LP ? FMB_FORMAT_LP : FMB_FORMAT_MPS;
}

/* Both read it, and the same. */
static void check_same(const char *text, size_t size, program_form form, const char *name)
{
    walk w = {.p = glpk_of(text, size, form)};
    fmb_system *s = parse(format_of(form), text, size);
    w.s = s;
    cr_assert(w.p, "GLPK cannot read %s\n%.2000s", name, text);
    cr_expect(is_same_program(&w, form), "%s: %s\n%.2000s", name, w.why, text);
    glp_delete_prob(w.p);
    fmb_system_free(s);
}

/* ---- collected files ------------------------------------------------------------------------- */

enum { LARGEST_COLLECTED = (1 << 20) / WATCHED };

static void check_same_mps(const char *text, size_t size, const char *name)
{
    glp_prob *fixed = glpk_of(text, size, MPS_FIXED);
    check_same(text, size, fixed ? MPS_FIXED : MPS_FREE, name);
    if (fixed)
        glp_delete_prob(fixed);
}

Test(as_glpk, collected)
{
    DIR *folder = opendir(CASES "/lp");
    if (!folder)
        cr_skip_test("no collected cases here");
    int files = 0;
    for (struct dirent *e; (e = readdir(folder)) != NULL;) {
        char path[1024];
        size_t size;
        if (!strstr(e->d_name, ".mps"))
            continue;
        snprintf(path, sizeof path, CASES "/lp/%s", e->d_name);
        char *text = slurp_file(path, &size);
        if (size < LARGEST_COLLECTED)
            check_same_mps(text, size, e->d_name);
        free(text);
        files++;
    }
    closedir(folder);
    cr_expect(files >= 84);
}

/* ---- random files ---------------------------------------------------------------------------- */

/* Others are asked about with another FMB_GLPK_SEED. */
static uint64_t first_seed(void)
{
    const char *other = getenv("FMB_GLPK_SEED");
    return other ? strtoull(other, NULL, 10) : 1;
}

static const program_form forms[] = {MPS_FIXED, MPS_FREE, LP};

Test(as_glpk, random_files)
{
    uint64_t seed = first_seed();
    for (int run = 0; run < 600; run++) {
        char name[64];
        size_t size;
        snprintf(name, sizeof name, "seed %llu", (unsigned long long)(seed + (uint64_t)run));
        char *text = random_program(seed + (uint64_t)run, forms[run % 3], &size);
        check_same(text, size, forms[run % 3], name);
        free(text);
    }
}

/* ---- mutated files --------------------------------------------------------------------------- */

/* A byte changed, a piece cut out, a piece twice. */
static void mutate(support_rng *g, char **text, size_t *size)
{
    static const char bytes[] = " \n\t:<>=+-.0123456789eExrRLGENU*$\\'";
    size_t at = support_next(g) % *size, n = 1 + support_next(g) % 12;
    n = n < *size - at ? n : *size - at;
    switch (support_between(g, 0, 2)) {
    case 0:
        (*text)[at] = bytes[support_next(g) % (sizeof bytes - 1)];
        break;
    case 1:
        memmove(*text + at, *text + at + n, *size - at - n);
        *size -= n;
        break;
    default:
        *text = realloc(*text, *size + n);
        memmove(*text + at + n, *text + at, *size - at);
        *size += n;
    }
}

/* The two may differ: GLPK takes the beginning of a keyword for the whole one (`minimu`) and
 * several bounds of LP in one line; a mutated file may fit the other form of MPS better. Files with
 * markers, which are hidden from GLPK, are read by us alone. */
Test(as_glpk, mutated_files)
{
    uint64_t seed = first_seed() + 1000000;
    int compared = 0, differing = 0;
    for (int run = 0; run < 3000; run++) {
        support_rng g = {seed + (uint64_t)run};
        size_t size;
        program_form form = forms[run % 3];
        char *text = random_program(g.state, form, &size);
        for (int k = support_between(&g, 1, 2); k > 0 && size > 1; k--)
            mutate(&g, &text, &size);
        bool hidden = memmem(text, size, "'M", 2) != NULL;
        walk w = {.p = hidden ? NULL : glpk_of(text, size, form)};
        fmb_system *s = NULL;
        fmb_where at = {0};
        fmb_status st = fmb_system_parse(
            text, size, &(fmb_reader){.size = sizeof(fmb_reader), .format = format_of(form)}, &s,
            &at);
        cr_expect(st == FMB_OK || (st == FMB_ERR_PARSE && at.line > 0 && at.text[0]), "seed %llu",
                  (unsigned long long)(seed + (uint64_t)run));
        w.s = s;
        compared += w.p != NULL;
        if (w.p && (st != FMB_OK || !is_same_program(&w, form)))
            differing++;
        if (w.p)
            glp_delete_prob(w.p);
        fmb_system_free(s);
        free(text);
    }
    cr_expect(compared > 100, "GLPK reads only %d of the files", compared);
    cr_expect(differing * 8 < compared, "%d of %d files differ; seed %llu", differing, compared,
              (unsigned long long)seed);
}
