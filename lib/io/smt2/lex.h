/* lex.h: tokens of SMT-LIB 2.
 *
 * Source: Barrett, Fontaine, Tinelli, The SMT-LIB Standard, version 2.6, 2017, section 3.1.
 */
#ifndef FMB_IO_SMT2_LEX_H
#define FMB_IO_SMT2_LEX_H

#include "io/core/io_private.h"

typedef enum fmb_smt_kind {
    FMB_SMT_END = 0,
    FMB_SMT_OPEN,
    FMB_SMT_CLOSE,
    FMB_SMT_SYMBOL,  /* text without the bars of |a b| */
    FMB_SMT_NUMBER,  /* numeral or decimal */
    FMB_SMT_KEYWORD, /* text without the colon */
    FMB_SMT_STRING,
    FMB_SMT_CODE /* #x1f, #b01 */
} fmb_smt_kind;

typedef struct fmb_smt_token {
    fmb_smt_kind kind;
    bool quoted;    /* a symbol in bars: never a reserved word */
    const char *at; /* where it starts */
    fmb_span text;
} fmb_smt_token;

/* The next token; c is then past it. Errors: PARSE. */
fmb_status fmb_smt_next(fmb_cursor *c, fmb_smt_token *t);
/* The next token must be of this kind; what is what the message expects. Errors: PARSE. */
fmb_status fmb_smt_expect(fmb_cursor *c, fmb_smt_kind kind, const char *what, fmb_smt_token *t);
/* Past the closing parenthesis that matches one already read. Errors: PARSE. */
fmb_status fmb_smt_leave(fmb_cursor *c, const char *open);
/* Past one expression, an atom or a list. Errors: PARSE. */
fmb_status fmb_smt_skip(fmb_cursor *c, const char *what);

/* The token is this reserved word. */
bool fmb_smt_is_word(const fmb_smt_token *t, const char *word);
/* Bytes of a symbol that needs no bars, apart from a leading digit. */
bool fmb_smt_is_plain(int byte);

#endif
