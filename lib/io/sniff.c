/* sniff.c: guessing a format from the text; see sniff.h. */
#include <string.h>

#include "io/sniff.h"

/* Some line consists of exactly this word. */
static bool has_line_of_word(fmb_cursor c, const char *word)
{
    for (; c.at < c.end; fmb_next_line(&c)) {
        fmb_skip_blanks(&c);
        if (fmb_span_is_nocase(fmb_scan_word(&c), word)) {
            fmb_skip_blanks(&c);
            if (fmb_peek(&c) == '\n' || fmb_peek(&c) < 0)
                return true;
        }
    }
    return false;
}

bool fmb_sniff_ine(const fmb_cursor *c)
{
    return has_line_of_word(*c, "begin") || has_line_of_word(*c, "H-representation") ||
           has_line_of_word(*c, "V-representation");
}

bool fmb_sniff_generators(const fmb_cursor *c)
{
    return has_line_of_word(*c, "V-representation");
}

bool fmb_sniff_ieq(const fmb_cursor *c)
{
    return has_line_of_word(*c, "INEQUALITIES_SECTION");
}

/* Past blank lines and lines that begin with this byte. */
static void skip_comment_lines(fmb_cursor *c, int mark)
{
    fmb_skip_space(c);
    while (fmb_peek(c) == mark) {
        fmb_next_line(c);
        fmb_skip_space(c);
    }
}

/* An S-expression whose head is a command. */
bool fmb_sniff_smt2(const fmb_cursor *from)
{
    static const char *const heads[] = {"set-",   "declare-", "define-", "assert",
                                        "check-", "push",     "echo",    "exit"};
    fmb_cursor c = *from;
    skip_comment_lines(&c, ';');
    if (!fmb_accept(&c, "("))
        return false;
    fmb_skip_space(&c);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++)
        if (fmb_accept(&c, heads[i]))
            return true;
    return false;
}

bool fmb_sniff_mps(const fmb_cursor *c)
{
    return has_line_of_word(*c, "ROWS") && has_line_of_word(*c, "COLUMNS");
}

/* An objective first, and a section of rows somewhere. */
bool fmb_sniff_lp(const fmb_cursor *from)
{
    static const char *const heads[] = {"min", "max", "minimize", "maximize", "minimum", "maximum"};
    static const char *const rows[] = {"subject", "such", "st", "s.t.",
                                       "st."}; /* two of two words */
    bool objective = false, section = false;
    fmb_cursor c = *from;
    skip_comment_lines(&c, '\\');
    fmb_span word = fmb_scan_word(&c);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++)
        objective = objective || fmb_span_is_nocase(word, heads[i]);
    const char *line = c.at;
    for (fmb_skip_space(&c); objective && !section && c.at < c.end; fmb_skip_space(&c)) {
        bool first = memchr(line, '\n', (size_t)(c.at - line)) != NULL;
        word = fmb_scan_word(&c);
        line = c.at;
        for (size_t i = 0; i < (first ? sizeof rows / sizeof *rows : 2); i++)
            section = section || fmb_span_is_nocase(word, rows[i]);
    }
    return section;
}
