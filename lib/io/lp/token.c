/* token.c: see token.h. */
#include "io/lp/token.h"

#include <string.h>
#include <strings.h>

#include "io/core/cursor.h"

static bool starts_lp_name(int b)
{
    return b >= 128 || (b >= 'a' && b <= 'z') || (b >= 'A' && b <= 'Z') ||
           (b > 0 && strchr("!\"#$%&(),;?@_`'{}|~/", b));
}

static bool continues_lp_name(int b)
{
    return starts_lp_name(b) || fmb_is_digit(b) || (b > 0 && strchr(".[]", b));
}

static fmb_span scan_lp_name(fmb_cursor *c)
{
    const char *p = c->at;
    while (continues_lp_name(fmb_peek(c)))
        c->at++;
    return (fmb_span){p, (size_t)(c->at - p)};
}

/* ---- keywords -------------------------------------------------------------------------------- */

typedef struct lp_keyword {
    const char *words;  /* any of these, with blanks between them */
    const char *second; /* and then this word, or NULL */
    fmb_lp_section section;
} lp_keyword;

static const lp_keyword keywords[] = {
    {"minimize minimum min maximize maximum max", NULL, FMB_LP_OBJECTIVE},
    {"subject", "to", FMB_LP_ROWS},
    {"such", "that", FMB_LP_ROWS},
    {"st s.t. st.", NULL, FMB_LP_ROWS},
    {"bounds bound", NULL, FMB_LP_BOUNDS},
    {"general lazy", "constraints", FMB_LP_UNREADABLE},
    {"user", "cuts", FMB_LP_UNREADABLE},
    {"general generals gen integer integers int", NULL, FMB_LP_GENERAL},
    {"binary binaries bin", NULL, FMB_LP_BINARY},
    {"end", NULL, FMB_LP_END},
    {"semi semis sos sos1 sos2 pwlobj", NULL, FMB_LP_UNREADABLE},
};

static bool is_one_of(fmb_span w, const char *words)
{
    for (size_t n; *words; words += n + (words[n] == ' ')) {
        n = strcspn(words, " ");
        if (n == w.n && strncasecmp(words, w.p, n) == 0)
            return true;
    }
    return false;
}

/* The next nonblank byte on this line; '\n' if there is none. */
static int peek_on_line(fmb_cursor c)
{
    fmb_skip_blanks(&c);
    return c.at == c.end || *c.at == '\\' ? '\n' : fmb_peek(&c);
}

/* The section whose keyword the word is, with c moved past the keyword; -1 if it is a name. It is
 * a name before a sign, too, except for keywords that a sum follows. */
static int keyword_section(fmb_cursor *c, fmb_span word)
{
    for (size_t i = 0; i < sizeof keywords / sizeof *keywords; i++) {
        const lp_keyword *k = &keywords[i];
        fmb_cursor at = *c;
        if (!is_one_of(word, k->words))
            continue;
        fmb_skip_blanks(&at);
        if (k->second && !is_one_of(scan_lp_name(&at), k->second))
            continue;
        const char *no = k->section <= FMB_LP_ROWS ? ":<>=" : ":<>=+-";
        bool semi = k->section == FMB_LP_UNREADABLE && fmb_peek(&at) == '-';
        if (!semi && strchr(no, peek_on_line(at)))
            continue;
        if (k->section == FMB_LP_UNREADABLE && !semi && peek_on_line(at) != '\n')
            continue;
        c->at = k->second ? at.at : c->at;
        return (int)k->section;
    }
    return -1;
}

/* ---- tokens ---------------------------------------------------------------------------------- */

/* <, <=, =<, >, >=, =>, = */
static void scan_lp_relation(fmb_cursor *c, fmb_lp_token *t)
{
    int sense = 0;
    bool equal = false;
    for (int n = 0; n < 2; n++, c->at++) {
        int b = fmb_peek(c);
        if (sense == 0 && (b == '<' || b == '>'))
            sense = b == '<' ? -1 : 1;
        else if (!equal && b == '=')
            equal = true;
        else
            break;
    }
    t->kind = FMB_LP_RELATION;
    t->relation = sense;
}

