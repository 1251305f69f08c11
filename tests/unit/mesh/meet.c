/* meet.c: trees find what all pairs find. */
#include <criterion/criterion.h>

#include <fmb/mesh.h>

#include "property/random/rows.h"
#include "support/support.h"

Test(meet, nothing)
{
    cr_expect(fmb_mesh_meet(NULL, NULL, NULL, NULL) == FMB_ERR_ARG);
}
