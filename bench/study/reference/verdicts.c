/* verdicts.c: see verdicts.h. */
#include "study/reference/verdicts.h"

#include "study/sat/sat.h"

typedef struct way {
    const char *text;
    study_pair_method method;
    bool closed, open; /* which contact its verdicts speak about */
} way;

/* Doubles are asked about closed frames. Of ours, whole numbers tell that closed frames touch;
 * those of SAT are certain only where the contact does not matter. */
static const way WAY[STUDY_PAIR_WAYS] = {
    [STUDY_FMB_DOUBLES] = {"fmb-doubles", STUDY_BY_FMB, true, false},
    [STUDY_SAT_DOUBLES] = {"sat-doubles", STUDY_BY_SAT, true, true},
    [STUDY_FMB_CLOSED] = {"fmb-closed", STUDY_BY_FMB, true, false},
    [STUDY_SAT_CLOSED] = {"sat-closed", STUDY_BY_SAT, true, false},
    [STUDY_FMB_OPEN] = {"fmb-open", STUDY_BY_FMB, false, true},
    [STUDY_SAT_OPEN] = {"sat-open", STUDY_BY_SAT, false, true},
    [STUDY_EXACT_CLOSED] = {"exact-closed", STUDY_BY_EXACT, true, false},
    [STUDY_EXACT_OPEN] = {"exact-open", STUDY_BY_EXACT, false, true},
};

static const char *const FAULT[STUDY_FAULTS] = {"sat",       "exact",    "itself",   "contact",
                                                "undecided", "outside",  "wide",     "tightest",
                                                "witness",   "unproved", "textbook", "near"};

const char *study_fault_text(int i)
{
    return FAULT[i];
}

const char *study_way_text(study_way_of_pairs which)
{
    return WAY[which].text;
}

study_pair_method study_way_method(study_way_of_pairs which)
{
    return WAY[which].method;
}

fmb_pair_options study_way_options(study_way_of_pairs which, fmb_simd simd)
{
    const way *w = &WAY[which];
    fmb_pair_options o = {.size = sizeof o};
    o.method = w->method == STUDY_BY_EXACT ? FMB_PAIR_EXACT : FMB_PAIR_FMB;
    o.contact = w->closed ? FMB_CONTACT_CLOSED : FMB_CONTACT_OPEN;
    o.doubles_only = which == STUDY_FMB_DOUBLES || which == STUDY_SAT_DOUBLES;
    o.simd = simd;
    return o;
}

fmb_status study_way_open(study_way_of_pairs which, int dim, fmb_simd simd, fmb_pair **out)
{
    fmb_pair_options o = study_way_options(which, simd);
    return WAY[which].method == STUDY_BY_SAT ? study_sat_new(dim, &o, out)
                                             : fmb_pair_new(dim, &o, NULL, out);
}

enum { MEETS = 1, APART = 2, BOTH = 3 };

static unsigned claim(fmb_verdict said)
{
    return said == FMB_FEASIBLE ? MEETS : said == FMB_INFEASIBLE ? APART : 0;
}

/* What ways of one method claim for one contact. */
static unsigned claims(const study_verdicts *v, study_pair_method method, bool open)
{
    unsigned all = 0;
    for (int i = 0; i < STUDY_PAIR_WAYS; i++)
        for (int order = 0; order < 2; order++)
            if ((v->asked >> i & 1) && WAY[i].method == method &&
                (open ? WAY[i].open : WAY[i].closed))
                all |= claim(v->said[i][order]);
    return all;
}

static bool is_undecided(const study_verdicts *v)
{
    bool some = false;
    for (int i = STUDY_FMB_CLOSED; i < STUDY_PAIR_WAYS; i++)
        for (int order = 0; order < 2; order++)
            some |= (v->asked >> i & 1) && v->said[i][order] == FMB_UNKNOWN;
    return some;
}

unsigned study_verdict_faults(const study_verdicts *v)
{
    unsigned faults = is_undecided(v) ? STUDY_FAULT_UNDECIDED : 0, all[2];
    for (int open = 0; open < 2; open++) {
        unsigned fmb = claims(v, STUDY_BY_FMB, open), sat = claims(v, STUDY_BY_SAT, open);
        unsigned exact = claims(v, STUDY_BY_EXACT, open) | claim(v->proved[open]);
        if (fmb == BOTH || sat == BOTH || exact == BOTH)
            faults |= STUDY_FAULT_ITSELF;
        if ((fmb | sat) == BOTH && fmb != BOTH && sat != BOTH)
            faults |= STUDY_FAULT_SAT;
        if (exact != 0 && ((fmb | exact) == BOTH || (sat | exact) == BOTH))
            faults |= STUDY_FAULT_EXACT;
        all[open] = fmb | sat | exact;
    }
    if (all[0] == APART && (all[1] & MEETS))
        faults |= STUDY_FAULT_CONTACT;
    return faults;
}
