/* glpk_mps.c: an MPS text made ready for GLPK; see glpk_mps.h. */
#include "io/glpk_mps.h"

#include <string.h>

void fmb_mps_edit_init(fmb_mps_edit *e, fmb_cursor *c, fmb_decimals *numbers)
{
    *e = (fmb_mps_edit){.c = c, .numbers = numbers};
}

void fmb_mps_edit_clear(fmb_mps_edit *e)
{
    fmb_names_clear(&e->bounded, e->c->mem);
    fmb_mem_put(e->c->mem, e->sides, e->sides_capacity, 1);
    fmb_mem_put(e->c->mem, e->text, e->capacity, 1);
}

static fmb_status put(fmb_mps_edit *e, const char *p, size_t n)
{
    fmb_status st = fmb_mem_reserve(e->c->mem, (void **)&e->text, &e->capacity, e->size + n, 1);
    if (st == FMB_OK && n > 0) {
        memcpy(e->text + e->size, p, n);
        e->size += n;
    }
    return st;
}

/* ---- fields ---------------------------------------------------------------------------------- */

static bool is_blank(int b)
{
    return b == ' ' || b == '\t' || b == '\r' || b == '\f' || b == '\v';
}

/* The word of the line at or after *at, which moves past it. */
static fmb_span next_word(fmb_span line, size_t *at)
{
    while (*at < line.n && is_blank(line.p[*at]))
        ++*at;
    size_t from = *at;
    while (*at < line.n && !is_blank(line.p[*at]))
        ++*at;
    return (fmb_span){line.p + from, *at - from};
}

/* The k-th word of the line, from 0. */
static fmb_span word_of(fmb_span line, size_t k)
{
    size_t at = 0;
    fmb_span w = next_word(line, &at);
    while (k-- > 0)
        w = next_word(line, &at);
    return w;
}

/* Column of a BOUNDS line: positions 15-22, or the third word. */
static fmb_span column_field(const fmb_mps_edit *e, fmb_span line)
{
    if (!e->fixed)
        return word_of(line, 2);
    if (line.n <= 14)
        return (fmb_span){line.p, 0};
    size_t n = line.n < 22 ? line.n - 14 : 8;
    fmb_span w = {line.p + 14, n};
    for (; w.n > 0 && is_blank(*w.p); w.p++)
        w.n--;
    while (w.n > 0 && is_blank(w.p[w.n - 1]))
        w.n--;
    return w;
}

/* ---- what a line says ------------------------------------------------------------------------ */

static fmb_status note_numbers(fmb_mps_edit *e, fmb_span line)
{
    fmb_status st = FMB_OK;
    size_t at = 0;
    for (fmb_span w = next_word(line, &at); st == FMB_OK && w.n > 0; w = next_word(line, &at))
        if (fmb_decimals_is_number(w))
            st = fmb_decimals_note(e->numbers, w);
    return st;
}

/* Index of a column among the bounded ones. */
static fmb_status bounded_index(fmb_mps_edit *e, fmb_span name, size_t *out)
{
    char *text = fmb_mem_get(e->c->mem, name.n + 1, 1);
    if (!text)
        return fmb_mem_status(e->c->mem);
    memcpy(text, name.p, name.n);
    text[name.n] = '\0';
    fmb_status st = FMB_OK;
    int j = fmb_names_find(&e->bounded, text);
    if (j < 0) {
        j = (int)e->bounded.size;
        st = fmb_mem_reserve(e->c->mem, (void **)&e->sides, &e->sides_capacity, (size_t)j + 1, 1);
        if (st == FMB_OK)
            st = fmb_names_add(&e->bounded, text, e->c->mem);
        if (st == FMB_OK)
            e->sides[j] = 0;
    }
    fmb_mem_put(e->c->mem, text, name.n + 1, 1);
    *out = (size_t)j;
    return st;
}

typedef struct bound_kind {
    const char *word;
    unsigned char sides;
    bool whole;
} bound_kind;

static const bound_kind kinds[] = {
    {"LO", 1, false}, {"UP", 2, false}, {"FX", 3, false}, {"FR", 3, false}, {"MI", 1, false},
    {"PL", 2, false}, {"LI", 1, true},  {"UI", 2, true},  {"BV", 3, false},
};

