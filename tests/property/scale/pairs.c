/* pairs.c: the law of pairs (law.h): verdicts, boxes in every mode, witnesses. */
#include <math.h>

#include "property/scale/bodies.h"

typedef struct told {
    fmb_verdict verdict;
    double world[BODIES_MOST_DIM][2], inside[BODIES_MOST_DIM][2], time[2];
} told;

static told ask_pair(const fmb_pair_options *o, const fmb_frame f[2])
{
    told t = {.time = {0, 1}};
    fmb_pair *k = NULL;
    must(fmb_pair_new(f[0].dim, o, NULL, &k));
    fmb_pair_answers out = {.size = sizeof out,
                            .verdict = &t.verdict,
                            .world = t.world[0],
                            .inside = t.inside[0],
                            .time = t.time};
    must(fmb_pair_test(k, 1, &f[0], &f[1], &out));
    fmb_pair_free(k);
    return t;
}

static fmb_verdict ask_verdict(const fmb_pair_options *o, const fmb_frame f[2])
{
    fmb_pair *k = NULL;
    fmb_verdict v = FMB_UNKNOWN;
    must(fmb_pair_new(f[0].dim, o, NULL, &k));
    must(fmb_pair_test(k, 1, &f[0], &f[1],
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &v}));
    fmb_pair_free(k);
    return v;
}

/* A tightest end is the exact one rounded outward. Where 2^power keeps it normal, rounding commutes
 * with it; elsewhere the scaled end is that of the plain one or further out by one step: the plain
 * one is out by less than half a step of the least doubles. */
static bool is_scaled_end(double plain, double scaled, int side, int power)
{
    double there = ldexp(plain, power);
    if (fabs(there) >= 0x1p-1022 || plain == 0)
        return scaled == there;
    double step = ldexp(1, -1074);
    return scaled == there || scaled == (side == 0 ? there - step : there + step);
}

static bool same_ends(const told *plain, const told *scaled, const bodies *b, char why[LAW_WHY])
{
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j < b->dim; j++)
            if (!is_scaled_end(plain->world[j][side], scaled->world[j][side], side, b->power[j]))
                return law_broken(why, "coordinate of the box", j, b->power[j]);
        for (int i = 0; i < b->plain[1].naxes; i++)
            if (plain->inside[i][side] != scaled->inside[i][side])
                return law_broken(why, "inside, axis and side", i, side);
        if (plain->time[side] != scaled->time[side])
            return law_broken(why, "time, side", side, side);
    }
    return true;
}

/* The answer holds the tightest box, whatever the mode. */
static bool holds_ends(const told *outer, const told *tight, const bodies *b, char why[LAW_WHY])
{
    for (int j = 0; j < b->dim; j++)
        if (outer->world[j][0] > tight->world[j][0] || outer->world[j][1] < tight->world[j][1])
            return law_broken(why, "quick box misses points, coordinate", j, b->power[j]);
    for (int i = 0; i < b->plain[1].naxes; i++)
        if (outer->inside[i][0] > tight->inside[i][0] || outer->inside[i][1] < tight->inside[i][1])
            return law_broken(why, "quick box misses points, inside", i, i);
    if (outer->time[0] > tight->time[0] || outer->time[1] < tight->time[1])
        return law_broken(why, "quick box misses times", 0, 0);
    return true;
}

bool law_of_pairs(law_source *g, char why[LAW_WHY])
{
    bodies b;
    bodies_draw(g, false, true, &b);
    for (int contact = 0; contact < 2; contact++)
        for (int method = 0; method < 2; method++) {
            fmb_pair_options o = {.size = sizeof o};
            o.contact = (fmb_contact)contact;
            o.method = (fmb_pair_method)method;
            fmb_verdict v = ask_verdict(&o, b.plain), w = ask_verdict(&o, b.scaled);
            if (v != w)
                return law_broken(why, contact ? "open verdict" : "verdict", (int)v, (int)w);
            told quick = ask_pair(&o, b.scaled);
            o.tightest = true;
            told plain = ask_pair(&o, b.plain), scaled = ask_pair(&o, b.scaled);
            if (quick.verdict != v || plain.verdict != v || scaled.verdict != v)
                return law_broken(why, "verdict beside a box", (int)v, (int)scaled.verdict);
            if (v == FMB_FEASIBLE &&
                !(same_ends(&plain, &scaled, &b, why) && holds_ends(&quick, &scaled, &b, why)))
                return false;
        }
    return true;
}
