/* fmb/geometry.h: cuboids, simplices and meshes: do they meet, where, how near, how deep?
 *
 *   numbers -> fmb_frame -> fmb_pair (two at a time) or fmb_frames (stored once, queried often)
 *   file -> fmb_mesh -> fmb_mesh_meet
 *
 * Systems and the questions about them: <fmb/fmb.h>.
 */
#ifndef FMB_GEOMETRY_H
#define FMB_GEOMETRY_H

#include <fmb/frame.h>
#include <fmb/frames.h>
#include <fmb/mesh.h>
#include <fmb/pair.h>
#include <fmb/proximity.h>

#endif
