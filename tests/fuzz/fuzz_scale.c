/* fuzz_scale.c: the law of scales (tests/property/scale/law.h) on problems drawn from any bytes:
 * the first one says which law. */
#include <stdlib.h>

#include "property/scale/law.h"
#include "round.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    law_source source = {.byte = data + 1, .left = size - 1, .state = size};
    char why[LAW_WHY] = "";
    const law_entry *e = &law_list[data[0] % LAWS];
    if (!e->holds(&source, why)) {
        fprintf(stderr, "%s: %s\n", e->name, why);
        abort();
    }
    return 0;
}
