/* rows.c: projections of systems whose rows are drawn at random. */
#include "study/program/writer.h"

/* The left side of a row of all terms. */
static void write_all_terms(study_writer *w, int64_t largest)
{
    for (int j = 0; j < w->variables; j++)
        study_write_term(w, j, study_random_between(&w->g, -largest, largest));
}

static void write_dense_rows(study_writer *w, int rows, fmb_rel other)
{
    for (int i = 0; i < rows; i++) {
        write_all_terms(w, 9);
        study_write_end(w, i % 2 ? other : FMB_LE, study_draw(w, 5, 60));
    }
}

void study_image_dense(study_writer *w)
{
    int n = study_draw_size(w, 4, 8);
    if (study_write_image(w, n, study_draw(w, 2, 3) + w->larger / 2))
        write_dense_rows(w, study_draw(w, 2 * n, n < 8 ? 3 * n : 2 * n + 4), FMB_LE);
}

void study_image_wide(study_writer *w)
{
    int n = study_draw_size(w, 7, 9);
    if (study_write_image(w, n, study_draw(w, 4, n - 3)))
        write_dense_rows(w, n + study_draw(w, 4, 6), FMB_LE);
}

void study_image_strict(study_writer *w)
{
    int n = study_draw(w, 4, 8);
    if (study_write_image(w, n, study_draw(w, 2, n > 5 ? 4 : 3)))
        write_dense_rows(w, 2 * n + study_draw(w, 0, 2), FMB_LT);
}

/* Each row has three variables, and what is left of a long band of variables hangs together. */
void study_image_sparse(study_writer *w)
{
    int n = study_draw(w, 10, 24);
    if (!study_write_image(w, n, study_draw(w, 2, 3)))
        return;
    for (int i = 0; i < 2 * n; i++) {
        int at = study_draw(w, 0, n - 1), step = study_draw(w, 1, n / 2 - 1);
        for (int k = 0; k < 3; k++)
            study_write_term(w, (at + k * step) % n, study_random_nonzero(&w->g, -5, 5));
        study_write_end(w, FMB_LE, study_draw(w, 3, 30));
    }
}

/* Numbers of four digits grow long while rows are combined, and the box makes most of those
 * redundant. */
void study_image_boxed(study_writer *w)
{
    int n = study_draw(w, 12, 50);
    if (!study_write_image(w, n, study_draw(w, 2, 4)))
        return;
    for (int i = study_draw(w, n, 3 * n / 2); i > 0; i--) {
        for (int k = 0; k < 3; k++) {
            int64_t coef = study_random_nonzero(&w->g, -1000, 1000);
            study_write_term(w, study_draw(w, 0, n - 1), coef);
        }
        study_write_end(w, FMB_LE, study_draw(w, 0, 5000));
    }
    for (int k = 0; k < 2 * n; k++) {
        study_write_term(w, k / 2, k % 2 ? 1 : -1);
        study_write_end(w, FMB_LE, 10);
    }
}

void study_image_cone(study_writer *w)
{
    int n = study_draw(w, 6, 10);
    if (!study_write_image(w, n, study_draw(w, 2, 3)))
        return;
    for (int i = study_draw(w, n + 4, n + 7); i > 0; i--) {
        write_all_terms(w, 9);
        study_write_end(w, FMB_LE, 0);
    }
}

void study_image_long(study_writer *w)
{
    int n = study_draw_size(w, 4, 7);
    if (!study_write_image(w, n, study_draw(w, 2, 3) + w->larger / 2))
        return;
    for (int i = study_draw(w, 2 * n, 2 * n + 3); i > 0; i--) {
        write_all_terms(w, 9999999999);
        study_write_end(w, FMB_LE, study_random_between(&w->g, 9999999999, 99999999990));
    }
}

void study_image_octagon(study_writer *w)
{
    int n = study_draw(w, 8, 20);
    if (!study_write_image(w, n, study_draw(w, 2, 4)))
        return;
    for (int i = 0; i < 3 * n; i++) {
        int at = study_draw(w, 0, n - 1);
        study_write_term(w, at, study_random_chance(&w->g, 50) ? 1 : -1);
        int sign = study_random_chance(&w->g, 50) ? 1 : -1;
        study_write_term(w, (at + study_draw(w, 1, n - 1)) % n, sign);
        study_write_end(w, FMB_LE, study_draw(w, 1, 20));
    }
}

