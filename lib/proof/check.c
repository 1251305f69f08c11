/* check.c: the judge of evidence. This file is the trusted base: believe it, GMP, and how a system
 * stores its rows, and nothing else of the library needs to be believed.
 *
 * All claims come down to two questions, asked of the rows as the user wrote them:
 *   proves:  do the multipliers combine the rows to a given inequality?
 *   side_of: on which side of a row does a point lie?
 * Numbers that a claim does not need are not looked at. Claims about redundancy stand or fall
 * together: they tell how rows go one after another, each implied by rows not gone by then; "the
 * rows that stay" are those that never go, and one that a claim EQUALITY names counts as an
 * equality. Source: Schrijver, Theory of Linear and Integer Programming, 1986, sections 7.3
 * and 7.8.
 */
#include <stdarg.h>
#include <stdio.h>

#include "proof/evidence.h"
#include "proof/whole.h"
#include "system/system_private.h"

typedef struct court {
    const fmb_system *s;
    const fmb_evidence *e;
    fmb_mem mem;
    size_t *goes;  /* [rows] the first claim REDUNDANT that names the row, SIZE_MAX: it stays */
    size_t *equal; /* [rows] the first claim EQUALITY that names the row, SIZE_MAX: none */
    size_t now;    /* the claim being judged */
    bool feasible; /* a claim FEASIBLE was accepted */
    bool doubtful; /* a claim other than WHOLE was not */
    fmb_status st; /* not FMB_OK: there was no memory to go on */
    char *reason;  /* [sizeof fmb_judgement.reason] */
    mpq_srcptr *x; /* [dim] the point or ray at hand: NULL is 0 */
    /* The combination minus the inequality it shall prove: left.x <= right, or < if strict. Entries
     * of left that are not in used are 0. */
    mpq_t *left, right; /* left[dim] */
    int *used;          /* [uses] variables */
    bool *is_used;      /* [dim] */
    size_t uses;
    bool strict;
    mpq_t sum, weight; /* scratch */
    mpz_t z, t;
} court;

/* Always false, so that a refusal reads as one line. Rows and variables are named as in files. */
__attribute__((format(printf, 2, 3))) static bool refuse(court *c, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(c->reason, sizeof((fmb_judgement *)0)->reason, format, args);
    va_end(args);
    return false;
}

/* sum += factor x. The sum is kept over a common denominator and not reduced: its sign is right
 * and its denominator positive. */
static void add_product(court *c, mpq_ptr sum, mpz_srcptr factor, mpq_srcptr x)
{
    mpz_ptr num = mpq_numref(sum), den = mpq_denref(sum);
    if (!mpz_divisible_p(den, mpq_denref(x))) {
        mpz_lcm(c->t, den, mpq_denref(x));
        mpz_divexact(den, c->t, den);
        mpz_mul(num, num, den);
        mpz_set(den, c->t);
    }
    mpz_divexact(c->t, den, mpq_denref(x));
    mpz_mul(c->t, c->t, factor);
    mpz_addmul(num, c->t, mpq_numref(x));
}

/* ---- points ---------------------------------------------------------------------------------- */

/* Lay a claim's point or ray out by variable; afterwards take it away again. */
static bool lay_out(court *c, const fmb_sparse_vector *x)
{
    for (size_t k = 0; k < x->size; k++)
        if (x->index[k] >= (size_t)c->e->dim)
            return refuse(c, "a coordinate is of no variable");
    for (size_t k = 0; k < x->size; k++)
        c->x[x->index[k]] = x->value[k];
    return true;
}

static void take_away(court *c, const fmb_sparse_vector *x)
{
    for (size_t k = 0; k < x->size; k++)
        c->x[x->index[k]] = NULL;
}

/* The sign of a.x - b for row a.x REL b; for a direction, the sign of a.x. */
static int side_of(court *c, const fmb_sysrow *row, bool direction)
{
    mpq_set_ui(c->sum, 0, 1);
    for (size_t k = 0; k < row->nnz; k++) {
        if (!c->x[row->var[k]])
            continue;
        fmb_vec_get(&row->val, k, c->z);
        add_product(c, c->sum, c->z, c->x[row->var[k]]);
    }
    if (!direction) {
        fmb_vec_get(&row->val, row->nnz, c->z);
        mpz_submul(mpq_numref(c->sum), c->z, mpq_denref(c->sum));
    }
    return mpq_sgn(c->sum);
}

