/* round.h: what the fuzz targets of readers share. */
#ifndef FMB_FUZZ_ROUND_H
#define FMB_FUZZ_ROUND_H

#include <fmb/io.h>

/* Read the bytes in format f. A system that is read must come back the same from what is written of
 * it in format `through`; else the program is aborted. */
void fuzz_round(const uint8_t *data, size_t size, fmb_format f, fmb_format through);

/* libFuzzer's entry point, called by replay.c in other builds. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
