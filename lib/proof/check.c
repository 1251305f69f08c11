/* check.c: the checker of evidence. This file, combine_rows.c and sum.c, complete.c and lattice.c,
 * by_elimination.c and elimination.c are the trusted base: if they, GMP, and the storage of a
 * system's rows are correct, no other part of the library needs to be trusted.
 *
 * All claims come down to two questions about the rows as the user wrote them (combine_rows.h):
 *   proves:  do the multipliers combine the rows to a given inequality?
 *   side_of: on which side of a row does a point lie?
 * Numbers that a claim does not need are ignored. Claims about redundancy hold only together: they
 * remove rows one after another, each implied by rows not removed by then; the "kept rows" are
 * those that no claim removes, and a row that a claim EQUALITY names counts as an equality. Source:
 * Schrijver, Theory of Linear and Integer Programming, 1986, sections 7.3 and 7.8.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/sized.h"
#include "proof/by_elimination.h"
#include "proof/combine_rows.h"
#include "proof/complete.h"
#include "proof/integral.h"
#include "system/system_private.h"

typedef struct court {
    const fmb_system *s;
    const fmb_evidence *e;
    fmb_mem mem;
    fmb_guard guard;
    fmb_poll poll;
    size_t *goes;   /* [rows] the first claim REDUNDANT that names the row, SIZE_MAX: kept */
    size_t *equal;  /* [rows] the first claim EQUALITY that names the row, SIZE_MAX: none */
    size_t now;     /* the claim being judged */
    bool feasible;  /* a claim FEASIBLE was accepted */
    bool integers;  /* the system has integer variables ... */
    bool integral;  /* ... and a claim FEASIBLE was accepted whose point is integral there */
    bool doubtful;  /* a claim other than WHOLE was rejected */
    fmb_status st;  /* not FMB_OK: out of memory, or a limit was reached */
    char *reason;   /* [sizeof fmb_judgement.reason] */
    fmb_place here; /* the point or ray being tested */
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

/* May the checker go on? */
static bool goes_on(court *c, fmb_status st)
{
    if (c->st == FMB_OK)
        c->st = st;
    return c->st == FMB_OK || refuse(c, "not judged");
}

/* ---- points ---------------------------------------------------------------------------------- */

/* Store a claim's point or ray by variable; fmb_place_take removes it afterwards. */
static bool lay_out(court *c, const fmb_sparse_vector *x, bool direction)
{
    for (size_t k = 0; k < x->size; k++)
        if (x->index[k] >= (size_t)c->e->dim)
            return refuse(c, "a coordinate is of no variable");
    fmb_status st = fmb_place_put(&c->here, x, direction, &c->mem, &c->poll);
    if (st != FMB_OK)
        fmb_place_take(&c->here, x);
    return goes_on(c, st);
}

static bool keeps(int side, fmb_rel rel)
{
    return rel == FMB_EQ ? side == 0 : rel == FMB_LT ? side < 0 : side <= 0;
}

typedef enum reading { AS_WRITTEN, CLOSED, DIRECTION } reading;

/* Does x satisfy every row: as written; with < read as <=; or as a direction of the recession
 * cone? */
static bool keeps_all(court *c, const fmb_sparse_vector *x, reading how)
{
    bool good = true;
    if (!lay_out(c, x, how == DIRECTION))
        return false;
    for (size_t i = 0; good && i < c->s->rows; i++) {
        const fmb_sysrow *row = fmb_system_row(c->s, i);
        fmb_rel rel = row->rel == FMB_LT && how != AS_WRITTEN ? FMB_LE : row->rel;
        int side = 0;
        good = goes_on(c, fmb_place_side(&c->here, row, &side)) &&
               (keeps(side, rel) ||
                refuse(c, "the %s violates row %zu", how == DIRECTION ? "ray" : "point", i + 1));
    }
    fmb_place_take(&c->here, x);
    return good;
}

/* ---- combinations ---------------------------------------------------------------------------- */

