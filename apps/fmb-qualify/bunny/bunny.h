/* bunny.h: a mesh against its mirror image, as frames and as cells. */
#ifndef QUALIFY_BUNNY_H
#define QUALIFY_BUNNY_H

#include <stdlib.h>

#include <fmb/mesh.h>
#include <fmb/pair.h>

/* The faces of a mesh, one unit thick: simplices with two edges of the face and its normal. */
typedef struct bunny_body {
    size_t faces;
    double *number;   /* [faces][12]: origin, edges */
    fmb_frame *frame; /* [faces], into number */
    fmb_mesh *cells;  /* the simplices as tetrahedra with rounded corners */
} bunny_body;

/* [give, fmb_mesh_free] A mesh of triangles from a file; APP_YES, or an exit code after a message.
 * path NULL: a bumpy ball of about as many faces as the scan has. */
int bunny_read(const char *path, fmb_mesh **out);

/* [give, bunny_body_clear] From the mesh with its coordinates times 1000: (x, y, z) or, mirrored,
 * (50 - x, y - 10, z). Errors: MEMORY. */
fmb_status bunny_body_make(const fmb_mesh *m, bool mirrored, bunny_body *out);
void bunny_body_clear(bunny_body *b);

#endif
