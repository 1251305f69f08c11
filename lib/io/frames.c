/* frames.c: pairs of frames from text, line by line; see fmb/gmp.h. */
#include "io/frames.h"

#include <errno.h>
#include <string.h>

#include "system/system.h"

/* ---- one line -------------------------------------------------------------------------------- */

static fmb_status read_id(void *reader, fmb_cursor *c)
{
    fmb_frames *r = reader;
    const char *p = c->at;
    fmb_status st = fmb_json_skip(c);
    size_t n = (size_t)(c->at - p);
    if (st == FMB_OK)
        st = fmb_mem_reserve(&r->mem, (void **)&r->id, &r->id_capacity, n + 1, 1);
    if (st != FMB_OK)
        return st;
    memcpy(r->id, p, n);
    r->id[n] = '\0';
    r->line.id = r->id;
    return FMB_OK;
}

static fmb_status read_a(void *reader, fmb_cursor *c)
{
    fmb_frames *r = reader;
    r->now = &r->body[0];
    return fmb_frames_body(r, c);
}

static fmb_status read_b(void *reader, fmb_cursor *c)
{
    fmb_frames *r = reader;
    r->now = &r->body[1];
    return fmb_frames_body(r, c);
}

/* All numbers of one world axis get a common denominator, as long as all theirs together. */
static fmb_status charge(fmb_frames *r, fmb_cursor *c, const char *p)
{
    size_t each = r->numbers / (size_t)r->dim + 1;
    return fmb_io_charge(c, p, r->digits > SIZE_MAX / each ? SIZE_MAX : r->digits * each);
}

static fmb_status read_pair(fmb_frames *r, fmb_cursor *c)
{
    static const fmb_json_key keys[] = {{"A", read_a}, {"B", read_b}, {"id", read_id}};
    char found[FMB_QUOTE];
    unsigned seen;
    const char *p = c->at;
    r->dim = 0;
    r->exact = true;
    r->digits = r->numbers = 0;
    r->line.id = NULL;
    fmb_status st = fmb_json_object(c, "a pair of frames, {...}", keys, 3, r, &seen);
    if (st == FMB_OK && (seen & 3) != 3)
        st = fmb_io_fail(c, p, "expected \"A\" and \"B\" in a pair");
    if (st != FMB_OK)
        return st;
    fmb_skip_blanks(c);
    if (fmb_peek(c) >= 0 && fmb_peek(c) != '\n')
        return fmb_io_fail(c, c->at, "expected end of line, found %s", fmb_quote(c, c->at, found));
    return charge(r, c, p);
}

/* ---- the answer ------------------------------------------------------------------------------ */

static void give_body(fmb_frames *r, int k)
{
    const fmb_body_draft *b = &r->body[k];
    bool moves = b->speed.n > 0;
    r->line.body[k].rows = b->rows;
    r->line.body[k].frame = (fmb_frame_q){.dim = r->dim};
    r->line.frame[k] = (fmb_frame){.dim = r->dim};
    if (b->rows)
        return;
    r->line.body[k].frame = (fmb_frame_q){b->shape,    r->dim,    b->naxes,
                                          b->origin.q, b->axes.q, moves ? b->speed.q : NULL};
    r->line.frame[k] =
        (fmb_frame){b->shape, r->dim, b->naxes, b->origin.d, b->axes.d, moves ? b->speed.d : NULL};
}

static void give(fmb_frames *r)
{
    r->line.dim = r->dim;
    give_body(r, 0);
    give_body(r, 1);
    r->line.are_doubles = r->exact && !r->body[0].rows && !r->body[1].rows;
}

/* ---- lines ----------------------------------------------------------------------------------- */

/* The next line, with its end; size 0 at the end of the stream. */
static fmb_status get_line(fmb_frames *r)
{
    int b = 0;
    r->size = 0;
    while (b != '\n' && (b = getc_unlocked(r->in)) != EOF) {
        fmb_status st = FMB_OK;
        if (r->size == r->capacity)
            st = fmb_mem_reserve(&r->mem, (void **)&r->text, &r->capacity, r->size + 1, 1);
        if (st != FMB_OK)
            return st;
        r->text[r->size++] = (char)b;
    }
    r->line.number++;
    return ferror(r->in) ? FMB_ERR_IO : FMB_OK;
}

/* *blank: there is no pair. */
static fmb_status read_line(fmb_frames *r, bool *blank, fmb_where *where)
{
    fmb_where at = {0};
    fmb_cursor c = fmb_io_cursor(r->text, r->size, &r->how, &r->mem, &at);
    if (r->line.number > 1)
        c.begin = c.at = c.mark = r->text;
    c.line = r->line.number;
    fmb_status st = fmb_io_check(&c);
    fmb_skip_space(&c);
    *blank = c.at == c.end;
    if (st == FMB_OK && !*blank)
        st = read_pair(r, &c);
    if (st == FMB_ERR_PARSE && where)
        *where = at;
    return st;
}

fmb_status fmb_frames_next(fmb_frames *r, const fmb_frames_line **out, fmb_where *where)
{
    fmb_status st;
    bool blank = true;
    if (!r || !out)
        return FMB_ERR_ARG;
    do {
        errno = 0;
        st = get_line(r);
        if (st == FMB_OK && r->size > 0)
            st = read_line(r, &blank, where);
    } while (st == FMB_OK && blank && r->size > 0);
    if (st != FMB_OK)
        return st;
    if (!blank)
        give(r);
    *out = blank ? NULL : &r->line;
    return FMB_OK;
}

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_frames_open(FILE *in, const fmb_reader *how, fmb_frames **out)
{
    fmb_mem mem;
    if (!in || !out)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, how ? how->mem : NULL, 0);
    fmb_frames *r = fmb_mem_zero(&mem, 1, sizeof *r);
    if (!r)
        return fmb_mem_status(&mem);
    r->mem = mem;
    r->in = in;
    r->how = how ? *how : (fmb_reader){0};
    r->hook = mem.alloc;
    r->how.mem = &r->hook;
    fmb_draft_init(&r->row, &r->mem);
    *out = r;
    return FMB_OK;
}

static void close_body(fmb_body_draft *b, fmb_mem *mem)
{
    fmb_numbers_clear(&b->origin, mem);
    fmb_numbers_clear(&b->axes, mem);
    fmb_numbers_clear(&b->speed, mem);
    fmb_numbers_clear(&b->coefficients, mem);
    fmb_system_free(b->rows);
}

void fmb_frames_close(fmb_frames *r)
{
    if (!r)
        return;
    close_body(&r->body[0], &r->mem);
    close_body(&r->body[1], &r->mem);
    fmb_draft_clear(&r->row);
    fmb_mem_put(&r->mem, r->text, r->capacity, 1);
    fmb_mem_put(&r->mem, r->id, r->id_capacity, 1);
    fmb_mem mem = r->mem;
    fmb_mem_put(&mem, r, 1, sizeof *r);
}
