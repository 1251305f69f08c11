/* preimages.c: one program per part and per reading of strict rows; see preimages.h. */
#include "solve/project/preimages.h"

#include "system/system_private.h"

/* A part as a program over its eliminated variables, of the rows that name one. */
typedef struct lifted_part {
    const fmb_part *p;
    int *column; /* [p->n] of eliminated variables; -1: kept */
    int n;       /* columns */
    fmb_program program;
    const fmb_sysrow **row; /* [p->m] of the program's rows */
    fmb_oracle *oracle;     /* NULL: no variable was eliminated */
} lifted_part;

struct fmb_preimages {
    fmb_query *q;
    const int *place;
    size_t parts;
    lifted_part *part[2]; /* [parts] for the closure, and with strict rows */
    mpz_t b, t;
};

/* ---- programs -------------------------------------------------------------------------------- */

static fmb_status number_eliminated_columns(fmb_preimages *l, lifted_part *h)
{
    fmb_arena *arena = &l->q->v->arena;
    h->column = fmb_arena_get(arena, (size_t)h->p->n, sizeof *h->column);
    h->row = fmb_arena_get(arena, h->p->m, sizeof(fmb_sysrow *));
    if (!h->column || !h->row)
        return fmb_mem_status(l->q->run.mem);
    for (int j = 0; j < h->p->n; j++)
        h->column[j] = l->place[h->p->var[j]] < 0 ? h->n++ : -1;
    return FMB_OK;
}

/* Add the row's terms in eliminated variables, if any, with right side 0 for now; z[h->n + 1]. */
static fmb_status add_lifted_row(fmb_preimages *l, lifted_part *h, const fmb_sysrow *row,
                                 bool strict, fmb_integers *z)
{
    bool any = false;
    for (int j = 0; j <= h->n; j++)
        mpz_set_ui(z->z[j], 0);
    for (size_t k = 0; k < row->nnz; k++) {
        int column = h->column[l->q->parts.place[row->var[k]]];
        if (column >= 0)
            fmb_vec_get(&row->val, k, z->z[column]);
        any = any || column >= 0;
    }
    if (!any)
        return FMB_OK;
    h->row[h->program.m] = row;
    return fmb_program_add_integers(&h->program, z->z,
                                    row->rel == FMB_LT && !strict ? FMB_LE : row->rel);
}

static fmb_status open_lifted_part(fmb_preimages *l, lifted_part *h, const fmb_part *p, bool strict)
{
    fmb_integers z = {0};
    *h = (lifted_part){.p = p};
    fmb_status st = number_eliminated_columns(l, h);
    fmb_program_init(&h->program, l->q->run.mem, h->n);
    FMB_THEN(st, fmb_integers_init(&z, (size_t)h->n + 1, l->q->run.mem));
    for (size_t i = 0; st == FMB_OK && h->n > 0 && i < p->m; i++)
        st = add_lifted_row(l, h, fmb_system_row(l->q->s, p->source[i]), strict, &z);
    fmb_integers_clear(&z, l->q->run.mem);
    return st == FMB_OK && h->n > 0 ? fmb_oracle_new(&l->q->run, &h->program, &h->oracle) : st;
}

fmb_status fmb_preimages_open(fmb_query *q, const int *place, fmb_preimages **out)
{
    size_t parts = (size_t)q->parts.count;
    fmb_preimages *l = fmb_mem_zero(q->run.mem, 1, sizeof *l);
    *out = l;
    if (!l)
        return fmb_mem_status(q->run.mem);
    *l = (fmb_preimages){.q = q, .place = place};
    mpz_inits(l->b, l->t, NULL);
    for (int strict = 0; strict <= 1; strict++)
        if (!(l->part[strict] = fmb_arena_get(&q->v->arena, parts, sizeof **l->part)))
            return fmb_mem_status(q->run.mem);
    fmb_status st = FMB_OK;
    for (; st == FMB_OK && l->parts < parts; l->parts++) {
        const fmb_part *p = &q->parts.part[l->parts];
        l->part[1][l->parts] = (lifted_part){.p = p};
        st = open_lifted_part(l, &l->part[0][l->parts], p, false);
        FMB_THEN(st, open_lifted_part(l, &l->part[1][l->parts], p, true));
    }
    return st;
}

