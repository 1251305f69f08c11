/* frame_reader_next.c: pairs of frames from text, line by line; see fmb/gmp.h. */
#include "io/frames/frame_reader.h"

#include <errno.h>
#include <string.h>

#include "base/line.h"
#include "base/memory_stream.h"
#include "system/system_private.h"

/* ---- one line -------------------------------------------------------------------------------- */

static fmb_status copy_pair_id_as_json(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    const char *p = c->at;
    FMB_TRY(fmb_json_skip(c));
    size_t n = (size_t)(c->at - p);
    FMB_TRY(FMB_RESERVE(&r->mem, &r->id, &r->id_capacity, n + 1));
    memcpy(r->id, p, n);
    r->id[n] = '\0';
    r->line.id = r->id;
    return FMB_OK;
}

static fmb_status read_first_body(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    r->now = &r->body[0];
    return fmb_frame_reader_body(r, c);
}

static fmb_status read_second_body(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    r->now = &r->body[1];
    return fmb_frame_reader_body(r, c);
}

/* Charge for the common denominator of each world axis, at most as long as all its denominators. */
static fmb_status charge_common_denominators(fmb_frame_reader *r, fmb_cursor *c, const char *p)
{
    size_t each = r->numbers / (size_t)r->dim + 1;
    return fmb_io_charge(c, p, r->digits > SIZE_MAX / each ? SIZE_MAX : r->digits * each);
}

static fmb_status read_pair_object(fmb_frame_reader *r, fmb_cursor *c)
{
    static const fmb_json_key keys[] = {
        {"A", read_first_body}, {"B", read_second_body}, {"id", copy_pair_id_as_json}};
    unsigned seen;
    const char *p = c->at;
    r->dim = 0;
    r->exact = true;
    r->digits = r->numbers = 0;
    r->line.id = NULL;
    FMB_TRY(fmb_json_object(c, "a pair of frames, {...}", keys, 3, r, &seen));
    if ((seen & 3) != 3)
        return fmb_io_fail(c, p, "expected \"A\" and \"B\" in a pair");
    fmb_skip_blanks(c);
    if (fmb_peek(c) >= 0 && fmb_peek(c) != '\n')
        return fmb_io_expected(c, c->at, "end of line");
    return charge_common_denominators(r, c, p);
}

/* ---- the answer ------------------------------------------------------------------------------ */

static void publish_body(fmb_frame_reader *r, int k)
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

/* If all numbers are doubles, rationals are made only on demand. */
static void withhold_rationals(fmb_frame_line *line)
{
    for (int k = 0; k < 2; k++) {
        fmb_frame_q *f = &line->body[k].frame;
        f->origin = f->axes = f->speed = NULL;
    }
}

static void publish_pair(fmb_frame_reader *r)
{
    r->line.dim = r->dim;
    publish_body(r, 0);
    publish_body(r, 1);
    r->line.are_doubles = r->exact && !r->body[0].rows && !r->body[1].rows;
    if (fmb_frame_reader_are_nearest(r))
        withhold_rationals(&r->line);
}

fmb_status fmb_frame_reader_rationals(fmb_frame_reader *r)
{
    FMB_TRY(r ? FMB_OK : FMB_ERR_ARG);
    for (int k = 0; fmb_frame_reader_are_nearest(r) && k < 2; k++) {
        fmb_body_draft *b = &r->body[k];
        FMB_TRY(fmb_numbers_rationals(&b->origin, &r->mem));
        FMB_TRY(fmb_numbers_rationals(&b->axes, &r->mem));
        FMB_TRY(fmb_numbers_rationals(&b->speed, &r->mem));
        publish_body(r, k);
    }
    return FMB_OK;
}

/* ---- lines ----------------------------------------------------------------------------------- */

/* Read the next line, with its end; size 0 at the end of the stream. Of a line that is too long,
 * limit + 1 bytes are kept. */
static fmb_status fetch_line_of_stream(fmb_frame_reader *r)
{
    enum { LEAST = 1024, MOST = 1 << 30 };
    const size_t most = fmb_io_max_bytes(&r->how);
    bool more = true;
    for (r->size = 0; more;) {
        size_t n = r->size < LEAST ? LEAST : r->size < MOST ? r->size : MOST;
        FMB_TRY(fmb_frame_reader_poll(r));
        FMB_TRY(FMB_RESERVE(&r->mem, &r->text, &r->capacity, r->size + n));
        size_t got = fmb_fetch_part_of_line(r->in, r->text + r->size, n);
        r->size += got;
        more = got > 0 && r->text[r->size - 1] != '\n';
        r->size = r->size > most ? most + 1 : r->size;
    }
    r->line.number++;
    return ferror(r->in) ? FMB_ERR_IO : FMB_OK;
}

