/* exact_walk.c: see exact_walk.h.
 *
 * The primal simplex method with Bland's rule. While unknowns are outside of their places, the sum
 * of their infeasibilities is minimized; an unknown that reaches its place stays in it. If the sum
 * cannot be reduced to 0, there is no common point. (Dantzig 1955; Bland 1977.)
 *
 * Each pivot exchanges one column in adjugate, det and values, which remain integers (Edmonds 1967,
 * Systems of distinct representatives and linear algebra).
 */
#include "pair/exact_box/exact_walk.h"

#include "pair/exact_box/exact_box_value.h"

#define DIM FMB_EXACT_BOX_DIM
enum { MOST_EXACT_STEPS = 256 };

/* Items are the basic unknowns: those of P, item k in place k, and then the references. Values and
 * falls of items are in v->whole. */
typedef struct exact_walk {
    fmb_exact_box *v;
    fmb_exact_box_whole *whole;
    int items, unknown[FMB_EXACT_BOX_ITEMS];
    int out[FMB_EXACT_BOX_ITEMS]; /* -1: below its place, 1: above it */
    bool any_out;
    fmb_exact_box_cost cost[FMB_EXACT_BOX_UNKNOWNS]; /* of the sum to be maximized */
    bool turned;                                     /* minimized instead */
} exact_walk;

static int place_group(const exact_walk *w, int unknown)
{
    return w->v->program->group[unknown];
}

/* -1: below its place, 1: above it. */
static int side_of_place(const exact_walk *w, const fmb_wide *value, int unknown)
{
    int group = place_group(w, unknown);
    fmb_wide beyond;
    if (value->minus)
        return -1;
    if (group != FMB_EXACT_BOX_UNIT)
        return group == FMB_EXACT_BOX_ZERO && value->n > 0;
    fmb_wide_copy(&beyond, value);
    fmb_exact_box_gather_end(w->v->program, unknown, &beyond, &w->whole->det, true);
    return fmb_wide_sign(&beyond) > 0;
}

static void list_items(exact_walk *w)
{
    fmb_exact_box *v = w->v;
    (void)fmb_exact_box_need_whole(v);
    w->whole = fmb_exact_box_need_adjugate(v);
    w->items = v->program->dim;
    for (int k = 0; k < w->items; k++) {
        w->unknown[k] = v->basic[k];
        fmb_wide_copy(&w->whole->value[k], &w->whole->x[k]);
    }
    for (int group = 0; group < 2; group++)
        if (v->reference[group] >= 0) {
            w->unknown[w->items] = v->reference[group];
            fmb_exact_box_remainder(v, group, -1, &w->whole->value[w->items++]);
        }
}

static void look_at_places(exact_walk *w)
{
    w->any_out = false;
    for (int i = 0; i < w->items; i++) {
        w->out[i] = side_of_place(w, &w->whole->value[i], w->unknown[i]);
        w->any_out |= w->out[i] != 0;
    }
}

/* The costs of the infeasibilities, if some unknown is outside of its place; else of the goal. */
static void list_exact_costs(exact_walk *w, const fmb_exact_box_goal *goal)
{
    w->turned = !w->any_out && goal->greatest == (goal->is_world && w->v->side == 1);
    if (!w->any_out) {
        fmb_exact_box_list_costs(w->v, goal, w->cost);
        return;
    }
    for (int i = 0; i < 3; i++) {
        fmb_wide_set_word(&w->whole->way[i], i != 1);
        w->whole->way[i].minus = i == 2;
    }
    for (int j = 0; j < w->v->program->unknowns; j++)
        w->cost[j].whole = &w->whole->way[1];
    for (int i = 0; i < w->items; i++)
        w->cost[w->unknown[i]].whole = &w->whole->way[1 + w->out[i]];
}

/* The entering unknown by Bland's rule: the first with a favourable reduced cost; or -1. */
static int find_gaining(exact_walk *w)
{
    fmb_exact_box *v = w->v;
    fmb_wide *room = w->whole->cost;
    const fmb_wide *cost[DIM];
    for (int k = 0; k < v->program->dim; k++)
        cost[k] = fmb_exact_box_relative_cost(v, w->cost, v->basic[k], &room[k]);
    fmb_exact_box_find_prices(v, cost, w->whole->price);
    for (int j = 0; j < v->program->artificial; j++) {
        fmb_wide loss;
        int place = v->basis.place[j];
        if (place == FMB_EXACT_BOX_BASIC || place_group(w, j) == FMB_EXACT_BOX_NONE)
            continue;
        fmb_exact_box_find_loss(v, w->whole->price,
                                fmb_exact_box_relative_cost(v, w->cost, j, &room[0]), j, &loss);
        if (fmb_wide_sign(&loss) == ((place == FMB_EXACT_BOX_HIGH) != w->turned ? 1 : -1))
            return j;
    }
    return -1;
}