void fmb_preimages_close(fmb_preimages *l)
{
    if (!l)
        return;
    fmb_mem *mem = l->q->run.mem;
    for (size_t c = 0; c < 2 * l->parts; c++) {
        lifted_part *h = &l->part[c % 2][c / 2];
        fmb_oracle_free(h->oracle);
        fmb_program_clear(&h->program);
    }
    mpz_clears(l->b, l->t, NULL);
    fmb_mem_put(mem, l, 1, sizeof *l);
}

/* ---- points ---------------------------------------------------------------------------------- */

/* b = t times the right side minus the terms of kept variables. */
static void find_right_side(fmb_preimages *l, const fmb_sysrow *row, const fmb_integers *y)
{
    fmb_vec_get(&row->val, row->nnz, l->b);
    mpz_mul(l->b, l->b, y->z[y->size - 1]);
    for (size_t k = 0; k < row->nnz; k++) {
        int column = l->place[row->var[k]];
        if (column < 0)
            continue;
        fmb_vec_get(&row->val, k, l->t);
        mpz_submul(l->b, l->t, y->z[column]);
    }
}

/* Do the strict rows over kept variables only hold at y? */
static bool keeps_strict_rows(fmb_preimages *l, const fmb_integers *y)
{
    bool good = true;
    for (size_t i = 0; good && i < l->q->s->rows; i++) {
        const fmb_sysrow *row = fmb_system_row(l->q->s, i);
        bool kept = row->rel == FMB_LT;
        for (size_t k = 0; kept && k < row->nnz; k++)
            kept = l->place[row->var[k]] >= 0;
        if (!kept)
            continue;
        find_right_side(l, row, y);
        good = mpz_sgn(l->b) > 0;
    }
    return good;
}

static fmb_status lift_in_part(fmb_preimages *l, lifted_part *h, const fmb_integers *y, mpq_t *x,
                               bool *found)
{
    fmb_mem *mem = l->q->run.mem;
    fmb_integers z = {0};
    for (size_t i = 0; i < h->program.m; i++) {
        find_right_side(l, h->row[i], y);
        FMB_TRY(fmb_program_set_right(&h->program, i, l->b));
    }
    fmb_oracle_shift(h->oracle);
    FMB_TRY(fmb_oracle_feasible(h->oracle, found));
    if (*found)
        FMB_TRY(fmb_integers_init(&z, (size_t)h->n + 1, mem));
    if (!*found)
        return FMB_OK;
    fmb_oracle_point_integers(h->oracle, z.z, z.z[h->n]);
    bool direction = mpz_sgn(y->z[y->size - 1]) == 0;
    for (int j = 0; j < h->p->n; j++) {
        if (h->column[j] < 0)
            continue;
        mpq_ptr at = x[h->p->var[j]];
        mpz_set(mpq_numref(at), z.z[h->column[j]]);
        mpz_set(mpq_denref(at), z.z[h->n]);
        if (!direction)
            mpz_mul(mpq_denref(at), mpq_denref(at), y->z[y->size - 1]);
        mpq_canonicalize(at);
    }
    fmb_integers_clear(&z, mem);
    return FMB_OK;
}

/* Set kept variables from y; eliminated ones that no row names become 0. */
static void set_kept_variables(const fmb_preimages *l, const fmb_integers *y, mpq_t *x)
{
    bool direction = mpz_sgn(y->z[y->size - 1]) == 0;
    for (int j = 0; j < fmb_system_dim(l->q->s); j++) {
        mpq_set_ui(x[j], 0, 1);
        if (l->place[j] < 0)
            continue;
        mpz_set(mpq_numref(x[j]), y->z[l->place[j]]);
        if (!direction)
            mpz_set(mpq_denref(x[j]), y->z[y->size - 1]);
        mpq_canonicalize(x[j]);
    }
}

fmb_status fmb_preimages_find(fmb_preimages *l, const fmb_integers *y, bool strict, bool tight,
                              mpq_t *x, bool *found)
{
    *found = !strict || keeps_strict_rows(l, y);
    set_kept_variables(l, y, x);
    FMB_TRY(fmb_run_poll(&l->q->run));
    for (size_t c = 0; *found && c < l->parts; c++) {
        lifted_part *h = &l->part[strict][c];
        if (!h->oracle)
            continue;
        fmb_oracle_expect_tight_rows(h->oracle, tight && !strict);
        FMB_TRY(lift_in_part(l, h, y, x, found));
    }
    return FMB_OK;
}
