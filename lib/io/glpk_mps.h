/* glpk_mps.h: an MPS text made ready for GLPK, line by line.
 *
 * Lines keep their numbers. Comments replace what GLPK refuses or what is not wanted: blank lines,
 * OBJSENSE sections, and the markers of integer columns (GLPK would bound those columns by 0 and 1;
 * integrality is ignored here, and so is that).
 */
#ifndef FMB_IO_GLPK_MPS_H
#define FMB_IO_GLPK_MPS_H

#include "io/glpk_decimals.h"
#include "system/names.h"

typedef enum fmb_mps_section {
    FMB_MPS_START = 0,
    FMB_MPS_OBJSENSE,
    FMB_MPS_ROWS,
    FMB_MPS_COLUMNS,
    FMB_MPS_RHS,
    FMB_MPS_RANGES,
    FMB_MPS_BOUNDS,
    FMB_MPS_OTHER
} fmb_mps_section;

typedef struct fmb_mps_edit {
    fmb_cursor *c;
    fmb_decimals *numbers;
    bool fixed;  /* fields by position, else by blanks */
    bool ranges; /* make the ranges the right sides: RHS goes, RANGES is called RHS */
    fmb_mps_section section;
    bool has_integers, has_ranges; /* found out on the way */
    fmb_names bounded;             /* columns with bounds */
    unsigned char *sides;          /* [bounded.size] sides they have: bit 0 lower, bit 1 upper */
    size_t sides_capacity;
    char *text;
    size_t size, capacity;
} fmb_mps_edit;

void fmb_mps_edit_init(fmb_mps_edit *e, fmb_cursor *c, fmb_decimals *numbers);
void fmb_mps_edit_clear(fmb_mps_edit *e);
/* The whole text of the cursor into e->text; its numbers are noted. Errors: MEMORY, PARSE. */
fmb_status fmb_mps_edit_run(fmb_mps_edit *e, bool fixed, bool ranges);

#endif