/* Inside a line a keyword follows a name or a number; a one-word keyword follows a number only if a
 * relation precedes the number, as `2 end` may be a term. Keywords of objectives, which come first,
 * and of unreadable sections are not recognized here. */
static int keyword_section_inside(fmb_cursor *c, fmb_span word, const fmb_lp_token *before)
{
    fmb_cursor at = *c;
    bool number = before->kind == FMB_LP_NUMBER;
    if (!number && (before->kind != FMB_LP_NAME || before->is_label))
        return -1;
    int section = keyword_section(&at, word);
    if (section == FMB_LP_OBJECTIVE || section == FMB_LP_UNREADABLE || section < 0)
        return -1;
    if (number && !before->is_side && at.at == c->at)
        return -1;
    *c = at;
    return section;
}

static void scan_lp_word(fmb_cursor *c, fmb_lp_token *t, const fmb_lp_token *before)
{
    t->text = scan_lp_name(c);
    int section =
        t->starts_line ? keyword_section(c, t->text) : keyword_section_inside(c, t->text, before);
    t->kind = section >= 0 ? FMB_LP_KEYWORD : FMB_LP_NAME;
    t->section = section >= 0 ? (fmb_lp_section)section : FMB_LP_OBJECTIVE;
    t->is_label = section < 0 && peek_on_line(*c) == ':';
}

/* An 'e' directly after a number begins its exponent, and '/' makes it a fraction: strictly by the
 * format 1/2 would be 1 times a variable named /2, which nobody means. */
static fmb_status scan_lp_number(fmb_cursor *c, fmb_lp_token *t, mpq_t value)
{
    t->kind = FMB_LP_NUMBER;
    FMB_TRY(fmb_scan_number(c, FMB_NUM_DECIMAL | FMB_NUM_EXPONENT, "a number", value));
    if ((fmb_peek(c) | 32) == 'e')
        return fmb_io_fail(c, c->at + 1, "expected the digits of an exponent");
    if (fmb_peek(c) == '/')
        return fmb_io_fail(c, c->at,
                           "expected a decimal, or a blank in front of a name that begins "
                           "with '/': LP has no fractions");
    return FMB_OK;
}

/* Skip blanks, line ends and comments; true if a line end was among them. */
static bool skip_lp_space(fmb_cursor *c)
{
    const char *from = c->at;
    for (fmb_skip_space(c); fmb_peek(c) == '\\'; fmb_skip_space(c))
        fmb_skip_line(c);
    return from == c->begin || memchr(from, '\n', (size_t)(c->at - from)) != NULL;
}

fmb_status fmb_lp_scan(fmb_cursor *c, fmb_lp_token *t, mpq_t value)
{
    bool starts_line = skip_lp_space(c);
    const fmb_lp_token before = *t;
    bool side = before.kind == FMB_LP_RELATION || (before.kind == FMB_LP_SIGN && before.is_side);
    *t = (fmb_lp_token){.starts_line = starts_line, .is_side = side, .text = {c->at, 1}};
    int b = fmb_peek(c);
    if (b < 0) {
        t->kind = FMB_LP_EOF;
        return FMB_OK;
    }
    if (starts_lp_name(b)) {
        scan_lp_word(c, t, &before);
        return FMB_OK;
    }
    if (b == '.' || fmb_is_digit(b))
        return scan_lp_number(c, t, value);
    if (b == '<' || b == '>' || b == '=') {
        scan_lp_relation(c, t);
        return FMB_OK;
    }
    t->kind = b == ':' ? FMB_LP_COLON : b == '+' || b == '-' ? FMB_LP_SIGN : FMB_LP_OTHER;
    t->minus = b == '-';
    c->at++;
    return FMB_OK;
}
