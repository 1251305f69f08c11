/* lying.c: answers about what is near that are never true, in place of the library's, for a command
 * that is to notice. In the norm max it only seems that a limit was reached. */
#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>

static void end(fmb_norm norm, fmb_result *res)
{
    *res = (fmb_result){.size = sizeof(fmb_result),
                        .stop = norm == FMB_NORM_MAX ? FMB_STOP_TIME : FMB_STOP_DONE};
}

fmb_status fmb_depth_q(fmb_solver *v, const fmb_frame_q *f, fmb_norm norm, fmb_proximity **out,
                       fmb_result *res)
{
    (void)v, (void)f;
    *out = NULL;
    end(norm, res);
    return FMB_OK;
}

/* That of a point from itself; in the norm max none at all. */
fmb_status fmb_distance_q(fmb_solver *v, const fmb_frame_q *f, fmb_norm norm, fmb_proximity **out,
                          fmb_result *res)
{
    const double here[] = {0};
    const fmb_frame point = {FMB_CUBOID, 1, 0, here, NULL, NULL}, same[2] = {point, point};
    (void)f;
    fmb_status st = fmb_distance(v, same, norm, out, res);
    end(norm, res);
    if (norm == FMB_NORM_MAX) {
        fmb_proximity_free(*out);
        *out = NULL;
    }
    return st;
}

fmb_status fmb_common_q(fmb_solver *v, const fmb_frame_q *f, fmb_generators **out, fmb_result *res)
{
    (void)v, (void)f;
    *out = NULL;
    end(FMB_NORM_EUCLIDEAN, res);
    return FMB_OK;
}

fmb_status fmb_separate_q(fmb_solver *v, const fmb_frame_q *f, fmb_contact contact,
                          fmb_system **out, fmb_result *res)
{
    (void)v, (void)f, (void)contact;
    *out = NULL;
    end(FMB_NORM_EUCLIDEAN, res);
    return FMB_OK;
}
