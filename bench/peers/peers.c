/* peers.c: the drivers of this build, the usually fast ones first (see --quick). */
#include "peers.h"

const peer *const peers[] = {
    &peer_fmb,
#ifdef PEERS_PPL
    &peer_ppl,
#endif
#ifdef PEERS_NORMALIZ
    &peer_normaliz,
#endif
#ifdef PEERS_ISL
    &peer_isl,
#endif
#ifdef PEERS_CDD
    &peer_cdd_block,
    &peer_cdd_gens,
    &peer_cdd_fourier,
#endif
#ifdef PEERS_GLPK
    &peer_glpk,
#endif
#ifdef PEERS_QSOPT
    &peer_qsopt,
#endif
#ifdef PEERS_Z3
    &peer_z3,
#endif
    NULL,
};
