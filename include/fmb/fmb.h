/* fmb/fmb.h: systems of linear inequalities, and the questions about them.
 *
 *   text -> fmb_system -> fmb_solver -> fmb_result + fmb_evidence -> fmb_check
 *
 * Frames, pairs of them and meshes: <fmb/geometry.h>. Exact values in GMP's types: <fmb/gmp.h>.
 */
#ifndef FMB_FMB_H
#define FMB_FMB_H

#include <fmb/base.h>
#include <fmb/generators.h>
#include <fmb/io.h>
#include <fmb/lift.h>
#include <fmb/options.h>
#include <fmb/proof.h>
#include <fmb/rule.h>
#include <fmb/session.h>
#include <fmb/solve.h>
#include <fmb/symmetry.h>
#include <fmb/system.h>
#include <fmb/trace.h>

#endif