static bool keeps(int side, fmb_rel rel)
{
    return rel == FMB_EQ ? side == 0 : rel == FMB_LT ? side < 0 : side <= 0;
}

typedef enum reading { AS_WRITTEN, CLOSED, DIRECTION } reading;

/* Does x keep every row: as written; with < read as <=; or as a direction in which one can walk
 * for ever without leaving the rows? */
static bool keeps_all(court *c, const fmb_sparse_vector *x, reading how)
{
    bool good = true;
    if (!lay_out(c, x))
        return false;
    for (size_t i = 0; good && i < c->s->rows; i++) {
        const fmb_sysrow *row = fmb_system_row(c->s, i);
        fmb_rel rel = row->rel == FMB_LT && how != AS_WRITTEN ? FMB_LE : row->rel;
        good = keeps(side_of(c, row, how == DIRECTION), rel) ||
               refuse(c, "the %s violates row %zu", how == DIRECTION ? "ray" : "point", i + 1);
    }
    take_away(c, x);
    return good;
}

/* ---- combinations ---------------------------------------------------------------------------- */

static void clear_combination(court *c)
{
    for (; c->uses > 0; c->uses--) {
        mpq_set_ui(c->left[c->used[c->uses - 1]], 0, 1);
        c->is_used[c->used[c->uses - 1]] = false;
    }
    mpq_set_ui(c->right, 0, 1);
    c->strict = false;
}

/* The entry of variable j, to be changed. */
static mpq_ptr left_of(court *c, int j)
{
    if (!c->is_used[j])
        c->used[c->uses++] = j;
    c->is_used[j] = true;
    return c->left[j];
}

/* Add weight times row i, which is (val / den). */
static void add_row(court *c, size_t i, mpq_srcptr weight)
{
    const fmb_sysrow *row = fmb_system_row(c->s, i);
    fmb_vec_get(&row->val, row->nnz + 1, mpq_numref(c->weight));
    mpz_set_ui(mpq_denref(c->weight), 1);
    mpq_div(c->weight, weight, c->weight);
    for (size_t k = 0; k < row->nnz; k++) {
        fmb_vec_get(&row->val, k, c->z);
        add_product(c, left_of(c, row->var[k]), c->z, c->weight);
    }
    fmb_vec_get(&row->val, row->nnz, c->z);
    add_product(c, c->right, c->z, c->weight);
}

typedef enum basis {
    WRITTEN, /* all rows */
    FLAT,    /* all rows; those that an earlier claim EQUALITY names count as equalities */
    PRESENT  /* rows that have not gone; those that never go and that any claim EQUALITY names count
                as equalities */
} basis;

/* The relation that multipliers in the claim being judged may take row i to have. */
static fmb_rel relation_in(const court *c, size_t i, basis from)
{
    bool equal = from == FLAT      ? c->equal[i] < c->now
                 : from == PRESENT ? c->equal[i] != SIZE_MAX && c->goes[i] == SIZE_MAX
                                   : false;
    return equal ? FMB_EQ : fmb_system_row(c->s, i)->rel;
}

/* Do the multipliers prove the inequality whose negation clear_combination and additions have left
 * in the combination?
 *
 * Let the goal be g.x <= h, or g.x < h. Multipliers that are >= 0 on inequalities add the rows up
 * to a.x <= b, true of all solutions, and a.x < b if one of a strict row is positive. With a = g it
 * implies the goal if b < h, or if b = h and (the goal is not strict or a.x < b holds). The
 * combination holds left = a - g and right = b - h. */
static bool proves(court *c, const fmb_sparse_vector *multipliers, bool strict_goal, basis from)
{
    for (size_t k = 0; k < multipliers->size; k++) {
        size_t i = multipliers->index[k];
        if (i >= c->s->rows)
            return refuse(c, "there is no row %zu", i + 1);
        if (from == PRESENT && c->goes[i] <= c->now)
            return refuse(c, "row %zu is gone", i + 1);
        fmb_rel rel = relation_in(c, i, from);
        int sign = mpq_sgn(multipliers->value[k]);
        if (rel != FMB_EQ && sign < 0)
            return refuse(c, "the multiplier of row %zu is negative", i + 1);
        c->strict = c->strict || (rel == FMB_LT && sign > 0);
        add_row(c, i, multipliers->value[k]);
    }
    int wrong = -1; /* the first variable whose coefficient is */
    for (size_t k = 0; k < c->uses; k++)
        if (mpq_sgn(c->left[c->used[k]]) != 0 && (wrong < 0 || c->used[k] < wrong))
            wrong = c->used[k];
    if (wrong >= 0)
        return refuse(c, "the combined coefficient of %s is wrong", fmb_system_name(c->s, wrong));
    if (mpq_sgn(c->right) > 0)
        return refuse(c, "the combined right side is too large");
    if (mpq_sgn(c->right) == 0 && strict_goal && !c->strict)
        return refuse(c, "the combination is not strict");
    return true;
}

