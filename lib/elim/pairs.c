/* pairs.c: combine every lower with every upper row of a round, but for the pairs that rules refuse
 * beforehand. */
#include "elim/filter.h"
#include "elim/view.h"

static uint64_t count_bits(const uint64_t *set, size_t words)
{
    uint64_t n = 0;
    for (size_t k = 0; k < words; k++)
        n += (uint64_t)__builtin_popcountll(set[k]);
    return n;
}

/* Ask the rules about lower row i; what each adds to drop is its own. */
static fmb_status refuse_pairs(fmb_elim *e, const fmb_round *round, size_t lowers, size_t i,
                               uint64_t *drop)
{
    size_t words = fmb_set_words(round->rows - lowers);
    uint64_t before = 0;
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < e->workers; k++) {
        const fmb_rule *rule = e->worker[k].rule;
        if (!rule->drop_pairs)
            continue;
        fmb_window w;
        fmb_window_open(&w, e, round->var);
        w.view.lower = round->row;
        w.view.lowers = lowers;
        w.view.upper = round->row + lowers;
        w.view.uppers = round->rows - lowers;
        rule->drop_pairs(e->worker[k].state, &w.view, i, drop);
        st = fmb_window_close(&w);
        uint64_t after = count_bits(drop, words);
        fmb_elim_note_drop(e, k, after - before);
        before = after;
    }
    return st;
}

static fmb_status combine_row(fmb_elim *e, const fmb_round *round, size_t lowers, size_t i,
                              const uint64_t *drop)
{
    fmb_status st = fmb_run_poll(e->run);
    size_t uppers = round->rows - lowers;
    for (size_t word = 0; word < fmb_set_words(uppers); word++) {
        uint64_t left = ~drop[word];
        if (uppers - word * 64 < 64)
            left &= ((uint64_t)1 << (uppers - word * 64)) - 1;
        for (; left != 0 && st == FMB_OK && e->clash == FMB_NO_ROW; left &= left - 1) {
            size_t j = word * 64 + (size_t)__builtin_ctzll(left);
            st = fmb_elim_combine(e, round->row[i], round->row[lowers + j], round->var);
        }
    }
    return st;
}

fmb_status fmb_elim_pair(fmb_elim *e, const fmb_round *round, size_t lowers)
{
    size_t uppers = round->rows - lowers;
    fmb_status st = FMB_OK;
    fmb_filter_new_round(e->filter);
    for (size_t i = 0; st == FMB_OK && e->clash == FMB_NO_ROW && i < lowers; i++) {
        uint64_t *drop = fmb_filter_bits(e->filter, uppers, e->run->mem);
        if (!drop)
            return fmb_mem_status(e->run->mem);
        e->run->stats.pairs += uppers;
        st = refuse_pairs(e, round, lowers, i, drop);
        if (st == FMB_OK)
            st = combine_row(e, round, lowers, i, drop);
    }
    return st;
}
