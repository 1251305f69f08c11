/* measure.h: what the study of other libraries measures; peers.c reports it. */
#ifndef QUALIFY_PEERS_MEASURE_H
#define QUALIFY_PEERS_MEASURE_H

#include "fmb-qualify/peers/peer.h"
#include "fmb-qualify/study.h"
#include "study/clock/clock.h"
#include "study/draw/pairs.h"

enum { PEERS_MOST = 16, PEERS_KINDS = 4, PEERS_FAMILIES = 4 };

/* Shapes of A and B; the last kind, PEERS_BOXES: cuboids with right angles. */
enum { PEERS_BOXES = PEERS_KINDS - 1 };
extern const fmb_shape peers_shape[PEERS_KINDS][2];
extern const study_pair_family peers_family[PEERS_FAMILIES];

/* Times on pairs of one kind of the article's generator, all meeting or all disjoint. */
typedef struct peers_times {
    bool complete;
    size_t pairs;
    study_spread ns[PEERS_MOST];   /* of a query, over the passes; NaN: not asked */
    study_ratio ratio[PEERS_MOST]; /* over driver 0 */
    size_t wrong[PEERS_MOST];      /* answers that differ from the class */
} peers_times;

/* Answers on pairs of one family, of all kinds. A pair touches if the closed frames meet but the
 * open ones do not: there both answers pass. */
typedef struct peers_faults {
    bool complete;
    size_t touching[PEERS_MOST], touching_meet[PEERS_MOST]; /* all; said to meet */
    size_t clear[PEERS_MOST];                               /* pairs asked that do not touch */
    size_t false_meet[PEERS_MOST], false_apart[PEERS_MOST], unknown[PEERS_MOST]; /* of clear ones */
} peers_faults;

/* Exit codes, after a message unless it is APP_YES. */
int peers_time(const peer_driver *const *driver, size_t drivers, int kind, bool meets,
               const qualify_setup *o, peers_times *out);
int peers_judge(const peer_driver *const *driver, size_t drivers, study_pair_family family,
                const qualify_setup *o, peers_faults *out);

#endif
