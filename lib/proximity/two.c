/* two.c: see two.h. */
#include "proximity/two.h"

fmb_status fmb_two_expect(fmb_solver *v, const fmb_two *two, bool out, const fmb_result *res)
{
    char fault[FMB_FRAME_FAULT_SIZE] = "";
    fmb_status st;
    if (!v || !out || (!two->f && !two->q))
        return fmb_solver_refuse(v, FMB_ERR_ARG, "%s is NULL",
                                 !v     ? "the solver"
                                 : !out ? "out"
                                        : "f");
    if ((st = fmb_solver_expect_result(v, res)) != FMB_OK)
        return st;
    if (fmb_two_dim(two) < 1)
        return fmb_solver_refuse(v, FMB_ERR_ARG, "dim is %d, not at least 1", fmb_two_dim(two));
    for (int k = 0; two->f && k < 2; k++)
        if (fmb_frame_describe_fault(&two->f[k], two->f[0].dim, fault, sizeof fault))
            return fmb_solver_refuse(v, FMB_ERR_ARG, "f[%d]: %s", k, fault);
    for (int k = 0; two->q && k < 2; k++)
        if (!fmb_frame_q_is_good(&two->q[k], two->q[0].dim))
            return fmb_solver_refuse(v, FMB_ERR_ARG, "f[%d] is no frame", k);
    return FMB_OK;
}

int fmb_two_dim(const fmb_two *two)
{
    return two->f ? two->f[0].dim : two->q[0].dim;
}

bool fmb_two_moves(const fmb_two *two)
{
    return two->f ? two->f[0].speed || two->f[1].speed : two->q[0].speed || two->q[1].speed;
}

fmb_status fmb_two_system(const fmb_two *two, fmb_coordinates in, fmb_contact contact,
                          const fmb_alloc *mem, fmb_system **out)
{
    return fmb_frames_within_limits(two->f, two->q, 2, in, contact, mem, NULL, out);
}
