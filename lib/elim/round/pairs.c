/* pairs.c: combines every lower with every upper row of a round, except for pairs that rules refuse
 * beforehand. */
#include "elim/history/filter.h"
#include "elim/round/round.h"
#include "elim/rules/prune.h"

static fmb_status combine_with_uppers(fmb_elim *e, const fmb_round *round, size_t lowers, size_t i,
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

bool fmb_elim_is_slice_over(fmb_elim *e)
{
    e->paused = e->pauses && fmb_run_is_slice_over(e->run);
    return e->paused;
}

fmb_status fmb_elim_pair(fmb_elim *e, const fmb_round *round)
{
    size_t lowers = e->at.lowers, uppers = round->rows - lowers;
    fmb_status st = FMB_OK;
    if (e->at.next == 0)
        fmb_filter_new_round(e->filter);
    for (; st == FMB_OK && e->clash == FMB_NO_ROW && e->at.next < lowers; e->at.next++) {
        size_t i = e->at.next;
        if (fmb_elim_is_slice_over(e))
            return FMB_LIMIT;
        uint64_t *drop = fmb_filter_bits(e->filter, uppers, e->run->mem);
        if (!drop)
            return fmb_mem_status(e->run->mem);
        e->run->stats.pairs += uppers;
        st = fmb_rules_refuse_pairs(e, round, lowers, i, drop);
        FMB_THEN(st, combine_with_uppers(e, round, lowers, i, drop));
    }
    return st;
}