/* The decrease of each item, times det, per unit by which unknown j leaves its end. */
static void find_falls(const exact_walk *w, int j)
{
    fmb_exact_box *v = w->v;
    fmb_wide *fall = w->whole->fall;
    int n = v->program->dim;
    const fmb_wide *column[DIM];
    fmb_exact_box_list_column(v, j, column, w->whole->column);
    for (int k = 0; k < n; k++)
        fmb_exact_box_times_row(w->whole, n, k, column, &fall[k]);
    for (int i = n; i < w->items; i++) {
        int group = place_group(w, w->unknown[i]);
        fmb_wide_set_word(&fall[i], 0);
        if (place_group(w, j) == group)
            fmb_wide_copy(&fall[i], &w->whole->det);
        for (int k = 0; k < n; k++)
            if (place_group(w, v->basic[k]) == group)
                fmb_wide_subtract(&fall[i], &fall[k]);
    }
    for (int i = 0; v->basis.place[j] == FMB_EXACT_BOX_HIGH && i < w->items; i++)
        fmb_wide_negate(&fall[i]);
}

/* ---- which unknown leaves -------------------------------------------------------------------- */

/* The step of an entering unknown: room / speed, until that item reaches an end of its place; or,
 * if item is -1, until the unknown itself reaches its other end. */
typedef struct exact_way {
    int item;
    bool high;
    fmb_wide room, speed;
} exact_way;

/* det times the distance of item i to the end of its place, or, if it is outside, to the nearer
 * end. False: it is unlimited. */
static bool room_of_item(const exact_walk *w, int i, bool up, fmb_wide *room, bool *high)
{
    int group = place_group(w, w->unknown[i]), out = w->out[i];
    *high = group == FMB_EXACT_BOX_UNIT && (up ? out == 0 : out > 0);
    if (up ? out > 0 || (out == 0 && group <= FMB_EXACT_BOX_OF_B) : out < 0)
        return false;
    fmb_wide_copy(room, &w->whole->value[i]);
    if (*high)
        fmb_exact_box_gather_end(w->v->program, w->unknown[i], room, &w->whole->det, true);
    room->minus = false;
    return true;
}

static bool is_shorter(const exact_walk *w, int j, const exact_way *a, const exact_way *b)
{
    fmb_wide left, right;
    fmb_wide_multiply(&left, &a->room, &b->speed);
    fmb_wide_multiply(&right, &b->room, &a->speed);
    int order = fmb_wide_compare(&left, &right);
    return order < 0 ||
           (order == 0 && w->unknown[a->item] < (b->item < 0 ? j : w->unknown[b->item]));
}

/* The ratio test: unknown j moves until an item reaches an end, or j its other end; ties go to the
 * least number. False: nothing limits it. */
static bool find_way(const exact_walk *w, int j, exact_way *way)
{
    bool any = place_group(w, j) == FMB_EXACT_BOX_UNIT;
    exact_way next;
    way->item = -1;
    fmb_wide_set_word(&way->speed, 1);
    way->room.n = 0;
    fmb_exact_box_gather_end(w->v->program, j, &way->room, &way->speed, false);
    for (next.item = 0; next.item < w->items; next.item++) {
        const fmb_wide *fall = &w->whole->fall[next.item];
        if (fall->n == 0 || !room_of_item(w, next.item, fall->minus, &next.room, &next.high))
            continue;
        fmb_wide_copy(&next.speed, fall);
        next.speed.minus = false;
        if (any && !is_shorter(w, j, &next, way))
            continue;
        way->item = next.item;
        way->high = next.high;
        fmb_wide_copy(&way->room, &next.room);
        fmb_wide_copy(&way->speed, &next.speed);
        any = true;
    }
    return any;
}

/* ---- a step ---------------------------------------------------------------------------------- */

/* Replace row k of the adjugate by minus the sum of all rows of its group: the reference of the
 * group and the unknown of place k are exchanged. */
static void swap_reference(exact_walk *w, int item, int k)
{
    fmb_exact_box *v = w->v;
    fmb_exact_box_whole *whole = w->whole;
    int group = place_group(w, w->unknown[item]), n = v->program->dim;
    for (int i = 0; i < n; i++)
        for (int row = 0; row < n; row++)
            if (row != k && place_group(w, w->unknown[row]) == group)
                fmb_wide_add(&whole->adjugate[k][i], &whole->adjugate[row][i]);
    for (int i = 0; i < n; i++)
        fmb_wide_negate(&whole->adjugate[k][i]);
    fmb_wide_swap(&whole->value[k], &whole->value[item]);
    fmb_wide_swap(&whole->fall[k], &whole->fall[item]);
    v->reference[group] = w->unknown[k];
    w->unknown[k] = v->basic[k] = w->unknown[item];
    w->unknown[item] = v->reference[group];
}

/* If the leaving item is a reference, exchange it with an unknown of P in its group, if there is
 * one. Returns the item that it is then. */
