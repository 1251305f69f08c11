/* fuzz_ine.c: the reader of .ine files on any bytes. */
#include "round.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_round(data, size, FMB_FORMAT_INE, FMB_FORMAT_INE);
    return 0;
}
