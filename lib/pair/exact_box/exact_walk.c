/* exact_walk.c: see exact_walk.h.
 *
 * The primal simplex method with Bland's rule. As long as unknowns are out of their places, it is
 * the sum of the ways there that becomes less; an unknown that gets to its place stays in it. Where
 * nothing makes that sum less, there is no common point. (Dantzig 1955; Bland 1977.)
 */
#include "pair/exact_box/exact_walk.h"

#include "pair/exact_box/exact_box_value.h"

enum { DIM = FMB_EXACT_BOX_DIM, MOST_STEPS = 256 };

/* Basic unknowns, those of P and then the references, by number. */
enum { MOST_ITEMS = DIM + 2 };

typedef struct exact_walk {
    fmb_exact_box *v;
    int items, unknown[MOST_ITEMS];
    fmb_wide value[MOST_ITEMS]; /* times det */
    int out[MOST_ITEMS];        /* -1: below its place, 1: above it */
    bool any_out;
    fmb_wide cost[FMB_EXACT_BOX_UNKNOWNS]; /* of what is to become greater */
} exact_walk;

static int place_group(const exact_walk *w, int unknown)
{
    return w->v->program->group[unknown];
}

/* -1: below its place, 1: above it. */
static int side_of_place(const exact_walk *w, const fmb_wide *value, int group)
{
    if (value->minus)
        return -1;
    if (group == FMB_EXACT_BOX_ZERO)
        return value->n > 0;
    return group == FMB_EXACT_BOX_UNIT && fmb_wide_compare(value, &w->v->whole->det) > 0;
}

static void list_items(exact_walk *w)
{
    fmb_exact_box *v = w->v;
    const fmb_exact_box_whole *whole = fmb_exact_box_need_whole(v);
    w->items = v->program->dim;
    for (int k = 0; k < w->items; k++) {
        w->unknown[k] = v->basic[k];
        fmb_wide_copy(&w->value[k], &whole->x[k]);
    }
    for (int group = 0; group < 2; group++)
        if (v->reference[group] >= 0) {
            w->unknown[w->items] = v->reference[group];
            fmb_exact_box_remainder(v, group, -1, &w->value[w->items++]);
        }
    w->any_out = false;
    for (int i = 0; i < w->items; i++) {
        w->out[i] = side_of_place(w, &w->value[i], place_group(w, w->unknown[i]));
        w->any_out |= w->out[i] != 0;
    }
}

/* Where something is out of its place, that; else the goal. */
static void list_exact_costs(exact_walk *w, const fmb_exact_box_goal *goal)
{
    const fmb_exact_box_program *s = w->v->program;
    fmb_exact_box_cost cost[FMB_EXACT_BOX_UNKNOWNS];
    if (!w->any_out)
        fmb_exact_box_list_costs(w->v, goal, cost);
    bool turned = !w->any_out && goal->greatest == (goal->is_world && w->v->side == 1);
    for (int j = 0; j < s->unknowns; j++) {
        if (w->any_out)
            fmb_wide_set_word(&w->cost[j], 0);
        else
            fmb_wide_copy(&w->cost[j], cost[j].whole);
        if (turned)
            fmb_wide_negate(&w->cost[j]);
    }
    for (int i = 0; i < w->items; i++)
        if (w->out[i] != 0) {
            fmb_wide_set_word(&w->cost[w->unknown[i]], 1);
            w->cost[w->unknown[i]].minus = w->out[i] > 0;
        }
}

static const fmb_wide *relative_cost(const exact_walk *w, int j, fmb_wide *room)
{
    int reference = fmb_exact_box_reference_of(w->v, j);
    return fmb_exact_box_difference(&w->cost[j], reference < 0 ? NULL : &w->cost[reference], room);
}

/* The first unknown that gains where it leaves its end, or -1. */
static int find_gaining(exact_walk *w)
{
    fmb_exact_box *v = w->v;
    fmb_wide room[DIM], y[DIM], loss;
    const fmb_wide *cost[DIM];
    for (int k = 0; k < v->program->dim; k++)
        cost[k] = relative_cost(w, v->basic[k], &room[k]);
    fmb_exact_box_find_prices(v, cost, y);
    for (int j = 0; j < v->program->artificial; j++) {
        int place = v->basis.place[j];
        if (place == FMB_EXACT_BOX_BASIC || place_group(w, j) == FMB_EXACT_BOX_NONE)
            continue;
        fmb_exact_box_find_loss(v, y, relative_cost(w, j, &room[0]), j, &loss);
        if (fmb_wide_sign(&loss) == (place == FMB_EXACT_BOX_HIGH ? 1 : -1))
            return j;
    }
    return -1;
}

