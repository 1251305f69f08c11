/* wide.c: see wide.h. */
#include "pair/extreme/wide.h"

/* to += a b in magnitude; there is room for carries. */
static void add_product_of_words(uint64_t *to, const fmb_wide *a, const fmb_wide *b)
{
    for (int i = 0; i < a->n; i++) {
        uint64_t x = a->word[i], carry = 0;
        int k = i;
        for (int j = 0; j < b->n; j++, k++) {
            fmb_u128 sum = (fmb_u128)x * b->word[j] + to[k] + carry;
            to[k] = (uint64_t)sum;
            carry = (uint64_t)(sum >> 64);
        }
        for (; carry != 0; k++) {
            to[k] += carry;
            carry = to[k] < carry;
        }
    }
}

/* out = large - small, of n words. */
static void subtract_words(fmb_wide *out, const uint64_t *large, const uint64_t *small, int n)
{
    uint64_t borrow = 0;
    for (int i = 0; i < n; i++) {
        uint64_t less = large[i] - small[i];
        out->word[i] = less - borrow;
        borrow = (large[i] < small[i]) | (less < borrow);
    }
    out->n = n;
}

/* Products are gathered by their signs; in the end one sum is taken from the other. */
void fmb_wide_dot(fmb_wide *out, int n, const fmb_wide *const *a, const fmb_wide *const *b,
                  unsigned minus)
{
    uint64_t part[2][FMB_WIDE_WORDS + 1];
    int words = 0, top;
    for (int i = 0; i < n; i++)
        if (a[i]->n > 0 && b[i]->n > 0 && a[i]->n + b[i]->n > words)
            words = a[i]->n + b[i]->n;
    assert(words <= FMB_WIDE_WORDS);
    for (int i = 0; i <= words; i++)
        part[0][i] = part[1][i] = 0;
    for (int i = 0; i < n; i++)
        if (a[i]->n > 0 && b[i]->n > 0)
            add_product_of_words(part[(a[i]->minus != b[i]->minus) != (minus >> i & 1)], a[i],
                                 b[i]);
    for (top = words; top >= 0 && part[0][top] == part[1][top]; top--)
        ;
    assert(top < FMB_WIDE_WORDS);
    out->minus = top >= 0 && part[0][top] < part[1][top];
    subtract_words(out, part[out->minus], part[!out->minus], top + 1);
    fmb_wide_trim(out);
}
