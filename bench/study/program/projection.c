/* projection.c: the table of families of projections. See projection.h. */
#include "study/program/projection.h"

#include <stdlib.h>

#include "study/program/writer.h"

static const struct {
    const char *name, *about;
    study_family *write;
} FAMILY[] = {
    {"dense", "all terms, around the origin; two or three of up to eight stay", study_image_dense},
    {"wide", "all terms, few rows, four to six of up to nine stay", study_image_wide},
    {"sparse", "three terms a row", study_image_sparse},
    {"strict", "all terms, every other row strict", study_image_strict},
    {"cone", "all rows through the origin", study_image_cone},
    {"long", "numbers of ten digits", study_image_long},
    {"octagon", "+-x +-y <= c", study_image_octagon},
    {"equal", "a third of the variables are bound by equalities", study_image_equal},
    {"endless", "all rows let a planted ray through", study_image_endless},
    {"open", "few rows around many variables, which often leave all of them behind",
     study_image_open},
    {"flat", "a hidden equality between kept and eliminated variables", study_image_flat},
    {"none", "a hidden contradiction", study_image_none},
    {"cube", "a sheared cube", study_image_cube},
    {"slice", "a unit cube between three pairs of parallel planes", study_image_slice},
    {"relu", "outputs of a network of rectifiers, by the triangle relaxation", study_image_relu},
    {"control", "states that can be kept in a box by bounded inputs", study_image_control},
    {"union", "the convex hull of polytopes (Balas)", study_image_union},
    {"sum", "the Minkowski sum of two polytopes", study_image_sum},
    {"zonotope", "a sum of segments", study_image_zonotope},
    {"orbit", "the hull of all orders of some numbers, by doubly stochastic matrices",
     study_image_orbit},
    {"parity", "0/1 vectors of even or odd sum", study_image_parity},
    {"value", "the best value of a linear program over its right side", study_image_value},
    {"chain", "x_i+1 in terms of x_i, three along it stay", study_image_chain},
    {"flow", "what arcs of a network can carry", study_image_flow},
    {"transport", "what some of the shipments can be", study_image_transport},
    {"knapsack", "0/1 knapsacks as paths through a table", study_image_knapsack},
    {"clocks", "differences of clocks, after a delay", study_image_clocks},
    {"boxed", "three terms of four digits a row, in a box", study_image_boxed},
    {"schedule", "ends and begins of jobs that wait for others", study_image_schedule},
    {"petri", "markings of a Petri net, by its state equation", study_image_petri},
    {"hydro", "what reservoirs along a river let through", study_image_hydro},
    {"power", "what may be fed into a network of lines", study_image_power},
    {"loops", "sizes and tiles of a nest of loops", study_image_loops},
    {"entropy", "entropies of some sets of three or four sources", study_image_entropy},
    {"metric", "some distances of four to six points", study_image_metric},
    {"games", "what a player may be sure of in several games at once", study_image_games},
    {"points", "the hull of points, by their weights", study_image_points},
    {"local", "probabilities of events and of pairs of them", study_image_local},
    {"scarce", "two or three terms a row, half of the variables stay", study_image_scarce},
    {"tree", "variables bound to their parents in a tree", study_image_tree},
    {"stages", "stocks with which a production plan can begin", study_image_stages},
    {"packing", "sums of some variables are bounded", study_image_packing},
    {"crowd", "ten to thirty rows a variable", study_image_crowd},
    {"redundant", "two of three rows are sums of others", study_image_redundant},
    /* Those from here to "cells" were held out of earlier fits of the choice of ways, or invented
     * for one: now all of them are fitted to. */
    {"cuts", "capacities that every cut has, by potentials", study_image_cuts},
    {"marginals", "sums of cells of a table of three ways", study_image_marginals},
    {"recourse", "what a decision costs in a second stage", study_image_recourse},
    {"automaton", "clocks after steps with guards, resets and delays", study_image_automaton},
    {"mostly kept", "two to four terms a row, few variables go", study_image_mostly_kept},
    {"tails", "bounds on the sum of the largest values", study_image_tails},
    {"lots", "which periods make something", study_image_lots},
    {"parameters", "what measurements with bounded errors leave, ten digits",
     study_image_parameters},
    {"weights", "sums of vectors, flat or endless images", study_image_weights},
    {"mixture", "contents of mixtures, within strict bounds", study_image_mixture},
    {"sites", "points not too far from others, by absolute values", study_image_sites},
    {"dependences", "distances of iterations that touch the same elements",
     study_image_dependences},
    {"frontier", "what can be made of what, as observed units show", study_image_frontier},
    {"hedge", "money and shares that are enough to pay later", study_image_hedge},
    {"grip", "forces that fingers with friction withstand", study_image_grip},
    {"gates", "and and or of numbers between 0 and 1", study_image_gates},
    {"warmth", "power by the hour that keeps rooms warm", study_image_warmth},
    {"fluxes", "exchanges of a network of reactions in balance", study_image_fluxes},
    {"shifts", "hours of groups that cover a day", study_image_shifts},
    {"scenarios", "what is made at once, and costs over a tree of events", study_image_scenarios},
    {"reach", "states that bounded inputs reach, in units of 2^20 and 2^-20", study_image_reach},
    {"coalitions", "shares that no coalition improves on", study_image_coalitions},
    {"beliefs", "probabilities at the ends of a chain, by pairs", study_image_beliefs},
    {"accesses", "elements that a nest of loops touches", study_image_accesses},
    {"votes", "weights of criteria behind choices, strictly", study_image_votes},
    {"tolerances", "deviations of parts along chains, in millionths", study_image_tolerances},
    {"truss", "loads that the bars of a truss bear", study_image_truss},
    {"mixed", "rows of all kinds, in a box or none", study_image_mixed},
    {"fans", "rows of all kinds through the origin", study_image_fans},
    {"bound", "rows of all kinds, a quarter of them equalities", study_image_bound},
    {"plenty", "many rows in three to five variables", study_image_plenty},
    {"blocks", "blocks of variables, bound together by what stays", study_image_blocks},
    {"band", "rows of neighbours along a line or a ring", study_image_band},
    {"measured", "sums of neighbours between bounds", study_image_measured},
    {"differences", "differences of two, and sums of some", study_image_differences},
    {"layers", "at least some functions of what is below, in layers", study_image_layers},
    {"planes", "a box between pairs of planes", study_image_planes},
    {"covers", "some of each set, and what all cost", study_image_covers},
    {"sorted", "numbers in order, sums of the first ones bounded", study_image_sorted},
    {"lattice", "heights on a lattice, whose neighbours are close", study_image_lattice},
    {"shares", "shares with bounded ratios", study_image_shares},
    {"steered", "what a state costs to be steered", study_image_steered},
    {"windows", "stocks by bounded sums over windows of time", study_image_windows},
    {"totals", "totals of totals with bounds", study_image_totals},
    {"packages", "prices of goods behind those of packages", study_image_packages},
    {"polar", "polars of points, of which one or two variables go", study_image_polar},
    {"leaks", "what comes into a network whose arcs lose and gain", study_image_leaks},
    {"simplices", "a sum of simplices on some axes each", study_image_simplices},
    {"routes", "loads of links, by routes of demands", study_image_routes},
    {"fits", "coefficients and greatest errors of fits, ten digits", study_image_fits},
    {"moments", "moments of distributions, in powers of 2", study_image_moments},
    {"implied", "rows that follow from given ones", study_image_implied},
    {"slots", "begins of jobs, by slots of their windows", study_image_slots},
    {"products", "sums of products in boxes, by envelopes", study_image_products},
    {"bends", "functions by their bends, under a bound", study_image_bends},
    {"cells", "cells of planes with normals of -1, 0, 1, strictly", study_image_cells},
    /* Held out of the fit of the choice of ways: they judge it, and no fit may see them. */
    {"majority", "pairs of candidates, by shares of all orders", study_image_majority},
    {"degrees", "degrees of fractional matchings", study_image_degrees},
    {"payoffs", "pay of workers and firms that no pair improves on", study_image_payoffs},
    {"decisions", "bounds of the values of a decision process", study_image_decisions},
    {"visits", "rewards of a decision process, by visits of states", study_image_visits},
    {"dominance", "portfolios with small shortfalls", study_image_dominance},
    {"quotes", "prices of options, by those of others", study_image_quotes},
    {"protected", "decisions that bear a few errors", study_image_protected},
    {"enclosures", "solutions of equations with errors, 1 to 10 digits", study_image_enclosures},
    {"codes", "solutions with short sums of absolute values", study_image_codes},
    {"estimates", "states by measurements with errors", study_image_estimates},
    {"membrane", "heights of a membrane above an obstacle", study_image_membrane},
    {"scans", "cells of a picture, by sums along lines", study_image_scans},
    {"skews", "the period of a circuit, delays and skews", study_image_skews},
    {"legal", "schedules of loops, by Farkas' lemma", study_image_legal},
};

