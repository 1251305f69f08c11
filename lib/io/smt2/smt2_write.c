/* smt2_write.c: a system as an SMT-LIB 2 script over QF_LRA, or QF_LIRA where it has integers.
 *
 * Names that SMT-LIB cannot spell (empty, with '|' or '\', or meaning something already) become
 * x<number>; labels that it cannot spell, or that are taken, are left out. The rows stay the same.
 */
#include <stdio.h>
#include <string.h>

#include "io/core/cursor.h"
#include "io/core/utf8.h"
#include "io/smt2/term.h"
#include "system/names.h"
#include "system/system_private.h"

typedef struct writer {
    const fmb_system *s;
    FILE *out;
    fmb_mem mem;
    fmb_names taken; /* names of variables and labels written so far */
    mpq_t q;         /* scratch */
} writer;

/* Symbols that no script may declare. */
static bool is_known_symbol(const char *name)
{
    const fmb_smt_operator *op;
    for (size_t i = 0; (op = fmb_smt_operator_at(i)) != NULL; i++)
        if (strcmp(op->name, name) == 0)
            return true;
    return strcmp(name, "true") == 0 || strcmp(name, "false") == 0;
}

static bool can_spell_symbol(const char *name)
{
    size_t size = strlen(name), i = 0, n;
    while ((n = fmb_utf8_printable(name + i, size - i)) > 0 && !strchr("|\\", name[i]))
        i += n;
    return size > 0 && i == size && !is_known_symbol(name);
}

/* Words of the language need bars, and so do names with other bytes than a symbol has. */
static bool symbol_needs_bars(const char *name)
{
    static const char *const reserved[] = {"!",       "_",      "as",          "BINARY", "DECIMAL",
                                           "exists",  "forall", "HEXADECIMAL", "let",    "match",
                                           "NUMERAL", "par",    "STRING"};
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (strcmp(reserved[i], name) == 0)
            return true;
    size_t i = 0;
    while (fmb_smt_is_plain((unsigned char)name[i]))
        i++;
    return name[i] != '\0' || fmb_is_digit(name[0]);
}

static void write_smt_symbol(const char *name, FILE *out)
{
    fprintf(out, symbol_needs_bars(name) ? "|%s|" : "%s", name);
}

#define SPELLING 64

/* How variable j is spelled: its name, or x<number> with underscores while that is taken. */
static const char *spelling_of_variable(const fmb_system *s, int j, char buf[SPELLING])
{
    const char *name = fmb_system_name(s, j);
    if (can_spell_symbol(name))
        return name;
    int n = snprintf(buf, SPELLING, "x%d", j + 1);
    while (fmb_system_find(s, buf) >= 0 && n < SPELLING - 1) {
        buf[n++] = '_';
        buf[n] = '\0';
    }
    return buf;
}

static void write_variable_symbol(const writer *w, int j)
{
    char buf[SPELLING];
    write_smt_symbol(spelling_of_variable(w->s, j, buf), w->out);
}

/* 3, (- 3), (/ 1 3), (- (/ 1 3)) */
static void write_smt_rational(writer *w)
{
    bool minus = mpq_sgn(w->q) < 0, whole = mpz_cmp_ui(mpq_denref(w->q), 1) == 0;
    fputs(minus ? "(- " : "", w->out);
    mpz_abs(mpq_numref(w->q), mpq_numref(w->q));
    fputs(whole ? "" : "(/ ", w->out);
    mpz_out_str(w->out, 10, mpq_numref(w->q));
    if (!whole) {
        fputc(' ', w->out);
        mpz_out_str(w->out, 10, mpq_denref(w->q));
        fputc(')', w->out);
    }
    fputs(minus ? ")" : "", w->out);
}

/* w->q times variable j */
static void write_product_term(writer *w, int j)
{
    bool plain = mpq_cmp_si(w->q, 1, 1) == 0, minus = mpq_cmp_si(w->q, -1, 1) == 0;
    if (minus) {
        fputs("(- ", w->out);
    } else if (!plain) {
        fputs("(* ", w->out);
        write_smt_rational(w);
        fputc(' ', w->out);
    }
    bool integer = fmb_system_is_integer(w->s, j);
    fputs(integer ? "(to_real " : "", w->out);
    write_variable_symbol(w, j);
    fputs(integer ? ")" : "", w->out);
    fputs(plain ? "" : ")", w->out);
}

