/* random.h: random integers from a seed, the same on every machine: splitmix64 (Steele, Lea, Flood
 * 2014, doi 10.1145/2714064.2660195). Any state is a good seed. Never draw twice among the
 * arguments of one call: compilers differ in the order of evaluation. */
#ifndef FMB_STUDY_RANDOM_H
#define FMB_STUDY_RANDOM_H

#include <stdbool.h>
#include <stdint.h>

typedef struct study_random {
    uint64_t state;
} study_random;

static inline uint64_t study_random_next(study_random *g)
{
    uint64_t z = (g->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* From lo to hi, both included. */
static inline int64_t study_random_between(study_random *g, int64_t lo, int64_t hi)
{
    return lo + (int64_t)(study_random_next(g) % (uint64_t)(hi - lo + 1));
}

/* Like study_random_between, but never 0: lo < 0 < hi. */
static inline int64_t study_random_nonzero(study_random *g, int64_t lo, int64_t hi)
{
    int64_t x = study_random_between(g, lo, hi - 1);
    return x + (x >= 0);
}

/* True with a probability of `percent` in 100. */
static inline bool study_random_chance(study_random *g, int percent)
{
    return study_random_between(g, 0, 99) < percent;
}

#endif
