/* options.c: the one table of options. */
#include <stdlib.h>
#include <string.h>

#include "solve/query/solver.h"

typedef enum kind { WORD, FLAG, TEXT, SECONDS, COUNT } kind;

typedef struct entry {
    fmb_option_info info;
    kind kind;
    size_t offset;
    const char *const *words; /* WORD: the values of the enum, in order */
} entry;

static const char *const ARITH[] = {"auto", "int", "gmp", NULL};
static const char *const METHOD[] = {"auto", "fm", "lp", "hull", "dd", NULL};
static const char *const ORDER[] = {"pairs", "given", "min", "fill", NULL};

static const char *const EVIDENCE[] = {"all", "none", "verdict", "whole", NULL};
static const char *const SYMMETRY[] = {"auto", "none", NULL};
static const char *const REBASE[] = {"auto", "always", "never", NULL};
static const char *const SIMD[] = {"auto", "plain", "avx2", "avx512", NULL};

/* An option: its member in fmb_options, which has the same name, and its description. */
#define OPTION(kind, name, words, ...)                                                             \
    {                                                                                              \
        {#name, __VA_ARGS__}, kind, offsetof(fmb_options, name), words                             \
    }

static const entry TABLE[] = {
    OPTION(WORD, arith, ARITH, "auto|int|gmp", "auto",
           "Arithmetic of rows: int64 widening to GMP, or GMP only."),
    OPTION(WORD, method, METHOD, "auto|fm|lp|hull|dd", "auto",
           "Elimination, exact simplex, projections by support queries or double description, or "
           "by size."),
    OPTION(WORD, order, ORDER, "pairs|given|min|fill", "pairs",
           "Which variable is eliminated next."),
    OPTION(TEXT, rules, NULL, "LIST|none", "kohler,chernikov,box,duplicate,lp",
           "Pruning rules, separated by commas."),
    OPTION(WORD, rebase, REBASE, "auto|always|never", "auto",
           "When other rules may interrupt history rules."),
    OPTION(TEXT, presolve, NULL, "LIST|none", "equalities,components,onesided,bounds,refute",
           "Steps before and beside the elimination, separated by commas."),
    OPTION(WORD, simd, SIMD, "auto|plain|avx2|avx512", "auto", "Instructions for the inner loops."),
    OPTION(FLAG, trace_rows, NULL, "true|false", "false", "Put every new row into the trace."),
    OPTION(WORD, evidence, EVIDENCE, "all|none|verdict|whole", "all",
           "Keep proofs of the answer, of its verdict only, or also that no row of a projection is "
           "missing."),
    OPTION(SECONDS, max_seconds, NULL, "SECONDS", "0", "Wall-clock limit of a query; 0 is none."),
    OPTION(COUNT, max_rows, NULL, "ROWS", "0", "Limit on live rows of an elimination; 0 is none."),
    OPTION(COUNT, max_bytes, NULL, "BYTES", "0",
           "Limit on workspace, evidence and result, in all; 0 is none."),
    OPTION(COUNT, threads, NULL, "THREADS", "0",
           "Threads for ends of a box, redundant rows, support queries and rays; 0 is one."),
    OPTION(WORD, symmetry, SYMMETRY, "auto|none", "auto",
           "Support queries for one facet of each orbit of given symmetries."),
};

const fmb_option_info *fmb_options_describe(size_t i)
{
    return i < sizeof TABLE / sizeof *TABLE ? &TABLE[i].info : NULL;
}

static const entry *find_option(const char *name)
{
    for (size_t i = 0; i < sizeof TABLE / sizeof *TABLE; i++)
        if (strcmp(TABLE[i].info.name, name) == 0)
            return &TABLE[i];
    return NULL;
}

const char *fmb_options_initial(const char *name)
{
    return find_option(name)->info.initial;
}

static fmb_status set_word_option(const entry *e, const char *value, void *field)
{
    for (int i = 0; e->words[i]; i++)
        if (strcmp(e->words[i], value) == 0) {
            *(int *)field = i;
            return FMB_OK;
        }
    return FMB_ERR_ARG;
}

/* Decimal digits only: no sign, no blanks. */
static fmb_status set_count_option(const char *value, size_t *field)
{
    size_t n = 0;
    if (!*value)
        return FMB_ERR_ARG;
    for (; *value; value++) {
        if (*value < '0' || *value > '9' || __builtin_mul_overflow(n, 10, &n) ||
            __builtin_add_overflow(n, (size_t)(*value - '0'), &n))
            return FMB_ERR_ARG;
    }
    *field = n;
    return FMB_OK;
}

/* Read the digits of "12.5e-3", independent of the locale: *value becomes 125, *unit 10. Returns
 * the text after them, or NULL if there are none. */
static const char *read_digits(const char *p, double *value, double *unit)
{
    bool point = false, digits = false;
    for (; (*p >= '0' && *p <= '9') || (*p == '.' && !point); p++) {
        point = point || *p == '.';
        digits = digits || *p != '.';
        *value = *p == '.' ? *value : *value * 10 + (*p - '0');
        *unit *= point && *p != '.' ? 10 : 1;
    }
    return digits ? p : NULL;
}

/* Read "e-3", with at most three digits, or an empty text. */
static bool read_exponent(const char *p, double *value, double *unit)
{
    if (*p == '\0')
        return true;
    if ((*p | 32) != 'e')
        return false;
    bool minus = p[1] == '-';
    p += minus || p[1] == '+' ? 2 : 1;
    size_t digits = strspn(p, "0123456789");
    for (long n = strtol(p, NULL, 10); digits > 0 && digits <= 3 && n > 0; n--)
        *(minus ? unit : value) *= 10;
    return digits > 0 && digits <= 3 && p[digits] == '\0';
}

/* A positive value never becomes 0, as 0 means no limit. */
static fmb_status set_seconds_option(const char *value, double *field)
{
    double number = 0, unit = 1;
    const char *rest = read_digits(value, &number, &unit);
    if (!rest || !read_exponent(rest, &number, &unit))
        return FMB_ERR_ARG;
    double seconds = number / unit;
    if (!(seconds <= 1e15) || (number > 0 && !(seconds > 0)))
        return FMB_ERR_ARG;
    *field = seconds;
    return FMB_OK;
}

static fmb_status set_flag_option(const char *value, bool *field)
{
    bool on = strcmp(value, "true") == 0;
    if (!on && strcmp(value, "false") != 0)
        return FMB_ERR_ARG;
    *field = on;
    return FMB_OK;
}

/* The offset of the end of an option's field. */
static size_t find_end_of_option(const entry *e)
{
    switch (e->kind) {
    case WORD:
        return e->offset + sizeof(int);
    case FLAG:
        return e->offset + sizeof(bool);
    case SECONDS:
        return e->offset + sizeof(double);
    case COUNT:
        return e->offset + sizeof(size_t);
    case TEXT:
        return e->offset + sizeof(const char *);
    }
    return SIZE_MAX;
}

fmb_status fmb_options_set(fmb_options *o, const char *name, const char *value)
{
    const entry *e = name ? find_option(name) : NULL;
    if (!e || !value || !o || o->size < find_end_of_option(e))
        return FMB_ERR_ARG;
    void *field = (char *)o + e->offset;
    switch (e->kind) {
    case WORD:
        return set_word_option(e, value, field);
    case FLAG:
        return set_flag_option(value, field);
    case SECONDS:
        return set_seconds_option(value, field);
    case COUNT:
        return set_count_option(value, field);
    case TEXT:
        *(const char **)field = value;
        return FMB_OK;
    }
    return FMB_ERR_ARG;
}

/* ---- values by name of a field --------------------------------------------------------------- */

static int count_words(const entry *e)
{
    int n = 0;
    while (e->words[n])
        n++;
    return n;
}

fmb_status fmb_options_expect(fmb_solver *v, const fmb_options *o)
{
    for (size_t i = 0; i < sizeof TABLE / sizeof *TABLE; i++) {
        const entry *e = &TABLE[i];
        const void *field = (const char *)o + e->offset;
        int word = e->kind == WORD ? *(const int *)field : 0;
        double seconds = e->kind == SECONDS ? *(const double *)field : 0;
        if (e->kind == WORD && (word < 0 || word >= count_words(e)))
            return fmb_solver_refuse(v, FMB_ERR_ARG, "%s is %d, which is none", e->info.name, word);
        if (!(seconds >= 0))
            return fmb_solver_refuse(v, FMB_ERR_ARG, "%s is %g", e->info.name, seconds);
    }
    return FMB_OK;
}
