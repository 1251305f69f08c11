/* parse.c: reading texts in tests; see parse.h. */
#include "parse.h"

#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

fmb_system *parse(fmb_format f, const char *text, size_t size)
{
    fmb_system *s = NULL;
    fmb_where w = {0};
    fmb_status st = fmb_system_parse(
        text, size, &(fmb_reader){.size = sizeof(fmb_reader), .format = f}, &s, &w);
    cr_assert(st == FMB_OK, "%s at %ld:%ld: %s\n%.300s", fmb_status_text(st), w.line, w.column,
              w.text, text);
    return s;
}

static void hear(void *self, const fmb_where *w)
{
    warnings *h = self;
    if (h->n < 4)
        h->at[h->n] = *w;
    h->n++;
}

warnings parse_warnings(fmb_format f, const char *text)
{
    warnings h = {0};
    fmb_system *s = NULL;
    fmb_reader how = {.size = sizeof how, .format = f, .warn = hear, .self = &h};
    cr_assert(fmb_system_parse(text, strlen(text), &how, &s, NULL) == FMB_OK, "%s", text);
    fmb_system_free(s);
    return h;
}

char *write_text(const fmb_system *s, fmb_format f)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    cr_assert(fmb_system_write(s, f, out) == FMB_OK);
    fclose(out);
    return text;
}

void check_meanings(fmb_format f, const meaning *table, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        fmb_system *s = parse(f, table[i].text, strlen(table[i].text));
        char *text = write_text(s, FMB_FORMAT_TEXT);
        cr_expect(strcmp(text, table[i].says) == 0, "%s\nreads as\n%s\nnot\n%s", table[i].text,
                  text, table[i].says);
        free(text);
        fmb_system_free(s);
    }
}

void check_mistakes(fmb_format f, const mistake *table, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const mistake *m = &table[i];
        fmb_system *s = NULL;
        fmb_where w = {0};
        fmb_status st =
            fmb_system_parse(m->text, strlen(m->text),
                             &(fmb_reader){.size = sizeof(fmb_reader), .format = f}, &s, &w);
        cr_expect(st == FMB_ERR_PARSE && !s, "read without complaint: %s", m->text);
        cr_expect(w.line == m->line && w.column == m->column && strstr(w.text, m->piece),
                  "%s\ncomplains at %ld:%ld: %s\nnot at %ld:%ld: %s", m->text, w.line, w.column,
                  w.text, m->line, m->column, m->piece);
        fmb_system_free(s);
    }
}

/* ---- equality -------------------------------------------------------------------------------- */

static bool same_text(const char *a, const char *b)
{
    return a == b || (a && b && strcmp(a, b) == 0);
}

static bool same_row(const fmb_system *a, const fmb_system *b, size_t i)
{
    mpq_t p, q;
    mpq_inits(p, q, NULL);
    fmb_system_rhs_q(a, i, p);
    fmb_system_rhs_q(b, i, q);
    bool same = mpq_equal(p, q) && fmb_system_rel(a, i) == fmb_system_rel(b, i) &&
                fmb_system_terms(a, i) == fmb_system_terms(b, i);
    for (size_t k = 0; same && k < fmb_system_terms(a, i); k++)
        same = fmb_system_term_q(a, i, k, p) == fmb_system_term_q(b, i, k, q) && mpq_equal(p, q);
    mpq_clears(p, q, NULL);
    return same;
}

static bool same_objective(const fmb_system *a, const fmb_system *b)
{
    mpq_t p, q;
    mpq_inits(p, q, NULL);
    fmb_system_objective_constant_q(a, p);
    fmb_system_objective_constant_q(b, q);
    bool same = fmb_system_sense(a) == fmb_system_sense(b) && mpq_equal(p, q) &&
                fmb_system_objective_terms(a) == fmb_system_objective_terms(b);
    for (size_t k = 0; same && k < fmb_system_objective_terms(a); k++)
        same = fmb_system_objective_term_q(a, k, p) == fmb_system_objective_term_q(b, k, q) &&
               mpq_equal(p, q);
    mpq_clears(p, q, NULL);
    return same;
}

bool same_system(const fmb_system *a, const fmb_system *b, bool named)
{
    bool same =
        fmb_system_dim(a) == fmb_system_dim(b) && fmb_system_rows(a) == fmb_system_rows(b) &&
        fmb_system_asks_projection(a) == fmb_system_asks_projection(b) && same_objective(a, b);
    for (int j = 0; same && j < fmb_system_dim(a); j++)
        same = fmb_system_is_kept(a, j) == fmb_system_is_kept(b, j) &&
               (!named || same_text(fmb_system_name(a, j), fmb_system_name(b, j)));
    for (size_t i = 0; same && i < fmb_system_rows(a); i++)
        same = same_row(a, b, i) &&
               (!named || same_text(fmb_system_label(a, i), fmb_system_label(b, i)));
    return same;
}

char *slurp_file(const char *path, size_t *size)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return NULL;
    char *text = NULL;
    FILE *out = open_memstream(&text, size);
    for (int b; (b = fgetc(in)) != EOF;)
        fputc(b, out);
    fclose(out);
    fclose(in);
    return text;
}

/* ---- failing allocations --------------------------------------------------------------------- */

static void *resize(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    countdown *c = self;
    if (new_bytes == 0) {
        free(p);
        c->live -= old_bytes;
        return NULL;
    }
    if (c->left == 0)
        return NULL;
    c->left--;
    void *q = realloc(p, new_bytes);
    if (q)
        c->live += new_bytes - old_bytes;
    return q;
}

fmb_alloc countdown_alloc(countdown *c)
{
    return (fmb_alloc){resize, c};
}

void check_every_failure(fmb_format f, const char *text, size_t size, fmb_status expected)
{
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 0; st == FMB_ERR_MEMORY && k < 100000; k += WATCHED) {
        countdown c = {.left = k};
        fmb_alloc mem = countdown_alloc(&c);
        fmb_system *s = NULL;
        fmb_where w = {0};
        st = fmb_system_parse(text, size,
                              &(fmb_reader){.size = sizeof(fmb_reader), .format = f, .mem = &mem},
                              &s, &w);
        cr_assert((st == FMB_OK) == (s != NULL), "out argument touched at request %zu", k);
        fmb_system_free(s);
        cr_assert(c.live == 0, "%zu bytes lost when request %zu failed: %.80s", c.live, k, text);
    }
    cr_expect(st == expected, "%s: %.80s", fmb_status_text(st), text);
}
