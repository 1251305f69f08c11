/* mesh_ask.h: the options of `fmb mesh`, and its answers. */
#ifndef APP_MESH_ASK_H
#define APP_MESH_ASK_H

#include <fmb/mesh.h>

#include "fmb/intersect_near.h"

typedef struct mesh_ask {
    const char *file[2]; /* the second may be NULL */
    const char *marked;  /* a file to write, or NULL */
    fmb_mesh_format format;
    fmb_mesh_place place; /* its move; the scale is the following */
    double scale[3], motion[3];
    bool mirror[3], moves, neighbours, where, common, all_pairs, json, csv, quiet;
    int digits;    /* of decimals, or 0: fractions, and doubles as they are */
    near_ask near; /* its distance, or its within and margin */
    char *within;  /* the margin as text, or NULL */
    double max_seconds;
    size_t max_bytes, max_input, threads;
} mesh_ask;

/* ---- mesh_files.c: exit codes, after messages ------------------------------------------------ */

/* [give, fmb_mesh_free] */
int mesh_file_read(const mesh_ask *ask, const char *path, fmb_mesh **out);
/* Replace *m by the placed mesh. */
int mesh_file_place(const mesh_ask *ask, fmb_mesh **m);
/* Write both meshes, b may be NULL; returns code, or that of an error. */
int mesh_mark(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
              const fmb_mesh_answer *answer, int code);

/* ---- mesh_ranks.c ---------------------------------------------------------------------------- */

/* [give, fmb_mesh_free] Send the mesh that rank 0 has read, if its code is APP_YES, or NULL, to all
 * ranks. Returns rank 0's code. */
int mesh_share(int code, fmb_mesh **m);
/* [give, free() out->hit] Test all pairs, without trees, by all ranks: rank 0 gets the answer and
 * calls how->progress; how->max_bytes is for all ranks together, how->max_seconds for all rows.
 * Errors: as fmb_mesh_meet_pairs, of this rank only. */
fmb_status mesh_meet_pairs(const fmb_mesh *a, const fmb_mesh *b, const fmb_mesh_options *how,
                           fmb_mesh_answer *out);

/* ---- mesh_report.c --------------------------------------------------------------------------- */

/* Print the answer; returns code, or that of an error. */
int mesh_report(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                const fmb_mesh_answer *answer, int code);
/* Print a distance and the row between the nearest cells, likewise. */
int mesh_report_nearest(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                        const fmb_mesh_nearest *nearest, int code);

#endif