enum { UNSEEN = 15, APART = 56, FAMILIES = (int)(sizeof FAMILY / sizeof *FAMILY) - APART - UNSEEN };

/* Seeds are spread as when there were so many families, so that no problem changes. */
enum { SPREAD = 28 };

int study_projections(void)
{
    return FAMILIES;
}

int study_projections_apart(void)
{
    return APART;
}

int study_projections_unseen(void)
{
    return UNSEEN;
}

const char *study_projection_name(int family)
{
    return FAMILY[family].name;
}

const char *study_projection_about(int family)
{
    return FAMILY[family].about;
}

fmb_status study_projection_draw(int family, uint64_t seed, study_projection *out)
{
    return study_projection_draw_larger(family, seed, 0, out);
}

fmb_status study_projection_draw_larger(int family, uint64_t seed, int larger,
                                        study_projection *out)
{
    study_program p = {.s = NULL};
    study_writer w = {.to = &p, .g.state = seed * SPREAD + (uint64_t)family, .larger = larger};
    mpq_inits(p.best, w.right, NULL);
    FAMILY[family].write(&w);
    for (size_t k = 0; k < w.capacity; k++)
        mpq_clear(w.coef[k]);
    mpq_clears(p.best, w.right, NULL);
    free(w.var);
    free(w.goal);
    free(w.coef);
    if (w.st == FMB_OK)
        *out = (study_projection){p.s, w.keep};
    else
        fmb_system_free(p.s);
    return w.st;
}