static void write_constraint(writer *w, size_t i)
{
    static const char *const rel[] = {[FMB_LE] = "(<= ", [FMB_LT] = "(< ", [FMB_EQ] = "(= "};
    size_t n = fmb_system_terms(w->s, i);
    fputs(rel[fmb_system_rel(w->s, i)], w->out);
    fputs(n > 1 ? "(+" : n == 0 ? "0" : "", w->out);
    for (size_t k = 0; k < n; k++) {
        fputs(n > 1 ? " " : "", w->out);
        int j = fmb_system_term_q(w->s, i, k, w->q);
        write_product_term(w, j);
    }
    fputs(n > 1 ? ") " : " ", w->out);
    fmb_system_rhs_q(w->s, i, w->q);
    write_smt_rational(w);
    fputc(')', w->out);
}

/* Z3 and OptiMathSAT know these commands. */
static void write_objective_command(writer *w)
{
    size_t n = fmb_system_objective_terms(w->s);
    fmb_system_objective_constant_q(w->s, w->q);
    bool constant = n == 0 || mpq_sgn(w->q) != 0, sum = n + constant > 1;
    fputs(fmb_system_sense(w->s) == FMB_SENSE_MAX ? "(maximize" : "(minimize", w->out);
    fputs(sum ? " (+" : "", w->out);
    for (size_t k = 0; k < n; k++) {
        int j = fmb_system_objective_term_q(w->s, k, w->q);
        fputc(' ', w->out);
        write_product_term(w, j);
    }
    if (constant) {
        fmb_system_objective_constant_q(w->s, w->q);
        fputc(' ', w->out);
        write_smt_rational(w);
    }
    fputs(sum ? "))\n" : ")\n", w->out);
}

static fmb_status write_assertion(writer *w, size_t i)
{
    const char *label = fmb_system_label(w->s, i);
    bool named = label && can_spell_symbol(label) && fmb_names_find(&w->taken, label) < 0;
    if (named)
        FMB_TRY(fmb_names_add(&w->taken, label, &w->mem));
    fputs(named ? "(assert (! " : "(assert ", w->out);
    write_constraint(w, i);
    if (named) {
        fputs(" :named ", w->out);
        write_smt_symbol(label, w->out);
        fputc(')', w->out);
    }
    fputs(")\n", w->out);
    return FMB_OK;
}

static fmb_status write_declaration(writer *w, int j)
{
    char buf[SPELLING];
    fputs("(declare-fun ", w->out);
    write_variable_symbol(w, j);
    fputs(fmb_system_is_integer(w->s, j) ? " () Int)\n" : " () Real)\n", w->out);
    return fmb_names_add(&w->taken, spelling_of_variable(w->s, j, buf), &w->mem);
}

fmb_status fmb_write_smt2(const fmb_system *s, FILE *out)
{
    writer w = {.s = s, .out = out};
    fmb_status st = FMB_OK;
    fmb_mem_init(&w.mem, &s->mem.alloc, 0);
    mpq_init(w.q);
    fputs(fmb_system_first_integer(s) >= 0 ? "(set-logic QF_LIRA)\n" : "(set-logic QF_LRA)\n", out);
    for (int j = 0; st == FMB_OK && j < fmb_system_dim(s); j++)
        st = write_declaration(&w, j);
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++)
        st = write_assertion(&w, i);
    if (fmb_system_dim(s) == 0 && fmb_system_rows(s) == 0)
        fputs("(assert (<= 0 0))\n", out); /* a script without assertions is no system */
    if (st == FMB_OK && fmb_system_sense(s) != FMB_SENSE_NONE)
        write_objective_command(&w);
    if (st == FMB_OK)
        fputs("(check-sat)\n", out);
    fmb_names_clear(&w.taken, &w.mem);
    mpq_clear(w.q);
    return st;
}
