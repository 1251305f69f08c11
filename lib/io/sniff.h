/* sniff.h: does a text look like this format? Each looks for lines that the other formats cannot
 * have.
 */
#ifndef FMB_IO_SNIFF_H
#define FMB_IO_SNIFF_H

#include "io/core/cursor.h"

bool fmb_sniff_ine(const fmb_cursor *c);
/* Of those .ine texts that are V-representations. */
bool fmb_sniff_generators(const fmb_cursor *c);
bool fmb_sniff_ieq(const fmb_cursor *c);
bool fmb_sniff_smt2(const fmb_cursor *c);
bool fmb_sniff_mps(const fmb_cursor *c);
bool fmb_sniff_lp(const fmb_cursor *c);

#endif
