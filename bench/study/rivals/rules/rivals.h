/* rivals.h: published pruning rules of other authors, one in each file, and their shared helpers.
 *
 * They use only the interface of <fmb/rule.h>, and commands load them by --rule-library like any
 * user's rule. docs/rivals.md says what each drops and whether it is sound, with figures.
 */
#ifndef FMB_STUDY_RIVALS_H
#define FMB_STUDY_RIVALS_H

#include <fmb/rule.h>

/* Sound. */
extern const fmb_rule rival_bastrakov_zolotykh, rival_chernikov_sets, rival_imbert_first,
    rival_quasi_syntactic, rival_raytracing, rival_test_cone;
/* Not sound: each has a system on which it goes wrong in tests/unit/study/rival_rules. */
extern const fmb_rule rival_imbert_printed, rival_linarith, rival_simon_king;

/* Elements of a bit set. */
static inline int rival_count(const uint64_t *set, size_t words)
{
    int n = 0;
    for (size_t k = 0; k < words; k++)
        n += __builtin_popcountll(set[k]);
    return n;
}

/* Elements of the union of two. */
static inline int rival_count_union(const uint64_t *a, const uint64_t *b, size_t words)
{
    int n = 0;
    for (size_t k = 0; k < words; k++)
        n += __builtin_popcountll(a[k] | b[k]);
    return n;
}

/* Does the i-th live row have a history larger than Imbert's first theorem allows a minimal row to
 * have? (imbert_first.c) */
bool rival_imbert_exceeds(const fmb_view *w, size_t row);

#endif
