/* cloud.h: small vectors, and the facets of the cone that they span by brute force: all hyperplanes
 * through enough of them, by determinants in int64. */
#ifndef FMB_TEST_CLOUD_H
#define FMB_TEST_CLOUD_H

#include <stddef.h>
#include <stdint.h>

enum { MOST_D = 6, MOST = 24 };

typedef struct cloud {
    int d, size;
    int64_t v[MOST][MOST_D];
} cloud;

/* Of the vectors of a set. */
int cloud_rank(const cloud *c, uint32_t set);
/* Append a set to a list, unless it is there; how many there are now. */
size_t cloud_put_set(uint32_t *list, size_t size, uint32_t set);
/* The facets as sets of vectors. */
size_t cloud_facets(const cloud *c, uint32_t *out);

#endif
