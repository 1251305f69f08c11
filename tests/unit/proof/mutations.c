/* mutations.c: each change returns false if there was nothing to change; see mutations.h. */
#include "mutations.h"

#include "support/dense.h"

static void change_number(support_rng *g, mpq_t q)
{
    mpq_t by;
    mpq_init(by);
    mpq_set_si(by, support_between(g, -3, 3), (unsigned)support_between(g, 1, 3));
    mpq_canonicalize(by);
    switch (support_between(g, 0, 3)) {
    case 0:
        mpq_neg(q, q);
        break;
    case 1:
        mpq_set(q, by);
        break;
    case 2:
        mpq_mul(q, q, by);
        break;
    default:
        mpq_add(q, q, by);
    }
    mpq_clear(by);
}

size_t subject_any(support_rng *g, size_t n)
{
    return (size_t)(support_next(g) % n);
}

static fmb_claim *any_claim(subject *u)
{
    return &u->e->claim[subject_any(&u->g, u->e->claims)];
}

static bool change_list_value(subject *u, fmb_sparse_vector *list)
{
    if (list->size > 0)
        change_number(&u->g, list->value[subject_any(&u->g, list->size)]);
    return list->size > 0;
}

static bool change_multiplier(subject *u)
{
    return change_list_value(u, &any_claim(u)->multipliers);
}

static bool change_reverse(subject *u)
{
    return change_list_value(u, &any_claim(u)->reverse);
}

static bool change_term(subject *u)
{
    return change_list_value(u, &any_claim(u)->terms);
}

/* A multiplier moves to another row, perhaps one that there is not. */
static bool rename_multiplier(subject *u)
{
    fmb_sparse_vector *list = &any_claim(u)->multipliers;
    if (list->size > 0)
        list->index[subject_any(&u->g, list->size)] = subject_any(&u->g, u->e->rows + 1);
    list->mixed = true;
    return list->size > 0;
}

static bool add_multiplier(subject *u)
{
    mpq_t q;
    mpq_init(q);
    change_number(&u->g, q);
    fmb_status st =
        fmb_evidence_push(u->e, &any_claim(u)->multipliers, subject_any(&u->g, u->e->rows + 1), q);
    mpq_clear(q);
    return st == FMB_OK;
}

static bool drop_multiplier(subject *u)
{
    fmb_sparse_vector *list = &any_claim(u)->multipliers;
    if (list->size == 0)
        return false;
    mpq_clear(list->value[--list->size]);
    return true;
}

static bool change_point(subject *u)
{
    return change_list_value(u, &any_claim(u)->point);
}

static bool change_ray(subject *u)
{
    return change_list_value(u, &any_claim(u)->ray);
}

/* A coordinate that was 0, perhaps of a variable that there is not. */
static bool add_coordinate(subject *u, fmb_sparse_vector *list)
{
    size_t j = subject_any(&u->g, (size_t)u->e->dim + 1);
    mpq_t q;
    if (fmb_sparse_find(list, j))
        return false;
    mpq_init(q);
    mpq_set_si(q, support_between(&u->g, 0, 1) ? 1 : -1, (unsigned)support_between(&u->g, 1, 3));
    fmb_status st = fmb_evidence_push(u->e, list, j, q);
    mpq_clear(q);
    return st == FMB_OK;
}

static bool add_to_point(subject *u)
{
    return add_coordinate(u, &any_claim(u)->point);
}

static bool add_to_ray(subject *u)
{
    return add_coordinate(u, &any_claim(u)->ray);
}

static bool drop_coordinate(subject *u)
{
    fmb_sparse_vector *list = &any_claim(u)->point;
    if (list->size == 0)
        return false;
    mpq_clear(list->value[--list->size]);
    return true;
}

static bool swap_point_and_ray(subject *u)
{
    fmb_claim *c = any_claim(u);
    fmb_sparse_vector point = c->point;
    c->point = c->ray;
    c->ray = point;
    return c->point.size + c->ray.size > 0;
}

static bool is_inequality(const fmb_claim *c)
{
    return c->kind == FMB_CLAIM_BOUND || c->kind == FMB_CLAIM_IMPLIED;
}

static bool is_end(const fmb_claim *c)
{
    return c->kind == FMB_CLAIM_BOUND || c->kind == FMB_CLAIM_UNBOUNDED;
}

static bool change_value(subject *u)
{
    fmb_claim *c = any_claim(u);
    if (is_inequality(c))
        change_number(&u->g, c->value);
    return is_inequality(c);
}

static bool change_kind(subject *u)
{
    any_claim(u)->kind = (fmb_claim_kind)support_between(&u->g, FMB_CLAIM_NONE, FMB_CLAIM_FOLLOWS);
    return true;
}

static bool change_claim_relation(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->rel = (fmb_rel)support_between(&u->g, FMB_LE, FMB_EQ);
    return is_inequality(c);
}

static bool change_side(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->side = c->side == FMB_UPPER ? FMB_LOWER : FMB_UPPER;
    return is_end(c);
}

static bool change_row(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->row = subject_any(&u->g, u->e->rows + 1);
    return !is_end(c) && !is_inequality(c);
}

static bool change_variable(subject *u)
{
    fmb_claim *c = any_claim(u);
    c->var = support_between(&u->g, -1, u->e->dim);
    return is_end(c);
}

static bool drop_claim(subject *u)
{
    fmb_evidence_drop_last(u->e);
    return u->e->claims > 0;
}

static bool swap_claims(subject *u)
{
    fmb_claim *a = any_claim(u), *b = any_claim(u), keep = *a;
    *a = *b;
    *b = keep;
    return a != b;
}

/* The system, changed through a table of its numbers. */
static bool change_system(subject *u, void (*change)(support_rng *g, dense *d))
{
    dense d = dense_of(u->s);
    if (d.rows > 0)
        change(&u->g, &d);
    fmb_system_free(u->s);
    u->s = dense_system(&d);
    dense_free(&d);
    return d.rows > 0;
}

static int any_row(support_rng *g, const dense *d)
{
    return support_between(g, 0, d->rows - 1);
}

static void number_in_system(support_rng *g, dense *d)
{
    change_number(g, dense_row(d, any_row(g, d))[support_between(g, 0, d->dim)]);
}

static void relation_in_system(support_rng *g, dense *d)
{
    d->rel[any_row(g, d)] = (fmb_rel)support_between(g, FMB_LE, FMB_EQ);
}

static void rows_in_system(support_rng *g, dense *d)
{
    dense_swap(d, any_row(g, d), any_row(g, d));
}

static bool change_system_number(subject *u)
{
    return change_system(u, number_in_system);
}

static bool change_system_relation(subject *u)
{
    return change_system(u, relation_in_system);
}

static bool swap_system_rows(subject *u)
{
    return change_system(u, rows_in_system);
}

static bool (*const MUTATION[])(subject *u) = {
    change_multiplier, change_multiplier,    change_reverse,        change_term,
    rename_multiplier, add_multiplier,       drop_multiplier,       change_point,
    change_point,      change_ray,           add_to_point,          add_to_ray,
    drop_coordinate,   swap_point_and_ray,   change_value,          change_claim_relation,
    change_side,       change_row,           change_variable,       drop_claim,
    swap_claims,       change_system_number, change_system_number,  change_system_number,
    change_kind,       swap_system_rows,     change_system_relation};

enum { MUTATIONS = sizeof MUTATION / sizeof *MUTATION };

bool subject_change(subject *u)
{
    return MUTATION[subject_any(&u->g, MUTATIONS)](u);
}
