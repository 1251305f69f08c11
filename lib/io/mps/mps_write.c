/* mps_write.c: a system as a linear program in free MPS.
 *
 * Every row of the system is a row, and every column is free, so reading the file gives the same
 * rows and no bounds. Fields are separated by tabs, which fixed form never has.
 */
#include <string.h>

#include "io/core/utf8.h"
#include "io/program/export.h"
#include "num/rationals.h"

/* Is the name one word that is no number, no comment, and no marker? */
static bool spells_mps(const char *name)
{
    size_t size = strlen(name), i = 0, n;
    while ((n = fmb_utf8_printable(name + i, size - i)) > 0 && name[i] != ' ')
        i += n;
    return size > 0 && i == size && !strchr("$*!+-.0123456789'\"", *name) &&
           strcmp(name, "RHS") != 0;
}

/* A place of the matrix: term `term` of row `row`; next: the next one of its column, from 1. */
typedef struct mps_entry {
    size_t row, term, next;
} mps_entry;

typedef struct mps_columns {
    size_t *first; /* [dim] place + 1, or 0 */
    mpq_t *scale;  /* [rows] factor by which each is written */
    mps_entry *entry;
    size_t entries, capacity;
} mps_columns;

/* From the last row to the first, so that each column gets its rows in order. The factor of each
 * row is computed once. */
static fmb_status sort_by_columns(fmb_export *e, mps_columns *m)
{
    mpq_ptr q = e->q;
    *m = (mps_columns){.first =
                           fmb_mem_zero(&e->mem, (size_t)fmb_system_dim(e->s), sizeof *m->first)};
    if (!m->first)
        return fmb_mem_status(&e->mem);
    FMB_TRY(fmb_rationals_new(&m->scale, fmb_system_rows(e->s), &e->mem));
    for (size_t i = fmb_system_rows(e->s); i-- > 0;) {
        size_t n = fmb_system_terms(e->s, i);
        fmb_export_scale(e, i);
        mpq_set(m->scale[i], e->scale);
        FMB_TRY(FMB_RESERVE(&e->mem, &m->entry, &m->capacity, m->entries + n));
        for (size_t k = 0; k < n; k++) {
            size_t *first = &m->first[fmb_system_term_q(e->s, i, k, q)];
            m->entry[m->entries] = (mps_entry){i, k, *first};
            *first = ++m->entries;
        }
    }
    return FMB_OK;
}

static void write_entry(fmb_export *e, const char *set, size_t row)
{
    fprintf(e->out, "\t%s\t%s\t", set, e->row.name[row]);
    fmb_export_print(e);
    fputc('\n', e->out);
}

static void write_mps_rows(fmb_export *e)
{
    size_t m = fmb_system_rows(e->s);
    if (fmb_system_sense(e->s) == FMB_SENSE_MAX)
        fputs("OBJSENSE\n\tMAX\n", e->out);
    fputs("ROWS\n", e->out);
    if (fmb_system_sense(e->s) != FMB_SENSE_NONE)
        fprintf(e->out, " N\t%s\n", e->row.name[m]);
    for (size_t i = 0; i < m; i++)
        fprintf(e->out, " %c\t%s\n", fmb_system_rel(e->s, i) == FMB_EQ ? 'E' : 'L', e->row.name[i]);
}

/* Write column j; *k: the next term of the objective. A column without entries gets a 0 in some
 * row, else the file would lack it. */
static void write_column(fmb_export *e, const mps_columns *m, int j, size_t *k)
{
    size_t rows = fmb_system_rows(e->s);
    const char *name = e->column.name[j];
    bool asked = fmb_system_objective_term_q(e->s, *k, e->q) == j;
    mpq_set_ui(e->scale, 1, 1);
    if (!asked)
        mpq_set_ui(e->q, 0, 1);
    if (asked || (m->first[j] == 0 && fmb_system_sense(e->s) != FMB_SENSE_NONE))
        write_entry(e, name, rows);
    else if (m->first[j] == 0)
        write_entry(e, name, 0);
    *k += asked;
    for (size_t at = m->first[j]; at > 0; at = m->entry[at - 1].next) {
        const mps_entry *t = &m->entry[at - 1];
        mpq_set(e->scale, m->scale[t->row]);
        fmb_system_term_q(e->s, t->row, t->term, e->q);
        write_entry(e, name, t->row);
    }
}

static void write_mps_columns(fmb_export *e, const mps_columns *m)
{
    bool between = false;
    size_t markers = 0, k = 0;
    fputs("COLUMNS\n", e->out);
    for (int j = 0; j <= fmb_system_dim(e->s); j++) {
        if (fmb_system_is_integer(e->s, j) != between) {
            between = !between;
            fprintf(e->out, "\tM%zu\t'MARKER'\t%s\n", ++markers, between ? "'INTORG'" : "'INTEND'");
        }
        if (j < fmb_system_dim(e->s))
            write_column(e, m, j, &k);
    }
}

/* The right side of the objective is minus its constant. */
static void write_right_sides(fmb_export *e, const mps_columns *m)
{
    size_t rows = fmb_system_rows(e->s);
    fputs("RHS\n", e->out);
    fmb_system_objective_constant_q(e->s, e->q);
    mpq_neg(e->q, e->q);
    mpq_set_ui(e->scale, 1, 1);
    if (mpq_sgn(e->q) != 0)
        write_entry(e, "RHS", rows);
    for (size_t i = 0; i < rows; i++) {
        mpq_set(e->scale, m->scale[i]);
        fmb_system_rhs_q(e->s, i, e->q);
        if (mpq_sgn(e->q) != 0)
            write_entry(e, "RHS", i);
    }
}

fmb_status fmb_write_mps(const fmb_system *s, FILE *out)
{
    fmb_export e;
    mps_columns m = {0};
    fmb_status st = fmb_export_open(&e, s, spells_mps, out);
    if (st == FMB_OK && fmb_system_rows(s) == 0 && fmb_system_sense(s) == FMB_SENSE_NONE)
        st = FMB_ERR_ARG;
    FMB_THEN(st, sort_by_columns(&e, &m));
    if (st == FMB_OK) {
        fputs("NAME\n", out);
        write_mps_rows(&e);
        write_mps_columns(&e, &m);
        write_right_sides(&e, &m);
        fputs("BOUNDS\n", out);
        for (int j = 0; j < fmb_system_dim(s); j++)
            fprintf(out, " FR\tBND\t%s\n", e.column.name[j]);
        fputs("ENDATA\n", out);
    }
    fmb_mem_put(&e.mem, m.first, (size_t)fmb_system_dim(s), sizeof *m.first);
    fmb_mem_put(&e.mem, m.entry, m.capacity, sizeof *m.entry);
    fmb_rationals_free(m.scale, fmb_system_rows(s), &e.mem);
    fmb_export_close(&e);
    return st;
}