typedef enum basis {
    WRITTEN, /* all rows */
    FLAT,    /* all rows; a row that an earlier claim EQUALITY names counts as one */
    PRESENT  /* rows not yet removed; a row that is never removed and that any claim EQUALITY names
                counts as an equality */
} basis;

/* The relation of row i for the multipliers of the claim being checked. */
static fmb_rel relation_in(const court *c, size_t i, basis from)
{
    bool equal = from == FLAT      ? c->equal[i] < c->now
                 : from == PRESENT ? c->equal[i] != SIZE_MAX && c->goes[i] == SIZE_MAX
                                   : false;
    return equal ? FMB_EQ : fmb_system_row(c->s, i)->rel;
}

/* Are rows and signs of the multipliers valid? *strict: one of a strict row is positive. */
static bool are_multipliers(court *c, const fmb_sparse_vector *multipliers, basis from,
                            bool *strict)
{
    *strict = false;
    for (size_t k = 0; k < multipliers->size; k++) {
        size_t i = multipliers->index[k];
        if (i >= c->s->rows)
            return refuse(c, "there is no row %zu", i + 1);
        if (from == PRESENT && c->goes[i] <= c->now)
            return refuse(c, "row %zu was removed", i + 1);
        fmb_rel rel = relation_in(c, i, from);
        int sign = mpq_sgn(multipliers->value[k]);
        if (rel != FMB_EQ && sign < 0)
            return refuse(c, "the multiplier of row %zu is negative", i + 1);
        *strict = *strict || (rel == FMB_LT && sign > 0);
    }
    return true;
}

/* Do the multipliers prove the goal, read with < if that is strict?
 *
 * Let the goal be g.x <= h, or g.x < h. Multipliers that are >= 0 on inequalities add the rows up
 * to a.x <= b, true of all solutions, and a.x < b if one of a strict row is positive. With a = g it
 * implies the goal if b < h, or if b = h and (the goal is not strict or a.x < b holds). The
 * combination is left = a - g and right = b - h. */
static bool proves(court *c, const fmb_sparse_vector *multipliers, const fmb_combination_goal *goal,
                   bool strict_goal, basis from)
{
    bool strict;
    int wrong = -1, right = 0;
    if (!are_multipliers(c, multipliers, from, &strict) ||
        !goes_on(c, fmb_combine_rows(c->s, multipliers, goal, &c->mem, &c->poll, &wrong, &right)))
        return false;
    if (wrong >= 0)
        return refuse(c, "the combined coefficient of %s is wrong", fmb_system_name(c->s, wrong));
    if (right > 0)
        return refuse(c, "the combined right side is too large");
    if (right == 0 && strict_goal && !strict)
        return refuse(c, "the combination is not strict");
    return true;
}

/* ---- one check for each kind of claim -------------------------------------------------------- */

static bool check_feasible(court *c, const fmb_claim *q)
{
    return keeps_all(c, &q->point, AS_WRITTEN);
}

/* Infeasible: the rows prove 0 < 0. */
static bool check_infeasible(court *c, const fmb_claim *q)
{
    return proves(c, &q->multipliers, &(fmb_combination_goal){.row = SIZE_MAX}, true, WRITTEN);
}

/* The form of a claim is its variable, if any (BOUND and UNBOUNDED), plus its terms: is it
 * valid? */
static bool has_form(court *c, const fmb_claim *q)
{
    bool end = q->kind == FMB_CLAIM_BOUND || q->kind == FMB_CLAIM_UNBOUNDED;
    bool good = q->var >= -1 && q->var < (end ? c->e->dim : 0);
    for (size_t k = 0; k < q->terms.size; k++)
        good = good && q->terms.index[k] < (size_t)c->e->dim;
    return good || refuse(c, "the claim is about no variable");
}

/* Do the multipliers prove the claim's own inequality, form <= value, times sign? */
static bool proves_form(court *c, const fmb_claim *q, const fmb_sparse_vector *multipliers,
                        int sign, bool strict)
{
    return proves(c, multipliers, &(fmb_combination_goal){.claim = q, .sign = sign}, strict,
                  WRITTEN);
}

