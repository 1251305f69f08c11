/* families_random.c: rows at random, around a point or with a conflict planted. */
#include "study/program/writer.h"

#include <math.h>
#include <stdlib.h>

enum { TERMS = 8, LARGEST = 9 };

/* ---- left sides ------------------------------------------------------------------------------ */

/* A vector of few terms; a variable that is drawn twice is taken once. */
typedef struct left {
    int var[TERMS];
    int64_t coef[TERMS];
    int n;
} left;

static left draw_left(study_writer *w, int variables, int terms)
{
    left a = {.n = 0};
    for (int k = 0; k < terms; k++) {
        int var = (int)study_random_between(&w->g, 0, variables - 1), at = 0;
        while (at < a.n && a.var[at] != var)
            at++;
        if (at < a.n)
            continue;
        a.var[a.n] = var;
        a.coef[a.n++] = study_random_nonzero(&w->g, -LARGEST, LARGEST);
    }
    return a;
}

static int64_t value_at(const left *a, const int64_t *point)
{
    int64_t sum = 0;
    for (int k = 0; k < a->n; k++)
        sum += a->coef[k] * point[a->var[k]];
    return sum;
}

static void write_left(study_writer *w, const left *a, int64_t factor)
{
    for (int k = 0; k < a->n; k++)
        study_write_term(w, a->var[k], factor * a->coef[k]);
}

/* A point of small integers; NULL without memory. */
static int64_t *draw_point(study_writer *w)
{
    int64_t *point = malloc(((size_t)w->variables + 1) * sizeof *point);
    for (int j = 0; point && j < w->variables; j++)
        point[j] = study_random_between(&w->g, -LARGEST, LARGEST);
    if (!point)
        w->st = FMB_ERR_MEMORY;
    return point;
}

/* ---- sparse ---------------------------------------------------------------------------------- */

void study_sparse_origin(study_writer *w)
{
    if (!study_write_begin(w, w->variables))
        return;
    for (int i = 0; i < w->rows; i++) {
        left a = draw_left(w, w->variables, TERMS);
        write_left(w, &a, 1);
        study_write_end(w, FMB_LE, study_random_between(&w->g, 1, 50));
    }
    study_write_any_goal(w);
}

/* count rows that let the point in, one in five only just unless loose. */
static void write_around(study_writer *w, const int64_t *point, int count, bool loose)
{
    for (int i = 0; i < count && w->st == FMB_OK; i++) {
        left a = draw_left(w, w->variables, TERMS);
        bool touch = !loose && study_random_chance(&w->g, 20);
        write_left(w, &a, 1);
        study_write_end(w, FMB_LE,
                        value_at(&a, point) + (touch ? 0 : study_random_between(&w->g, 1, 50)));
    }
}

void study_sparse_point(study_writer *w)
{
    int64_t *point = draw_point(w);
    if (point && study_write_begin(w, w->variables)) {
        write_around(w, point, w->rows, false);
        study_write_any_goal(w);
    }
    free(point);
}

/* Rows c1 v1, c2 v2 - d2 v1, ..., -dk v(k-1) with vectors v of half the terms cancel if they are
 * taken l1, ..., lk times, l1 = 1 and l(i+1) = li ci / d(i+1); the last right side makes the sum
 * negative. All c and d are 1 or 2, so that 2^k li is whole. */
static void write_conflict(study_writer *w, int length)
{
    left last = {.n = 0};
    int64_t unit = (int64_t)1 << length, l = unit, sum = 0, c = 0;
    for (int i = 0; i < length; i++) {
        int64_t d = study_random_between(&w->g, 1, 2), right;
        if (i > 0)
            l = l * c / d;
        write_left(w, &last, -d);
        c = study_random_between(&w->g, 1, 2);
        left next = draw_left(w, w->variables, TERMS / 2);
        if (i + 1 < length) {
            write_left(w, &next, c);
            right = study_random_between(&w->g, -50, 50);
            sum += l * right;
        } else {
            /* The greatest right side with sum + l right < 0. */
            right = -sum / l - 2;
        }
        study_write_end(w, FMB_LE, right);
        last = next;
    }
}

void study_sparse_conflict(study_writer *w)
{
    int length = w->rows < 12 ? w->rows : 12, before = (w->rows - length) / 2;
    int64_t *point = draw_point(w);
    if (length == 1) /* one row alone: 0 <= -1 */
        length = 0;
    if (point && study_write_begin(w, w->variables)) {
        write_around(w, point, before, true);
        if (length == 0)
            study_write_end(w, FMB_LE, -1);
        write_conflict(w, length);
        write_around(w, point, w->rows - before - (length ? length : 1), true);
        study_write_any_goal(w);
    }
    free(point);
}

/* A third of the rows strict; none touches the point but the others of one in five. */
void study_strict(study_writer *w)
{
    int64_t *point = draw_point(w);
    if (point && study_write_begin(w, w->variables)) {
        for (int i = 0; i < w->rows; i++) {
            left a = draw_left(w, w->variables, TERMS);
            bool strict = study_random_chance(&w->g, 33);
            int64_t off = study_random_between(&w->g, strict, 9);
            write_left(w, &a, 1);
            study_write_end(w, strict ? FMB_LT : FMB_LE, value_at(&a, point) + off);
        }
        study_write_any_goal(w);
    }
    free(point);
}