/* How much, times det, each item falls for each unit by which unknown j leaves its end. */
static void find_falls(const exact_walk *w, int j, fmb_wide *fall)
{
    fmb_exact_box *v = w->v;
    int n = v->program->dim;
    fmb_wide room[DIM];
    const fmb_wide *column[DIM], *row[DIM];
    fmb_exact_box_list_column(v, j, column, room);
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < n; i++)
            row[i] = &v->whole->adjugate[k][i];
        fmb_wide_dot(&fall[k], n, row, column, 0);
    }
    for (int i = n; i < w->items; i++) {
        int group = place_group(w, w->unknown[i]);
        fmb_wide_set_word(&fall[i], 0);
        if (place_group(w, j) == group)
            fmb_wide_copy(&fall[i], &v->whole->det);
        for (int k = 0; k < n; k++)
            if (place_group(w, v->basic[k]) == group)
                fmb_wide_subtract(&fall[i], &fall[k]);
    }
    for (int i = 0; v->basis.place[j] == FMB_EXACT_BOX_HIGH && i < w->items; i++)
        fmb_wide_negate(&fall[i]);
}

/* What item i has left until it is at an end of its place, or, out of it, at the nearer one: det
 * times that. False: it may go on for ever. */
static bool room_of_item(const exact_walk *w, int i, bool up, fmb_wide *room, bool *high)
{
    int group = place_group(w, w->unknown[i]), out = w->out[i];
    *high = group == FMB_EXACT_BOX_UNIT && (up ? out == 0 : out > 0);
    if (up ? out > 0 || (out == 0 && group <= FMB_EXACT_BOX_OF_B) : out < 0)
        return false;
    fmb_wide_copy(room, &w->value[i]);
    if (*high)
        fmb_wide_subtract(room, &w->v->whole->det);
    room->minus = false;
    return true;
}

/* Unknown j leaves its end until an item comes to one, or j to its other one; of several the one
 * with the least number. False: nothing stops it. */
static bool leave_end_exactly(exact_walk *w, int j)
{
    fmb_exact_box *v = w->v;
    fmb_wide fall[MOST_ITEMS], room, way, speed, left, right;
    int leaving = -1;
    bool high = false, end;
    find_falls(w, j, fall);
    fmb_wide_set_word(&way, 1);
    fmb_wide_set_word(&speed, 1);
    if (place_group(w, j) == FMB_EXACT_BOX_UNIT) {
        leaving = j;
        high = v->basis.place[j] == FMB_EXACT_BOX_LOW;
    }
    for (int i = 0; i < w->items; i++) {
        if (fall[i].n == 0 || !room_of_item(w, i, fall[i].minus, &room, &end))
            continue;
        fall[i].minus = false;
        if (leaving >= 0) {
            fmb_wide_multiply(&left, &room, &speed);
            fmb_wide_multiply(&right, &way, &fall[i]);
            int order = fmb_wide_compare(&left, &right);
            if (order > 0 || (order == 0 && leaving < w->unknown[i]))
                continue;
        }
        fmb_wide_copy(&way, &room);
        fmb_wide_copy(&speed, &fall[i]);
        leaving = w->unknown[i];
        high = end;
    }
    if (leaving < 0)
        return false;
    v->basis.place[j] = FMB_EXACT_BOX_BASIC;
    v->basis.place[leaving] = high ? FMB_EXACT_BOX_HIGH : FMB_EXACT_BOX_LOW;
    return true;
}

/* All artificial unknowns and slacks: the one that always is a basis. */
static void put_unit_basis(const fmb_exact_box_program *s, fmb_exact_box_basis *basis)
{
    *basis = (fmb_exact_box_basis){{0}};
    for (int j = s->slack; j < s->unknowns; j++)
        if (s->group[j] != FMB_EXACT_BOX_NONE)
            basis->place[j] = FMB_EXACT_BOX_BASIC;
}

fmb_verdict fmb_exact_box_walk_exactly(fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    exact_walk w = {.v = v};
    if (fmb_exact_box_need_whole(v)->det.n == 0)
        put_unit_basis(v->program, &v->basis);
    for (int steps = 0; steps < MOST_STEPS; steps++) {
        fmb_exact_box_basis basis = v->basis;
        if (fmb_poll_ask(v->whole->poll) != FMB_OK ||
            !fmb_exact_box_take_basis(v, v->program, &basis))
            return FMB_UNKNOWN;
        list_items(&w);
        if (!w.any_out && !goal)
            return FMB_FEASIBLE;
        list_exact_costs(&w, goal);
        int j = find_gaining(&w);
        if (j < 0)
            return w.any_out ? FMB_INFEASIBLE : FMB_FEASIBLE;
        if (!leave_end_exactly(&w, j))
            return FMB_UNKNOWN;
    }
    return FMB_UNKNOWN;
}
