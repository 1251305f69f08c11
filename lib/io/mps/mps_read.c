/* mps_read.c: linear programs in MPS.
 *
 * A file gives its matrix by columns, so each row grows until the end. Where
 * programs differ this is as GLPK has it: an upper bound below 0 leaves the lower one at 0, and an
 * integer column without any bound ends at 1. Of several sets of right sides, ranges or
 * bounds the first counts.
 *
 * Sources: as in card.h.
 */
#include <string.h>

#include "io/mps/card.h"
#include "io/program/program_draft.h"

#define MPS_NUMBER (FMB_NUM_SIGN | FMB_NUM_DECIMAL | FMB_NUM_EXPONENT | FMB_NUM_FORTRAN)

/* Numbers are kept as text, already checked, until their row is assembled. */
typedef struct mps_term {
    int variable;
    fmb_span number;
} mps_term;

typedef struct mps_row {
    char type;                 /* N, L, G, E */
    fmb_span name, rhs, range; /* numbers; n 0: none */
    mps_term *term;
    size_t terms, capacity;
} mps_row;

typedef struct mps_reader {
    fmb_program_draft program;
    fmb_cursor *c;
    fmb_cursor text; /* all of it */
    fmb_mps_section section;
    bool knows_form, fixed; /* fixed, once that is known */
    bool between_markers, has_columns;
    mps_row *row;
    size_t rows, row_capacity;
    fmb_draft draft; /* scratch: a row */
    fmb_span column; /* the last one */
    int variable;
    fmb_sense sense;
    fmb_span objective;           /* the name that OBJNAME gives; n 0: none */
    fmb_span set[FMB_MPS_ENDATA]; /* the first of each section; p NULL: none so far */
    bool warned_set[FMB_MPS_ENDATA];
    mpq_t number, low, high; /* scratch */
} mps_reader;

static fmb_status fail_field(mps_reader *m, fmb_span field, const char *what)
{
    return fmb_io_expected(m->c, field.p, "%s", what);
}

static fmb_cursor cursor_at_field(const mps_reader *m, fmb_span field)
{
    fmb_cursor at = *m->c;
    at.at = field.p;
    at.end = field.p + field.n;
    return at;
}

/* The whole field as a number. */
static fmb_status read_field_number(mps_reader *m, fmb_span field)
{
    fmb_cursor at = cursor_at_field(m, field);
    if (field.n == 0)
        return fail_field(m, field, "a number");
    fmb_status st = fmb_scan_number(&at, MPS_NUMBER, "a number", m->number);
    m->c->budget = at.budget;
    return st == FMB_OK && at.at < at.end ? fail_field(m, field, "a number") : st;
}

/* Read a number again that was read, and charged, before. */
static fmb_status read_number_again(const mps_reader *m, fmb_span field, mpq_t out)
{
    fmb_cursor at = cursor_at_field(m, field);
    at.budget = SIZE_MAX;
    return fmb_scan_number(&at, MPS_NUMBER, "a number", out);
}

/* Does the set named on this line count? */
static bool is_first_set(mps_reader *m, fmb_span name)
{
    fmb_span *first = &m->set[m->section];
    if (!first->p)
        *first = name;
    if (first->n == name.n && memcmp(first->p, name.p, name.n) == 0)
        return true;
    if (!m->warned_set[m->section])
        fmb_io_warn(m->c, name.p, "ignored: another set than the first of its section");
    m->warned_set[m->section] = true;
    return false;
}

/* ---- rows, columns, right sides, ranges ------------------------------------------------------ */

static fmb_status read_row(mps_reader *m, const fmb_mps_card *card)
{
    const fmb_span *f = card->field;
    const char *known = f[0].n == 1 ? strchr("NLGEnlge", *f[0].p) : NULL;
    if (!known)
        return fail_field(m, f[0], "a type of row: N, L, G or E");
    if (f[1].n == 0 || f[2].n > 0)
        return fail_field(m, f[1].n == 0 ? f[1] : f[2], "one name of a row");
    size_t i;
    FMB_TRY(fmb_program_row(&m->program, f[1], true, &i));
    FMB_TRY(FMB_RESERVE(m->c->mem, &m->row, &m->row_capacity, i + 1));
    m->row[i] = (mps_row){.type = (char)(*known & ~32), .name = f[1]};
    m->rows++;
    return FMB_OK;
}

static fmb_status add_coefficient(mps_reader *m, mps_row *r, fmb_span row, fmb_span number)
{
    if (r->terms > 0 && r->term[r->terms - 1].variable == m->variable)
        return fail_field(m, row, "one coefficient of a column in each row");
    FMB_TRY(FMB_RESERVE(m->c->mem, &r->term, &r->capacity, r->terms + 1));
    r->term[r->terms++] = (mps_term){m->variable, number};
    return FMB_OK;
}

