/* term.h: terms of an SMT-LIB text, and the state of reading them.
 *
 * Terms are read with explicit stacks, never by recursion: nesting is bounded by memory alone.
 */
#ifndef FMB_IO_SMT2_TERM_H
#define FMB_IO_SMT2_TERM_H

#include "io/core/io_private.h"
#include "io/smt2/formula.h"
#include "io/smt2/scope.h"

/* ---- tokens (lex.c; Barrett, Fontaine, Tinelli, The SMT-LIB Standard, version 2.6, 2017, 3.1)  */

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
/* The next token must be of this kind; what names it in the message. Errors: PARSE. */
fmb_status fmb_smt_expect(fmb_cursor *c, fmb_smt_kind kind, const char *what, fmb_smt_token *t);
/* Skip past the closing parenthesis that matches one already read. Errors: PARSE. */
fmb_status fmb_smt_leave(fmb_cursor *c, const char *open);
/* Skip one expression, an atom or a list. Errors: PARSE. */
fmb_status fmb_smt_skip(fmb_cursor *c, const char *what);

/* Is the token this reserved word? */
bool fmb_smt_is_word(const fmb_smt_token *t, const char *word);
/* May the byte occur in a symbol without bars (which must not begin with a digit)? */
bool fmb_smt_is_plain(int byte);

/* A define-fun with parameters: its body is read anew at each use. */
typedef struct fmb_smt_macro {
    size_t first, n; /* param[first .. first + n) */
    bool formula;
    const char *body;
    size_t bytes;
} fmb_smt_macro;

typedef struct fmb_smt_param {
    size_t symbol;
    bool formula;
} fmb_smt_param;

/* What is being read inside an open parenthesis. */
typedef enum fmb_smt_frame_kind {
    FMB_SMT_APPLY, /* arguments, then ')' */
    FMB_SMT_LET,   /* the term of a binding */
    FMB_SMT_BODY,  /* the body of a let */
    FMB_SMT_NOTE,  /* the term of (! term attributes) */
    FMB_SMT_CALL   /* the body of a macro, elsewhere in the text */
} fmb_smt_frame_kind;

typedef struct fmb_smt_frame {
    fmb_smt_frame_kind kind;
    size_t symbol;         /* APPLY */
    const char *at;        /* the parenthesis */
    const char *back;      /* CALL: where reading continues */
    size_t values, locals; /* their numbers at the parenthesis */
    size_t names;          /* LET: number of pending names there */
    size_t visible;        /* CALL: to be restored */
} fmb_smt_frame;

typedef struct fmb_smt {
    fmb_cursor *c;
    fmb_system *s;
    fmb_lin lin;
    fmb_forms forms;
    fmb_smt_scope scope;
    fmb_smt_frame *frame;
    size_t frames, frame_capacity;
    fmb_smt_value *value;
    size_t values, value_capacity;
    size_t *name; /* names of let bindings whose terms are being read */
    size_t names, name_capacity;
    fmb_smt_macro *macro;
    size_t macros, macro_capacity;
    fmb_smt_param *param;
    size_t params, param_capacity;
    uint32_t *literal; /* scratch of operators */
    size_t literal_capacity;
    mpq_t number; /* scratch */
    bool named;   /* a command gave a term a global name: its nodes must be kept */
    bool checked, warned_late;
} fmb_smt;

/* facts outlives r. Errors: MEMORY. */
fmb_status fmb_smt_init(fmb_smt *r, fmb_cursor *c, fmb_system *s, fmb_smt_facts *facts);
void fmb_smt_clear(fmb_smt *r);

/* The term at the cursor. Errors: PARSE, MEMORY. */
fmb_status fmb_smt_term(fmb_smt *r, fmb_smt_value *out);
/* A symbol that has no global meaning yet. Errors: PARSE, MEMORY. */
fmb_status fmb_smt_new_name(fmb_smt *r, size_t *symbol, const char **at);

/* Read the ')' of a command; check that v is a formula, or that it is a term. Errors: PARSE. */
fmb_status fmb_smt_close_command(fmb_smt *r);
fmb_status fmb_smt_check_kind(fmb_smt *r, const fmb_smt_value *v, bool formula);

/* Execute the rest of a command that began at open. Errors: PARSE, MEMORY. */
typedef fmb_status fmb_smt_command(fmb_smt *r, const char *open);
fmb_smt_command fmb_smt_declare_const, fmb_smt_declare_fun, fmb_smt_define_const,
    fmb_smt_define_fun, fmb_smt_define_sort;

/* One operator, and its application to n arguments at a place of the text. */
typedef struct fmb_smt_operator fmb_smt_operator;
typedef struct fmb_smt_application {
    const fmb_smt_operator *op;
    const char *at;
    const fmb_smt_value *arg;
    size_t n;
} fmb_smt_application;
struct fmb_smt_operator {
    const char *name;
    enum { FMB_SMT_TERMS, FMB_SMT_FORMULAS, FMB_SMT_EITHER } takes;
    size_t least, most; /* arguments */
    fmb_status (*apply)(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out);
    fmb_rel rel; /* comparisons; FMB_LE elsewhere */
    bool swap;   /* -, >=, > and => */
};

/* The i-th operator, NULL past the end. */
const fmb_smt_operator *fmb_smt_operator_at(size_t i);
/* Check number and kinds of the arguments, then apply the operator. Errors: PARSE, MEMORY. */
fmb_status fmb_smt_operate(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out);

#endif
