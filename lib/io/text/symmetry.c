/* symmetry.c: permutations of variables from text; see fmb/symmetry.h.
 *
 *   x y z <> y z x; u <> v      takes x to y, y to z, z to x; and another one, u to v and v to u
 *   #>> AaBb<>BbAa              letters of names, as in files of pystif: H(A,b) goes to H(B,a)
 *
 * A chain becomes a cycle, and other variables are fixed. On lines #>> the order of a name's
 * letters (of those in parentheses, if any) does not matter. With a line #>>, others are ignored.
 */
#include <fmb/symmetry.h>

#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "io/core/stream.h"
#include "io/text/text.h"
#include "symmetry/group.h"
#include "symmetry/row_images.h"

/* A variable by its name with sorted letters, which is unique. */
typedef struct sorted_name {
    char *key;
    int index;
} sorted_name;

typedef struct permutation_reader {
    fmb_text *t;
    const fmb_system *s;
    bool *kept, *met; /* [dim], [most] */
    int *image;       /* [most] of the rule at hand: letters first, then variables */
    int *list;        /* [dim] variables on the left */
    size_t most;
    fmb_row_images rows;
    sorted_name *name; /* [dim] in order, or NULL: no line #>> so far */
    fmb_permutations *out;
} permutation_reader;

enum { LETTERS = 128 };

/* ---- the rule as a permutation --------------------------------------------------------------- */

/* Add the permutation image[dim] of the rule at p, if it is a symmetry. */
static fmb_status add_symmetry(permutation_reader *r, const char *p)
{
    fmb_cursor *c = r->t->c;
    size_t without = SIZE_MAX;
    char name[FMB_QUOTE], other[FMB_QUOTE];
    for (int j = 0; j < fmb_system_dim(r->s); j++)
        if (r->kept[j] != r->kept[r->image[j]])
            return fmb_io_fail(c, p, "expected a symmetry, but %s is %s, and %s is not",
                               fmb_quote_name(fmb_system_name(r->s, j), name),
                               r->kept[j] ? "kept" : "eliminated",
                               fmb_quote_name(fmb_system_name(r->s, r->image[j]), other));
    FMB_TRY(fmb_row_images_check(&r->rows, r->image, &without));
    if (without != SIZE_MAX)
        return fmb_io_fail(c, p, "expected a symmetry, but row %zu would become none of the rows",
                           without + 1);
    return fmb_permutations_add(r->out, r->image);
}

static void forget_rule(permutation_reader *r, size_t n)
{
    for (size_t j = 0; j < n; j++)
        r->image[j] = -1;
}

static fmb_status fail_at_sign(fmb_cursor *c)
{
    return fmb_io_expected(c, c->at, "names, '<>' and as many names");
}

/* ---- names of variables ---------------------------------------------------------------------- */

/* Is there a name at c, after blanks and commas? */
static bool is_at_next_name(fmb_cursor *c)
{
    while (fmb_skip_blanks(c), fmb_peek(c) == ',')
        c->at++;
    return fmb_text_is_at_name(c);
}

/* Read the name at c; each may occur once on its side. */
static fmb_status read_variable(permutation_reader *r, int *index)
{
    char found[FMB_QUOTE];
    const char *p = r->t->c->at;
    fmb_span name;
    FMB_TRY(fmb_text_scan_name(r->t, &name));
    FMB_TRY(fmb_text_variable(r->t, p, name, index));
    if (r->met[*index])
        return fmb_io_fail(r->t->c, p, "expected each name once on a side, found %s again",
                           fmb_quote(r->t->c, p, found));
    r->met[*index] = true;
    return FMB_OK;
}

static fmb_status read_variables(permutation_reader *r, int *list, size_t *n)
{
    memset(r->met, 0, r->most * sizeof *r->met);
    for (*n = 0; is_at_next_name(r->t->c);)
        FMB_TRY(read_variable(r, &list[(*n)++]));
    return FMB_OK;
}

