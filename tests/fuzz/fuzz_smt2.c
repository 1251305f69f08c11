/* fuzz_smt2.c: the reader of .smt2 files on any bytes. */
#include "round.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_round(data, size, FMB_FORMAT_SMT2, FMB_FORMAT_SMT2);
    return 0;
}