/* A row and its number: a coefficient, a right side or a range. */
static fmb_status read_entry(mps_reader *m, fmb_span set, fmb_span row, fmb_span number)
{
    size_t i = 0;
    FMB_TRY(fmb_program_row(&m->program, row, false, &i));
    FMB_TRY(read_field_number(m, number));
    mps_row *r = &m->row[i];
    if (m->section == FMB_MPS_COLUMNS)
        return add_coefficient(m, r, row, number);
    if (!is_first_set(m, set))
        return FMB_OK;
    fmb_span *to = m->section == FMB_MPS_RHS ? &r->rhs : &r->range;
    if (to->n > 0)
        return fail_field(m, row, "one number for each row");
    *to = number;
    return FMB_OK;
}

static fmb_status read_entries(mps_reader *m, const fmb_mps_card *card)
{
    const fmb_span *f = card->field;
    FMB_TRY(read_entry(m, f[1], f[2], f[3]));
    return f[4].n + f[5].n > 0 ? read_entry(m, f[1], f[4], f[5]) : FMB_OK;
}

static fmb_status read_marker(mps_reader *m, fmb_span kind)
{
    m->between_markers = fmb_span_is_nocase(kind, "'INTORG'");
    return m->between_markers || fmb_span_is_nocase(kind, "'INTEND'")
               ? FMB_OK
               : fail_field(m, kind, "'INTORG' or 'INTEND'");
}

static fmb_status read_column(mps_reader *m, const fmb_mps_card *card)
{
    fmb_span name = card->field[1];
    fmb_status st = FMB_OK;
    if (name.n == 0)
        return fail_field(m, name, "the name of a column");
    if (name.n != m->column.n || memcmp(name.p, m->column.p, name.n) != 0) {
        size_t before = m->program.ends;
        st = fmb_program_variable(&m->program, name, &m->variable);
        if (st == FMB_OK && m->program.ends == before)
            st = fail_field(m, name, "all lines of a column together");
        if (st == FMB_OK && m->between_markers)
            st = fmb_system_set_integer(m->program.s, m->variable, true);
        m->column = name;
    }
    return st == FMB_OK ? read_entries(m, card) : st;
}

/* Assemble terms and right side of a row in the draft. */
static fmb_status put_row_together(mps_reader *m, const mps_row *r)
{
    fmb_draft_reset(&m->draft);
    for (size_t k = 0; k < r->terms; k++) {
        mpq_ptr slot;
        FMB_TRY(fmb_draft_term(&m->draft, r->term[k].variable, &slot));
        FMB_TRY(read_number_again(m, r->term[k].number, slot));
    }
    return r->rhs.n > 0 ? read_number_again(m, r->rhs, m->draft.rhs) : FMB_OK;
}

/* The ends of a row are its right side, and with a range R: rhs - |R| and rhs (L), rhs and rhs +
 * |R| (G), rhs and rhs + R (E). An infinite range is none, and opens one side of an equation. */
static fmb_status append_mps_row(mps_reader *m, mps_row *r)
{
    bool has_range = r->range.n > 0, down = r->type == 'L', open = false;
    fmb_program_draft *p = &m->program;
    FMB_TRY(put_row_together(m, r));
    if (has_range)
        FMB_TRY(read_field_number(m, r->range));
    mpq_set(m->low, m->draft.rhs);
    mpq_set(m->high, m->draft.rhs);
    if (has_range) {
        down = down || (r->type == 'E' && mpq_sgn(m->number) < 0);
        mpq_abs(m->number, m->number);
        open = fmb_program_is_infinite(p, r->range.p, m->number, FMB_PROGRAM_HIGH);
        if (down)
            mpq_sub(m->low, m->low, m->number);
        else
            mpq_add(m->high, m->high, m->number);
    }
    bool has_low = !(open && down) && (r->type != 'L' || has_range);
    bool has_high = !(open && !down) && (r->type != 'G' || has_range);
    if (r->type != 'E') {
        has_low = has_low && !fmb_program_is_infinite(p, r->name.p, m->low, FMB_PROGRAM_LOW);
        has_high = has_high && !fmb_program_is_infinite(p, r->name.p, m->high, FMB_PROGRAM_HIGH);
    }
    return fmb_program_append(p, r->name.p, &m->draft, has_low ? m->low : NULL,
                              has_high ? m->high : NULL, r->name);
}

static fmb_status append_mps_rows(mps_reader *m)
{
    for (size_t i = 0; i < m->rows; i++)
        if (m->row[i].type != 'N')
            FMB_TRY(append_mps_row(m, &m->row[i]));
    return FMB_OK;
}

