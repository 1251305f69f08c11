/* token.h: the tokens of a CPLEX LP text: names, numbers, signs, relations, keywords of sections.
 *
 * A keyword, in upper or lower case, is the first word of its line, or follows a name or a side of
 * a row, unless a label or a row continues after it: `end:` and `end >= 2` mean a variable named
 * end. Comments reach from '\' to the end of the line. Names begin with a letter or one of
 * !"#$%&()/,;?@_`'{}|~ and continue with these, digits,
 * '.', '[' and ']'.
 *
 * Source: IBM, CPLEX 22.1 File formats, "LP file format"; Gurobi 11 Reference, "LP format" (names
 * with brackets); GLPK 5.0 Reference Manual, 2020, appendix C.
 */
#ifndef FMB_IO_LP_TOKEN_H
#define FMB_IO_LP_TOKEN_H

#include "io/core/io_private.h"

typedef enum fmb_lp_kind {
    FMB_LP_OTHER = 0, /* a byte that begins no token */
    FMB_LP_NAME,
    FMB_LP_NUMBER,
    FMB_LP_SIGN,
    FMB_LP_COLON,
    FMB_LP_RELATION,
    FMB_LP_KEYWORD,
    FMB_LP_EOF
} fmb_lp_kind;

typedef enum fmb_lp_section {
    FMB_LP_OBJECTIVE,
    FMB_LP_ROWS,
    FMB_LP_BOUNDS,
    FMB_LP_GENERAL,
    FMB_LP_BINARY,
    FMB_LP_END,
    FMB_LP_UNREADABLE /* semi-continuous, sos, lazy constraints, ... */
} fmb_lp_section;

typedef struct fmb_lp_token {
    fmb_lp_kind kind;
    fmb_span text;
    bool starts_line, is_label; /* label: a name followed by ':' */
    bool is_side;               /* it follows a relation, with only signs between */
    bool minus;                 /* SIGN */
    int relation;               /* -1 <=, 0 =, 1 >= */
    fmb_lp_section section;     /* KEYWORD */
} fmb_lp_token;

/* Read the token at c, with its value if it is a number, and move past it; on entry *t is the
 * previous token. Errors: MEMORY, PARSE. */
fmb_status fmb_lp_scan(fmb_cursor *c, fmb_lp_token *t, mpq_t value);

#endif
