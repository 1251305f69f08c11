/* intersect_agree.c: does what was found near a pair agree with its verdict? Both come from
 * different ways through the library, so that one that is wrong is noticed here. */
#include "fmb/intersect_near.h"

static bool is_zero(const fmb_proximity *p)
{
    mpq_t measure;
    mpq_init(measure);
    fmb_proximity_measure_q(p, measure);
    bool zero = mpq_sgn(measure) == 0;
    mpq_clear(measure);
    return zero;
}

/* Frames that meet without their boundaries meet with them, where depth and common points are
 * asked for. */
static const char *contradiction_when_meeting(const near_ask *ask, const near_found *found)
{
    if (ask->depth && !found->depth)
        return "they meet, but have no depth";
    if (ask->common && !found->common)
        return "they meet, but have no common points";
    return NULL;
}

/* Frames that only touch are apart if they are open, at a distance of 0. The row is asked for with
 * the contact of the verdict. */
static const char *contradiction_when_apart(const near_ask *ask, fmb_contact contact,
                                            const near_found *found)
{
    if ((ask->distance || ask->within) && !found->distance)
        return "they are apart, but have no distance";
    if (contact == FMB_CONTACT_CLOSED && found->distance && is_zero(found->distance))
        return "they are apart, but at a distance of 0";
    if (ask->separate && !found->row)
        return "they are apart, but no row separates them";
    return NULL;
}

const char *near_contradiction(const near_ask *ask, fmb_contact contact, fmb_verdict verdict,
                               const near_found *found)
{
    if (found->stop != FMB_STOP_DONE || verdict == FMB_UNKNOWN)
        return NULL;
    return verdict == FMB_FEASIBLE ? contradiction_when_meeting(ask, found)
                                   : contradiction_when_apart(ask, contact, found);
}
