/* frame_reader_packed.c: pairs of frames in binary, one after another; see frame_reader.h. */
#include "io/frames/frame_reader.h"

static fmb_status fail_in_pair(fmb_frame_reader *r, fmb_where *where, const char *what)
{
    if (where) {
        *where = (fmb_where){.line = r->line.number + 1, .column = 1};
        snprintf(where->text, sizeof where->text, "expected %s", what);
    }
    r->left = 0;
    r->is_over = true;
    return FMB_ERR_PARSE;
}

/* Read up to n bytes into r->text; memory grows with the bytes read. */
static fmb_status fetch_bytes(fmb_frame_reader *r, size_t n)
{
    enum { PORTION = 1 << 16 };
    size_t got = 1;
    fmb_status st = FMB_OK;
    for (r->size = 0; st == FMB_OK && r->size < n && got > 0; r->size += got) {
        size_t most = n - r->size < PORTION ? n - r->size : PORTION;
        got = 0;
        st = fmb_frame_reader_poll(r);
        FMB_THEN(st, FMB_RESERVE(&r->mem, &r->text, &r->capacity, r->size + most));
        if (st == FMB_OK)
            got = fread(r->text + r->size, 1, most, r->in);
    }
    return st == FMB_OK && ferror(r->in) ? FMB_ERR_IO : st;
}

/* Read the header of the next block that has pairs; none at the end. */
static fmb_status fetch_header(fmb_frame_reader *r, fmb_where *where)
{
    while (r->left == 0 && !r->is_over) {
        FMB_TRY(fetch_bytes(r, FMB_PACKED_HEADER));
        r->is_over = r->size == 0;
        if (r->is_over)
            return FMB_OK;
        const char *fault = r->size < FMB_PACKED_HEADER
                                ? "a header of 32 bytes"
                                : fmb_packed_decode((const unsigned char *)r->text, &r->block);
        if (fault)
            return fail_in_pair(r, where, fault);
        r->left = r->block.pairs;
    }
    return FMB_OK;
}

static bool are_all_finite(const fmb_numbers *a)
{
    bool good = true;
    for (size_t i = 0; i < a->n; i++)
        good &= a->d[i] - a->d[i] == 0;
    return good;
}

static bool are_all_zero(const fmb_numbers *a)
{
    size_t i = 0;
    while (i < a->n && a->d[i] == 0)
        i++;
    return i == a->n;
}

static fmb_status unpack_numbers(fmb_frame_reader *r, fmb_numbers *to, size_t n,
                                 const unsigned char **from)
{
    FMB_TRY(FMB_RESERVE(&r->mem, &to->d, &to->d_capacity, n));
    fmb_packed_read(*from, r->block.size, n, to->d);
    *from += n * r->block.size;
    to->n = n;
    return FMB_OK;
}

static fmb_status unpack_body(fmb_frame_reader *r, int k, const unsigned char **from)
{
    const fmb_packed_block *block = &r->block;
    fmb_body_draft *b = &r->body[k];
    size_t dim = block->dim;
    b->is_polytope = b->is_hull = false;
    fmb_system_free(b->rows);
    b->rows = NULL;
    b->shape = (fmb_shape)block->shape[k];
    b->naxes = (int)block->naxes[k];
    FMB_TRY(unpack_numbers(r, &b->origin, dim, from));
    FMB_TRY(unpack_numbers(r, &b->axes, dim * block->naxes[k], from));
    FMB_TRY(unpack_numbers(r, &b->speed, block->moves[k] ? dim : 0, from));
    if (are_all_zero(&b->speed))
        b->speed.n = 0;
    return FMB_OK;
}

static bool is_body_finite(const fmb_body_draft *b)
{
    return are_all_finite(&b->origin) && are_all_finite(&b->axes) && are_all_finite(&b->speed);
}

fmb_status fmb_frame_reader_fetch_packed(fmb_frame_reader *r, bool *found, fmb_where *where)
{
    *found = false;
    fmb_status st = fetch_header(r, where);
    if (st != FMB_OK || r->left == 0)
        return st;
    size_t n =
        (fmb_packed_numbers(&r->block, 0) + fmb_packed_numbers(&r->block, 1)) * r->block.size;
    if (n > fmb_io_max_bytes(&r->how))
        return fail_in_pair(r, where, "a pair within the limit on what is read");
    st = fetch_bytes(r, n);
    if (st != FMB_OK)
        return st;
    if (r->size < n)
        return fail_in_pair(r, where, "all bytes of a pair");
    const unsigned char *from = (const unsigned char *)r->text;
    for (int k = 0; st == FMB_OK && k < 2; k++)
        st = unpack_body(r, k, &from);
    if (st == FMB_OK && !(is_body_finite(&r->body[0]) && is_body_finite(&r->body[1])))
        return fail_in_pair(r, where, "numbers that are finite");
    r->dim = (int)r->block.dim;
    r->left--;
    r->line.number++;
    *found = st == FMB_OK;
    return st;
}
