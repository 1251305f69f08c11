/* lex.c: tokens of SMT-LIB 2; see term.h. */
#include "io/smt2/term.h"

#include <string.h>

#include "io/core/cursor.h"

bool fmb_smt_is_plain(int b)
{
    bool letter = (b >= 'a' && b <= 'z') || (b >= 'A' && b <= 'Z');
    return letter || fmb_is_digit(b) || (b > 0 && b < 128 && strchr("~!@$%^&*_-+=<>.?/", b));
}

static void skip_semicolon_comments(fmb_cursor *c)
{
    fmb_skip_space(c);
    while (fmb_peek(c) == ';') {
        fmb_skip_line(c);
        fmb_skip_space(c);
    }
}

static void skip_symbol_bytes(fmb_cursor *c)
{
    while (fmb_smt_is_plain(fmb_peek(c)))
        c->at++;
}

/* |any bytes but | and \|: the text is what the bars enclose. */
static fmb_status scan_barred_symbol(fmb_cursor *c, fmb_smt_token *t)
{
    t->kind = FMB_SMT_SYMBOL;
    t->quoted = true;
    t->text.p = ++c->at;
    while (fmb_peek(c) != '|') {
        if (fmb_peek(c) < 0)
            return fmb_io_fail(c, t->at, "expected '|' to end this symbol, found end of file");
        if (*c->at == '\\')
            return fmb_io_fail(c, c->at, "expected no '\\' in a quoted symbol");
        c->at++;
    }
    t->text.n = (size_t)(c->at++ - t->text.p);
    return FMB_OK;
}

/* "a string, with "" for a quote". */
static fmb_status scan_string_literal(fmb_cursor *c, fmb_smt_token *t)
{
    t->kind = FMB_SMT_STRING;
    do {
        c->at++;
        while (fmb_peek(c) != '"') {
            if (fmb_peek(c) < 0)
                return fmb_io_fail(c, t->at, "expected '\"' to end this string, found end of file");
            c->at++;
        }
        c->at++;
    } while (fmb_peek(c) == '"');
    t->text = (fmb_span){t->at, (size_t)(c->at - t->at)};
    return FMB_OK;
}

/* 12 or 12.5; "12x" is one wrong word rather than two tokens. */
static fmb_status scan_numeral_token(fmb_cursor *c, fmb_smt_token *t)
{
    t->kind = FMB_SMT_NUMBER;
    while (fmb_is_digit(fmb_peek(c)))
        c->at++;
    if (fmb_peek(c) == '.' && c->end - c->at > 1 && fmb_is_digit((unsigned char)c->at[1])) {
        c->at++;
        while (fmb_is_digit(fmb_peek(c)))
            c->at++;
    }
    if (fmb_smt_is_plain(fmb_peek(c))) {
        return fmb_io_expected(c, t->at, "a number or a name");
    }
    t->text = (fmb_span){t->at, (size_t)(c->at - t->at)};
    return FMB_OK;
}

static fmb_status scan_plain_token(fmb_cursor *c, fmb_smt_token *t)
{
    int b = fmb_peek(c);
    t->kind = b == ':' ? FMB_SMT_KEYWORD : b == '#' ? FMB_SMT_CODE : FMB_SMT_SYMBOL;
    c->at += t->kind != FMB_SMT_SYMBOL;
    t->text.p = c->at;
    skip_symbol_bytes(c);
    t->text.n = (size_t)(c->at - t->text.p);
    if (t->text.n > 0)
        return FMB_OK;
    return fmb_io_expected(c, t->at, "'(', ')', a name or a number");
}

fmb_status fmb_smt_next(fmb_cursor *c, fmb_smt_token *t)
{
    skip_semicolon_comments(c);
    c->tokens++;
    *t = (fmb_smt_token){.at = c->at, .text = {c->at, 0}};
    int b = fmb_peek(c);
    if (b < 0)
        return FMB_OK;
    if (b == '|')
        return scan_barred_symbol(c, t);
    if (b == '"')
        return scan_string_literal(c, t);
    if (fmb_is_digit(b))
        return scan_numeral_token(c, t);
    if (b != '(' && b != ')')
        return scan_plain_token(c, t);
    t->kind = b == '(' ? FMB_SMT_OPEN : FMB_SMT_CLOSE;
    t->text.n = 1;
    c->at++;
    return FMB_OK;
}

fmb_status fmb_smt_expect(fmb_cursor *c, fmb_smt_kind kind, const char *what, fmb_smt_token *t)
{
    FMB_TRY(fmb_smt_next(c, t));
    if (t->kind == kind)
        return FMB_OK;
    return fmb_io_expected(c, t->at, "%s", what);
}

fmb_status fmb_smt_leave(fmb_cursor *c, const char *open)
{
    for (size_t depth = 1; depth > 0;) {
        fmb_smt_token t;
        FMB_TRY(fmb_smt_next(c, &t));
        if (t.kind == FMB_SMT_END)
            return fmb_io_fail(c, open, "expected ')' to match this '(', found end of file");
        depth += t.kind == FMB_SMT_OPEN;
        depth -= t.kind == FMB_SMT_CLOSE;
    }
    return FMB_OK;
}

fmb_status fmb_smt_skip(fmb_cursor *c, const char *what)
{
    fmb_smt_token t;
    FMB_TRY(fmb_smt_next(c, &t));
    if (t.kind == FMB_SMT_OPEN)
        return fmb_smt_leave(c, t.at);
    if (t.kind == FMB_SMT_CLOSE || t.kind == FMB_SMT_END) {
        return fmb_io_expected(c, t.at, "%s", what);
    }
    return FMB_OK;
}

bool fmb_smt_is_word(const fmb_smt_token *t, const char *word)
{
    return t->kind == FMB_SMT_SYMBOL && !t->quoted && fmb_span_is(t->text, word);
}