/* form <= value and a solution attains it; or form < value and solutions come arbitrarily near. For
 * the latter, let p satisfy the rows with < read as <=, form(p) = value, and let q be a solution.
 * Every q + t(p - q), 0 <= t < 1, is a solution (a strict row holds strictly at q), and the form
 * tends to value as t tends to 1. Lower bounds are upper bounds of -form. */
static bool check_bound(court *c, const fmb_claim *q)
{
    if (q->rel == FMB_EQ)
        return refuse(c, "the claim is no bound");
    if (!has_form(c, q))
        return false;
    bool open = q->rel == FMB_LT;
    if (!proves_form(c, q, &q->multipliers, q->side == FMB_UPPER ? 1 : -1, open))
        return false;
    if (open && !c->feasible)
        return refuse(c, "no claim shows that the system is feasible");
    if (!keeps_all(c, &q->point, open ? CLOSED : AS_WRITTEN))
        return false;
    int sign = 0;
    return goes_on(c, fmb_form_sign(q, &q->point, q->value, &c->mem, &c->poll, &sign)) &&
           (sign == 0 || refuse(c, "the point is not at the bound"));
}

/* From a solution, all points along the ray are solutions. */
static bool check_unbounded(court *c, const fmb_claim *q)
{
    if (!has_form(c, q))
        return false;
    if (!c->feasible)
        return refuse(c, "no claim shows that the system is feasible");
    if (!keeps_all(c, &q->ray, DIRECTION))
        return false;
    int sign = 0;
    return goes_on(c, fmb_form_sign(q, &q->ray, NULL, &c->mem, &c->poll, &sign)) &&
           (sign == (q->side == FMB_UPPER ? 1 : -1) || refuse(c, "the ray does not go that way"));
}

/* An equality needs both directions. */
static bool check_implied(court *c, const fmb_claim *q)
{
    if (!has_form(c, q))
        return false;
    return proves_form(c, q, &q->multipliers, 1, q->rel == FMB_LT) &&
           (q->rel != FMB_EQ || proves_form(c, q, &q->reverse, -1, false));
}

/* Do the multipliers prove row i, times sign? */
static bool proves_row(court *c, size_t i, const fmb_sparse_vector *multipliers, int sign,
                       bool strict, basis from)
{
    return proves(c, multipliers, &(fmb_combination_goal){.row = i, .sign = sign}, strict, from);
}

static bool has_row(court *c, const fmb_claim *q)
{
    return q->row < c->s->rows || refuse(c, "the claim is about no row");
}

/* The last row removed follows from the kept rows, the one before it from these and the last, and
 * so on: the kept rows, with their equalities, imply all others. */
static bool check_redundant(court *c, const fmb_claim *q)
{
    if (!has_row(c, q))
        return false;
    fmb_rel rel = fmb_system_row(c->s, q->row)->rel;
    return proves_row(c, q->row, &q->multipliers, 1, rel == FMB_LT, PRESENT) &&
           (rel != FMB_EQ || proves_row(c, q->row, &q->reverse, -1, false, PRESENT));
}

/* Row a.x <= b is an equality if all rows, and earlier claims EQUALITY, prove -a.x <= -b. A strict
 * row is never one, even if there is no solution: as an equality it would admit points. */
static bool check_equality(court *c, const fmb_claim *q)
{
    if (!has_row(c, q))
        return false;
    if (fmb_system_row(c->s, q->row)->rel == FMB_LT)
        return refuse(c, "row %zu is strict", q->row + 1);
    return proves_row(c, q->row, &q->multipliers, -1, false, FLAT);
}