void study_image_equal(study_writer *w)
{
    int n = study_draw_size(w, 9, 15);
    if (!study_write_image(w, n, study_draw(w, 2, 4) + w->larger / 2))
        return;
    for (int i = 0; i < n / 3; i++) {
        write_all_terms(w, 4);
        study_write_end(w, FMB_EQ, 0);
    }
    write_dense_rows(w, n + 2, FMB_LE);
}

/* Rows that do not increase along (1, ..., 1). */
void study_image_endless(study_writer *w)
{
    int n = study_draw(w, 5, 8);
    if (!study_write_image(w, n, study_draw(w, 2, 3)))
        return;
    for (int i = study_draw(w, 2 * n - 2, 2 * n + 2); i > 0; i--) {
        int64_t sum = 0;
        for (int j = 0; j + 1 < n; j++) {
            int64_t a = study_random_between(&w->g, -9, 9);
            study_write_term(w, j, a);
            sum += a;
        }
        study_write_term(w, n - 1, -sum - study_draw(w, 0, 3));
        study_write_end(w, FMB_LE, study_draw(w, 5, 60));
    }
}

/* Fewer than twice as many rows as eliminated variables: about as often as not all rows decrease
 * along some direction of these variables (Wendel 1962), and no row is left. */
void study_image_open(study_writer *w)
{
    int keep = study_draw(w, 2, 4), gone = study_draw(w, 6, 30);
    if (study_write_image(w, keep + gone, keep))
        write_dense_rows(w, study_draw(w, gone + 1, 2 * gone - 1), FMB_LE);
}

/* Three rows whose sum is -s <= c, s the sum of the kept variables: with s <= -c an equality. */
static void write_flat_rows(study_writer *w, int64_t c)
{
    int64_t sum[16] = {0};
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < w->variables; j++) {
            int64_t a = study_random_between(&w->g, -5, 5);
            study_write_term(w, j, a);
            sum[j] += a;
        }
        study_write_end(w, FMB_LE, 4);
    }
    for (int j = 0; j < w->variables; j++)
        study_write_term(w, j, -sum[j] - (j < w->keep));
    study_write_end(w, FMB_LE, c - 8);
    for (int j = 0; j < w->keep; j++)
        study_write_term(w, j, 1);
    study_write_end(w, FMB_LE, -c);
}

void study_image_flat(study_writer *w)
{
    int n = study_draw(w, 5, 8);
    if (!study_write_image(w, n, 3))
        return;
    write_flat_rows(w, study_draw(w, 0, 3));
    write_dense_rows(w, 2 * n, FMB_LE);
}

/* c lower in one of the rows. */
void study_image_none(study_writer *w)
{
    int n = study_draw(w, 5, 8);
    if (!study_write_image(w, n, study_draw(w, 2, 3)))
        return;
    write_dense_rows(w, n, FMB_LE);
    write_flat_rows(w, 2);
    for (int j = 0; j < w->keep; j++)
        study_write_term(w, j, 1);
    study_write_end(w, FMB_LE, -study_draw(w, 3, 9));
    write_dense_rows(w, n, FMB_LE);
}

void study_image_cube(study_writer *w)
{
    int n = study_draw(w, 5, 9);
    if (!study_write_image(w, n, study_draw(w, 2, 3)))
        return;
    for (int i = 0; i < n; i++) {
        int64_t a[16];
        for (int j = 0; j <= i; j++)
            a[j] = j == i ? 1 : study_random_between(&w->g, -2, 2);
        for (int side = -1; side <= 1; side += 2) {
            for (int j = 0; j <= i; j++)
                study_write_term(w, j, side * a[j]);
            study_write_end(w, FMB_LE, 1);
        }
    }
}

void study_image_slice(study_writer *w)
{
    int n = study_draw(w, 8, 14);
    if (!study_write_image(w, n, study_draw(w, 3, 4)))
        return;
    for (int j = 0; j < n; j++) {
        study_write_least(w, j, 0);
        study_write_most(w, j, 1);
    }
    for (int i = 0; i < 3; i++) {
        int64_t a[16], half = 0;
        for (int j = 0; j < n; j++)
            half += a[j] = study_random_chance(&w->g, 40) ? study_random_between(&w->g, -3, 3) : 0;
        for (int side = -1; side <= 1; side += 2) {
            for (int j = 0; j < n; j++)
                study_write_term(w, j, 2 * side * a[j]);
            study_write_end(w, FMB_LE, side * half + 1);
        }
    }
}
