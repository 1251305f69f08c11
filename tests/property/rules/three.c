/* three.c: see three.h.
 *
 * A row is a code 0..161 = (((a1 + 1) * 3 + (a2 + 1)) * 3 + (a3 + 1)) * 6 + (b + 1) * 2 + strict.
 * Of the images of a list of rows under the 48 symmetries, each written non-decreasing, the one
 * that comes first stands for all. Its first row is then the least of all images of all its rows,
 * so that only few first rows are worth a look, and few others behind them.
 */
#include <stdlib.h>

#include "rows.h"
#include "three.h"

enum { CODES = 162, SYMMETRIES = 48 };

typedef struct tables {
    uint8_t image[SYMMETRIES][CODES];
    uint8_t least[CODES]; /* of all images */
} tables;

static void coefficients(int code, int a[3])
{
    code /= 6;
    for (int j = 2; j >= 0; j--) {
        a[j] = code % 3 - 1;
        code /= 3;
    }
}

/* Symmetry s: signs are changed as its low three bits say, then variables take other places. */
static int image_of(int code, int s)
{
    static const int place[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    int a[3], b[3];
    coefficients(code, a);
    for (int j = 0; j < 3; j++)
        b[place[s / 8][j]] = s >> j & 1 ? -a[j] : a[j];
    return (((b[0] + 1) * 3 + (b[1] + 1)) * 3 + (b[2] + 1)) * 6 + code % 6;
}

static void fill(tables *t)
{
    for (int code = 0; code < CODES; code++) {
        t->least[code] = (uint8_t)code;
        for (int s = 0; s < SYMMETRIES; s++) {
            t->image[s][code] = (uint8_t)image_of(code, s);
            if (t->image[s][code] < t->least[code])
                t->least[code] = t->image[s][code];
        }
    }
}

static void order(uint8_t *a, uint8_t *b)
{
    if (*a > *b) {
        uint8_t keep = *a;
        *a = *b;
        *b = keep;
    }
}

/* Does no image come before the list? */
static bool is_first(const tables *t, three list)
{
    for (int s = 1; s < SYMMETRIES; s++) {
        uint8_t r[4];
        int k = 0;
        for (int i = 0; i < 4; i++)
            r[i] = t->image[s][list.row[i]];
        order(&r[0], &r[1]);
        order(&r[2], &r[3]);
        order(&r[0], &r[2]);
        order(&r[1], &r[3]);
        order(&r[1], &r[2]);
        while (k < 4 && r[k] == list.row[k])
            k++;
        if (k < 4 && r[k] < list.row[k])
            return false;
    }
    return true;
}

/* The next row not before `from` that may stand behind the first one. */
static int next_row(const tables *t, int first, int from)
{
    while (from < CODES && t->least[from] < first)
        from++;
    return from;
}

typedef struct list {
    three *all;
    size_t count, capacity;
} list;

static void append(list *l, three t)
{
    if (l->count == l->capacity) {
        l->capacity = 2 * l->capacity + 1024;
        l->all = realloc(l->all, l->capacity * sizeof *l->all);
        if (!l->all)
            abort();
    }
    l->all[l->count++] = t;
}

three *three_all(size_t *count)
{
    tables t;
    list l = {0};
    fill(&t);
    for (int a = 0; a < CODES; a++) {
        if (t.least[a] != a)
            continue;
        for (int b = next_row(&t, a, a); b < CODES; b = next_row(&t, a, b + 1))
            for (int c = next_row(&t, a, b); c < CODES; c = next_row(&t, a, c + 1))
                for (int d = next_row(&t, a, c); d < CODES; d = next_row(&t, a, d + 1)) {
                    three x = {{(uint8_t)a, (uint8_t)b, (uint8_t)c, (uint8_t)d}};
                    if (is_first(&t, x))
                        append(&l, x);
                }
    }
    *count = l.count;
    return l.all;
}

fmb_system *three_system(three t)
{
    fmb_system *s = rows_none(3);
    for (int i = 0; i < 4; i++) {
        int a[3], rest = t.row[i] % 6;
        coefficients(t.row[i], a);
        must(fmb_system_add_int(s, (int64_t[]){a[0], a[1], a[2]}, rest % 2 ? FMB_LT : FMB_LE,
                                rest / 2 - 1));
    }
    return s;
}
