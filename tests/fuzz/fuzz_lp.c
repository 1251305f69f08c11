/* fuzz_lp.c: the reader of .lp files on any bytes. */
#include "round.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_round(data, size, FMB_FORMAT_LP, FMB_FORMAT_TEXT);
    return 0;
}
