/* kernels.c: the time to test a pair of rows before it is combined, by the kernels of each
 * instruction set of this processor, on random histories; and the time of a combination of two
 * rows.
 *
 * The history of one row is tested against those of 4,096 others, a different row each time; ratios
 * are to the first level. See README.md.
 */
#include <stdlib.h>

#include "machine.h"
#include "num/kernels/kernels.h"

enum { SETS = 4096, ROWS = 512, LENGTH = 32, PASSES = 7, REPEATS = 64 };

static const struct {
    const char *name;
    fmb_simd level;
} LEVEL[] = {{"plain", FMB_SIMD_PLAIN}, {"avx2", FMB_SIMD_AVX2}, {"avx512", FMB_SIMD_AVX512}};

/* xorshift64* (Vigna 2016). */
static uint64_t draw(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * 0x2545f4914f6cdd1du;
}

typedef struct data {
    uint64_t planes[4 * SETS], history[4 * ROWS], drop[SETS / 64];
    int64_t row[ROWS * LENGTH], result[LENGTH];
} data;

static void fill(data *d)
{
    uint64_t state = 42;
    for (size_t i = 0; i < sizeof d->planes / sizeof *d->planes; i++)
        d->planes[i] = draw(&state) & draw(&state) & draw(&state);
    for (size_t i = 0; i < sizeof d->history / sizeof *d->history; i++)
        d->history[i] = draw(&state) & draw(&state) & draw(&state);
    for (size_t i = 0; i < ROWS * LENGTH; i++)
        d->row[i] = (int64_t)(draw(&state) >> 40) - (1 << 23);
}

typedef double (*task)(const fmb_kernels *k, data *d, size_t words);

/* Nanoseconds to count the union of a pair. */
static double count_pairs(const fmb_kernels *k, data *d, size_t words)
{
    fmb_planes p = {d->planes, SETS, words, SETS};
    double begin = thread_seconds();
    for (size_t i = 0; i < REPEATS; i++)
        k->larger(&p, &d->history[4 * (i % ROWS)], 8 * (int)words, d->drop);
    return 1e9 * (thread_seconds() - begin) / (REPEATS * (double)SETS);
}

/* Nanoseconds to test one set against a union. */
static double cover_pairs(const fmb_kernels *k, data *d, size_t words)
{
    fmb_planes p = {d->planes, SETS, words, SETS};
    size_t found = 0;
    double begin = thread_seconds();
    for (size_t i = 0; i < REPEATS; i++)
        found += k->inside(&p, &d->history[4 * (i % ROWS)], SETS);
    d->drop[0] += found;
    return 1e9 * (thread_seconds() - begin) / (REPEATS * (double)SETS);
}

/* Nanoseconds for an entry of a combination of two rows. */
static double combine_rows(const fmb_kernels *k, data *d, size_t words)
{
    uint64_t all = 0;
    (void)words;
    double begin = thread_seconds();
    for (size_t i = 0; i + 1 < 64 * REPEATS; i++)
        all |= k->combine_narrow(d->result, &d->row[i % (ROWS - 1) * LENGTH],
                                 &d->row[(i % (ROWS - 1) + 1) * LENGTH], LENGTH, 3, -7);
    d->drop[0] ^= all;
    return 1e9 * (thread_seconds() - begin) / (64 * REPEATS * (double)LENGTH);
}

static double typical(task t, const fmb_kernels *k, data *d, size_t words)
{
    double times[PASSES];
    t(k, d, words);
    for (int i = 0; i < PASSES; i++)
        times[i] = t(k, d, words);
    return median(times, PASSES);
}

static void print_line(const char *what, task t, data *d, size_t words)
{
    double first = 0;
    printf("%-28s", what);
    for (size_t l = 0; l < sizeof LEVEL / sizeof *LEVEL; l++) {
        const fmb_kernels *k = fmb_kernels_choose(LEVEL[l].level);
        double ns = k ? typical(t, k, d, words) : 0;
        first = l == 0 ? ns : first;
        if (k)
            printf("  %8.3f %5.1fx", ns, first / ns);
        else
            printf("  %8s %6s", "-", "");
    }
    printf("\n");
}

int main(void)
{
    data *d = malloc(sizeof *d);
    if (!d)
        return 70;
    fill(d);
    printf("%-28s", "ns");
    for (size_t l = 0; l < sizeof LEVEL / sizeof *LEVEL; l++)
        printf("  %8s %6s", LEVEL[l].name, "");
    printf("\n");
    print_line("pair, 64 base rows", count_pairs, d, 1);
    print_line("pair, 128 base rows", count_pairs, d, 2);
    print_line("pair, 256 base rows", count_pairs, d, 4);
    print_line("covering set, 64 base rows", cover_pairs, d, 1);
    print_line("covering set, 128 base rows", cover_pairs, d, 2);
    print_line("entry of a combination", combine_rows, d, 0);
    free(d);
    return 0;
}
