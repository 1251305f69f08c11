/* ine_generators.c: V-representations of cddlib and lrslib: (1, x) is a vertex, (0, x) a ray, and a
 * row of the linearity line a line. They are read as rows -x.y <= 1 or 0, and then converted to
 * generators.
 */
#include <fmb/gmp.h>

#include "base/memory_stream.h"
#include "io/core/stream.h"
#include "io/ine/ine.h"
#include "num/rationals.h"

/* ---- reading --------------------------------------------------------------------------------- */

static fmb_status add_generator_of_row(const fmb_system *s, size_t i, mpq_t *x, fmb_generators *g)
{
    mpq_t t;
    for (int j = 0; j < fmb_system_dim(s); j++)
        mpq_set_ui(x[j], 0, 1);
    mpq_init(t);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int j = fmb_system_term_q(s, i, k, t);
        mpq_neg(x[j], t);
    }
    fmb_system_rhs_q(s, i, t);
    fmb_generator_kind kind = fmb_system_rel(s, i) == FMB_EQ ? FMB_LINE
                              : mpq_sgn(t) == 0              ? FMB_RAY
                                                             : FMB_VERTEX;
    mpq_clear(t);
    return fmb_generators_add_q(g, kind, x);
}

static fmb_status turn_rows_to_generators(fmb_cursor *c, const fmb_system *s, fmb_generators *g)
{
    mpq_t *x;
    size_t dim = (size_t)fmb_system_dim(s);
    fmb_status st = fmb_rationals_new(&x, dim, c->mem);
    if (st != FMB_OK)
        return st;
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++)
        st = add_generator_of_row(s, i, x, g);
    fmb_rationals_free(x, dim, c->mem);
    return st;
}

static fmb_status parse_generators(fmb_cursor *c, void *out)
{
    const fmb_alloc *hook = c->how->mem;
    fmb_system *s = NULL;
    fmb_generators *g = NULL;
    fmb_status st = fmb_io_check(c);
    FMB_THEN(st, fmb_system_new(0, hook, &s));
    FMB_THEN(st, fmb_ine_read(&(fmb_ine){.c = c, .s = s, .generators = true}));
    FMB_THEN(st, fmb_generators_new(fmb_system_dim(s), hook, &g));
    FMB_THEN(st, turn_rows_to_generators(c, s, g));
    fmb_system_free(s);
    if (st == FMB_OK)
        *(fmb_generators **)out = g;
    else
        fmb_generators_free(g);
    return st;
}

fmb_status fmb_generators_parse(const char *text, size_t size, const fmb_reader *how,
                                fmb_generators **out, fmb_where *where)
{
    return out ? fmb_parse_memory(text, size, how, parse_generators, out, where)
               : fmb_io_refuse_argument(where, "out is NULL");
}

fmb_status fmb_generators_read(FILE *in, const fmb_reader *how, fmb_generators **out,
                               fmb_where *where)
{
    return out ? fmb_parse_stream(in, how, parse_generators, out, where)
               : fmb_io_refuse_argument(where, "out is NULL");
}

/* ---- writing --------------------------------------------------------------------------------- */

static void write_linearity_line(const fmb_generators *g, FILE *out)
{
    size_t lines = 0;
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        lines += fmb_generators_kind(g, i) == FMB_LINE;
    if (lines == 0)
        return;
    fprintf(out, "linearity %zu", lines);
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        if (fmb_generators_kind(g, i) == FMB_LINE)
            fprintf(out, " %zu", i + 1);
    fputc('\n', out);
}

static bool are_all_coordinates_integer(const fmb_generators *g, mpq_t q)
{
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        for (int j = 0; j < fmb_generators_dim(g); j++) {
            fmb_generators_coordinate_q(g, i, j, q);
            if (mpz_cmp_ui(mpq_denref(q), 1) != 0)
                return false;
        }
    return true;
}

fmb_status fmb_generators_write(const fmb_generators *g, FILE *out)
{
    mpq_t q;
    if (!g || !out)
        return FMB_ERR_ARG;
    mpq_init(q);
    fputs("V-representation\n", out);
    write_linearity_line(g, out);
    fprintf(out, "begin\n%zu %d %s\n", fmb_generators_size(g), fmb_generators_dim(g) + 1,
            are_all_coordinates_integer(g, q) ? "integer" : "rational");
    for (size_t i = 0; i < fmb_generators_size(g); i++) {
        fputc(fmb_generators_kind(g, i) == FMB_VERTEX ? '1' : '0', out);
        for (int j = 0; j < fmb_generators_dim(g); j++) {
            fmb_generators_coordinate_q(g, i, j, q);
            fputc(' ', out);
            fmb_print_q(out, q);
        }
        fputc('\n', out);
    }
    fputs("end\n", out);
    mpq_clear(q);
    return fflush(out) != 0 || ferror(out) ? FMB_ERR_IO : FMB_OK;
}

static fmb_status write_these_generators(const void *self, FILE *out)
{
    return fmb_generators_write(self, out);
}

fmb_status fmb_generators_print(const fmb_generators *g, char *text, size_t size, size_t *length)
{
    return fmb_memory_print(write_these_generators, g, text, size, length);
}
