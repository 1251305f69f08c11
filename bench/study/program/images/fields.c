/* fields.c: states of systems in space and time, timing of circuits and loops.
 *
 * Sources: Kurzhanski, Valyi 1997 (states by bounded errors, doi 10.1007/978-1-4612-0277-6);
 * Kinderlehrer, Stampacchia 1980 (obstacles); Gordon, Bender, Herman 1970 (scans, doi
 * 10.1016/0022-5193(70)90109-8); Fishburn 1990 (skews of clocks, doi 10.1109/12.55696); Feautrier
 * 1992 (legal schedules, doi 10.1007/BF01407835).
 */
#include "study/program/writer.h"

/* The last state of a system in steps with disturbances, by measurements with errors. */
void study_image_estimates(study_writer *w)
{
    int dim = study_draw(w, 1, 3), steps = study_draw(w, 2, dim == 1 ? 8 : dim == 2 ? 4 : 2);
    int size = study_random_chance(&w->g, 50) ? 10 : 100000, last = steps;
    bool strict = study_random_chance(&w->g, 30), beginning = study_random_chance(&w->g, 80);
    if (!study_write_image(w, dim * (steps + 1), dim))
        return;
    for (int t = 0; t < steps; t++) { /* state t is steps - t before the last */
        int now = dim * (last - t), next = now - dim;
        for (int i = 0; i < dim; i++) {
            int coef[3] = {0}, noise = study_draw(w, 1, size);
            for (int j = 0; j < dim; j++)
                coef[j] = study_draw(w, -size, size);
            for (int side = -1; side <= 1; side += 2) {
                study_write_term(w, next + i, size);
                for (int j = 0; j < dim; j++)
                    study_write_term(w, now + j, -coef[j]);
                study_write_end(w, side < 0 ? FMB_GE : FMB_LE, side * noise);
            }
        }
        int seen = study_draw(w, 0, dim - 1), about = study_draw(w, -1, 1);
        study_write_term(w, next + seen, 1);
        study_write_end(w, strict ? FMB_GT : FMB_GE, about - 2);
        study_write_most(w, next + seen, about + 2);
    }
    if (beginning)
        study_write_box(w, dim * steps, dim, -3, 3);
}

/* Heights of a membrane on a line or a square, above an obstacle, under bounded loads; those at
 * some places stay. */
void study_image_membrane(study_writer *w)
{
    bool plane = study_random_chance(&w->g, 50);
    int side = plane ? study_draw(w, 2, 4) : study_draw(w, 4, 16), deep = plane ? side : 1;
    int places = side * deep, kept = study_draw(w, 1, plane ? 3 : 2), stride = 2 * (places / 4) + 1;
    if (!study_write_image(w, places, kept))
        return;
    while (places % stride == 0 || (places % 3 == 0 && stride % 3 == 0))
        stride += 2; /* place p is variable p stride mod places */
    int load = study_draw(w, 1, 9), top = study_draw(w, 4, 40);
    for (int p = 0; p < places; p++) {
        int x = p % side, y = p / side, about[4], n = 0;
        if (x > 0)
            about[n++] = p - 1;
        if (x + 1 < side)
            about[n++] = p + 1;
        if (plane && y > 0)
            about[n++] = p - side;
        if (plane && y + 1 < deep)
            about[n++] = p + side;
        for (int sign = -1; sign <= 1; sign += 2) {
            study_write_term(w, p * stride % places, plane ? 4 : 2);
            for (int k = 0; k < n; k++)
                study_write_term(w, about[k] * stride % places, -1);
            study_write_end(w, sign < 0 ? FMB_GE : FMB_LE, sign * load);
        }
        study_write_least(w, p * stride % places, study_random_chance(&w->g, 30) ? 0 : -top);
    }
}

/* A picture of small cells, by its sums along rows, columns and diagonals with errors: a few cells
 * stay. */