static int put_into_place(exact_walk *w, int item)
{
    int n = w->v->program->dim, k = 0;
    if (item < n)
        return item;
    while (k < n && place_group(w, w->unknown[k]) != place_group(w, w->unknown[item]))
        k++;
    if (k == n)
        return item;
    swap_reference(w, item, k);
    return k;
}

/* Put the column of j in place k; its entries are the falls, up to a sign. */
static void put_column_of(exact_walk *w, int k, bool high, const fmb_wide *speed)
{
    fmb_exact_box_whole *whole = w->whole;
    int n = w->v->program->dim;
    bool minus = whole->fall[k].minus;
    for (int i = 0; i < n; i++)
        for (int j = 0; i != k && j < n; j++)
            fmb_exact_box_reduce(&whole->adjugate[i][j], speed, &whole->fall[i],
                                 &whole->adjugate[k][j], minus, &whole->det);
    for (int j = 0; minus != high && j < n; j++)
        fmb_wide_negate(&whole->adjugate[k][j]);
}

/* Pivot: unknown j makes that step and becomes basic in place of the one that reached an end. */
static void go(exact_walk *w, int j, const exact_way *way)
{
    fmb_exact_box *v = w->v;
    fmb_exact_box_whole *whole = w->whole;
    int n = v->program->dim, k = put_into_place(w, way->item), group = place_group(w, j);
    bool high = v->basis.place[j] == FMB_EXACT_BOX_HIGH;
    v->basis.place[w->unknown[k]] = way->high ? FMB_EXACT_BOX_HIGH : FMB_EXACT_BOX_LOW;
    v->basis.place[j] = FMB_EXACT_BOX_BASIC;
    for (int i = 0; i < w->items; i++)
        if (i != k)
            fmb_exact_box_reduce(&whole->value[i], &way->speed, &whole->fall[i], &way->room, false,
                                 &whole->det);
    if (k < n)
        put_column_of(w, k, high, &way->speed);
    fmb_wide_copy(&whole->value[k], &way->room);
    if (high) {
        fmb_exact_box_gather_end(v->program, j, &whole->value[k], &way->speed, true);
        fmb_wide_negate(&whole->value[k]);
    }
    fmb_wide_copy(&whole->det, &way->speed);
    w->unknown[k] = j;
    if (k < n)
        v->basic[k] = j;
    else
        v->reference[group] = j;
}

/* Move nonbasic unknown j to its other end. */
static void turn_end(exact_walk *w, int j)
{
    unsigned char *place = &w->v->basis.place[j];
    *place = *place == FMB_EXACT_BOX_LOW ? FMB_EXACT_BOX_HIGH : FMB_EXACT_BOX_LOW;
    for (int i = 0; i < w->items; i++)
        fmb_exact_box_gather_end(w->v->program, j, &w->whole->value[i], &w->whole->fall[i], true);
}

static fmb_verdict walk_on(exact_walk *w, const fmb_exact_box_goal *goal)
{
    exact_way way;
    for (int steps = 0; steps < MOST_EXACT_STEPS; steps++) {
        if (fmb_poll_ask(w->whole->poll) != FMB_OK)
            return FMB_UNKNOWN;
        look_at_places(w);
        if (!w->any_out && !goal)
            return FMB_FEASIBLE;
        list_exact_costs(w, goal);
        int j = find_gaining(w);
        if (j < 0)
            return w->any_out ? FMB_INFEASIBLE : FMB_FEASIBLE;
        find_falls(w, j);
        if (!find_way(w, j, &way))
            return FMB_UNKNOWN;
        if (way.item < 0)
            turn_end(w, j);
        else
            go(w, j, &way);
    }
    return FMB_UNKNOWN;
}

/* ---- the walk -------------------------------------------------------------------------------- */

/* The basis of all artificial unknowns and slacks, which always exists. */
static void put_unit_basis(const fmb_exact_box_program *s, fmb_exact_box_basis *basis)
{
    *basis = (fmb_exact_box_basis){{0}};
    for (int j = s->slack; j < s->unknowns; j++)
        if (s->group[j] != FMB_EXACT_BOX_NONE)
            basis->place[j] = FMB_EXACT_BOX_BASIC;
}

/* Set v to its new basis, and forget the exact numbers of the old one. */
static bool look_again(fmb_exact_box *v)
{
    fmb_exact_box_basis basis = v->basis;
    return fmb_exact_box_take_basis(v, v->program, &basis);
}

fmb_verdict fmb_exact_box_walk_exactly(fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    exact_walk w = {.v = v};
    if (fmb_exact_box_need_whole(v)->det.n == 0)
        put_unit_basis(v->program, &v->basis);
    if (!look_again(v))
        return FMB_UNKNOWN;
    list_items(&w);
    fmb_verdict verdict = walk_on(&w, goal);
    return look_again(v) ? verdict : FMB_UNKNOWN;
}
