/* epa.h: how deep two bodies are in each other, guessed in doubles and proved with an error bound.
 *
 * Source: G. van den Bergen, Proximity queries and penetration depth computation on 3D game
 * objects, Game Developers Conference 2001.
 */
#ifndef FMB_PAIR_CONTACT_EPA_H
#define FMB_PAIR_CONTACT_EPA_H

#include "pair/contact/gjk.h"

/* g: with 0 inside of its simplex (fmb_gjk_is_inside), or in it if g is whole
 * (fmb_gjk_surrounds); the depth is then 0 iff 0 is on the boundary of M. *depth: off by at most
 * 2^-40 of the reach; normal[dim]: its direction, away from the first, and the depth along it is
 * off by no more. In units of the bodies. False: that is not certain. */
bool fmb_epa_depth(const fmb_gjk *g, double *depth, double *normal);

#endif