/* Read the variables on the right, the images of those on the left. */
static fmb_status read_images_of_list(permutation_reader *r, size_t n)
{
    memset(r->met, 0, r->most * sizeof *r->met);
    for (size_t k = 0; k < n; k++)
        FMB_TRY(is_at_next_name(r->t->c) ? read_variable(r, &r->image[r->list[k]])
                                         : fail_at_sign(r->t->c));
    return is_at_next_name(r->t->c) ? fail_at_sign(r->t->c) : FMB_OK;
}

static fmb_status read_rule_of_variables(permutation_reader *r)
{
    size_t n;
    const char *start = r->t->c->at;
    forget_rule(r, r->most);
    FMB_TRY(read_variables(r, r->list, &n));
    if (n == 0 || !fmb_accept(r->t->c, "<>"))
        return fail_at_sign(r->t->c);
    FMB_TRY(read_images_of_list(r, n));
    (void)fmb_permutation_complete(r->image, fmb_system_dim(r->s), r->met);
    return add_symmetry(r, start);
}

/* ---- letters of names ------------------------------------------------------------------------ */

static int compare_letters(const void *a, const void *b)
{
    return *(const unsigned char *)a - *(const unsigned char *)b;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const sorted_name *)a)->key, ((const sorted_name *)b)->key);
}

/* Set key[] to the name with its letters replaced (by letter[LETTERS], or NULL) and sorted. */
static void sort_letters(const char *name, const int *letter, char *key)
{
    const char *open = strchr(name, '(');
    size_t first = open ? (size_t)(open - name) : 0, n = strlen(name);
    memcpy(key, name, n + 1);
    for (size_t k = first; letter && k < n; k++)
        if ((unsigned char)key[k] < LETTERS)
            key[k] = (char)letter[(unsigned char)key[k]];
    qsort(key + first, n - first, 1, compare_letters);
}

/* Sort all names; two with the same letters are an error. */
static fmb_status open_sorted_names(permutation_reader *r, const char *p)
{
    fmb_cursor *c = r->t->c;
    size_t dim = (size_t)fmb_system_dim(r->s);
    char name[FMB_QUOTE], other[FMB_QUOTE];
    if (r->name)
        return FMB_OK;
    r->name = fmb_mem_zero(c->mem, dim, sizeof *r->name);
    for (size_t j = 0; r->name && j < dim; j++) {
        const char *from = fmb_system_name(r->s, (int)j);
        r->name[j] = (sorted_name){fmb_mem_text(c->mem, from), (int)j};
        if (!r->name[j].key)
            return fmb_mem_status(c->mem);
        sort_letters(from, NULL, r->name[j].key);
    }
    if (!r->name)
        return fmb_mem_status(c->mem);
    if (dim > 1)
        qsort(r->name, dim, sizeof *r->name, compare_names);
    for (size_t j = 1; j < dim; j++)
        if (compare_names(&r->name[j - 1], &r->name[j]) == 0)
            return fmb_io_fail(c, p, "expected names of different letters, found %s and %s",
                               fmb_quote_name(fmb_system_name(r->s, r->name[j - 1].index), name),
                               fmb_quote_name(fmb_system_name(r->s, r->name[j].index), other));
    return FMB_OK;
}

static void close_sorted_names(permutation_reader *r)
{
    for (int j = 0; r->name && j < fmb_system_dim(r->s); j++)
        fmb_mem_put_text(r->t->c->mem, r->name[j].key);
    fmb_mem_put(r->t->c->mem, r->name, (size_t)fmb_system_dim(r->s), sizeof *r->name);
}

static bool is_letter(int b)
{
    return (b >= 'A' && b <= 'Z') || (b >= 'a' && b <= 'z') || (b >= '0' && b <= '9');
}

