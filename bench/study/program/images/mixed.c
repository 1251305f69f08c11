/* mixed.c: projections of systems whose rows are of several kinds. */
#include "study/program/writer.h"

/* Of 100 rows, so many name all variables, others one to four; are strict; equalities; go through
 * the planted point. */
typedef struct mixture {
    int full, strict, equal, tight;
    int64_t most; /* of a coefficient */
} mixture;

/* A row around the point -1, 0, 1, -1, ..., or around 0, beside n variables from the first. */
static void write_mixed_row(study_writer *w, int n, const mixture *m, bool around_zero)
{
    int64_t at = 0;
    int terms = study_random_chance(&w->g, m->full) ? n : study_draw(w, 1, 4);
    for (int t = 0; t < terms; t++) {
        int64_t coef = study_random_nonzero(&w->g, -m->most, m->most);
        int x = terms == n ? t : study_draw(w, 0, n - 1);
        study_write_term(w, x, coef);
        at += coef * (around_zero ? 0 : x % 3 - 1);
    }
    bool equal = study_random_chance(&w->g, m->equal);
    bool tight = equal || study_random_chance(&w->g, m->tight);
    bool strict = !tight && study_random_chance(&w->g, m->strict);
    at += tight ? 0 : study_random_between(&w->g, 1, 9) * m->most;
    study_write_end(w, equal ? FMB_EQ : strict ? FMB_LT : FMB_LE, at);
}

static mixture draw_mixture(study_writer *w)
{
    static const int64_t MOST[] = {1, 3, 9, 99, 9999, 9999999999};
    mixture m;
    m.full = study_draw(w, 0, 3) * 33;
    m.strict = study_random_chance(&w->g, 30) ? 50 : 0;
    m.tight = study_random_chance(&w->g, 30) ? 30 : 0;
    m.equal = 0;
    m.most = MOST[study_draw(w, 0, 5)];
    return m;
}

/* Rows of all kinds, in a box or none. */
void study_image_mixed(study_writer *w)
{
    int n = study_draw(w, 4, 9), rows = study_draw(w, n + 1, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 1, n - 2)))
        return;
    mixture m = draw_mixture(w);
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, false);
    if (study_random_chance(&w->g, 50))
        study_write_box(w, 0, n, -study_draw(w, 2, 9), 9);
}

/* All rows through 0. */
void study_image_fans(study_writer *w)
{
    int n = study_draw(w, 4, 8), rows = study_draw(w, n + 1, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n - 2)))
        return;
    mixture m = draw_mixture(w);
    m.tight = 100;
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, true);
    int signs = study_draw(w, 0, n);
    for (int x = n - signs; x < n; x++)
        study_write_least(w, x, 0);
}

/* A quarter of the rows are equalities. */
void study_image_bound(study_writer *w)
{
    int n = study_draw(w, 6, 14), rows = study_draw(w, n, 2 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n / 2)))
        return;
    mixture m = draw_mixture(w);
    m.equal = 25;
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, false);
    int bounded = study_draw(w, 0, n);
    study_write_box(w, 0, bounded, -9, 9);
}

/* Many rows in few variables. */
void study_image_plenty(study_writer *w)
{
    int n = study_draw(w, 3, 5), rows = study_draw(w, 20, 80);
    if (!study_write_image(w, n, study_draw(w, 1, n - 1)))
        return;
    mixture m = draw_mixture(w);
    m.most = m.most == 1 ? 2 : m.most;
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, false);
}

/* Two to four terms a row, most of the variables are kept. */
void study_image_mostly_kept(study_writer *w)
{
    int n = study_draw(w, 7, 12), rows = study_draw(w, n + 4, 3 * n);
    if (!study_write_image(w, n, n - study_draw(w, 2, 4)))
        return;
    for (int r = 0; r < rows; r++) {
        for (int t = study_draw(w, 2, 4); t > 0; t--) {
            int64_t coef = study_random_nonzero(&w->g, -9, 9);
            study_write_term(w, study_draw(w, 0, n - 1), coef);
        }
        int64_t right = study_draw(w, 1, 40);
        study_write_end(w, study_random_chance(&w->g, 10) ? FMB_LT : FMB_LE, right);
    }
}

