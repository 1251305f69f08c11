/* shadows.h: systems of integers whose shadows are hard to walk around, one kind each. */
#ifndef FMB_TEST_SHADOWS_H
#define FMB_TEST_SHADOWS_H

#include "dense.h"

/* Up to 6 variables and 20 rows, all <= but for those with equalities; the caller frees it. */
dense shadow_dense_rows(support_rng *g);
dense shadow_bounded(support_rng *g);
dense shadow_through_a_point(support_rng *g);
dense shadow_cone(support_rng *g);
dense shadow_with_equalities(support_rng *g);
dense shadow_flat(support_rng *g);
dense shadow_single_point(support_rng *g);
dense shadow_cross_polytope(support_rng *g);
dense shadow_pyramid(support_rng *g);
dense shadow_narrow(support_rng *g);
dense shadow_unnamed(support_rng *g);
dense shadow_wide(support_rng *g);

#endif
