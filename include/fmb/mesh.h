/* fmb/mesh.h: which cells of one or two meshes meet, and how; which are near; and the distance of
 * two meshes.
 *
 * A mesh is a set of triangles or of tetrahedra over common vertices in space. Every answer is
 * exact for the vertices as they are given: cells that share a vertex meet, however the differences
 * of coordinates round. A tree of boxes around groups of cells selects the pairs to test; signs of
 * determinants, in doubles with an error bound, then exactly, decide them; flat cells and moving
 * ones are decided as pairs of frames given by corners (<fmb/pair.h>).
 *
 * Sources: Devillers and Guigue, Faster triangle-triangle intersection tests, INRIA RR-4488, 2002
 * (signs of volumes); Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996 (two trees side by side).
 */
#ifndef FMB_MESH_H
#define FMB_MESH_H

#include <fmb/io.h>
#include <fmb/options.h>
#include <fmb/proximity.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- meshes ---------------------------------------------------------------------------------- */

/* A mesh. It never changes once it is made, so threads may share it. */
typedef struct fmb_mesh fmb_mesh;

/* The most vertices, and the most cells. */
#define FMB_MESH_MOST ((size_t)UINT32_MAX - 1)

/* [give] A mesh of cells with `corners` vertices each, 3 (triangles) or 4 (tetrahedra); everything
 * is copied. point: [vertices][3] in world length units; corner: [cells][corners], numbers of
 * vertices from 0. Cells may be flat, and may occur repeatedly. Errors: ARG (corners, a count
 * beyond FMB_MESH_MOST, a number that is not finite, no such vertex), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_new(int corners, size_t vertices, const double *point,
                                            size_t cells, const uint32_t *corner,
                                            const fmb_alloc *mem, fmb_mesh **out);
FMB_API void fmb_mesh_free(fmb_mesh *m);

/* All of these are 0 or NULL if m is NULL. */
FMB_API int fmb_mesh_corners(const fmb_mesh *m);
FMB_API size_t fmb_mesh_vertices(const fmb_mesh *m);
FMB_API size_t fmb_mesh_cells(const fmb_mesh *m);
/* [vertices][3] and [cells][corners], as they were given; they live as long as the mesh. */
FMB_API const double *fmb_mesh_points(const fmb_mesh *m);
FMB_API const uint32_t *fmb_mesh_indices(const fmb_mesh *m);
/* The number in its file, from 0, of the face or tetrahedron that cell c comes from: a face of more
 * than three corners is cut into triangles around its first corner. Of other meshes it is c. */
FMB_API size_t fmb_mesh_face(const fmb_mesh *m, size_t c);
/* The name of the group of faces that cell c belongs to, as in its file (OBJ: in the last line g or
 * o before the face; if it lists several groups, all of them as written), or NULL; it is valid as
 * long as the mesh. */
FMB_API const char *fmb_mesh_group(const fmb_mesh *m, size_t c);

/* A placement of a mesh: x_j becomes the double nearest to scale_j x_j + move_j. So equal vertices
 * stay equal, and queries are about the mesh with the rounded vertices. */
typedef struct fmb_mesh_place {
    double scale[3], move[3];
} fmb_mesh_place;

/* [give] The placed mesh. Errors: ARG (a number of place, or a new coordinate, that is not finite),
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_placed(const fmb_mesh *m, const fmb_mesh_place *place,
                                               const fmb_alloc *mem, fmb_mesh **out);

/* ---- files ----------------------------------------------------------------------------------- */

/* docs/formats.md, "meshes". */
typedef enum fmb_mesh_format {
    FMB_MESH_AUTO = 0, /* by content */
    FMB_MESH_OFF,
    FMB_MESH_OBJ,
    FMB_MESH_PLY,  /* text, or binary of either byte order */
    FMB_MESH_STL,  /* text or binary */
    FMB_MESH_MEDIT /* .mesh */
} fmb_mesh_format;

/* "off", "obj", "ply", "stl", "mesh" of a format; and back (also "auto"): false if the word is
 * unknown. */
FMB_API const char *fmb_mesh_format_text(fmb_mesh_format f);
FMB_API bool fmb_mesh_format_parse(const char *word, fmb_mesh_format *out);
/* Format by the ending of a file name, AUTO if that is unknown. */
FMB_API fmb_mesh_format fmb_mesh_format_of_name(const char *path);

/* [give] Read a mesh: a decimal means the double nearest to it. how->format and how->nearest are
 * ignored; how may be NULL. Errors: PARSE (malformed, no cell, or longer than max_bytes), IO,
 * MEMORY, ARG (a pointer that must not be NULL, no such format). After PARSE and ARG *where is
 * filled, if not NULL. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_read(FILE *in, fmb_mesh_format f, const fmb_reader *how,
                                             fmb_mesh **out, fmb_where *where);
/* [give] A mesh from size bytes of text. Errors: as above, without IO. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_parse(const char *text, size_t size, fmb_mesh_format f,
                                              const fmb_reader *how, fmb_mesh **out,
                                              fmb_where *where);

/* [give] Read TetGen's two files, points and tetrahedra. Errors: as above, and *in_cells (may be
 * NULL) says whether the error is in the second one. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_read_tetgen(FILE *points, FILE *cells,
                                                    const fmb_reader *how, fmb_mesh **out,
                                                    fmb_where *where, bool *in_cells);

/* [give] A mesh from the contents of these files. Errors: as above, without IO. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_parse_tetgen(const char *points, size_t points_size,
                                                     const char *cells, size_t cells_size,
                                                     const fmb_reader *how, fmb_mesh **out,
                                                     fmb_where *where, bool *in_cells);

/* ---- queries --------------------------------------------------------------------------------- */

