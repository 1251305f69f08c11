/* functions.c: functions by rows: products, bends, layers, covers.
 *
 * Sources: McCormick 1976 (envelopes of products, doi 10.1007/BF01580665); Beale, Tomlin 1970
 * (functions by their bends).
 */
#include "study/program/writer.h"

/* Sums of products of numbers in boxes, each by its envelope. */
void study_image_products(study_writer *w)
{
    int numbers = study_draw(w, 2, 4), sums = study_draw(w, 1, 2), products = study_draw(w, 2, 5);
    int kept = sums + study_draw(w, 1, numbers), x = sums, z = sums + numbers;
    if (!study_write_image(w, z + products, kept))
        return;
    for (int s = 0; s < sums; s++) {
        study_write_term(w, s, -1);
        for (int p = 0; p < products; p++)
            study_write_term(w, z + p, study_random_nonzero(&w->g, -5, 5));
        study_write_end(w, FMB_EQ, 0);
    }
    for (int p = 0; p < products; p++) {
        int a = study_draw(w, 0, numbers - 2), b = study_draw(w, a + 1, numbers - 1);
        for (int corner = 0; corner < 4; corner++) { /* (a - ea)(b - eb) at the ends 0 and 7 */
            int ea = corner & 1 ? 7 : 0, eb = corner & 2 ? 7 : 0;
            study_write_term(w, z + p, 1);
            study_write_term(w, x + a, -eb);
            study_write_term(w, x + b, -ea);
            study_write_end(w, ea == eb ? FMB_GE : FMB_LE, -ea * eb);
        }
    }
    study_write_box(w, x, numbers, 0, 7);
}

/* Functions of one number each by their bends, with a bound on all values; numbers kept. */
void study_image_bends(study_writer *w)
{
    int functions = study_draw(w, 2, 3), bends = study_draw(w, 3, 6);
    int kept = functions + 1, all = kept + functions * bends;
    if (!study_write_image(w, all, kept))
        return;
    study_write_term(w, functions, -1);
    for (int b = kept; b < all; b++)
        study_write_term(w, b, study_draw(w, -9, 20));
    study_write_end(w, study_random_chance(&w->g, 30) ? FMB_LT : FMB_EQ, 0);
    for (int f = 0; f < functions; f++) {
        int at = 0, first = kept + f * bends;
        study_write_term(w, f, -1);
        for (int b = 0; b < bends; b++)
            study_write_term(w, first + b, at += study_draw(w, 1, 9));
        study_write_end(w, FMB_EQ, 0);
        study_write_sum(w, first, bends, 1);
        study_write_end(w, FMB_EQ, 1);
        for (int b = 0; b < bends; b++)
            study_write_least(w, first + b, 0);
    }
    study_write_sum(w, 0, functions, 1);
    study_write_end(w, FMB_LE, study_draw(w, 8, 40));
}

/* What is at least some functions of what is below it, in layers. */
void study_image_layers(study_writer *w)
{
    int each = study_draw(w, 2, 3), layers = study_draw(w, 2, 3), n = each * (layers + 1);
    if (!study_write_image(w, n, each))
        return;
    for (int l = 0; l < layers; l++)
        for (int y = l * each; y < (l + 1) * each; y++)
            for (int rows = study_draw(w, 2, 3); rows > 0; rows--) {
                study_write_term(w, y, 1);
                for (int x = (l + 1) * each; x < (l + 2) * each; x++)
                    study_write_term(w, x, study_random_between(&w->g, -3, 3));
                study_write_end(w, FMB_GE, study_draw(w, -9, 9));
            }
    study_write_box(w, layers * each, each, -study_draw(w, 2, 9), 9);
    if (study_random_chance(&w->g, 60))
        study_write_box(w, 0, layers * each, -99, study_draw(w, 20, 99));
}

/* Some of each set are needed; the total cost is kept, too. */
void study_image_covers(study_writer *w)
{
    int n = study_draw(w, 5, 9), sets = study_draw(w, 4, 10), kept = study_draw(w, 2, 4);
    if (!study_write_image(w, 1 + n, kept))
        return;
    study_write_term(w, 0, -1);
    for (int x = 1; x <= n; x++)
        study_write_term(w, x, study_draw(w, 1, 9));
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_LE, 0);
    for (int s = 0; s < sets; s++) {
        for (int x = 1; x <= n; x++)
            if (x - 1 == s % n || study_random_chance(&w->g, 35))
                study_write_term(w, x, 1);
        study_write_end(w, FMB_GE, 1);
    }
    study_write_box(w, 1, n, 0, study_draw(w, 1, 3));
}
