/* epa.h: the penetration depth of two bodies, guessed in doubles and proved with an error bound.
 *
 * Source: G. van den Bergen, Proximity queries and penetration depth computation on 3D game
 * objects, Game Developers Conference 2001.
 */
#ifndef FMB_PAIR_CONTACT_EPA_H
#define FMB_PAIR_CONTACT_EPA_H

#include "pair/contact/gjk.h"

/* g has 0 inside its simplex (fmb_gjk_is_inside), or in the closed simplex if g->whole
 * (fmb_gjk_surrounds); then the depth is 0 iff 0 is on the boundary of M. *depth has an error of at
 * most 2^-40 reach, and so has the depth along normal[dim], its direction, away from the first
 * body. In units of the bodies. False: that could not be proved. */
bool fmb_epa_depth(const fmb_gjk *g, double *depth, double *normal);

#endif