void study_equalities(study_writer *w)
{
    int64_t *point = draw_point(w);
    int equal = w->variables / 2 < w->rows ? w->variables / 2 : w->rows;
    if (point && study_write_begin(w, w->variables)) {
        for (int i = 0; i < equal; i++) {
            left a = draw_left(w, w->variables, TERMS);
            write_left(w, &a, 1);
            study_write_end(w, FMB_EQ, value_at(&a, point));
        }
        write_around(w, point, w->rows - equal, false);
        study_write_any_goal(w);
    }
    free(point);
}

/* No row increases along the ray, which is the objective; the origin is a solution. */
void study_unbounded(study_writer *w)
{
    int64_t *ray = draw_point(w);
    if (ray && study_write_begin(w, w->variables)) {
        for (int i = 0; i < w->rows; i++) {
            left a = draw_left(w, w->variables, TERMS);
            write_left(w, &a, value_at(&a, ray) > 0 ? -1 : 1);
            study_write_end(w, FMB_LE, study_random_between(&w->g, 0, 20));
        }
        for (int j = 0; j < w->variables; j++)
            w->goal[j] = (double)ray[j];
    }
    free(ray);
}

/* All rows through one point. */
void study_degenerate(study_writer *w)
{
    int64_t *point = draw_point(w);
    if (point && study_write_begin(w, w->variables)) {
        for (int i = 0; i < w->rows; i++) {
            left a = draw_left(w, w->variables, TERMS / 2);
            write_left(w, &a, 1);
            study_write_end(w, FMB_LE, value_at(&a, point));
        }
        study_write_any_goal(w);
    }
    free(point);
}

/* ---- dense ----------------------------------------------------------------------------------- */

/* Rows of all terms; right sides around the point, or 0 for NULL. sum[n] += the row and its right
 * side, times a factor 1 ... 3, in rows before `summed`. */
static void write_dense(study_writer *w, const int64_t *point, int count, int64_t *sum)
{
    for (int i = 0; i < count && w->st == FMB_OK; i++) {
        int64_t right = study_random_between(&w->g, 1, 50);
        int64_t factor = sum ? study_random_between(&w->g, 1, 3) : 0;
        for (int j = 0; j < w->variables; j++) {
            int64_t a = study_random_between(&w->g, -LARGEST, LARGEST);
            right += point ? a * point[j] : 0;
            study_write_term(w, j, a);
            if (sum)
                sum[j] += factor * a;
        }
        if (sum)
            sum[w->variables] += factor * right;
        study_write_end(w, FMB_LE, right);
    }
}

void study_dense_origin(study_writer *w)
{
    if (!study_write_begin(w, w->variables))
        return;
    write_dense(w, NULL, w->rows, NULL);
    study_write_any_goal(w);
}

void study_dense_point(study_writer *w)
{
    int64_t *point = draw_point(w);
    if (point && study_write_begin(w, w->variables)) {
        write_dense(w, point, w->rows, NULL);
        study_write_any_goal(w);
    }
    free(point);
}

/* The row after the first `conflict` is what they lack, times factors, to 0 <= -1. */
void study_dense_conflict(study_writer *w)
{
    int conflict = w->variables < w->rows - 1 ? w->variables : w->rows - 1;
    int64_t *point = draw_point(w);
    int64_t *sum = calloc((size_t)w->variables + 1, sizeof *sum);
    if (!sum)
        w->st = FMB_ERR_MEMORY;
    if (point && sum && study_write_begin(w, w->variables)) {
        write_dense(w, point, conflict, sum);
        for (int j = 0; j < w->variables; j++)
            study_write_term(w, j, -sum[j]);
        study_write_end(w, FMB_LE, -sum[w->variables] - 1);
        write_dense(w, point, w->rows - conflict - 1, NULL);
        study_write_any_goal(w);
    }
    free(point);
    free(sum);
}

/* ---- balls ----------------------------------------------------------------------------------- */

/* Rows with whole normals, 1000 from the origin and up to `beyond` farther. */
static void write_around_ball(study_writer *w, int beyond)
{
    if (!study_write_begin(w, w->variables))
        return;
    for (int i = 0; i < w->rows; i++) {
        double square = 0;
        for (int j = 0; j < w->variables; j++) {
            int64_t a = study_random_nonzero(&w->g, -99, 99);
            square += (double)(a * a);
            study_write_term(w, j, a);
        }
        double distance = 1000 + (double)study_random_between(&w->g, 0, beyond);
        study_write_end(w, FMB_LE, (int64_t)ceil(distance * sqrt(square)));
    }
    study_write_any_goal(w);
}

void study_ball(study_writer *w)
{
    write_around_ball(w, 200);
}

void study_sphere(study_writer *w)
{
    write_around_ball(w, 0);
}