/* GLPK stops with a failed assertion where a column with both bounds gets both anew, and rounds
 * bounds of kind LI and UI. */
static fmb_status check_bound(fmb_mps_edit *e, fmb_span line)
{
    char buf[FMB_QUOTE];
    fmb_span kind = word_of(line, 0), column = column_field(e, line), value = {NULL, 0};
    size_t at = 0, j = 0;
    for (fmb_span w = next_word(line, &at); w.n > 0; w = next_word(line, &at))
        value = w;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (column.n == 0 || !fmb_span_is(kind, kinds[i].word))
            continue;
        if (kinds[i].whole && fmb_decimals_is_number(value) && !fmb_decimals_is_whole(value))
            return fmb_io_fail(e->c, value.p, "expected a whole number as bound of kind %s",
                               kinds[i].word);
        fmb_status st = bounded_index(e, column, &j);
        if (st == FMB_OK && (e->sides[j] & kinds[i].sides) == 3)
            st = fmb_io_fail(e->c, column.p, "expected one bound of each side, %s has both",
                             fmb_quote(e->c, column.p, buf));
        if (st == FMB_OK)
            e->sides[j] |= kinds[i].sides;
        return st;
    }
    return FMB_OK;
}

static void enter_section(fmb_mps_edit *e, fmb_span line)
{
    static const struct {
        const char *word;
        fmb_mps_section section;
    } titles[] = {{"OBJSENSE", FMB_MPS_OBJSENSE}, {"ROWS", FMB_MPS_ROWS},
                  {"COLUMNS", FMB_MPS_COLUMNS},   {"RHS", FMB_MPS_RHS},
                  {"RANGES", FMB_MPS_RANGES},     {"BOUNDS", FMB_MPS_BOUNDS}};
    fmb_span word = word_of(line, 0);
    e->section = FMB_MPS_OTHER;
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++)
        if (fmb_span_is(word, titles[i].word))
            e->section = titles[i].section;
    e->has_ranges = e->has_ranges || e->section == FMB_MPS_RANGES;
}

/* A line that becomes a comment. */
static bool is_unwanted(fmb_mps_edit *e, fmb_span line, bool title)
{
    if (word_of(line, 0).n == 0 || e->section == FMB_MPS_OBJSENSE)
        return true;
    if (e->ranges && e->section == FMB_MPS_RHS)
        return true;
    if (title || e->section != FMB_MPS_COLUMNS || !fmb_span_is(word_of(line, 1), "'MARKER'"))
        return false;
    e->has_integers = true;
    return true;
}

static fmb_status edit_line(fmb_mps_edit *e, fmb_span line)
{
    bool comment = line.n > 0 && line.p[0] == '*';
    bool title = line.n > 0 && !comment && !is_blank(line.p[0]);
    fmb_status st = FMB_OK;
    if (title)
        enter_section(e, line);
    if (!comment && is_unwanted(e, line, title))
        return put(e, "*", 1);
    if (e->ranges && title && e->section == FMB_MPS_RANGES)
        return put(e, "RHS", 3);
    if (!comment && !title && e->section >= FMB_MPS_COLUMNS && e->section <= FMB_MPS_BOUNDS)
        st = note_numbers(e, line);
    if (st == FMB_OK && !comment && !title && e->section == FMB_MPS_BOUNDS)
        st = check_bound(e, line);
    return st == FMB_OK ? put(e, line.p, line.n) : st;
}

fmb_status fmb_mps_edit_run(fmb_mps_edit *e, bool fixed, bool ranges)
{
    fmb_status st = FMB_OK;
    e->fixed = fixed;
    e->ranges = ranges;
    e->section = FMB_MPS_START;
    e->size = 0;
    if (e->bounded.size > 0)
        memset(e->sides, 0, e->bounded.size);
    for (const char *p = e->c->begin; st == FMB_OK && p < e->c->end;) {
        const char *eol = memchr(p, '\n', (size_t)(e->c->end - p));
        eol = eol ? eol : e->c->end;
        st = edit_line(e, (fmb_span){p, (size_t)(eol - p)});
        if (st == FMB_OK)
            st = put(e, "\n", 1);
        p = eol + (eol < e->c->end);
    }
    return st;
}