/* Rows that follow from given ones, by multipliers: a cone of them, and some strictly. */
void study_image_implied(study_writer *w)
{
    int n = study_draw(w, 2, 5), given = study_draw(w, n + 2, 2 * n + 3);
    if (!study_write_image(w, n + 1 + given, n + 1))
        return;
    for (int j = 0; j < n; j++) {
        study_write_term(w, j, -1);
        for (int g = 0; g < given; g++)
            study_write_term(w, n + 1 + g, study_draw(w, -3, 3));
        study_write_end(w, FMB_EQ, 0);
    }
    study_write_term(w, n, -1);
    for (int g = 0; g < given; g++)
        study_write_term(w, n + 1 + g, study_draw(w, 1, 9));
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_LT : FMB_LE, 0);
    for (int g = 0; g < given; g++)
        study_write_least(w, n + 1 + g, 0);
    if (study_random_chance(&w->g, 50))
        study_write_most(w, n, study_draw(w, 3, 30));
}

/* Blocks of separate variables, connected by the kept ones. */
void study_image_blocks(study_writer *w)
{
    int kept = study_draw(w, 2, 5), blocks = study_draw(w, 2, 4), each = study_draw(w, 2, 3);
    if (!study_write_image(w, kept + blocks * each, kept))
        return;
    for (int b = 0; b < blocks; b++) {
        int first = kept + b * each;
        for (int rows = study_draw(w, each + 1, 3 * each); rows > 0; rows--) {
            for (int x = 0; x < each; x++)
                study_write_term(w, first + x, study_random_between(&w->g, -5, 5));
            for (int x = 0; x < kept; x++)
                if (study_random_chance(&w->g, 40))
                    study_write_term(w, x, study_random_between(&w->g, -5, 5));
            study_write_end(w, FMB_LE, study_draw(w, 1, 30));
        }
        if (study_random_chance(&w->g, 60))
            study_write_box(w, first, each, 0, study_draw(w, 3, 20));
    }
}

/* Rows of neighbours along a line or a ring, some way apart of which some stay. */
void study_image_band(study_writer *w)
{
    int n = study_draw(w, 7, 13), wide = study_draw(w, 2, 4), step = n % 3 ? 3 : n % 2 ? 2 : 5;
    int last = study_random_chance(&w->g, 50) ? n : n - wide + 1;
    if (!study_write_image(w, n, study_draw(w, 2, 4)))
        return;
    for (int i = 0; i < last; i++)
        for (int rows = study_draw(w, 1, 2); rows > 0; rows--) {
            for (int t = 0; t < wide; t++)
                study_write_term(w, (i + t) * step % n, study_random_between(&w->g, -4, 4));
            study_write_end(w, FMB_LE, study_draw(w, 0, 20));
        }
    study_write_box(w, 0, n, -study_draw(w, 5, 20), 20);
}

/* Differences of two are bounded, and some sums of several. */
void study_image_differences(study_writer *w)
{
    int n = study_draw(w, 5, 11), pairs = study_draw(w, n, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n / 2)))
        return;
    for (int p = 0; p < pairs; p++) {
        int x = study_draw(w, 0, n - 1);
        study_write_term(w, x, 1);
        study_write_term(w, (x + study_draw(w, 1, n - 1)) % n, -1);
        study_write_end(w, FMB_LE, study_draw(w, 0, 15));
    }
    for (int s = study_draw(w, 0, 3); s > 0; s--) {
        int first = study_draw(w, 0, n - 3);
        study_write_sum(w, first, study_draw(w, 2, 3), 1);
        study_write_end(w, FMB_LE, study_draw(w, 0, 20));
    }
    study_write_box(w, 0, study_draw(w, 1, n), -20, 20);
}
