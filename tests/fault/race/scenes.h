/* scenes.h: systems with known answers whose queries take from microseconds to seconds. */
#ifndef FMB_TEST_SCENES_H
#define FMB_TEST_SCENES_H

#include <fmb/system.h>

enum { SCENES_MOST = 16, SCENE_KEEP = 16 };

typedef struct scene {
    const char *name;
    fmb_system *s;
    fmb_verdict verdict;
    int keep[SCENE_KEEP], kept; /* what to project on */
    bool cone;                  /* every variable ranges over [0, infinity) */
} scene;

/* All of them, and how many; release each s. The first is tiny; SCENE_HARD is Shannon's cone of 5
 * random variables (31 variables, 85 rows), projected on a cycle of entropies; from SCENE_SLOW on
 * queries take long. */
enum { SCENE_TINY = 0, SCENE_SLOW = 5, SCENE_HARD = 9 };
int scenes_all(scene out[SCENES_MOST]);

#endif