/* The point satisfies all kept rows but row q->row, which it violates. */
static bool check_irredundant(court *c, const fmb_claim *q)
{
    bool good = true;
    if (!has_row(c, q) || !lay_out(c, &q->point, false))
        return false;
    for (size_t i = 0; good && i < c->s->rows; i++) {
        const fmb_sysrow *row = fmb_system_row(c->s, i);
        if (c->goes[i] != SIZE_MAX && i != q->row)
            continue;
        fmb_rel rel = c->equal[i] != SIZE_MAX ? FMB_EQ : row->rel;
        int side = 0;
        good = goes_on(c, fmb_place_side(&c->here, row, &side));
        bool kept = keeps(side, rel);
        if (good && kept == (i == q->row))
            good = refuse(c, "the point %s row %zu", kept ? "satisfies" : "violates", i + 1);
    }
    fmb_place_take(&c->here, &q->point);
    return good;
}

/* A point of the closure, or a direction in it. */
static bool check_corner(court *c, const fmb_claim *q)
{
    if (q->point.size > 0 && q->ray.size > 0)
        return refuse(c, "the corner is both a point and a ray");
    return q->ray.size > 0 ? keeps_all(c, &q->ray, DIRECTION) : keeps_all(c, &q->point, CLOSED);
}

static bool check_complete(court *c, const fmb_claim *q)
{
    const char *why = NULL;
    if (!has_form(c, q))
        return false;
    if (c->doubtful)
        return refuse(c, "it leans on claims that do not hold");
    fmb_status st = q->point.size > 0
                        ? fmb_by_elimination_check(c->s, c->e, q, &c->mem, &c->poll, &why)
                        : fmb_complete_check(c->s, c->e, q, &c->mem, &c->poll, &why, NULL);
    return goes_on(c, st) && (!why || refuse(c, "%s", why));
}

static bool check_follows(court *c, const fmb_claim *q)
{
    const char *why = NULL;
    return has_form(c, q) && goes_on(c, fmb_follows_check(c->e, q, &c->mem, &c->poll, &why)) &&
           (!why || refuse(c, "%s", why));
}

/* ---- the session ----------------------------------------------------------------------------- */

static bool check_by_kind(court *c, const fmb_claim *q)
{
    static bool (*const by_kind[])(court *, const fmb_claim *) = {
        [FMB_CLAIM_FEASIBLE] = check_feasible, [FMB_CLAIM_INFEASIBLE] = check_infeasible,
        [FMB_CLAIM_BOUND] = check_bound,       [FMB_CLAIM_UNBOUNDED] = check_unbounded,
        [FMB_CLAIM_IMPLIED] = check_implied,   [FMB_CLAIM_REDUNDANT] = check_redundant,
        [FMB_CLAIM_EQUALITY] = check_equality, [FMB_CLAIM_IRREDUNDANT] = check_irredundant,
        [FMB_CLAIM_CORNER] = check_corner,     [FMB_CLAIM_WHOLE] = check_complete,
        [FMB_CLAIM_FOLLOWS] = check_follows};
    if (q->kind <= FMB_CLAIM_NONE || q->kind > FMB_CLAIM_FOLLOWS)
        return refuse(c, "the claim is of no known kind");
    return by_kind[q->kind](c, q);
}

/* The verdict on the system that an accepted claim gives. */
static fmb_verdict meaning(const fmb_claim *q)
{
    if (q->kind == FMB_CLAIM_INFEASIBLE)
        return FMB_INFEASIBLE;
    bool has_solution = q->kind == FMB_CLAIM_FEASIBLE || q->kind == FMB_CLAIM_UNBOUNDED ||
                        q->kind == FMB_CLAIM_BOUND;
    return has_solution ? FMB_FEASIBLE : FMB_UNKNOWN;
}

/* Claims FEASIBLE come first, as others rely on them; claims WHOLE last: they rely on all
 * others. */
static int turn_of(const fmb_claim *q)
{
    return q->kind == FMB_CLAIM_FEASIBLE ? 0 : q->kind != FMB_CLAIM_WHOLE ? 1 : 2;
}

