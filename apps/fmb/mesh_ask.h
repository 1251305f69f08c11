/* mesh_ask.h: what `fmb mesh` is asked, and its report. */
#ifndef APP_MESH_ASK_H
#define APP_MESH_ASK_H

#include <fmb/mesh.h>

typedef struct mesh_ask {
    const char *file[2]; /* the second may be NULL */
    fmb_mesh_format format;
    fmb_mesh_place place; /* its move; the scale is the following */
    double scale[3], motion[3];
    bool mirror[3], moves, neighbours, json, csv, quiet;
    size_t max_bytes, max_input;
} mesh_ask;

/* Print the answer. */
void mesh_report(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                 const fmb_mesh_answer *answer);

#endif
