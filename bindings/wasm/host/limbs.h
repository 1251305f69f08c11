/* limbs.h: products and quotients of GMP's limbs for WebAssembly, which multiplies and divides
 * numbers of 64 bits: GMP's portable macros build them from halves of 16 bits. Included before all
 * of GMP's sources, whose longlong.h defines only missing macros. Limbs have 32 bits. */
#include <stdint.h>

#define umul_ppmm(high, low, u, v)                                                                 \
    do {                                                                                           \
        uint64_t product_ = (uint64_t)(uint32_t)(u) * (uint32_t)(v);                               \
        (high) = (uint32_t)(product_ >> 32);                                                       \
        (low) = (uint32_t)product_;                                                                \
    } while (0)

#define udiv_qrnnd(quotient, rest, high, low, divisor)                                             \
    do {                                                                                           \
        uint64_t n_ = (uint64_t)(uint32_t)(high) << 32 | (uint32_t)(low);                          \
        uint32_t d_ = (uint32_t)(divisor);                                                         \
        (quotient) = (uint32_t)(n_ / d_);                                                          \
        (rest) = (uint32_t)(n_ % d_);                                                              \
    } while (0)

#define count_leading_zeros(count, x)  ((count) = __builtin_clz(x))
#define count_trailing_zeros(count, x) ((count) = __builtin_ctz(x))
