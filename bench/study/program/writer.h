/* writer.h: a program under construction; for the families.
 *
 * A row is written term by term, then ended. After a failure nothing more is written, and st keeps
 * the first error.
 */
#ifndef FMB_STUDY_PROGRAM_WRITER_H
#define FMB_STUDY_PROGRAM_WRITER_H

#include "study/program/program.h"
#include "study/program/random.h"

typedef struct study_writer {
    study_random g;
    int rows, variables; /* as planned */
    int keep;            /* projections: the first `keep` variables are kept */
    int larger;          /* projections: growth of the sizes, 0 by default */
    study_program *to;
    fmb_status st;
    double *goal; /* [dim] the objective: whole numbers below 2^53 */
    /* The row being written. */
    int *var;
    mpq_t *coef;
    size_t terms, capacity;
    mpq_t right;
} study_writer;

/* Begin a system with that many variables; false if memory runs out. Call once, first. */
bool study_write_begin(study_writer *w, int variables);
/* Likewise, for a projection that keeps the first `keep` of them. */
bool study_write_image(study_writer *w, int variables, int keep);
/* A number lo ... hi. */
int study_draw(study_writer *w, int lo, int hi);
/* A size lo ... hi, plus the growth of a larger problem. */
int study_draw_size(study_writer *w, int lo, int hi);

void study_write_term(study_writer *w, int var, int64_t coef);
void study_write_term_q(study_writer *w, int var, int64_t num, uint64_t den);
void study_write_end(study_writer *w, fmb_rel rel, int64_t right);
void study_write_end_q(study_writer *w, fmb_rel rel, int64_t num, uint64_t den);
/* x_var >= least; x_var <= most. */
void study_write_least(study_writer *w, int var, int64_t least);
void study_write_most(study_writer *w, int var, int64_t most);
/* lo <= x <= hi of count variables from the first. */
void study_write_box(study_writer *w, int first, int count, int64_t lo, int64_t hi);
/* coef times each of count variables from the first. */
void study_write_sum(study_writer *w, int first, int count, int64_t coef);

/* The known optimum of the program. */
void study_write_best(study_writer *w, int64_t num, uint64_t den);
/* The goal becomes random, coefficients -9 ... 9. */
void study_write_any_goal(study_writer *w);

typedef void study_family(study_writer *w);

/* families_random.c: rows at random, around a point or a conflict */
study_family study_sparse_origin, study_sparse_point, study_sparse_conflict;
study_family study_dense_origin, study_dense_point, study_dense_conflict;
study_family study_degenerate, study_strict, study_equalities, study_unbounded, study_ball,
    study_sphere;
/* families_known.c: by name and from the books */
study_family study_klee_minty, study_beale, study_kuhn, study_cube, study_chain, study_chain_equal,
    study_strict_cycle;
/* families_flow.c: what practice looks like */
study_family study_assignment, study_transport, study_staircase;

/* images/rows.c: rows at random; the writer draws sizes */
study_family study_image_dense, study_image_wide, study_image_strict, study_image_sparse,
    study_image_boxed, study_image_cone, study_image_long, study_image_octagon, study_image_equal,
    study_image_endless, study_image_open, study_image_flat, study_image_none, study_image_cube,
    study_image_slice;
/* images/lifted.c: polytopes that have fewer rows in more variables */
study_family study_image_union, study_image_sum, study_image_zonotope, study_image_orbit,
    study_image_parity, study_image_knapsack;
/* images/practice.c: planning, networks, loops, entropies */
study_family study_image_schedule, study_image_petri, study_image_hydro, study_image_power,
    study_image_loops, study_image_entropy, study_image_metric, study_image_games;
/* images/structured.c: hulls of points, trees, stages, rows in plenty */
study_family study_image_points, study_image_local, study_image_scarce, study_image_tree,
    study_image_stages, study_image_packing, study_image_crowd, study_image_redundant;
/* images/systems.c: networks, controllers, programs, clocks */
study_family study_image_relu, study_image_control, study_image_value, study_image_chain,
    study_image_flow, study_image_transport, study_image_clocks;
/* images/networks.c: flows, cuts, sums of tables */
study_family study_image_cuts, study_image_marginals, study_image_fluxes, study_image_leaks,
    study_image_routes, study_image_measured;
/* images/plans.c: decisions over time */
study_family study_image_recourse, study_image_scenarios, study_image_lots, study_image_shifts,
    study_image_slots, study_image_windows, study_image_totals, study_image_steered,
    study_image_warmth;
/* images/data.c: measurements, choices, distributions */
study_family study_image_parameters, study_image_fits, study_image_moments, study_image_tails,
    study_image_beliefs, study_image_votes, study_image_shares, study_image_sorted;
/* images/markets.c: prices, shares of a gain */
study_family study_image_frontier, study_image_hedge, study_image_coalitions, study_image_packages;
/* images/mechanics.c: forces, positions, tolerances */
study_family study_image_grip, study_image_truss, study_image_tolerances, study_image_reach,
    study_image_sites, study_image_mixture;
/* images/automata.c: clocks, loops, gates */
study_family study_image_automaton, study_image_dependences, study_image_accesses,
    study_image_gates;
/* images/functions.c: functions by rows */
study_family study_image_products, study_image_bends, study_image_layers, study_image_covers;
/* images/shapes.c: sums of simplices, cells, polars, lattices */
study_family study_image_simplices, study_image_weights, study_image_cells, study_image_planes,
    study_image_polar, study_image_lattice;
/* images/mixed.c: rows of several kinds */
study_family study_image_mixed, study_image_fans, study_image_bound, study_image_plenty,
    study_image_mostly_kept, study_image_implied, study_image_blocks, study_image_band,
    study_image_differences;
/* images/choices.c: orders, matchings, decisions under chance */
study_family study_image_majority, study_image_degrees, study_image_payoffs, study_image_decisions,
    study_image_visits;
/* images/risks.c: portfolios, options, errors */
study_family study_image_dominance, study_image_quotes, study_image_protected,
    study_image_enclosures, study_image_codes;
/* images/fields.c: states in space and time, timing */
study_family study_image_estimates, study_image_membrane, study_image_scans, study_image_skews,
    study_image_legal;

#endif