/* *blank: there is no pair. */
static fmb_status parse_pair_line(fmb_frame_reader *r, bool *blank, fmb_where *where)
{
    fmb_where at = {0};
    fmb_cursor c = fmb_io_cursor(r->text, r->size, &r->how, &r->mem, &at);
    if (r->line.number > 1)
        c.begin = c.at = c.mark = r->text;
    c.line = r->line.number;
    fmb_status st =
        r->size > fmb_io_max_bytes(&r->how) ? fmb_io_fail_too_long(&c, c.begin) : fmb_io_check(&c);
    fmb_skip_space(&c);
    *blank = c.at == c.end;
    if (st == FMB_OK && !*blank)
        st = read_pair_object(r, &c);
    if (st == FMB_ERR_PARSE && where)
        *where = at;
    return st;
}

/* The first byte decides whether the whole stream is binary. */
static void sniff_binary(fmb_frame_reader *r)
{
    int b = getc(r->in);
    r->is_packed = b == 'f';
    r->exact = true;
    r->line.id = NULL;
    if (b != EOF)
        ungetc(b, r->in);
}

/* *found: there is one more pair. */
static fmb_status fetch_pair(fmb_frame_reader *r, bool *found, fmb_where *where)
{
    fmb_status st;
    bool blank = true;
    if (r->is_packed)
        return fmb_frame_reader_fetch_packed(r, found, where);
    do {
        errno = 0;
        st = fetch_line_of_stream(r);
        if (st == FMB_OK && r->size > 0)
            st = parse_pair_line(r, &blank, where);
    } while (st == FMB_OK && blank && r->size > 0);
    *found = !blank;
    return st;
}

fmb_status fmb_frame_reader_next(fmb_frame_reader *r, const fmb_frame_line **out, fmb_where *where)
{
    bool found = false;
    if (!r || !out)
        return fmb_io_refuse_argument(where, r ? "out is NULL" : "the reader of frames is NULL");
    if (r->line.number == 0 && !r->is_packed)
        sniff_binary(r);
    fmb_status st = fetch_pair(r, &found, where);
    if (fmb_frame_reader_poll(r) != FMB_OK) {
        *out = NULL;
        return FMB_OK;
    }
    if (st != FMB_OK)
        return st;
    if (found)
        publish_pair(r);
    *out = found ? &r->line : NULL;
    return FMB_OK;
}

void fmb_frame_reader_cancel(fmb_frame_reader *r)
{
    if (r)
        atomic_store_explicit(&r->cancel, 1, memory_order_relaxed);
}

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_frame_reader_new(FILE *in, const fmb_reader *how, fmb_frame_reader **out)
{
    fmb_mem mem;
    fmb_reader reader;
    if (!in || !out || fmb_io_take_reader(how, &reader, NULL) != FMB_OK)
        return FMB_ERR_ARG;
    fmb_mem_init(&mem, reader.mem, 0);
    fmb_frame_reader *r;
    FMB_TRY(FMB_GET_ZERO(&mem, r, 1));
    r->mem = mem;
    r->in = in;
    atomic_init(&r->cancel, 0);
    r->how = reader;
    r->hook = mem.alloc;
    r->how.mem = &r->hook;
    fmb_draft_init(&r->row, &r->mem);
    *out = r;
    return FMB_OK;
}

fmb_status fmb_frame_reader_from_text(const char *text, size_t size, const fmb_reader *how,
                                      fmb_frame_reader **out)
{
    fmb_frame_reader *r;
    if ((!text && size > 0) || !out)
        return FMB_ERR_ARG;
    FILE *in = fmb_memory_stream(text, size);
    fmb_status st = in ? fmb_frame_reader_new(in, how, &r) : FMB_ERR_MEMORY;
    if (st == FMB_OK) {
        r->owns_in = true;
        *out = r;
    } else if (in) {
        fclose(in);
    }
    return st;
}

static void free_body_draft(fmb_body_draft *b, fmb_mem *mem)
{
    fmb_numbers_clear(&b->origin, mem);
    fmb_numbers_clear(&b->axes, mem);
    fmb_numbers_clear(&b->speed, mem);
    fmb_numbers_clear(&b->coefficients, mem);
    fmb_system_free(b->rows);
}

void fmb_frame_reader_free(fmb_frame_reader *r)
{
    if (!r)
        return;
    free_body_draft(&r->body[0], &r->mem);
    free_body_draft(&r->body[1], &r->mem);
    fmb_draft_clear(&r->row);
    if (r->owns_in)
        fclose(r->in);
    fmb_mem_put(&r->mem, r->text, r->capacity, 1);
    fmb_mem_put(&r->mem, r->id, r->id_capacity, 1);
    fmb_mem mem = r->mem;
    fmb_mem_put(&mem, r, 1, sizeof *r);
}
