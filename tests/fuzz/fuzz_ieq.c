/* fuzz_ieq.c: the reader of .ieq files on any bytes. */
#include "round.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_round(data, size, FMB_FORMAT_IEQ, FMB_FORMAT_INE);
    return 0;
}
