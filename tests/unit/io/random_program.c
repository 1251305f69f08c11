/* random_program.c: see random_program.h. */
#include "random_program.h"

#include "support/support.h"

typedef struct writer {
    support_rng g;
    FILE *out;
    program_form form;
    int rows, columns;
    char type[9];
} writer;

static int below(writer *w, int n)
{
    return support_between(&w->g, 0, n - 1);
}

/* Names are told apart by their numbers; those of fixed form may have a blank inside. */
static const char *name_of(writer *w, char kind, int i)
{
    static char buf[4][24];
    static int turn;
    static const char *const shapes[] = {"%c%d", "%c%d_x", "%c(%d)", "%c#%d", "%c %d"};
    char *to = buf[turn++ % 4];
    snprintf(to, 24, shapes[i % (w->form == MPS_FIXED ? 5 : 4)], kind, i);
    return to;
}

/* A multiple of 1/8, so that sums are exact in doubles, spelled some way. */
static const char *number_of(writer *w)
{
    static const char *const shapes[] = {"%g", "%.3f", "%.4e", "%+g"};
    static char buf[4][24];
    static int turn;
    char *to = buf[turn++ % 4];
    double d = (below(w, 161) - 80) / 8.0;
    snprintf(to, 24, shapes[w->form == LP ? 0 : below(w, 4)], d == 0 ? 1.0 : d);
    return to;
}

/* A line of data: kind, name, and up to two pairs of name and number. */
static void put_card(writer *w, const char *kind, const char *name, const char *row,
                     const char *number)
{
    if (w->form == MPS_FIXED)
        fprintf(w->out,
                number ? " %-2s %-8s  %-8s  %12s\n"
                : row  ? " %-2s %-8s  %s\n"
                       : " %-2s %s\n",
                kind, name, row, number);
    else
        fprintf(w->out, " %s %s %s %s\n", kind, name, row ? row : "", number ? number : "");
}

static void write_mps_bounds(writer *w)
{
    static const char *const kinds[] = {"UP", "LO", "FX", "FR", "MI", "PL", "BV", "LI", "UI"};
    fputs("BOUNDS\n", w->out);
    for (int j = 0; j < w->columns; j++) {
        int k = below(w, 12);
        char whole[16];
        snprintf(whole, sizeof whole, "%d", below(w, 9));
        if (k < 9)
            put_card(w, kinds[k], "BND", name_of(w, 'x', j),
                     k < 3   ? number_of(w)
                     : k > 6 ? whole
                             : NULL);
        if (k == 1 && below(w, 2))
            put_card(w, "UP", "BND", name_of(w, 'x', j), "90.5");
    }
}

static void write_mps(writer *w)
{
    fputs("NAME          RANDOM\nROWS\n N  cost\n", w->out);
    for (int i = 0; i < w->rows; i++) {
        w->type[i] = "LGEN"[below(w, 4)];
        put_card(w, (char[]){w->type[i], 0}, name_of(w, 'r', i), NULL, NULL);
    }
    fputs("COLUMNS\n", w->out);
    bool integer = false;
    for (int j = 0; j < w->columns; j++) {
        if (below(w, 4) == 0) {
            integer = !integer;
            fprintf(w->out, "    M%-8d %-8s                 '%s'\n", j, "'MARKER'",
                    integer ? "INTORG" : "INTEND");
        }
        put_card(w, "", name_of(w, 'x', j), "cost", number_of(w));
        for (int i = 0; i < w->rows; i++)
            if (below(w, 3) > 0)
                put_card(w, "", name_of(w, 'x', j), name_of(w, 'r', i), number_of(w));
        if (below(w, 5) == 0)
            fputs("* a comment\n", w->out);
    }
    fputs("RHS\n", w->out);
    for (int i = 0; i < w->rows; i++)
        if (below(w, 3) > 0)
            put_card(w, "", "RHS", name_of(w, 'r', i), number_of(w));
    if (below(w, 3) == 0)
        put_card(w, "", "RHS", "cost", number_of(w));
    fputs("RANGES\n", w->out);
    for (int i = 0; i < w->rows; i++)
        if (below(w, 3) == 0 && w->type[i] != 'N')
            put_card(w, "", "RNG", name_of(w, 'r', i), number_of(w));
    write_mps_bounds(w);
    fputs("ENDATA\n", w->out);
}

static void write_lp_sum(writer *w)
{
    fprintf(w->out, "%s %s", number_of(w), name_of(w, 'x', 0));
    for (int j = 1; j < w->columns; j++)
        if (below(w, 3) > 0)
            fprintf(w->out, "%s %c %g %s", below(w, 4) == 0 ? "\n  " : "", below(w, 2) ? '+' : '-',
                    below(w, 80) / 8.0, name_of(w, 'x', j));
}

static void write_lp_bounds(writer *w)
{
    fputs("Bounds\n", w->out);
    for (int j = 0; j < w->columns; j++) {
        const char *x = name_of(w, 'x', j), *d = number_of(w);
        switch (below(w, 7)) {
        case 0:
            fprintf(w->out, " %s <= %s\n", x, d);
            break;
        case 1:
            fprintf(w->out, " %s >= %s\n", x, d);
            break;
        case 2:
            fprintf(w->out, " %s <= %s <= 100\n", d, x);
            break;
        case 3:
            fprintf(w->out, " %s free\n", x);
            break;
        case 4:
            fprintf(w->out, " -inf <= %s <= %s\n", x, d);
            break;
        case 5:
            fprintf(w->out, " %s = %s\n", x, d);
            break;
        }
    }
}

static void write_lp(writer *w)
{
    static const char *const relations[] = {"<=", ">=", "=", "<", ">", "=<", "=>"};
    static const char *const heads[] = {"Subject To", "st", "such that", "s.t."};
    fputs(below(w, 2) ? "Maximize\n cost: " : "minimum\n ", w->out);
    write_lp_sum(w);
    fprintf(w->out, "\n%s\n", heads[below(w, 4)]);
    for (int i = 0; i < w->rows; i++) {
        fputs(" ", w->out);
        if (below(w, 4) > 0)
            fprintf(w->out, "%s: ", name_of(w, 'r', i));
        write_lp_sum(w);
        fprintf(w->out, " %s %s%s\n", relations[below(w, 7)], number_of(w),
                below(w, 5) == 0 ? " \\ a comment" : "");
    }
    write_lp_bounds(w);
    fputs("General\n", w->out);
    for (int j = 0; j < w->columns; j++)
        if (below(w, 4) == 0)
            fprintf(w->out, " %s\n", name_of(w, 'x', j));
    fputs("End\n", w->out);
}

char *random_program(uint64_t seed, program_form form, size_t *size)
{
    char *text = NULL;
    writer w = {.g = {seed}, .out = open_memstream(&text, size), .form = form};
    w.rows = 1 + below(&w, 8);
    w.columns = 1 + below(&w, 8);
    if (form == LP)
        write_lp(&w);
    else
        write_mps(&w);
    fclose(w.out);
    return text;
}