/* Read letters, each at most once. */
static fmb_status scan_letters(permutation_reader *r, fmb_span *out)
{
    fmb_cursor *c = r->t->c;
    fmb_skip_blanks(c);
    *out = (fmb_span){c->at, 0};
    memset(r->met, 0, LETTERS * sizeof *r->met);
    for (; is_letter(fmb_peek(c)); c->at++, out->n++) {
        if (r->met[fmb_peek(c)])
            return fmb_io_fail(c, c->at, "expected each letter once on a side");
        r->met[fmb_peek(c)] = true;
    }
    return out->n > 0 ? FMB_OK : fmb_io_expected(c, c->at, "letters, '<>' and as many letters");
}

/* image[dim] of the letters[]; on the way a key that is not longer than the longest name. */
static fmb_status take_letters_to_variables(permutation_reader *r, const int *letter, const char *p)
{
    fmb_cursor *c = r->t->c;
    size_t dim = (size_t)fmb_system_dim(r->s);
    fmb_status st = FMB_OK;
    char quoted[FMB_QUOTE];
    for (size_t j = 0; st == FMB_OK && j < dim; j++) {
        const char *name = fmb_system_name(r->s, (int)j);
        sorted_name moved = {fmb_mem_text(c->mem, name), 0};
        if (!moved.key)
            return fmb_mem_status(c->mem);
        sort_letters(name, letter, moved.key);
        const sorted_name *to = bsearch(&moved, r->name, dim, sizeof *r->name, compare_names);
        if (to)
            r->image[j] = to->index;
        else
            st = fmb_io_fail(c, p, "expected a variable that %s goes to, found none",
                             fmb_quote_name(name, quoted));
        fmb_mem_put_text(c->mem, moved.key);
    }
    return st;
}

static fmb_status read_rule_of_letters(permutation_reader *r)
{
    fmb_cursor *c = r->t->c;
    fmb_span left, right;
    int letter[LETTERS];
    fmb_skip_blanks(c);
    const char *start = c->at;
    fmb_status st = open_sorted_names(r, start);
    FMB_THEN(st, scan_letters(r, &left));
    fmb_skip_blanks(c);
    if (st == FMB_OK && !fmb_accept(c, "<>"))
        st = fail_at_sign(c);
    FMB_THEN(st, scan_letters(r, &right));
    if (st == FMB_OK && left.n != right.n)
        st = fmb_io_fail(c, right.p, "expected %zu letters, as on the left, found %zu", left.n,
                         right.n);
    if (st != FMB_OK)
        return st;
    for (int b = 0; b < LETTERS; b++)
        letter[b] = -1;
    for (size_t k = 0; k < left.n; k++)
        letter[(unsigned char)left.p[k]] = (unsigned char)right.p[k];
    (void)fmb_permutation_complete(letter, LETTERS, r->met);
    st = take_letters_to_variables(r, letter, start);
    return st == FMB_OK ? add_symmetry(r, start) : st;
}

/* ---- lines ----------------------------------------------------------------------------------- */

/* Rules with ';' between them, to the end of the line. */
static fmb_status read_rules(permutation_reader *r, fmb_status rule(permutation_reader *))
{
    fmb_cursor *c = r->t->c;
    fmb_status st;
    do {
        st = rule(r);
        fmb_skip_blanks(c);
    } while (st == FMB_OK && fmb_accept(c, ";"));
    if (st == FMB_OK && fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && fmb_peek(c) != '#')
        st = fmb_io_expected(c, c->at, "';' or the end of the line");
    return st;
}

static bool has_lines_of_letters(fmb_cursor c)
{
    for (; c.at < c.end; fmb_next_line(&c)) {
        fmb_skip_blanks(&c);
        if (fmb_accept(&c, "#>>"))
            return true;
    }
    return false;
}

static fmb_status read_lines(permutation_reader *r)
{
    fmb_cursor *c = r->t->c;
    fmb_status st = fmb_io_check(c);
    bool letters = st == FMB_OK && has_lines_of_letters(*c);
    for (; st == FMB_OK && c->at < c->end; fmb_next_line(c)) {
        fmb_skip_blanks(c);
        if (letters)
            st = fmb_accept(c, "#>>") ? read_rules(r, read_rule_of_letters) : FMB_OK;
        else if (fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && fmb_peek(c) != '#')
            st = read_rules(r, read_rule_of_variables);
    }
    if (st == FMB_OK && fmb_permutations_size(r->out) == 0)
        st = fmb_io_fail(c, NULL, "expected lines NAMES <> NAMES, found none");
    return st;
}

