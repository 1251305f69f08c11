/* load.c: the time to add 20,000 rows at once, and to read them back. See README.md. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <fmb/fmb.h>

#include "machine.h"

enum { ROWS = 20000, DIM = 500, TERMS = 5, PASSES = 25 };

/* All matrices are built first; a pass uses each once. */
typedef struct matrix {
    const char *name;
    size_t start[ROWS + 1];
    int var[ROWS * TERMS];
    double coef[ROWS * TERMS], b[ROWS];
    int64_t whole[ROWS * TERMS], right[ROWS];
    double in[PASSES], out[PASSES];
} matrix;

enum { INTEGERS, WHOLE, BINARY, DECIMAL, WIDE, KINDS };

static const char *const NAME[KINDS] = {
    [INTEGERS] = "int64",
    [WHOLE] = "whole doubles",
    [BINARY] = "doubles, 10 binary places",
    [DECIMAL] = "doubles, 2 decimal places",
    [WIDE] = "doubles of any size",
};

static void must_be_ok(fmb_status st)
{
    if (st == FMB_OK)
        return;
    fprintf(stderr, "bench-load: %s\n", fmb_status_text(st));
    exit(70);
}

static double number_of_kind(int kind, int64_t z)
{
    return kind == BINARY    ? ldexp((double)z, -10)
           : kind == DECIMAL ? (double)z / 100
           : kind == WIDE    ? ldexp((double)z, (int)(z % 120) - 60)
                             : (double)z;
}

static void fill(matrix *m, int kind)
{
    uint64_t state = (uint64_t)kind;
    m->name = NAME[kind];
    for (size_t i = 0; i < ROWS; i++) {
        m->start[i + 1] = m->start[i] + TERMS;
        for (size_t k = i * TERMS; k < m->start[i + 1]; k++) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            m->var[k] = (int)((k % TERMS) * (DIM / TERMS) + (state >> 33) % (DIM / TERMS));
            m->whole[k] = (int64_t)(state >> 48) + 1;
            m->coef[k] = number_of_kind(kind, m->whole[k]);
        }
        m->right[i] = (int64_t)(state >> 44);
        m->b[i] = number_of_kind(kind, m->right[i]);
    }
}

static void load(const matrix *m, int kind, fmb_system *s)
{
    must_be_ok(kind == INTEGERS
                   ? fmb_system_add_rows_int(s, ROWS, m->start, m->var, m->whole, NULL, m->right)
                   : fmb_system_add_rows(s, ROWS, m->start, m->var, m->coef, NULL, m->b));
}

static void measure(matrix *m, int kind, int pass)
{
    static size_t start[ROWS + 1];
    static int var[ROWS * TERMS];
    static double coef[ROWS * TERMS], b[ROWS];
    fmb_system *s = NULL;
    must_be_ok(fmb_system_new(DIM, NULL, &s));
    double begin = thread_seconds();
    load(m, kind, s);
    m->in[pass] = thread_seconds() - begin;
    begin = thread_seconds();
    must_be_ok(fmb_system_get_rows(s, 0, ROWS, start, var, coef, NULL, b));
    m->out[pass] = thread_seconds() - begin;
    fmb_system_free(s);
}

int main(void)
{
    static matrix m[KINDS];
    for (int kind = 0; kind < KINDS; kind++)
        fill(&m[kind], kind);
    for (int pass = -1; pass < PASSES; pass++)
        for (int kind = 0; kind < KINDS; kind++)
            measure(&m[kind], kind, pass < 0 ? 0 : pass);
    printf("%d rows of %d terms, %d variables\n", ROWS, TERMS, DIM);
    for (int kind = 0; kind < KINDS; kind++)
        printf("  %-26s in %6.2f ms   out as doubles %6.2f ms\n", m[kind].name,
               1e3 * median(m[kind].in, PASSES), 1e3 * median(m[kind].out, PASSES));
    return 0;
}
