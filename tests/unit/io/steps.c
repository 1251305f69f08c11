/* steps.c: see steps.h. The linker's --wrap redirects the library's calls to this file. */
#include "steps.h"

#include <gmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#pragma GCC diagnostic ignored "-Wmissing-prototypes"

static bool counting;
static uint64_t steps;

static void count(size_t n)
{
    steps += counting ? n : 0;
}

void __sanitizer_cov_trace_pc(void)
{
    steps += counting;
}

/* ---- the C library: bytes that it looks at --------------------------------------------------- */

void *__real_memcpy(void *to, const void *from, size_t n);
void *__real_memmove(void *to, const void *from, size_t n);
void *__real_memset(void *to, int c, size_t n);
int __real_memcmp(const void *a, const void *b, size_t n);
void *__real_memchr(const void *s, int c, size_t n);
void *__real_memmem(const void *s, size_t n, const void *piece, size_t m);
size_t __real_strlen(const char *s);
int __real_strcmp(const char *a, const char *b);
char *__real_strchr(const char *s, int c);

void *__wrap_memcpy(void *to, const void *from, size_t n)
{
    count(n);
    return __real_memcpy(to, from, n);
}

void *__wrap_memmove(void *to, const void *from, size_t n)
{
    count(n);
    return __real_memmove(to, from, n);
}

void *__wrap_memset(void *to, int c, size_t n)
{
    count(n);
    return __real_memset(to, c, n);
}

int __wrap_memcmp(const void *a, const void *b, size_t n)
{
    const char *p = a, *q = b;
    for (size_t i = 0; counting && i < n && (i == 0 || p[i - 1] == q[i - 1]); i++)
        steps++;
    return __real_memcmp(a, b, n);
}

void *__wrap_memchr(const void *s, int c, size_t n)
{
    void *at = __real_memchr(s, c, n);
    count(at ? (size_t)((char *)at - (const char *)s) : n);
    return at;
}

void *__wrap_memmem(const void *s, size_t n, const void *piece, size_t m)
{
    void *at = __real_memmem(s, n, piece, m);
    count(at ? (size_t)((char *)at - (const char *)s) + m : n);
    return at;
}

size_t __wrap_strlen(const char *s)
{
    size_t n = __real_strlen(s);
    count(n);
    return n;
}

int __wrap_strcmp(const char *a, const char *b)
{
    for (size_t i = 0; counting && (i == 0 || (a[i - 1] != 0 && a[i - 1] == b[i - 1])); i++)
        steps++;
    return __real_strcmp(a, b);
}

char *__wrap_strchr(const char *s, int c)
{
    char *at = __real_strchr(s, c);
    count(at ? (size_t)(at - s) : __real_strlen(s));
    return at;
}

/* ---- GMP: bytes that it asks for ------------------------------------------------------------- */

static void *gmp_get(size_t n)
{
    count(n);
    return malloc(n);
}

static void *gmp_resize(void *p, size_t old_bytes, size_t new_bytes)
{
    (void)old_bytes;
    count(new_bytes);
    return realloc(p, new_bytes);
}

static void gmp_put(void *p, size_t n)
{
    (void)n;
    free(p);
}

/* ---------------------------------------------------------------------------------------------- */

void steps_start(void)
{
    mp_set_memory_functions(gmp_get, gmp_resize, gmp_put);
    steps = 0;
    counting = true;
}

uint64_t steps_stop(void)
{
    counting = false;
    return steps;
}