/* How two closed cells meet. The interior of a cell is its relative interior: a triangle without
 * its edges. */
typedef enum fmb_mesh_how {
    FMB_MESH_APART = 0, /* not at all; a hit if they are near enough */
    FMB_MESH_SHARE,     /* only in the hull of the vertices that they share: neighbours of a sound
                           mesh */
    FMB_MESH_TOUCH,     /* their interiors do not meet, but they have other common points */
    FMB_MESH_CROSS,     /* their interiors meet */
    FMB_MESH_COPLANAR /* two triangles in one plane whose interiors meet; but CROSS if one is flat,
                         or has a coordinate beyond 2^200 or, other than 0, below 2^-200 */
} fmb_mesh_how;

/* "apart", "share", "touch", "cross", "coplanar" */
FMB_API const char *fmb_mesh_how_text(fmb_mesh_how h);

/* Two cells that meet, or are near. */
typedef struct fmb_mesh_hit {
    uint32_t a, b;    /* cells: of the first and of the second mesh; of one mesh, a < b */
    int shared;       /* vertices in common: equal points, whatever their numbers */
    fmb_mesh_how how; /* if something moves: TOUCH, for "they meet at some time", or APART */
} fmb_mesh_hit;

/* Options of mesh queries. The defaults: hits that are not mere neighbours, no motion, no limit. */
typedef struct fmb_mesh_options {
    size_t size;          /* sizeof(fmb_mesh_options) */
    bool neighbours;      /* report hits of kind SHARE, too: most pairs of a mesh with itself */
    const double *motion; /* [3] or NULL: the translation of the second mesh while t goes from 0 to
                             1 [world length units] */
    double max_seconds;   /* wall clock [s]; 0 = no limit */
    size_t max_bytes;     /* of the meshes, the hits, and the memory to find and sort them [bytes];
                             0 = no limit */
    size_t threads;       /* at most 64; 0 or 1: only the caller's. With more, mem must be safe for
                             threads. Answers are the same for any number, except at a limit */
    const fmb_alloc *mem; /* NULL: malloc */
    /* Called now and then by the caller's thread with the share done, 0 to 1; false: stop. May be
     * NULL. */
    bool (*progress)(void *self, double done);
    void *self;
    /* A length, "p" or "p/q" in decimal digits: cells whose exact distance (with a motion the least
     * of all times) is at most this are hits, too, APART unless they meet; "0" and NULL: none.
     * [world length units] */
    const char *within;
} fmb_mesh_options;

/* Why fmb_mesh_meet refuses these options, like fmb_options_trouble; for a mesh against itself it
 * refuses a motion, too. */
FMB_API size_t fmb_mesh_options_trouble(const fmb_mesh_options *o, char *text, size_t size);

/* Which cells meet. */
typedef struct fmb_mesh_answer {
    size_t size; /* sizeof(fmb_mesh_answer) */
    size_t hits;
    fmb_mesh_hit *hit; /* [hits] by a, then b */
    uint64_t tested;   /* pairs of cells whose boxes, rounded outward to floats, meet or are near
                          enough; without trees, all pairs */
    uint64_t framed;   /* of those, decided as frames, or by an exact distance */
    fmb_stop stop;     /* DONE; CANCELLED, TIME, BYTES: hits are incomplete */
    size_t capacity;   /* of hit; mem is its allocator */
    fmb_alloc mem;
} fmb_mesh_answer;

/* [give, fmb_mesh_answer_clear] Which cells of a and b meet; b NULL or a: which cells of a meet
 * one another. Errors: ARG (a or out NULL, a motion that is not finite, or of a mesh against
 * itself, max_seconds below 0 or NaN, within no length), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_meet(const fmb_mesh *a, const fmb_mesh *b,
                                             const fmb_mesh_options *o, fmb_mesh_answer *out);
/* [give, fmb_mesh_answer_clear] fmb_mesh_meet for the cells from ... to - 1 of a only, without
 * trees: each is tested against every cell of b (of a: every later one), whatever their boxes. For
 * checking the trees, and for dividing the work. Errors: ARG (as above; no such cells), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_meet_pairs(const fmb_mesh *a, size_t from, size_t to,
                                                   const fmb_mesh *b, const fmb_mesh_options *o,
                                                   fmb_mesh_answer *out);
/* NULL and an answer of zeros are fine. */
FMB_API void fmb_mesh_answer_clear(fmb_mesh_answer *a);

/* The distance of two meshes. */
typedef struct fmb_mesh_nearest {
    size_t size;             /* sizeof(fmb_mesh_nearest) */
    uint32_t a, b;           /* the nearest cells; of several pairs the first by a, then b */
    fmb_proximity *distance; /* their Euclidean distance (<fmb/proximity.h>); NULL at a limit, or if
                                a mesh has no cell */
    uint64_t tested;         /* pairs of cells tested, some of them twice */
    fmb_stop stop;           /* DONE; CANCELLED, TIME, BYTES */
} fmb_mesh_nearest;

/* [give, fmb_proximity_free of the distance] The exact distance of two meshes: the least of all
 * pairs of cells, with a motion the least of all times. Branch and bound over the trees finds a
 * bound in doubles, and the pairs within it are compared exactly. <fmb/proximity.h> gives a row
 * that separates the two cells; the meshes need not have one. The option `neighbours` is ignored.
 * Errors: ARG (a, b or out NULL, a and b one mesh, options as above, within not NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_mesh_distance(const fmb_mesh *a, const fmb_mesh *b,
                                                 const fmb_mesh_options *o, fmb_mesh_nearest *out);

#ifdef __cplusplus
}
#endif
#endif
