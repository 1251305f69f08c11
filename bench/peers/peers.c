/* peers.c: the drivers of this build, the usually fast ones first (see --quick). */
#include "peers.h"

peer_ask *peer_way(const peer *p, peer_question question)
{
    switch (question) {
    case PEER_DECIDE:
        return p->decide;
    case PEER_BOX:
        return p->box;
    case PEER_REDUCE:
        return p->reduce;
    case PEER_OPTIMIZE:
        return p->optimize;
    default:
        return NULL;
    }
}

const peer *const peers[] = {
    &peer_fmb,
    &peer_fmb_proof,
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
