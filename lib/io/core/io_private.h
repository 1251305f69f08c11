/* io_private.h: the interface of a format: a reader, a writer, or both.
 *
 * A reader gets a cursor at the start of a text and an empty system, and returns FMB_OK,
 * FMB_ERR_MEMORY or FMB_ERR_PARSE (through fmb_io_fail, which says where and what was expected).
 */
#ifndef FMB_IO_CORE_IO_PRIVATE_H
#define FMB_IO_CORE_IO_PRIVATE_H

#include "io/core/cursor.h"
#include "io/core/draft.h"
#include "io/core/number.h"

typedef fmb_status fmb_read_fn(fmb_cursor *c, fmb_system *s);
typedef fmb_status fmb_write_fn(const fmb_system *s, FILE *out);

fmb_read_fn fmb_read_text, fmb_read_ine, fmb_read_ieq, fmb_read_smt2, fmb_read_mps, fmb_read_lp;
fmb_write_fn fmb_write_text, fmb_write_ine, fmb_write_smt2, fmb_write_mps, fmb_write_lp;

#endif