static fmb_status open_reader(permutation_reader *r, const int *keep, int n)
{
    fmb_mem *mem = r->t->c->mem;
    size_t dim = (size_t)fmb_system_dim(r->s);
    r->most = dim > LETTERS ? dim : LETTERS;
    fmb_status st = fmb_row_images_init(&r->rows, r->s, mem);
    FMB_THEN(st,
             FMB_ARRAYS(mem, true, FMB_ARRAY_ZERO(r->kept, dim), FMB_ARRAY_ZERO(r->met, r->most),
                        FMB_ARRAY(r->image, r->most), FMB_ARRAY(r->list, dim + 1)));
    FMB_TRY(st);
    for (int j = 0; j < n; j++)
        r->kept[keep[j]] = true;
    return fmb_permutations_new((int)dim, r->t->c->how->mem, &r->out);
}

static void close_reader(permutation_reader *r)
{
    fmb_mem *mem = r->t->c->mem;
    size_t dim = (size_t)fmb_system_dim(r->s);
    close_sorted_names(r);
    fmb_row_images_clear(&r->rows);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(r->list, dim + 1), FMB_ARRAY(r->image, r->most),
                   FMB_ARRAY(r->met, r->most), FMB_ARRAY(r->kept, dim));
    fmb_mem_put(mem, r->t->name.p, r->t->name.capacity, 1);
}

/* fmb_text_variable finds names of a system that is not written to, as names are declared. */
typedef struct symmetry_text {
    const fmb_system *s;
    const int *keep;
    int n;
    fmb_permutations **out;
} symmetry_text;

static fmb_status parse_symmetries(fmb_cursor *c, void *self)
{
    const symmetry_text *x = self;
    fmb_system *names = NULL;
    FMB_TRY(fmb_system_copy_to(x->s, c->how->mem, &names));
    fmb_text t = {.c = c, .s = names, .declared = true, .alone = true};
    permutation_reader r = {.t = &t, .s = names};
    fmb_status st = open_reader(&r, x->keep, x->n);
    FMB_THEN(st, read_lines(&r));
    close_reader(&r);
    fmb_system_free(names);
    if (st == FMB_OK)
        *x->out = r.out;
    else
        fmb_permutations_free(r.out);
    return st;
}

/* ---- entry points ---------------------------------------------------------------------------- */

static const char *bad_argument(const fmb_system *s, const int *keep, int n, fmb_permutations **out)
{
    if (!s || !out)
        return s ? "out is NULL" : "s is NULL";
    if (n < 0 || (!keep && n > 0))
        return keep ? "n is negative" : "keep is NULL";
    for (int j = 0; j < n; j++)
        if (keep[j] < 0 || keep[j] >= fmb_system_dim(s))
            return "keep names no variable of s";
    return NULL;
}

fmb_status fmb_permutations_parse(const char *text, size_t size, const fmb_reader *how,
                                  const fmb_system *s, const int *keep, int n,
                                  fmb_permutations **out, fmb_where *where)
{
    const char *bad = bad_argument(s, keep, n, out);
    symmetry_text x = {s, keep, n, out};
    return bad ? fmb_io_refuse_argument(where, bad)
               : fmb_parse_memory(text, size, how, parse_symmetries, &x, where);
}

fmb_status fmb_permutations_read(FILE *in, const fmb_reader *how, const fmb_system *s,
                                 const int *keep, int n, fmb_permutations **out, fmb_where *where)
{
    const char *bad = bad_argument(s, keep, n, out);
    symmetry_text x = {s, keep, n, out};
    return bad ? fmb_io_refuse_argument(where, bad)
               : fmb_parse_stream(in, how, parse_symmetries, &x, where);
}
