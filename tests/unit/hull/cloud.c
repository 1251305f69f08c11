/* cloud.c: see cloud.h. */
#include "cloud.h"

#include <string.h>

/* Rank of rows[size][d], d columns; the determinant where they are square. */
static int eliminate(int64_t row[][MOST_D], int size, int d, int64_t *det)
{
    int rank = 0, sign = 1;
    int64_t last = 1;
    for (int c = 0; c < d && rank < size; c++) {
        int r = rank;
        while (r < size && row[r][c] == 0)
            r++;
        if (r == size)
            continue;
        for (int j = 0; j < d && r != rank; j++) {
            int64_t t = row[r][j];
            row[r][j] = row[rank][j];
            row[rank][j] = t;
        }
        sign = r == rank ? sign : -sign;
        for (int i = rank + 1; i < size; i++) {
            for (int j = c + 1; j < d; j++)
                row[i][j] = (row[i][j] * row[rank][c] - row[i][c] * row[rank][j]) / last;
            row[i][c] = 0;
        }
        last = row[rank++][c];
    }
    *det = rank == d ? sign * last : 0;
    return rank;
}

int cloud_rank(const cloud *c, uint32_t set)
{
    int64_t row[MOST][MOST_D], det;
    int size = 0;
    for (int i = 0; i < c->size; i++)
        if (set >> i & 1)
            memcpy(row[size++], c->v[i], sizeof row[0]);
    return eliminate(row, size, c->d, &det);
}

/* The same cone in as many dimensions as it has: a column that is not missed goes. */
static cloud without_idle_columns(cloud c)
{
    int rank = cloud_rank(&c, (1u << c.size) - 1);
    for (int j = c.d - 1; j >= 0 && c.d > rank; j--) {
        cloud t = c;
        t.d--;
        for (int i = 0; i < c.size; i++)
            for (int k = j; k < t.d; k++)
                t.v[i][k] = c.v[i][k + 1];
        if (cloud_rank(&t, (1u << t.size) - 1) == rank)
            c = t;
    }
    return c;
}

/* normal[d] is 0 on the d - 1 vectors of the set; its entries are minors. */
static void normal_of(const cloud *c, uint32_t set, int64_t *normal)
{
    for (int j = 0; j < c->d; j++) {
        int64_t row[MOST][MOST_D];
        int size = 0;
        for (int i = 0; i < c->size; i++) {
            if (!(set >> i & 1))
                continue;
            for (int k = 0, to = 0; k < c->d; k++)
                if (k != j)
                    row[size][to++] = c->v[i][k];
            size++;
        }
        normal[j] = 1;
        if (c->d > 1)
            eliminate(row, size, c->d - 1, &normal[j]);
        normal[j] = j % 2 ? -normal[j] : normal[j];
    }
}

static int64_t dot(const cloud *c, int i, const int64_t *normal)
{
    int64_t sum = 0;
    for (int k = 0; k < c->d; k++)
        sum += c->v[i][k] * normal[k];
    return sum;
}

size_t cloud_put_set(uint32_t *list, size_t size, uint32_t set)
{
    for (size_t i = 0; i < size; i++)
        if (list[i] == set)
            return size;
    list[size] = set;
    return size + 1;
}

size_t cloud_facets(const cloud *full, uint32_t *out)
{
    cloud c = without_idle_columns(*full);
    size_t size = 0;
    for (uint32_t set = 0; set < 1u << c.size; set++) {
        int64_t normal[MOST_D];
        if (__builtin_popcount(set) != c.d - 1 || cloud_rank(&c, set) != c.d - 1)
            continue;
        normal_of(&c, set, normal);
        uint32_t on = 0;
        int above = 0, below = 0;
        for (int i = 0; i < c.size; i++) {
            int64_t t = dot(&c, i, normal);
            above += t > 0;
            below += t < 0;
            on |= (uint32_t)(t == 0) << i;
        }
        if ((above > 0) != (below > 0))
            size = cloud_put_set(out, size, on);
    }
    return size;
}