/* ---- one judge for each kind of claim -------------------------------------------------------- */

static bool judge_feasible(court *c, const fmb_claim *q)
{
    return keeps_all(c, &q->point, AS_WRITTEN);
}

/* Infeasible: the rows prove 0 < 0. */
static bool judge_infeasible(court *c, const fmb_claim *q)
{
    clear_combination(c);
    return proves(c, &q->multipliers, true, WRITTEN);
}

/* The form of a claim is its variable, if it names one, as ends may, plus its terms. */
static bool has_form(court *c, const fmb_claim *q)
{
    bool end = q->kind == FMB_CLAIM_BOUND || q->kind == FMB_CLAIM_UNBOUNDED;
    bool good = q->var >= -1 && q->var < (end ? c->e->dim : 0);
    for (size_t k = 0; k < q->terms.size; k++)
        good = good && q->terms.index[k] < (size_t)c->e->dim;
    return good || refuse(c, "the claim is about no variable");
}

/* Load the negation of the claim's own inequality, form <= value, times sign. */
static void oppose_form(court *c, const fmb_claim *q, int sign)
{
    mpz_set_si(c->z, -sign);
    clear_combination(c);
    if (q->var >= 0)
        mpq_set_si(left_of(c, q->var), -sign, 1);
    for (size_t k = 0; k < q->terms.size; k++)
        add_product(c, left_of(c, (int)q->terms.index[k]), c->z, q->terms.value[k]);
    add_product(c, c->right, c->z, q->value);
}

/* c->sum = the form's value at x. */
static void form_at(court *c, const fmb_claim *q, const fmb_sparse_vector *x)
{
    mpq_srcptr at = q->var >= 0 ? fmb_sparse_find(x, (size_t)q->var) : NULL;
    mpq_set_ui(c->sum, 0, 1);
    if (at)
        mpq_set(c->sum, at);
    for (size_t k = 0; k < q->terms.size; k++) {
        if (!(at = fmb_sparse_find(x, q->terms.index[k])))
            continue;
        mpq_mul(c->weight, at, q->terms.value[k]);
        mpq_add(c->sum, c->sum, c->weight);
    }
}

/* form <= value and a solution attains it; or form < value and solutions come as near as you like.
 * For the latter, let p satisfy the rows with < read as <=, form(p) = value, and let q be a
 * solution. Every q + t(p - q), 0 <= t < 1, is a solution (a strict row holds strictly at q), and
 * the form tends to value as t tends to 1. Lower ends are upper ends of -form. */
static bool judge_bound(court *c, const fmb_claim *q)
{
    if (q->rel == FMB_EQ)
        return refuse(c, "the claim is no bound");
    if (!has_form(c, q))
        return false;
    bool open = q->rel == FMB_LT;
    oppose_form(c, q, q->side == FMB_UPPER ? 1 : -1);
    if (!proves(c, &q->multipliers, open, WRITTEN))
        return false;
    if (open && !c->feasible)
        return refuse(c, "no claim shows that the system is feasible");
    if (!keeps_all(c, &q->point, open ? CLOSED : AS_WRITTEN))
        return false;
    form_at(c, q, &q->point);
    return mpq_equal(c->sum, q->value) || refuse(c, "the point is not at the bound");
}

/* From a solution one can walk along the ray for ever. */
static bool judge_unbounded(court *c, const fmb_claim *q)
{
    if (!has_form(c, q))
        return false;
    if (!c->feasible)
        return refuse(c, "no claim shows that the system is feasible");
    if (!keeps_all(c, &q->ray, DIRECTION))
        return false;
    form_at(c, q, &q->ray);
    return mpq_sgn(c->sum) == (q->side == FMB_UPPER ? 1 : -1) ||
           refuse(c, "the ray does not go that way");
}

/* An equality needs both directions. */
static bool judge_implied(court *c, const fmb_claim *q)
{
    if (!has_form(c, q))
        return false;
    oppose_form(c, q, 1);
    if (!proves(c, &q->multipliers, q->rel == FMB_LT, WRITTEN))
        return false;
    oppose_form(c, q, -1);
    return q->rel != FMB_EQ || proves(c, &q->reverse, false, WRITTEN);
}