static bool is_named_objective(const mps_reader *m, const mps_row *r)
{
    return m->objective.n == 0 ||
           (m->objective.n == r->name.n && memcmp(m->objective.p, r->name.p, r->name.n) == 0);
}

/* The objective is the row of type N that OBJNAME names, else the first one; others of that type
 * bound nothing. Its right side is minus its constant. */
static fmb_status set_mps_objective(mps_reader *m)
{
    for (size_t i = 0; i < m->rows; i++) {
        const mps_row *r = &m->row[i];
        if (r->type != 'N' || !is_named_objective(m, r))
            continue;
        FMB_TRY(put_row_together(m, r));
        return fmb_draft_set_objective(m->c, r->name.p, &m->draft, m->sense, m->program.s);
    }
    return m->objective.n > 0 ? fail_field(m, m->objective, "the name of a row of type N") : FMB_OK;
}

/* ---- bounds ---------------------------------------------------------------------------------- */

/* The effect of a kind of bound on each end: 'n' the number, 'i' infinity, a digit, 0 none. */
typedef struct mps_bound_kind {
    const char *word;
    char end[2];
    bool integer; /* it makes the column integer */
} mps_bound_kind;

static const mps_bound_kind *bound_kind_of(fmb_span word)
{
    static const mps_bound_kind kinds[] = {
        {"LO", {'n', 0}, false},   {"UP", {0, 'n'}, false}, {"FX", {'n', 'n'}, false},
        {"FR", {'i', 'i'}, false}, {"MI", {'i', 0}, false}, {"PL", {0, 'i'}, false},
        {"BV", {'0', '1'}, true},  {"LI", {'n', 0}, true},  {"UI", {0, 'n'}, true},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (fmb_span_is_nocase(word, kinds[i].word))
            return &kinds[i];
    return NULL;
}

/* The ends of variable j by a kind of bound with its number in m->number. */
static fmb_status set_mps_bound(mps_reader *m, const mps_bound_kind *kind, int j, fmb_span column)
{
    bool fixes = kind->end[0] == 'n' && kind->end[1] == 'n';
    for (int end = 0; end < 2; end++) {
        char what = kind->end[end];
        if (what && m->program.end[j][end].at)
            return fail_field(m, column, "one bound of each side of a column");
        if (what == '0' || what == '1')
            mpq_set_ui(m->number, (unsigned)(what - '0'), 1);
        bool infinite =
            what == 'i' || (what == 'n' && !fixes &&
                            fmb_program_is_infinite(&m->program, column.p, m->number, end));
        if (what)
            fmb_program_bound(&m->program, j, end, column.p, infinite ? NULL : m->number);
    }
    return kind->integer ? fmb_system_set_integer(m->program.s, j, true) : FMB_OK;
}

static fmb_status read_bound(mps_reader *m, const fmb_mps_card *card)
{
    const fmb_span *f = card->field;
    const mps_bound_kind *kind = bound_kind_of(f[0]);
    int j = -1;
    if (!kind)
        return fail_field(m, f[0], "a kind of bound: LO, UP, FX, FR, MI, PL, BV, LI or UI");
    FMB_TRY(f[2].n > 0 ? fmb_span_find(m->c, f[2], m->program.s, &j) : FMB_OK);
    if (j < 0)
        return fail_field(m, f[2], "the name of a column");
    bool number = kind->end[0] == 'n' || kind->end[1] == 'n';
    if (number)
        FMB_TRY(read_field_number(m, f[3]));
    if (number && kind->integer && mpz_cmp_ui(mpq_denref(m->number), 1) != 0)
        return fail_field(m, f[3], "a whole number as bound of an integer column");
    return is_first_set(m, f[1]) ? set_mps_bound(m, kind, j, f[2]) : FMB_OK;
}

/* Columns that are integer by markers, not by a bound, have the upper bound 1 unless the text
 * bounds them (GLPK 5.0 Reference Manual, 2020, appendix B). */
static void bound_free_integers(mps_reader *m)
{
    char name[FMB_QUOTE];
    bool told = false;
    mpq_set_ui(m->number, 1, 1);
    for (int j = 0; j < (int)m->program.ends; j++) {
        const fmb_program_end *end = m->program.end[j];
        if (!fmb_system_is_integer(m->program.s, j) || end[0].at || end[1].at)
            continue;
        if (!told)
            fmb_io_warn(m->c, NULL,
                        "integer columns without bounds, such as %s, end at 1, as elsewhere",
                        fmb_quote_name(fmb_system_name(m->program.s, j), name));
        told = true;
        fmb_program_bound(&m->program, j, FMB_PROGRAM_HIGH, NULL, m->number);
    }
}

/* ---- sections -------------------------------------------------------------------------------- */

static fmb_status read_sense(mps_reader *m, fmb_span word)
{
    static const char *const senses[] = {"MIN", "MINIMIZE", "MAX", "MAXIMIZE"};
    for (size_t i = 0; i < sizeof senses / sizeof *senses; i++) {
        if (!fmb_span_is_nocase(word, senses[i]))
            continue;
        m->sense = i < 2 ? FMB_SENSE_MIN : FMB_SENSE_MAX;
        return FMB_OK;
    }
    return fail_field(m, word, "MIN or MAX");
}

/* Read a word of the sections that name the objective row, or its sense. */
static fmb_status read_word_about_objective(mps_reader *m, fmb_span word)
{
    if (m->section == FMB_MPS_OBJSENSE)
        return read_sense(m, word);
    m->objective = word;
    return FMB_OK;
}

static fmb_status begin_section(mps_reader *m, const fmb_mps_card *card)
{
    m->has_columns = m->has_columns || m->section == FMB_MPS_COLUMNS;
    if (m->section == FMB_MPS_NONE || (m->section == FMB_MPS_ENDATA && !m->has_columns))
        return fail_field(m, card->word[0],
                          "a section: NAME, OBJSENSE, OBJNAME, ROWS, COLUMNS, then RHS, RANGES, "
                          "BOUNDS or ENDATA");
    bool is_short = m->section == FMB_MPS_OBJSENSE || m->section == FMB_MPS_OBJNAME;
    return is_short && card->words > 1 ? read_word_about_objective(m, card->word[1]) : FMB_OK;
}

/* The form of the text is decided at the first line that both forms may read differently. */
static void lay_out_fields(mps_reader *m, fmb_mps_card *card)
{
    if (!m->knows_form && fmb_mps_lay_out_alike(card, m->section))
        return;
    if (!m->knows_form)
        m->fixed = fmb_mps_is_fixed(&m->text);
    m->knows_form = true;
    fmb_mps_lay_out(card, m->section, m->fixed);
}

static fmb_status read_data(mps_reader *m, fmb_mps_card *card)
{
    if (m->section == FMB_MPS_OBJSENSE || m->section == FMB_MPS_OBJNAME)
        return read_word_about_objective(m, card->word[0]);
    if (m->section < FMB_MPS_ROWS)
        return fail_field(m, card->word[0], "a section such as ROWS at the start of its line");
    if (m->section == FMB_MPS_COLUMNS && fmb_mps_is_marker(card))
        return read_marker(m, card->word[card->words - 1]);
    lay_out_fields(m, card);
    if (m->knows_form && !m->fixed && card->words > 5)
        return fail_field(m, card->word[5], "at most two numbers a line");
    return m->section == FMB_MPS_ROWS      ? read_row(m, card)
           : m->section == FMB_MPS_COLUMNS ? read_column(m, card)
           : m->section == FMB_MPS_BOUNDS  ? read_bound(m, card)
                                           : read_entries(m, card);
}

static fmb_status read_cards(mps_reader *m)
{
    fmb_mps_card card;
    while (m->section != FMB_MPS_ENDATA) {
        if (!fmb_mps_next_card(m->c, &card))
            return fmb_io_fail(m->c, m->c->end, "expected ENDATA, found end of file");
        FMB_TRY(fmb_mps_is_title(&card, &m->section) ? begin_section(m, &card)
                                                     : read_data(m, &card));
    }
    return FMB_OK;
}

fmb_status fmb_read_mps(fmb_cursor *c, fmb_system *s)
{
    mps_reader m = {.c = c, .text = *c, .sense = FMB_SENSE_MIN};
    fmb_program_open(&m.program, c, s);
    fmb_draft_init(&m.draft, c->mem);
    mpq_inits(m.number, m.low, m.high, (mpq_ptr)NULL);
    fmb_status st = read_cards(&m);
    FMB_THEN(st, append_mps_rows(&m));
    FMB_THEN(st, set_mps_objective(&m));
    if (st == FMB_OK) {
        bound_free_integers(&m);
        st = fmb_program_finish(&m.program);
    }
    for (size_t i = 0; i < m.rows; i++)
        fmb_mem_put(c->mem, m.row[i].term, m.row[i].capacity, sizeof *m.row[i].term);
    fmb_draft_clear(&m.draft);
    fmb_mem_put(c->mem, m.row, m.row_capacity, sizeof *m.row);
    mpq_clears(m.number, m.low, m.high, (mpq_ptr)NULL);
    fmb_program_close(&m.program);
    return st;
}
