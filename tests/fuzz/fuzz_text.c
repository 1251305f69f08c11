/* fuzz_text.c: the reader of .fmb files on any bytes. */
#include "round.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_round(data, size, FMB_FORMAT_TEXT, FMB_FORMAT_TEXT);
    return 0;
}
