/* fmb/fmb.h: everything but the exact values (<fmb/gmp.h>).
 *
 *   text -> fmb_system -> fmb_solver -> fmb_result + fmb_evidence -> fmb_check
 */
#ifndef FMB_FMB_H
#define FMB_FMB_H

#include <fmb/base.h>
#include <fmb/frame.h>
#include <fmb/frames.h>
#include <fmb/generators.h>
#include <fmb/io.h>
#include <fmb/lift.h>
#include <fmb/mesh.h>
#include <fmb/options.h>
#include <fmb/pair.h>
#include <fmb/proof.h>
#include <fmb/proximity.h>
#include <fmb/rule.h>
#include <fmb/session.h>
#include <fmb/solve.h>
#include <fmb/symmetry.h>
#include <fmb/system.h>
#include <fmb/trace.h>

#endif
