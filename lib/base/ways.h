/* ways.h: the optional engines and tricks, on which no answer depends, each with a switch.
 *
 * A switch never changes an answer: if a way is off, another one computes it. A build with
 * -Dablate=true (FMB_ABLATE) can switch each way off, and counts how often it was asked and how
 * often it answered; bench/ablate makes docs/ways.md of these counts. In every other build all ways
 * are on, and this file leaves no code behind.
 *
 *   if (suits && fmb_way(FMB_WAY_RECESSION)) ... fmb_way_answered(FMB_WAY_RECESSION, done);
 *
 * A row: identifier, name, the files that only this way needs (room/name, without .c or .h; a star
 * for all of a folder), and a description. A way stays in the library while it pays: docs/ways.md.
 */
#ifndef FMB_BASE_WAYS_H
#define FMB_BASE_WAYS_H

#include <stdbool.h>
#include <stddef.h>

/* clang-format off */
#define FMB_WAYS(WAY)                                                                              \
    WAY(RECESSION, "recession directions", "solve/prepare/recession",                              \
        "projections: recession directions that leave all rows behind")                            \
    WAY(BOUNDED_GROWTH, "bounded elimination", "",                                                 \
        "projections: variables that make few rows are eliminated first")                          \
    WAY(PRUNED, "pruned elimination", "solve/query/rule_lp",                                       \
        "projections: elimination pruned by the oracle, where cones are large")                    \
    WAY(RAYS, "rays", "", "projections: double description within a budget")                       \
    WAY(KNOWN, "known rows", "hull/support/support_known",                                         \
        "support queries: facets that are rows of the system")                                     \
    WAY(LATTICE, "rounding to a lattice", "lp/oracle/lattice_point",                               \
        "oracle: solutions of short numbers by rounding")                                          \
    WAY(REFINED_FARKAS, "Farkas by refinement", "lp/oracle/refined_farkas lp/oracle/refinement",   \
        "oracle: conflicts between long numbers by iterative refinement")                          \
    WAY(TRIANGULAR, "substitution", "lp/linalg/exact/triangular", "exact: triangular bases")       \
    WAY(MINORS, "minors", "lp/linalg/exact/minors", "exact: small bases without fractions")        \
    WAY(FACTORED, "LU with updates",                                                               \
        "lp/linalg/doubles/triangle lp/linalg/doubles/updated_lu "                                 \
        "lp/linalg/doubles/updated_lu_solve lp/linalg/doubles/eliminate_core",                     \
        "doubles: a basis as sparse triangles instead of a dense inverse")                         \
    WAY(RAY_SHOOTING, "ray shooting",                                                              \
        "lp/redundancy/ray_shooting/ray_shooting lp/redundancy/ray_shooting/ray_sorter "           \
        "lp/redundancy/ray_shooting/polar_points lp/redundancy/ray_shooting/polar_points_open "    \
        "lp/redundancy/ray_shooting/ray lp/redundancy/ray_shooting/spatial_blocks "                \
        "lp/redundancy/ray_shooting/membership "                                                   \
        "lp/redundancy/ray_shooting/centre",                                                       \
        "redundancy: rows seen from a point inside")                                               \
    WAY(ACTIVE_SET, "active set",                                                                  \
        "lp/redundancy/active_set/implied lp/redundancy/active_set/active_set "                    \
        "lp/redundancy/active_set/rounded_proof "                                                  \
        "lp/redundancy/active_set/interior_point",                                                 \
        "elimination: implied rows, guessed among few active ones")                                \
    WAY(EDGES, "edges of rays", "dd/edges",                                                        \
        "double description: adjacency of simple rays by their edges")                             \
    WAY(ROUGH, "facets in doubles", "hull/facets/facets_roughly hull/facets/facets_normals",       \
        "hulls: sides of facets by doubles with an error bound")                                   \
    WAY(SQUEEZE, "last variable", "elim/round/squeeze",                                            \
        "elimination: the last variable by its ends, not by pairs")                                \
    WAY(TINY, "tiny systems", "elim/tiny/*", "verdicts: elimination on the stack")                 \
    WAY(PAIR_KERNELS, "kernels of pairs", "pair/kernels/verdict/*",                                \
        "pairs: verdicts side by side, with error bounds")                                         \
    WAY(PAIR_FLAT, "kernels of few axes",                                                          \
        "pair/kernels/verdict/verdict_flat pair/kernels/packed/packed_flat",                       \
        "pairs: verdict kernels for any number of axes")                                           \
    WAY(PAIR_CORNERS, "signs of determinants", "pair/corners/decide_corners",                      \
        "pairs: verdicts on triangles and tetrahedra by their corners")                            \
    WAY(PAIR_VERTICES, "exact vertices", "pair/exact_box/*",                                       \
        "pairs: exact verdicts and boxes in up to eight dimensions")                               \
    WAY(PAIR_DOUBLES, "pairs in doubles", "pair/general/*",                                        \
        "pairs: verdicts and boxes in any dimension, proved in doubles")
/* clang-format on */

#define FMB_WAY_IDENTIFIER(id, name, files, about) FMB_WAY_##id,
typedef enum fmb_way_id { FMB_WAYS(FMB_WAY_IDENTIFIER) FMB_WAY_COUNT } fmb_way_id;
#undef FMB_WAY_IDENTIFIER

#ifdef FMB_ABLATE

typedef struct fmb_ways {
    bool off[FMB_WAY_COUNT];
    unsigned long long asked[FMB_WAY_COUNT], answered[FMB_WAY_COUNT];
} fmb_ways;

/* The switches and counts; bench/ablate puts them into memory shared between processes. Not for
 * several threads. */
extern fmb_ways *fmb_ways_at_hand;

/* Is the way on? Counts the question, too. */
static inline bool fmb_way(fmb_way_id way)
{
    fmb_ways_at_hand->asked[way]++;
    return !fmb_ways_at_hand->off[way];
}

static inline void fmb_way_answered(fmb_way_id way, bool answered)
{
    fmb_ways_at_hand->answered[way] += answered;
}

#else

static inline bool fmb_way(fmb_way_id way)
{
    (void)way;
    return true;
}

static inline void fmb_way_answered(fmb_way_id way, bool answered)
{
    (void)way;
    (void)answered;
}

#endif
#endif
