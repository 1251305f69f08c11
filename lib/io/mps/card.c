/* card.c: see card.h. All control bytes of a checked text are blanks (fmb_io_check). */
#include "io/mps/card.h"

#include <string.h>

#include "io/core/cursor.h"

static bool starts_card_number(fmb_span w)
{
    size_t i = w.n > 0 && (*w.p == '+' || *w.p == '-');
    return i < w.n && (w.p[i] == '.' || fmb_is_digit(w.p[i]));
}

/* A word after the first that begins with '$' begins a comment; so does '*' or '!' after a number
 * of the line, unless a number follows: then it begins a name. */
static void end_at_comment(fmb_mps_card *card)
{
    for (size_t k = 2; k < card->words; k++) {
        fmb_span w = card->word[k];
        bool number = k + 1 < card->words && starts_card_number(card->word[k + 1]);
        if ((*w.p == '*' || *w.p == '!') && starts_card_number(card->word[k - 1]) && !number) {
            card->words = k;
            card->line.n = (size_t)(w.p - card->line.p);
        }
    }
}

bool fmb_mps_next_card(fmb_cursor *c, fmb_mps_card *card)
{
    for (card->words = 0; card->words == 0 && c->at < c->end; fmb_next_line(c)) {
        const char *from = c->at;
        if (*from == '*')
            continue;
        for (fmb_skip_blanks(c); card->words < 7; fmb_skip_blanks(c)) {
            fmb_span w = fmb_scan_word(c);
            if (w.n == 0 || (*w.p == '$' && card->words > 0))
                break;
            card->word[card->words++] = w;
        }
        fmb_skip_line(c);
        card->line = (fmb_span){from, (size_t)(c->at - from)};
        end_at_comment(card);
    }
    return card->words > 0;
}

bool fmb_mps_is_title(const fmb_mps_card *card, fmb_mps_section *section)
{
    static const char *const titles[] = {NULL,      "NAME", "OBJNAME", "OBJSENSE", "ROWS",
                                         "COLUMNS", "RHS",  "RANGES",  "BOUNDS",   "ENDATA"};
    if (*card->line.p <= ' ')
        return false;
    int k = FMB_MPS_ENDATA;
    while (k > 0 && !fmb_span_is_nocase(card->word[0], titles[k]))
        k--;
    *section = (fmb_mps_section)k;
    return true;
}

bool fmb_mps_is_marker(const fmb_mps_card *card)
{
    return card->words > 1 && fmb_span_is_nocase(card->word[1], "'MARKER'");
}

/* ---- fields ---------------------------------------------------------------------------------- */

static fmb_span trim_field(const char *p, const char *end)
{
    while (p < end && *p <= ' ' && *p > 0)
        p++;
    while (p < end && end[-1] <= ' ' && end[-1] > 0)
        end--;
    return (fmb_span){p, (size_t)(end - p)};
}

/* Where fields of the fixed form begin and end. */
static const size_t field_from[] = {1, 4, 14, 24, 39, 49}, field_to[] = {3, 12, 22, 36, 47, 61};

/* False if there is text between the fields. A '$' at the start of field 2 or 4 begins a comment;
 * all text after the last field is a comment. */
static bool lay_out_fixed(fmb_mps_card *card)
{
    const char *p = card->line.p;
    size_t n = card->line.n, gap = 0;
    bool clean = memchr(p, '\t', n) == NULL;
    for (size_t k = 0; k < 6; gap = field_to[k++]) {
        if ((k == 2 || k == 4) && field_from[k] < n && p[field_from[k]] == '$')
            n = field_from[k];
        size_t begin = field_from[k] < n ? field_from[k] : n,
               end = field_to[k] < n ? field_to[k] : n;
        if (gap < begin)
            clean = clean && trim_field(p + gap, p + begin).n == 0;
        card->field[k] = trim_field(p + begin, p + end);
    }
    return clean;
}

/* The name of the set is missing if there is a number in the place of the row or column. */
static void lay_out_free(fmb_mps_card *card, fmb_mps_section section)
{
    size_t n = card->words, k = 0, to = 1;
    for (size_t i = 0; i < 6; i++)
        card->field[i] = (fmb_span){card->line.p + card->line.n, 0};
    if (section == FMB_MPS_ROWS || section == FMB_MPS_BOUNDS)
        card->field[0] = card->word[k++];
    if (section >= FMB_MPS_RHS &&
        (n - k == 1 || (n - k > 1 && (n - k) % 2 == 0 && starts_card_number(card->word[k + 1]))))
        to = 2;
    while (k < n && to < 6)
        card->field[to++] = card->word[k++];
}

void fmb_mps_lay_out(fmb_mps_card *card, fmb_mps_section section, bool fixed)
{
    if (fixed)
        lay_out_fixed(card);
    else
        lay_out_free(card, section);
}

/* ---- which form? ----------------------------------------------------------------------------- */

/* Are there names and numbers where they have to be, and nowhere else? */
static bool fits_section(const fmb_mps_card *card, fmb_mps_section section)
{
    const fmb_span *f = card->field;
    bool one = f[4].n + f[5].n == 0, number = starts_card_number(f[3]);
    if (section == FMB_MPS_ROWS)
        return f[0].n > 0 && f[1].n > 0 && f[2].n + f[3].n == 0 && one;
    if (section == FMB_MPS_BOUNDS)
        return f[0].n > 0 && f[2].n > 0 && (f[3].n == 0 || number) && one;
    return f[0].n == 0 && (f[1].n > 0 || section != FMB_MPS_COLUMNS) && f[2].n > 0 && number &&
           (one || (f[4].n > 0 && starts_card_number(f[5])));
}

/* If each word stands within its field, the fixed form has the same fields. */
bool fmb_mps_lay_out_alike(fmb_mps_card *card, fmb_mps_section section)
{
    fmb_span line = card->line;
    lay_out_free(card, section);
    bool alike = card->words <= 5 && fits_section(card, section) && !memchr(line.p, '\t', line.n) &&
                 !memchr(line.p, '$', line.n);
    for (size_t k = 0; alike && k < 6; k++) {
        fmb_span *f = &card->field[k];
        if (f->n > 0)
            alike = f->p >= line.p + field_from[k] && f->p + f->n <= line.p + field_to[k];
        else
            f->p = line.p + (field_to[k] < line.n ? field_to[k] : line.n);
    }
    return alike;
}

bool fmb_mps_is_fixed(const fmb_cursor *text)
{
    fmb_cursor c = *text;
    fmb_mps_card card;
    fmb_mps_section section = FMB_MPS_NONE;
    size_t fixed = 0, free = 0; /* lines that fit */
    while (section != FMB_MPS_ENDATA && fmb_mps_next_card(&c, &card)) {
        if (fmb_mps_is_title(&card, &section) || section < FMB_MPS_ROWS || fmb_mps_is_marker(&card))
            continue;
        fixed += lay_out_fixed(&card) && fits_section(&card, section);
        lay_out_free(&card, section);
        free += card.words <= 5 && fits_section(&card, section);
    }
    return fixed >= free;
}