/* Load the negation of row i, times sign. */
static void oppose_row(court *c, size_t i, int sign)
{
    clear_combination(c);
    mpq_set_si(c->sum, -sign, 1);
    add_row(c, i, c->sum);
}

static bool has_row(court *c, const fmb_claim *q)
{
    return q->row < c->s->rows || refuse(c, "the claim is about no row");
}

/* The last row to go follows from rows that stay, the one before it from those and the last, and so
 * on: the rows that stay, with their equalities, imply all others. */
static bool judge_redundant(court *c, const fmb_claim *q)
{
    if (!has_row(c, q))
        return false;
    fmb_rel rel = fmb_system_row(c->s, q->row)->rel;
    oppose_row(c, q->row, 1);
    if (!proves(c, &q->multipliers, rel == FMB_LT, PRESENT))
        return false;
    oppose_row(c, q->row, -1);
    return rel != FMB_EQ || proves(c, &q->reverse, false, PRESENT);
}

/* Row a.x <= b is an equality if all rows, and equalities known by now, prove -a.x <= -b. A strict
 * row is none, even where there is no solution: as an equality it would let points in. */
static bool judge_equality(court *c, const fmb_claim *q)
{
    if (!has_row(c, q))
        return false;
    if (fmb_system_row(c->s, q->row)->rel == FMB_LT)
        return refuse(c, "row %zu is strict", q->row + 1);
    oppose_row(c, q->row, -1);
    return proves(c, &q->multipliers, false, FLAT);
}

/* Without row i the rows that stay would let the point in. */
static bool judge_irredundant(court *c, const fmb_claim *q)
{
    bool good = true;
    if (!has_row(c, q) || !lay_out(c, &q->point))
        return false;
    for (size_t i = 0; good && i < c->s->rows; i++) {
        const fmb_sysrow *row = fmb_system_row(c->s, i);
        if (c->goes[i] != SIZE_MAX && i != q->row)
            continue;
        fmb_rel rel = c->equal[i] != SIZE_MAX ? FMB_EQ : row->rel;
        bool kept = keeps(side_of(c, row, false), rel);
        if (kept == (i == q->row))
            good = refuse(c, "the point %s row %zu", kept ? "satisfies" : "violates", i + 1);
    }
    take_away(c, &q->point);
    return good;
}

/* A point of the closure, or a direction in it. */
static bool judge_corner(court *c, const fmb_claim *q)
{
    if (q->point.size > 0 && q->ray.size > 0)
        return refuse(c, "the corner is both a point and a ray");
    return q->ray.size > 0 ? keeps_all(c, &q->ray, DIRECTION) : keeps_all(c, &q->point, CLOSED);
}

static bool judge_whole(court *c, const fmb_claim *q)
{
    const char *why = NULL;
    if (!has_form(c, q))
        return false;
    if (c->doubtful)
        return refuse(c, "it leans on claims that do not hold");
    c->st = fmb_whole_judge(c->s, c->e, q, &c->mem, &(fmb_patience){0}, &why, NULL);
    return !why || refuse(c, "%s", why);
}

/* ---- the session ----------------------------------------------------------------------------- */

static bool judge(court *c, const fmb_claim *q)
{
    static bool (*const by_kind[])(court *, const fmb_claim *) = {
        [FMB_CLAIM_FEASIBLE] = judge_feasible, [FMB_CLAIM_INFEASIBLE] = judge_infeasible,
        [FMB_CLAIM_BOUND] = judge_bound,       [FMB_CLAIM_UNBOUNDED] = judge_unbounded,
        [FMB_CLAIM_IMPLIED] = judge_implied,   [FMB_CLAIM_REDUNDANT] = judge_redundant,
        [FMB_CLAIM_EQUALITY] = judge_equality, [FMB_CLAIM_IRREDUNDANT] = judge_irredundant,
        [FMB_CLAIM_CORNER] = judge_corner,     [FMB_CLAIM_WHOLE] = judge_whole};
    if (q->kind <= FMB_CLAIM_NONE || q->kind > FMB_CLAIM_WHOLE)
        return refuse(c, "the claim is of no known kind");
    return by_kind[q->kind](c, q);
}

