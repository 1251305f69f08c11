/* dixon.c: p-adic lifting; see dixon.h. */
#include "lp/linalg/exact/dixon.h"

#include <string.h>

#include "num/gcd.h"

/* A residual of row k stays below 2^62 + 2^61 + 5 in a word if the sum S of the row's |entries| is
 * at most 2^62: |r - B d| / p <= |r| / p + S, and a digit of the right side is less than p. */
#define WORD_BITS 62

fmb_status fmb_dixon_init(fmb_dixon *l, fmb_arena *arena, const fmb_prime *q, const fmb_sparse *b,
                          const fmb_sweep *first, const fmb_sweep *second)
{
    size_t n = b->n;
    *l = (fmb_dixon){.mem = arena->mem, .q = q, .b = b, .first = first, .second = second, .n = n};
    l->wide = b->bits_max > WORD_BITS;
    FMB_TRY(FMB_ARENA_GET(arena, l->first_step, n));
    FMB_TRY(FMB_ARENA_GET(arena, l->second_step, n));
    FMB_TRY(FMB_ARENA_GET(arena, l->v, n));
    FMB_TRY(FMB_ARENA_GET(arena, l->word_start, n + 1));
    bool *all;
    FMB_TRY(FMB_ARENA_GET(arena, all, n));
    l->word_start[0] = 0;
    for (size_t k = 0; k < n; k++)
        l->word_start[k + 1] =
            l->word_start[k] + (b->bits[k] <= WORD_BITS ? 1 : b->bits[k] / 64 + 2);
    FMB_TRY(FMB_ARENA_GET(arena, l->word, l->word_start[n]));
    memset(all, true, n * sizeof *all);
    l->first_steps = fmb_sweep_reach(first, all, l->first_step);
    l->second_steps = fmb_sweep_reach(second, all, l->second_step);
    return FMB_OK;
}

static void forget_rests(fmb_dixon *l)
{
    while (l->rests > 0)
        mpz_clear(l->rest[--l->rests].rest);
}

void fmb_dixon_clear(fmb_dixon *l)
{
    if (!l->mem)
        return;
    forget_rests(l);
    fmb_mem_put(l->mem, l->rest, l->rest_room, sizeof *l->rest);
    fmb_mem_put(l->mem, l->digit, l->digit_room, sizeof *l->digit);
    l->mem = NULL;
}

/* The residual of row k becomes `value`, |value| < 2^63. */
static void set_residual(fmb_dixon *l, size_t k, int64_t value)
{
    size_t at = l->word_start[k];
    l->word[at] = (fmb_word)value;
    while (++at < l->word_start[k + 1])
        l->word[at] = value < 0 ? ~(fmb_word)0 : 0;
}

fmb_status fmb_dixon_begin(fmb_dixon *l, mpz_t *right, const int *at)
{
    l->digits = 0;
    forget_rests(l);
    for (size_t k = 0; k < l->n; k++) {
        mpz_srcptr b = right[at[k]];
        if (mpz_sizeinbase(b, 2) < FMB_PRIME_BITS) {
            set_residual(l, k, fmb_integer_get_i64(b));
            continue;
        }
        fmb_status st = FMB_RESERVE(l->mem, &l->rest, &l->rest_room, l->rests + 1);
        if (st != FMB_OK)
            return st;
        fmb_dixon_rest *rest = &l->rest[l->rests++];
        rest->place = (int)k;
        mpz_init(rest->rest);
        uint64_t low = fmb_integer_divide_u64(rest->rest, b, l->q->p);
        set_residual(l, k, mpz_sgn(b) < 0 ? -(int64_t)low : (int64_t)low);
    }
    return FMB_OK;
}

/* ---- words ----------------------------------------------------------------------------------- */

/* The residual of row k modulo p. */
static uint64_t reduce_residual(const fmb_dixon *l, size_t k)
{
    const fmb_word *w = l->word + l->word_start[k];
    size_t words = l->word_start[k + 1] - l->word_start[k];
    if (words == 1)
        return fmb_prime_of_signed(l->q, (int64_t)w[0]);
    /* from the sign down, as 2^64 = 8 c */
    uint64_t x = (int64_t)w[words - 1] < 0 ? l->q->p - 1 : 0;
    while (words-- > 0)
        x = fmb_prime_fold(l->q, fmb_u128_join(x, w[words]));
    return x;
}

