/* mesh_draft.h: a mesh being read from a text. A reader fills a draft through these calls, which
 * grow it with the text: the sizes in a header reserve no memory, and are only checked against the
 * data that follow.
 */
#ifndef FMB_IO_MESH_MESH_DRAFT_H
#define FMB_IO_MESH_MESH_DRAFT_H

#include "io/core/cursor.h"
#include "mesh/mesh_private.h"

typedef struct fmb_mesh_draft {
    fmb_mem *mem;
    double *point; /* [points] */
    size_t points, point_capacity;
    /* Triangles, cut from faces, and tetrahedra. */
    uint32_t *triangle, *face, *tetrahedron;
    size_t triangles, triangle_capacity, face_capacity, tetrahedra, tetrahedron_capacity;
    uint32_t *group; /* [group_capacity] of triangles: as in fmb_mesh, if names_size > 0 */
    char *names;
    size_t group_capacity, names_size, name_capacity;
    uint32_t group_now;   /* the group of the faces that follow */
    size_t faces;         /* read from the file so far */
    uint32_t first, last; /* corners of the face being added */
    int face_corners;
    size_t base;                 /* the number of the first vertex: 0 or 1 (TetGen) */
    void (*skip)(fmb_cursor *c); /* skips the text between two words */
} fmb_mesh_draft;

void fmb_mesh_draft_clear(fmb_mesh_draft *d);

/* Errors of the functions below: PARSE (too many), MEMORY. */
fmb_status fmb_mesh_draft_point(fmb_cursor *c, fmb_mesh_draft *d, const double p[3]);
/* Begin a face, then add three or more corners: a fan of triangles around the first one. */
void fmb_mesh_draft_face(fmb_mesh_draft *d);
fmb_status fmb_mesh_draft_corner(fmb_cursor *c, fmb_mesh_draft *d, size_t vertex);
/* The faces that follow belong to the group of that name; to none, if it is empty. */
fmb_status fmb_mesh_draft_group(fmb_cursor *c, fmb_mesh_draft *d, fmb_span name);
fmb_status fmb_mesh_draft_tetrahedron(fmb_cursor *c, fmb_mesh_draft *d, const uint32_t corner[4]);

/* ---- words of a text ------------------------------------------------------------------------- */

/* For d->skip: skips line ends, blanks, and comments from # to the end of a line. */
void fmb_mesh_skip_comments(fmb_cursor *c);
/* The functions below call d->skip first. Errors: PARSE. */
fmb_status fmb_mesh_scan_real(fmb_cursor *c, const fmb_mesh_draft *d, double *out);
fmb_status fmb_mesh_scan_point(fmb_cursor *c, const fmb_mesh_draft *d, double out[3]);
fmb_status fmb_mesh_scan_size(fmb_cursor *c, const fmb_mesh_draft *d, const char *what,
                              size_t *out);
/* Read the number of one of `vertices` vertices, counted from `base`; *out counts from 0. */
fmb_status fmb_mesh_scan_vertex(fmb_cursor *c, const fmb_mesh_draft *d, size_t base,
                                size_t vertices, size_t *out);

/* ---- formats --------------------------------------------------------------------------------- */

typedef fmb_status fmb_mesh_read_fn(fmb_cursor *c, fmb_mesh_draft *d);
fmb_mesh_read_fn fmb_mesh_read_off, fmb_mesh_read_obj, fmb_mesh_read_ply, fmb_mesh_read_stl,
    fmb_mesh_read_medit, fmb_mesh_read_node, fmb_mesh_read_ele;
/* Has the text the size that the header of a binary STL file announces? */
bool fmb_mesh_is_binary_stl(const fmb_cursor *c);

/* ---- binary numbers -------------------------------------------------------------------------- */

/* Read n <= 8 bytes as an unsigned integer in that byte order. Errors: PARSE (end of the text while
 * reading `what`). */
fmb_status fmb_mesh_take_bytes(fmb_cursor *c, int n, bool big_endian, const char *what,
                               uint64_t *out);
/* The floating-point number with these bits, of n = 4 or 8 bytes. */
double fmb_mesh_real_of_bits(uint64_t bits, int n);

#endif
