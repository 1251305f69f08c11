/* card.h: the six fields of a line of MPS data, in fixed or free form.
 *
 *   field    0     1       2       3       4    5
 *   ROWS     type  row
 *   COLUMNS        column  row     number  row  number
 *   RHS            set     row     number  row  number     RANGES likewise
 *   BOUNDS   kind  set     column  number
 *
 * Fixed form has them at positions 2-3, 5-12, 15-22, 25-36, 40-47 and 50-61, and names may contain
 * blanks; free form has words, and the name of a set may be missing. No file declares its form: it
 * is taken to be the one that more of its lines fit.
 *
 * Source: IBM, MPSX/370 Program Reference Manual, 1979; GLPK 5.0 Reference Manual, 2020, appendix
 * B; lp_solve 5.5 reference, "mps-format".
 */
#ifndef FMB_IO_MPS_CARD_H
#define FMB_IO_MPS_CARD_H

#include "io/core/io_private.h"

typedef enum fmb_mps_section {
    FMB_MPS_NONE = 0,
    FMB_MPS_NAME,
    FMB_MPS_OBJNAME,
    FMB_MPS_OBJSENSE,
    FMB_MPS_ROWS,
    FMB_MPS_COLUMNS,
    FMB_MPS_RHS,
    FMB_MPS_RANGES,
    FMB_MPS_BOUNDS,
    FMB_MPS_ENDATA
} fmb_mps_section;

typedef struct fmb_mps_card {
    fmb_span line, word[7], field[6]; /* an empty field has n = 0; its p is where it would be */
    size_t words;
} fmb_mps_card;

/* The next line that is neither empty nor a comment, without its fields; false at the end. */
bool fmb_mps_next_card(fmb_cursor *c, fmb_mps_card *card);
/* Does the line begin a section? *section is NONE if the section is unknown. */
bool fmb_mps_is_title(const fmb_mps_card *card, fmb_mps_section *section);
/* Among columns: is the second word 'MARKER'? */
bool fmb_mps_is_marker(const fmb_mps_card *card);
/* Fill the fields of a data line. */
void fmb_mps_lay_out(fmb_mps_card *card, fmb_mps_section section, bool fixed);
/* Fill the fields if both forms read the line alike and it fits them; false if they may differ. */
bool fmb_mps_lay_out_alike(fmb_mps_card *card, fmb_mps_section section);
/* Does the text at c fit the fixed form at least as well as the free one? */
bool fmb_mps_is_fixed(const fmb_cursor *c);

#endif
