/* peers.h: all possible drivers; peers.c lists the drivers of this build. */
#ifndef FMB_PEERS_PEERS_H
#define FMB_PEERS_PEERS_H

#include "peer.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const peer peer_fmb, peer_fmb_proof, peer_fmb_fm, peer_fmb_dd, peer_fmb_hull, peer_cdd_block,
    peer_cdd_fourier, peer_cdd_gens, peer_ppl, peer_pplite, peer_isl, peer_normaliz, peer_glpk,
    peer_qsopt, peer_z3, peer_fmb_cones, peer_ppl_cones, peer_normaliz_cones, peer_cdd_cones,
    peer_lrs;

#ifdef __cplusplus
}
#endif
#endif
