/* peers.c: the drivers of this build, the usually fast ones first (see --quick). */
#include "peers.h"

#include <string.h>

/* Do the n bytes name p, or its library, which stands for all its drivers? */
static bool names(const char *word, size_t n, const peer *p)
{
    return (strlen(p->name) == n && strncmp(word, p->name, n) == 0) ||
           (strlen(p->library) == n && strncmp(word, p->library, n) == 0);
}

bool peer_is_listed(const char *list, const peer *p)
{
    for (const char *at = list; *at;) {
        size_t n = strcspn(at, ",");
        if (names(at, n, p))
            return true;
        at += n + (at[n] == ',');
    }
    return false;
}

bool peers_know_all(const char *list)
{
    for (const char *at = list; *at;) {
        size_t n = strcspn(at, ",");
        bool known = false;
        for (int i = 0; peers[i] && !known; i++)
            known = names(at, n, peers[i]);
        if (!known)
            return false;
        at += n + (at[n] == ',');
    }
    return true;
}

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

peer_make *peer_maker(const peer *p, peer_question question)
{
    return question == PEER_PROJECT    ? p->project
           : question == PEER_VERTICES ? p->vertices
           : question == PEER_HULL     ? p->hull
                                       : NULL;
}

const peer *const peers[] = {
    &peer_fmb,
    &peer_fmb_proof,
    &peer_fmb_cones,
    &peer_fmb_fm,
    &peer_fmb_dd,
    &peer_fmb_hull,
#ifdef PEERS_PPLITE
    &peer_pplite,
#endif
#ifdef PEERS_PPL
    &peer_ppl,
    &peer_ppl_cones,
#endif
#ifdef PEERS_NORMALIZ
    &peer_normaliz,
    &peer_normaliz_cones,
#endif
#ifdef PEERS_ISL
    &peer_isl,
#endif
#ifdef PEERS_CDD
    &peer_cdd_block,
    &peer_cdd_gens,
    &peer_cdd_fourier,
    &peer_cdd_cones,
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
#ifdef PEERS_LRS
    &peer_lrs,
#endif
    NULL,
};