/* w -= f times the entry t. */
static void subtract_product(fmb_word *w, size_t words, const fmb_sparse *b, size_t t, uint64_t f)
{
    fmb_word small = fmb_abs64(b->value[t]);
    mpz_srcptr big = b->big ? b->big[t] : NULL;
    size_t size = big ? fmb_integer_words(big) : 1;
    bool minus = big ? mpz_sgn(big) > 0 : b->value[t] > 0;
    uint64_t carry;
    if (minus)
        carry =
            big ? fmb_words_subtract_product(w, big, f) : fmb_word_subtract_product(w, small, f);
    else
        carry = big ? fmb_words_add_product(w, big, f) : fmb_word_add_product(w, small, f);
    if (words > size && minus)
        fmb_words_subtract(w + size, words - size, carry);
    else if (words > size)
        fmb_words_add(w + size, words - size, carry);
}

/* w / p, which is known to be an integer, modulo 2^64 to the power of `words`. */
static void divide_words_exactly(fmb_word *w, size_t words, const fmb_prime *q)
{
    for (size_t k = 0; k < words; k++) {
        w[k] *= q->inverse;
        uint64_t over = fmb_u128_high(fmb_u128_product(w[k], q->p));
        if (k + 1 < words)
            fmb_words_subtract(w + k + 1, words - k - 1, over);
    }
}

static void update_short_residual(fmb_dixon *l, size_t k)
{
    const fmb_sparse *b = l->b;
    uint64_t x = l->word[l->word_start[k]];
    for (size_t t = b->start[k]; t < b->start[k + 1]; t++)
        x -= (uint64_t)b->value[t] * l->v[b->index[t]];
    l->word[l->word_start[k]] = x * l->q->inverse;
}

static void update_residual(fmb_dixon *l, size_t k)
{
    const fmb_sparse *b = l->b;
    fmb_word *w = l->word + l->word_start[k];
    size_t words = l->word_start[k + 1] - l->word_start[k];
    if (words == 1) {
        update_short_residual(l, k);
        return;
    }
    for (size_t t = b->start[k]; t < b->start[k + 1]; t++)
        subtract_product(w, words, b, t, l->v[b->index[t]]);
    divide_words_exactly(w, words, l->q);
}

/* ---- digits ---------------------------------------------------------------------------------- */

static void take_in_next_right_digit(fmb_dixon *l)
{
    for (size_t i = 0; i < l->rests; i++) {
        fmb_dixon_rest *rest = &l->rest[i];
        if (mpz_sgn(rest->rest) == 0)
            continue;
        bool minus = mpz_sgn(rest->rest) < 0;
        size_t k = (size_t)rest->place, words = l->word_start[k + 1] - l->word_start[k];
        fmb_word *w = l->word + l->word_start[k];
        uint64_t low = fmb_integer_divide_u64(rest->rest, rest->rest, l->q->p);
        if (minus)
            fmb_words_subtract(w, words, low);
        else
            fmb_words_add(w, words, low);
    }
}

fmb_status fmb_dixon_step(fmb_dixon *l)
{
    size_t n = l->n;
    FMB_TRY(FMB_RESERVE(l->mem, &l->digit, &l->digit_room, (l->digits + 1) * n));
    for (size_t k = 0; k < n; k++)
        l->v[k] = reduce_residual(l, k);
    fmb_sweep_run(l->first, l->q, l->first_step, l->first_steps, l->v);
    fmb_sweep_run(l->second, l->q, l->second_step, l->second_steps, l->v);
    memcpy(l->digit + l->digits * n, l->v, n * sizeof *l->v);
    l->digits++;
    for (size_t k = 0; k < n; k++)
        if (l->wide)
            update_residual(l, k);
        else
            update_short_residual(l, k);
    take_in_next_right_digit(l);
    return FMB_OK;
}

/* One poll for this many digits, which take at most milliseconds. */
#define ASKING_DIGITS 512

fmb_status fmb_dixon_value(fmb_dixon *l, size_t k, size_t digits, mpz_t out, const fmb_poll *poll)
{
    fmb_status st = FMB_OK;
    (void)mpz_limbs_write(out, (mp_size_t)(digits * FMB_PRIME_BITS / GMP_NUMB_BITS + 2));
    mpz_limbs_finish(out, 0); /* 0, with memory for all digits */
    for (size_t s = digits; st == FMB_OK && s-- > 0;) {
        fmb_integer_times_u64(out, out, l->q->p);
        fmb_integer_plus_u64(out, out, l->digit[s * l->n + k]);
        st = s > 0 && s % ASKING_DIGITS == 0 ? fmb_poll_ask(poll) : FMB_OK;
    }
    return st;
}
