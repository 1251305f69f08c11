/* fuzz_mps.c: the reader of .mps files on any bytes. */
#include "round.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_round(data, size, FMB_FORMAT_MPS, FMB_FORMAT_TEXT);
    return 0;
}
