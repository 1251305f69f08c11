/* intersect_agree.c: are distances, depths, common points and rows consistent with the verdict?
 * They come from independent code of the library, so an error in one of them is noticed here. */
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

/* Open frames that meet also meet as closed ones, for which depth and common points are computed.
 */
static const char *contradiction_when_meeting(const near_ask *ask, const near_found *found)
{
    if (ask->depth && !found->depth)
        return "they meet, but have no depth";
    if (ask->common && !found->common)
        return "they meet, but have no common points";
    return NULL;
}

/* Open frames that only touch are apart, at a distance of 0. The row is computed with the contact
 * of the verdict. */
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
