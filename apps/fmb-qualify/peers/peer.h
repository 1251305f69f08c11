/* peer.h: a common interface to other libraries that decide whether two frames meet.
 *
 * A driver prepares all pairs untimed, as a user of that library who keeps shapes would; only its
 * answers are timed. A library is asked only about shapes that it supports.
 */
#ifndef QUALIFY_PEER_H
#define QUALIFY_PEER_H

#include <fmb/pair.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Pairs of static frames with three axes in three dimensions; borrowed as long as a driver is open.
 */
typedef struct peer_work {
    size_t n;
    const fmb_frame *p, *q;
    fmb_simd simd;
} peer_work;

/* The frames that a driver takes: all; only simplices; only cuboids with right angles. */
typedef enum peer_takes { PEER_TAKES_ALL, PEER_TAKES_SIMPLICES, PEER_TAKES_BOXES } peer_takes;

typedef struct peer_driver {
    const char *name;
    const char *how; /* the measured call; one line */
    peer_takes takes;
    /* Errors: MEMORY. */
    fmb_status (*open)(const peer_work *w, void **self);
    /* Pairs first ... first + n - 1 into verdict[0..n). */
    fmb_status (*ask)(void *self, size_t first, size_t n, fmb_verdict *verdict);
    void (*close)(void *self);
} peer_driver;

/* Ours, and the algorithms of bench/study. */
extern const peer_driver peer_fmb, peer_sat, peer_article, peer_seidel, peer_tetra;
/* Other libraries, where installed. */
extern const peer_driver peer_ccd_gjk, peer_ccd_mpr, peer_fcl_ccd, peer_fcl_own, peer_fcl_obb,
    peer_fcl_box, peer_ode, peer_ode_box;

/* ---- frames as polytopes --------------------------------------------------------------------- */

enum { PEER_MOST_VERTICES = 8, PEER_MOST_FACES = 6 };

typedef struct peer_hull {
    int vertices, faces, corners; /* corners of each face */
    double vertex[PEER_MOST_VERTICES][3];
    int face[PEER_MOST_FACES][4]; /* anticlockwise as seen from outside */
} peer_hull;

void peer_hull_of(const fmb_frame *f, peer_hull *out);
void peer_centre(const fmb_frame *f, double *out);

/* A cuboid with right angles: unit axes, right-handed, and the side length along each. */
typedef struct peer_box {
    double centre[3], axis[3][3], side[3];
} peer_box;

void peer_box_of(const fmb_frame *f, peer_box *out);

#ifdef __cplusplus
}
#endif
#endif