void study_image_scans(study_writer *w)
{
    int width = study_draw(w, 2, 4), height = study_draw(w, 2, 4), cells = width * height;
    int kept = study_draw(w, 1, cells - 2 < 5 ? cells - 2 : 5), error = study_draw(w, 0, 5);
    int value[16], digits = study_draw(w, 0, 2);
    int unit = digits == 0 ? 1 : digits == 1 ? 1000 : 10000019;
    if (!study_write_image(w, cells, kept))
        return;
    for (int c = 0; c < cells; c++) {
        value[c] = study_draw(w, 0, 9);
        study_write_least(w, c, 0);
    }
    for (int way = 0; way < 3; way++)
        for (int line = 0; line < (way == 0 ? height : width); line++)
            for (int side = error == 0; side < 2; side++) {
                int64_t sum = 0;
                for (int c = 0; c < cells; c++) {
                    int x = c % width, y = c / width;
                    if (line != (way == 0 ? y : way == 1 ? x : (x + y) % width))
                        continue;
                    study_write_term(w, c, unit - y * (unit > 1));
                    sum += (int64_t)value[c] * (unit - y * (unit > 1));
                }
                study_write_end(w,
                                error == 0 ? FMB_EQ
                                : side     ? FMB_LE
                                           : FMB_GE,
                                error == 0 ? sum
                                : side     ? sum + error * (int64_t)unit
                                           : sum - error * (int64_t)unit);
            }
}

/* The period of a circuit, delays and skews of some registers, between which signals neither come
 * too late nor too early; other skews go. */
void study_image_skews(study_writer *w)
{
    int registers = study_draw(w, 4, 12), delays = study_draw(w, 0, 2), kept = 2 + delays;
    int paths = study_draw(w, registers, 2 * registers), size = study_draw(w, 0, 2);
    bool strict = study_random_chance(&w->g, 50);
    int unit = size == 0 ? 1 : size == 1 ? 100 : 1000000;
    if (!study_write_image(w, 1 + delays + registers, kept))
        return;
    for (int p = 0; p < paths; p++) {
        int from = p % registers, to = (from + study_draw(w, 1, registers - 1)) % registers;
        int least = study_draw(w, 1, 4 * unit), most = least + study_draw(w, 0, 9 * unit);
        int delay = delays > 0 && study_random_chance(&w->g, 40) ? study_draw(w, 1, delays) : 0;
        study_write_term(w, 1 + delays + from, 1); /* late */
        study_write_term(w, 1 + delays + to, -1);
        study_write_term(w, 0, delay ? 0 : -1);
        if (delay) {
            study_write_term(w, 0, -1);
            study_write_term(w, delay, study_draw(w, 1, 3));
        }
        study_write_end(w, strict ? FMB_LT : FMB_LE, -most);
        study_write_term(w, 1 + delays + from, 1); /* early */
        study_write_term(w, 1 + delays + to, -1);
        study_write_term(w, delay, delay ? 1 : 0);
        study_write_end(w, FMB_GE, -least);
    }
    for (int d = 0; d < delays; d++)
        study_write_least(w, 1 + d, 0);
    study_write_most(w, 0, 40 * unit);
    if (study_random_chance(&w->g, 50))
        study_write_box(w, 1 + delays, registers, -9 * unit, 9 * unit);
}

/* Coefficients of a schedule of loops that is later by one at least wherever a result is used, by
 * Farkas' lemma: multipliers go. */
void study_image_legal(study_writer *w)
{
    int loops = study_draw(w, 2, 4), uses = study_draw(w, 1, 3), each = 2 * loops + 2;
    bool bounded = study_random_chance(&w->g, 50);
    if (!study_write_image(w, loops + uses * each, loops))
        return;
    for (int u = 0; u < uses; u++) {
        int first = loops + u * each; /* of 0 <= i, i <= ends, sum of i <= end; then of no row */
        int distance[4], shear = study_draw(w, 0, loops - 1);
        for (int j = 0; j < loops; j++)
            distance[j] = study_draw(w, j == 0, 2);
        for (int j = 0; j < loops; j++) { /* the coefficient of iteration j */
            study_write_term(w, shear, study_draw(w, 0, 2));
            study_write_term(w, j, j == 0 ? 1 : study_draw(w, -1, 1));
            study_write_term(w, first + j, -1);
            study_write_term(w, first + loops + j, 1);
            study_write_term(w, first + 2 * loops, 1);
            study_write_end(w, FMB_EQ, 0);
        }
        for (int j = 0; j < loops; j++)
            study_write_term(w, j, distance[j]);
        for (int j = 0; j <= loops; j++)
            study_write_term(w, first + loops + j, -study_draw(w, 4, 99));
        study_write_term(w, first + 2 * loops + 1, -1);
        study_write_end(w, FMB_EQ, 1);
        for (int m = 0; m < each; m++)
            study_write_least(w, first + m, 0);
    }
    for (int j = 0; j < loops; j++) {
        if (study_random_chance(&w->g, 60))
            study_write_least(w, j, 0);
        if (bounded)
            study_write_most(w, j, study_draw(w, 2, 30));
    }
}