/* Check claim i, and note the result. The reason of the first failing claim is reported. */
static void check_claim(court *c, size_t i, fmb_judgement *out)
{
    char reason[sizeof out->reason] = "";
    const fmb_claim *q = &c->e->claim[i];
    c->reason = reason;
    c->now = i;
    if (check_by_kind(c, q) && goes_on(c, fmb_poll_ask(&c->poll))) {
        c->feasible = c->feasible || q->kind == FMB_CLAIM_FEASIBLE;
        c->integral = c->integral ||
                      (q->kind == FMB_CLAIM_FEASIBLE && fmb_point_is_integral(c->s, &q->point));
        out->relaxed =
            out->relaxed || (c->integers && !fmb_claim_is_integral(c->s, q, c->integral));
        out->held++;
        out->verdict = meaning(q) != FMB_UNKNOWN ? meaning(q) : out->verdict;
    } else if (c->st == FMB_OK && i < out->claim) {
        out->claim = i;
        memcpy(out->reason, reason, sizeof reason);
    }
}

static void check_all(court *c, fmb_judgement *out)
{
    const fmb_evidence *e = c->e;
    for (int turn = 0; turn <= 2; turn++) {
        c->doubtful = out->claim != SIZE_MAX;
        for (size_t i = 0; c->st == FMB_OK && i < e->claims; i++)
            if (turn_of(&e->claim[i]) == turn)
                check_claim(c, i, out);
    }
    out->accepted = c->st == FMB_OK && e->claims > 0 && out->claim == SIZE_MAX;
    if (e->claims == 0)
        snprintf(out->reason, sizeof out->reason, "there is no claim");
}

/* Note which rows are removed, and which are equalities. */
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

/* A limit is a result: claims not judged by then are not accepted. */
static void check_to_limit(court *c, fmb_judgement *out)
{
    fmb_judgement found = {.size = sizeof found, .claim = SIZE_MAX};
    if (c->st == FMB_OK) {
        mark_rows(c);
        check_all(c, &found);
    }
    if (c->st == FMB_LIMIT) {
        found.stop = fmb_guard_stop(&c->guard);
        found.verdict = FMB_UNKNOWN;
        if (found.claim == SIZE_MAX)
            snprintf(found.reason, sizeof found.reason, "undecided (%s): %zu of %zu claims hold",
                     fmb_stop_text(found.stop), found.held, c->e->claims);
        c->st = FMB_OK;
    }
    if (c->st == FMB_OK)
        fmb_sized_give(out, &found, sizeof found);
}

fmb_status fmb_check_within(const fmb_system *s, const fmb_evidence *e,
                            const fmb_patience *patience, fmb_judgement *out)
{
    if (!out || !fmb_sized_is_good(out, sizeof *out, "out", NULL, 0) || !fmb_evidence_fits(e, s))
        return FMB_ERR_ARG;
    court c = {.s = s, .e = e, .integers = fmb_system_first_integer(s) >= 0};
    fmb_mem_init(&c.mem, &s->mem.alloc, 0);
    c.st = fmb_guard_begin(&c.guard, patience, &c.mem);
    if (c.st != FMB_OK)
        return c.st;
    fmb_mem_take(&c.mem, e->mem.used);
    c.poll = fmb_guard_poll(&c.guard);
    c.goes = fmb_mem_get(&c.mem, e->rows, sizeof *c.goes);
    c.equal = fmb_mem_get(&c.mem, e->rows, sizeof *c.equal);
    c.st = fmb_place_init(&c.here, (size_t)e->dim, &c.mem);
    if (c.st == FMB_OK && (!c.goes || !c.equal))
        c.st = fmb_mem_status(&c.mem);
    check_to_limit(&c, out);
    fmb_place_clear(&c.here, &c.mem);
    fmb_mem_put(&c.mem, c.goes, e->rows, sizeof *c.goes);
    fmb_mem_put(&c.mem, c.equal, e->rows, sizeof *c.equal);
    return c.st;
}

fmb_status fmb_check(const fmb_system *s, const fmb_evidence *e, fmb_judgement *out)
{
    return fmb_check_within(s, e, NULL, out);
}
