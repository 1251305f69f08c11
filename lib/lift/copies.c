/* copies.c: the variables of polyhedra in a lift of several; see lift_private.h. */
#include <stdio.h>
#include <string.h>

#include "lift/lift_private.h"
#include "system/system_private.h"

int fmb_lift_dim(const fmb_system *s)
{
    int n = 0;
    for (int j = 0; j < fmb_system_dim(s); j++)
        n += fmb_system_keeps(s, j);
    return n;
}

/* ---- names ----------------------------------------------------------------------------------- */

fmb_status fmb_lift_add_answer(fmb_system *lift, const fmb_system *s)
{
    lift->asks_projection = true;
    for (int j = 0; j < fmb_system_dim(s); j++) {
        int index;
        if (!fmb_system_keeps(s, j))
            continue;
        FMB_TRY(fmb_system_add_variable(lift, fmb_system_name(s, j), &index));
        fmb_system_set_kept(lift, index, true);
    }
    return FMB_OK;
}

fmb_status fmb_lift_add_fresh(fmb_system *lift, const char *name, size_t k, int *index)
{
    size_t room = strlen(name) + 24 + (size_t)fmb_system_dim(lift);
    char *fresh;
    FMB_TRY(FMB_GET(&lift->mem, fresh, room));
    int n = k > 0 ? snprintf(fresh, room, "%s_%zu", name, k) : snprintf(fresh, room, "%s", name);
    for (; fmb_system_find(lift, fresh) >= 0; n++)
        memcpy(fresh + n, "_", 2);
    fmb_status st = fmb_system_add_variable(lift, fresh, index);
    fmb_mem_put(&lift->mem, fresh, room, 1);
    return st;
}

fmb_status fmb_lift_add_copies(fmb_system *lift, const fmb_system *s, size_t k, int *copy)
{
    for (int j = 0; j < fmb_system_dim(s); j++)
        FMB_TRY(fmb_lift_add_fresh(lift, fmb_system_name(s, j), k, &copy[j]));
    return FMB_OK;
}

/* Counts are equal, and names in s distinct: so if each is in `like`, the names are the same. */
static fmb_status match_names(fmb_system *lift, const fmb_system *like, const fmb_system *s,
                              size_t k)
{
    int n = fmb_lift_dim(s), expected = fmb_lift_dim(like);
    for (int j = 0; j < fmb_system_dim(s); j++) {
        const char *name = fmb_system_name(s, j);
        int found = fmb_system_find(like, name);
        if (fmb_system_keeps(s, j) && (found < 0 || !fmb_system_keeps(like, found)))
            return fmb_system_refuse(lift, "variable '%.80s' of number %zu is not one of number 1",
                                     name, k + 1);
    }
    return n == expected
               ? FMB_OK
               : fmb_system_refuse(lift, "number %zu has %d variables, but number 1 has %d", k + 1,
                                   n, expected);
}

fmb_status fmb_lift_match(fmb_system *lift, const fmb_system *const *s, size_t n)
{
    FMB_TRY(n > 0 && s ? FMB_OK : fmb_system_refuse(lift, "expected at least one system"));
    for (size_t k = 0; k < n; k++)
        if (!s[k])
            FMB_TRY(fmb_system_refuse(lift, "s[%zu] is NULL", k));
    for (size_t k = 1; k < n; k++)
        FMB_TRY(match_names(lift, s[0], s[k], k));
    return FMB_OK;
}

/* ---- of several ------------------------------------------------------------------------------ */

fmb_status fmb_lift_open_copies(fmb_lift_copies *c, fmb_system *lift, const fmb_system *like,
                                const fmb_system *const *s, size_t n)
{
    *c = (fmb_lift_copies){.s = s, .n = n};
    fmb_status st = fmb_lift_add_answer(lift, like);
    c->var = st == FMB_OK ? fmb_mem_zero(&lift->mem, n, sizeof *c->var) : NULL;
    if (st == FMB_OK && !c->var)
        st = fmb_mem_status(&lift->mem);
    for (size_t k = 0; st == FMB_OK && k < n; k++) {
        c->var[k] = fmb_mem_get(&lift->mem, (size_t)fmb_system_dim(s[k]), sizeof **c->var);
        st = c->var[k] ? fmb_lift_add_copies(lift, s[k], k + 1, c->var[k])
                       : fmb_mem_status(&lift->mem);
    }
    return st;
}

void fmb_lift_close_copies(fmb_lift_copies *c, fmb_system *lift)
{
    for (size_t k = 0; c->var && k < c->n; k++)
        fmb_mem_put(&lift->mem, c->var[k], (size_t)fmb_system_dim(c->s[k]), sizeof **c->var);
    fmb_mem_put(&lift->mem, c->var, c->n, sizeof *c->var);
}

fmb_status fmb_lift_append_sums(const fmb_lift_copies *c, fmb_system *lift)
{
    int *var = fmb_mem_get(&lift->mem, c->n + 1, sizeof *var);
    mpz_t *z = fmb_vec_block(c->n + 3, &lift->mem);
    fmb_status st = var && z ? FMB_OK : fmb_mem_status(&lift->mem);
    for (int j = 0; st == FMB_OK && j < fmb_system_dim(lift) && fmb_system_is_kept(lift, j); j++) {
        var[0] = j;
        mpz_set_si(z[0], -1);
        for (size_t k = 0; k < c->n; k++) {
            var[k + 1] = c->var[k][fmb_system_find(c->s[k], fmb_system_name(lift, j))];
            mpz_set_ui(z[k + 1], 1);
        }
        mpz_set_ui(z[c->n + 1], 0);
        mpz_set_ui(z[c->n + 2], 1);
        st = fmb_system_append(lift, c->n + 1, var, z, FMB_EQ);
    }
    fmb_vec_block_free(z, c->n + 3, &lift->mem);
    fmb_mem_put(&lift->mem, var, c->n + 1, sizeof *var);
    return st;
}