/* What an accepted claim says of the system. */
static fmb_verdict meaning(const fmb_claim *q)
{
    if (q->kind == FMB_CLAIM_INFEASIBLE)
        return FMB_INFEASIBLE;
    bool has_solution = q->kind == FMB_CLAIM_FEASIBLE || q->kind == FMB_CLAIM_UNBOUNDED ||
                        q->kind == FMB_CLAIM_BOUND;
    return has_solution ? FMB_FEASIBLE : FMB_UNKNOWN;
}

/* Claims FEASIBLE come first, others lean on them; claims WHOLE last, they lean on all others. */
static int turn_of(const fmb_claim *q)
{
    return q->kind == FMB_CLAIM_FEASIBLE ? 0 : q->kind != FMB_CLAIM_WHOLE ? 1 : 2;
}

/* The reason of the first failing claim wins. */
static void judge_all(court *c, fmb_judgement *out)
{
    const fmb_evidence *e = c->e;
    char reason[sizeof out->reason] = "";
    c->reason = reason;
    for (int turn = 0; turn <= 2; turn++) {
        c->doubtful = out->claim != SIZE_MAX;
        for (size_t i = 0; i < e->claims; i++) {
            const fmb_claim *q = &e->claim[i];
            if (turn_of(q) != turn)
                continue;
            c->now = i;
            if (judge(c, q)) {
                c->feasible = c->feasible || turn == 0;
                out->verdict = meaning(q) != FMB_UNKNOWN ? meaning(q) : out->verdict;
            } else if (i < out->claim) {
                out->claim = i;
                snprintf(out->reason, sizeof out->reason, "%s", reason);
            }
        }
    }
    out->accepted = e->claims > 0 && out->claim == SIZE_MAX;
    if (e->claims == 0)
        snprintf(out->reason, sizeof out->reason, "there is no claim");
}

/* Which rows go, and which are equalities. */
static void mark_rows(court *c)
{
    for (size_t i = 0; i < c->s->rows; i++)
        c->goes[i] = c->equal[i] = SIZE_MAX;
    for (size_t i = 0; i < c->e->claims; i++) {
        const fmb_claim *q = &c->e->claim[i];
        if (q->row < c->s->rows && q->kind == FMB_CLAIM_REDUNDANT && c->goes[q->row] > i)
            c->goes[q->row] = i;
        if (q->row < c->s->rows && q->kind == FMB_CLAIM_EQUALITY && c->equal[q->row] > i)
            c->equal[q->row] = i;
    }
}

fmb_status fmb_check(const fmb_system *s, const fmb_evidence *e, fmb_judgement *out)
{
    if (!out || !fmb_evidence_fits(e, s))
        return FMB_ERR_ARG;
    court c = {.s = s, .e = e};
    size_t dim = (size_t)e->dim, rows = e->rows;
    fmb_mem_init(&c.mem, &s->mem.alloc, 0);
    c.goes = fmb_mem_get(&c.mem, rows, sizeof *c.goes);
    c.equal = fmb_mem_get(&c.mem, rows, sizeof *c.equal);
    c.x = fmb_mem_zero(&c.mem, dim, sizeof *c.x);
    c.left = fmb_mem_get(&c.mem, dim, sizeof *c.left);
    c.used = fmb_mem_get(&c.mem, dim, sizeof *c.used);
    c.is_used = fmb_mem_zero(&c.mem, dim, sizeof *c.is_used);
    bool ready = c.goes && c.equal && c.x && c.left && c.used && c.is_used;
    if (ready) {
        for (size_t j = 0; j < dim; j++)
            mpq_init(c.left[j]);
        mpq_inits(c.right, c.sum, c.weight, NULL);
        mpz_inits(c.z, c.t, NULL);
        fmb_judgement found = {.claim = SIZE_MAX};
        mark_rows(&c);
        judge_all(&c, &found);
        if (c.st == FMB_OK)
            *out = found;
        mpq_clears(c.right, c.sum, c.weight, NULL);
        mpz_clears(c.z, c.t, NULL);
        for (size_t j = 0; j < dim; j++)
            mpq_clear(c.left[j]);
    }
    fmb_mem_put(&c.mem, c.goes, rows, sizeof *c.goes);
    fmb_mem_put(&c.mem, c.equal, rows, sizeof *c.equal);
    fmb_mem_put(&c.mem, c.x, dim, sizeof *c.x);
    fmb_mem_put(&c.mem, c.left, dim, sizeof *c.left);
    fmb_mem_put(&c.mem, c.used, dim, sizeof *c.used);
    fmb_mem_put(&c.mem, c.is_used, dim, sizeof *c.is_used);
    return ready ? c.st : FMB_ERR_MEMORY;
}
