/* edges.c: adjacency of simple rays by their edges; see edges.h.
 *
 * The hash of a set is the exclusive or of a word for each element, so that removing an element is
 * one operation. Equal hashes only propose a pair: it is accepted if the two rays have rank - 2
 * zeros in common, and the second is positive in the row that the edge of the first leaves out.
 */
#include "dd/edges.h"

#include <stdatomic.h>
#include <string.h>

#include "num/bitset.h"

void fmb_ray_edges_clear(fmb_ray_edges *e, fmb_mem *mem)
{
    fmb_mem_put(mem, e->edge, e->edge_capacity, sizeof *e->edge);
    fmb_mem_put(mem, e->table, e->table_capacity, sizeof *e->table);
    *e = (fmb_ray_edges){0};
}

/* Steele, Lea, Flood 2014, Fast splittable pseudorandom number generators: its finalizer. */
static uint64_t word_of_bit(size_t bit)
{
    uint64_t x = ((uint64_t)bit + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* The rows number 64 w ... 64 w + 63 in which the ray is zero, as bits. */
static uint64_t zeros_in_word(const fmb_edge_sides *of, uint32_t ray, size_t w)
{
    uint64_t zeros = ~of->support[ray * of->words + w];
    size_t left = of->bits > 64 * w ? of->bits - 64 * w : 0;
    return left >= 64 ? zeros : zeros & (((uint64_t)1 << left) - 1);
}

static uint64_t hash_zeros(const fmb_edge_sides *of, uint32_t ray)
{
    uint64_t hash = 0;
    for (size_t w = 0; w < of->words; w++)
        for (uint64_t z = zeros_in_word(of, ray, w); z != 0; z &= z - 1)
            hash ^= word_of_bit(64 * w + (size_t)__builtin_ctzll(z));
    return hash;
}

fmb_status fmb_ray_edges_begin(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_run *run)
{
    e->degree = of->rank - 1;
    size_t edges = of->smalls * e->degree, size = 64;
    while (size < 2 * edges)
        size *= 2;
    fmb_status st = FMB_RESERVE(run->mem, &e->edge, &e->edge_capacity, edges);
    FMB_THEN(st, FMB_RESERVE(run->mem, &e->table, &e->table_capacity, size));
    e->mask = size - 1;
    if (st == FMB_OK)
        memset((void *)e->table, 0xff, size * sizeof *e->table);
    return st;
}

/* Use the first free place from the key's own on; another thread may take it meanwhile. */
static void put_edge_into_table(fmb_ray_edges *e, uint64_t key, uint32_t number)
{
    for (size_t at = (size_t)key & e->mask;; at = (at + 1) & e->mask) {
        uint32_t free = FMB_NO_RAY;
        if (atomic_load_explicit(&e->table[at], memory_order_relaxed) == FMB_NO_RAY &&
            atomic_compare_exchange_strong_explicit(&e->table[at], &free, number,
                                                    memory_order_relaxed, memory_order_relaxed))
            return;
    }
}

/* Enter the edges of simple ray number i of the smaller side into the table. */
static void enter_edges(fmb_ray_edges *e, const fmb_edge_sides *of, size_t i)
{
    uint64_t hash = hash_zeros(of, of->small[i]);
    size_t number = i * e->degree;
    for (size_t w = 0; w < of->words; w++)
        for (uint64_t z = zeros_in_word(of, of->small[i], w); z != 0; z &= z - 1, number++) {
            size_t bit = 64 * w + (size_t)__builtin_ctzll(z);
            uint64_t key = hash ^ word_of_bit(bit);
            e->edge[number] = (fmb_ray_edge){key, (uint32_t)bit, FMB_NO_RAY};
            put_edge_into_table(e, key, (uint32_t)number);
        }
}

/* Is that edge also one of ray b? */
static bool ends_edge_at(const fmb_ray_edges *e, const fmb_edge_sides *of, size_t number,
                         uint32_t b)
{
    const uint64_t *x = of->support + of->small[number / e->degree] * of->words;
    const uint64_t *y = of->support + b * of->words;
    size_t gone = e->edge[number].gone, n = 0;
    for (size_t w = 0; w < of->words; w++)
        n += fmb_ones64(x[w] | y[w]);
    return n + of->rank == of->bits + 2 && fmb_set_has(y, gone);
}

/* An edge has at most one end on the larger side: no two rays write the same one. */
static void look_up_edges(fmb_ray_edges *e, const fmb_edge_sides *of, uint32_t b)
{
    uint64_t hash = hash_zeros(of, b);
    for (size_t w = 0; w < of->words; w++)
        for (uint64_t z = zeros_in_word(of, b, w); z != 0; z &= z - 1) {
            uint64_t key = hash ^ word_of_bit(64 * w + (size_t)__builtin_ctzll(z));
            for (size_t at = (size_t)key & e->mask;; at = (at + 1) & e->mask) {
                size_t number = atomic_load_explicit(&e->table[at], memory_order_relaxed);
                if (number == FMB_NO_RAY)
                    break;
                if (e->edge[number].key == key && ends_edge_at(e, of, number, b))
                    e->edge[number].end = b;
            }
        }
}

fmb_status fmb_ray_edges_enter(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_side_part part,
                               fmb_run *run)
{
    for (size_t i = part.from; i < part.to; i++) {
        if (fmb_is_simple(of, of->small[i]))
            enter_edges(e, of, i);
        FMB_TRY(fmb_run_poll(run));
    }
    return FMB_OK;
}

fmb_status fmb_ray_edges_look_up(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_side_part part,
                                 fmb_run *run)
{
    for (size_t j = part.from; j < part.to; j++) {
        if (fmb_is_simple(of, of->large[j]))
            look_up_edges(e, of, of->large[j]);
        FMB_TRY(fmb_run_poll(run));
    }
    return FMB_OK;
}

fmb_status fmb_ray_edges_find(fmb_ray_edges *e, const fmb_edge_sides *of, fmb_run *run)
{
    FMB_TRY(fmb_ray_edges_begin(e, of, run));
    FMB_TRY(fmb_ray_edges_enter(e, of, (fmb_side_part){0, of->smalls}, run));
    return fmb_ray_edges_look_up(e, of, (fmb_side_part){0, of->larges}, run);
}
