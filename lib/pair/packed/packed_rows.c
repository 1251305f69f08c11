/* packed_rows.c: one frame against many, and all against all.
 *
 * The frames of the second set are processed kind by kind, in chunks that stay in the first cache
 * as tiles of lanes while all frames of a band of the first set are tested against them. If a frame
 * does not meet the common box of eight frames, it is apart from them: no kernel runs, and no tile
 * is made. In four and more dimensions, where kernels take ten times as long as that, it is also
 * compared with the boxes of single frames. The results of a band are kept in bits, so that answers
 * come in the order of numbers.
 */
#include <stdio.h>
#include <string.h>

#include "pair/packed/bounds.h"
#include "pair/packed/packed.h"

enum {
    CHUNK = 256, /* most frames of the second set at a time */
    EIGHTS = CHUNK / 8,
    BAND = 64 /* frames of the first set at a time */
};

/* ---- chunks ---------------------------------------------------------------------------------- */

/* Frames order[from ... from + n - 1] of a set, of one kind, some of them as tiles. */
typedef struct chunk {
    const fmb_frames *set;
    size_t from, n;
    int kind;
    uint64_t tiled;         /* eights */
    unsigned vain;          /* consecutive rows whose box excluded nothing */
    unsigned asked, spared; /* eights that were compared by the boxes of single frames */
    _Alignas(64) double tiles[CHUNK * 2 * FMB_RECORD_LINE];
} chunk;

/* Frames of a chunk, in whole eights: 32 kB. */
static size_t most_of_chunk(const fmb_frames *s)
{
    const size_t fit = CHUNK * 2 * FMB_RECORD_LINE / (s->stride > 0 ? s->stride : 1) / 8 * 8;
    return fit < CHUNK ? fit : CHUNK;
}

/* Set the chunk that begins at `from`, without tiles; returns its end. */
static size_t begin_chunk(const fmb_frames *s, size_t from, chunk *out)
{
    int kind = s->kind[s->order[from]];
    size_t end = s->first[kind + 1];
    end = end - from < most_of_chunk(s) ? end : from + most_of_chunk(s);
    out->set = s;
    out->from = from;
    out->n = end - from;
    out->kind = kind;
    out->tiled = 0;
    out->vain = out->asked = out->spared = 0;
    return end;
}

/* Remove the lowest run of eights from *left; returns its first one, *count their number. */
static size_t take_run_of_eights(uint64_t *left, size_t *count)
{
    size_t g = (size_t)__builtin_ctzll(*left);
    *count = (size_t)__builtin_ctzll(~(*left >> g));
    *left &= *left + (UINT64_C(1) << g);
    return g;
}

static void tile_eights(const fmb_pair *k, chunk *c, uint64_t wanted)
{
    const fmb_frames *s = c->set;
    c->tiled |= wanted;
    while (wanted) {
        size_t count, g = take_run_of_eights(&wanted, &count);
        size_t n = c->n - 8 * g < 8 * count ? c->n - 8 * g : 8 * count;
        const uint32_t *index = s->order + c->from + 8 * g;
        double *to = c->tiles + 8 * g * s->stride;
        if (k->dim > 3)
            k->wide->minors->tiles(k->dim, s->record, index, n, to);
        else
            k->wide->packed->tiles(k->dim, s->record, index, n, to);
    }
}

/* After so many rows whose box excluded nothing, boxes are no longer tested for a chunk: if frames
 * are in no spatial order, all boxes of eight meet. */
enum { MOST_VAIN = 4 };

/* Eights of a chunk whose common boxes this one meets. */
static uint64_t find_open_eights(chunk *c, const fmb_bounds *box)
{
    const size_t eights = (c->n + 7) / 8;
    const uint64_t all = UINT64_MAX >> (64 - eights);
    uint64_t open = all;
    if (c->vain < MOST_VAIN) {
        open = fmb_bounds_open_eights(c->set, c->from, eights, box);
        c->vain = open == all ? c->vain + 1 : 0;
    }
    return open;
}

/* To compare takes a tenth of what a kernel takes at least, so it has to spare one in ten. */
static bool is_worth_comparing(const chunk *c)
{
    enum { TRIAL = 16, SHARE = 10 };
    return c->asked < TRIAL || SHARE * c->spared >= c->asked;
}

/* The open eights with a frame that is not beyond the box. */
static uint64_t compare_single_frames(chunk *c, const fmb_bounds *box, uint64_t open)
{
    for (uint64_t left = open; left && is_worth_comparing(c); left &= left - 1) {
        const size_t g = (size_t)__builtin_ctzll(left);
        const bool beyond = fmb_bounds_are_beyond(c->set, c->from + 8 * g, box);
        c->asked++;
        c->spared += beyond;
        open &= ~((uint64_t)beyond << g);
    }
    return open;
}

/* Eights of a chunk that a frame with this box may meet, all of them as tiles. */
static uint64_t open_eights(const fmb_pair *k, const fmb_bounds *box, chunk *c)
{
    uint64_t open = find_open_eights(c, box);
    if (k->dim > 3)
        open = compare_single_frames(c, box, open);
    tile_eights(k, c, open & ~c->tiled);
    return open;
}

/* The box of frame i, if that has a record. */
static fmb_bounds bounds_of(const fmb_frames *a, size_t i)
{
    fmb_bounds out = {{0}, {0}};
    if (a->kind[i] != FMB_KIND_NONE)
        fmb_bounds_of_frame(a, i, &out);
    return out;
}

/* Test open eights of a chunk: in the plane and in space by runs of them. */
static void ask_eights(const fmb_pair *k, fmb_packed_row row, fmb_minors_what what, const chunk *c,
                       fmb_packed_bits out[EIGHTS])
{
    if (k->dim > 3) {
        k->wide->minors->row(k->dim, what, &row, k->room, out);
        return;
    }
    for (uint64_t left = row.open; left;) {
        size_t count, g = take_run_of_eights(&left, &count);
        row.tiles = c->tiles + 8 * g * c->set->stride;
        row.index = c->set->order + c->from + 8 * g;
        row.n = c->n - 8 * g < 8 * count ? c->n - 8 * g : 8 * count;
        k->wide->packed->row[k->dim - 2](&row, out + g);
    }
}

/* Test frame i of a, with this box, against the frames of a chunk whose boxes it may meet. After a
 * cancel all are undecided. */
static void ask_chunk(const fmb_pair *k, const fmb_frames *a, size_t i, const fmb_bounds *box,
                      chunk *c, fmb_packed_bits out[EIGHTS])
{
    fmb_packed_plan plan;
    bool known = !fmb_pair_is_cancelled(k) && fmb_packed_plan_of(k, a->kind[i], c->kind, &plan);
    for (size_t g = 0; g < EIGHTS; g++)
        out[g] = (fmb_packed_bits){.apart = known ? 0xff : 0, .meet = 0};
    if (!known)
        return;
    const fmb_packed_row row = {.one = fmb_frames_record(a, i),
                                .tiles = c->tiles,
                                .record = c->set->record,
                                .index = c->set->order + c->from,
                                .n = c->n,
                                .open = open_eights(k, box, c),
                                .moves = plan.moves,
                                .closed = k->options.contact == FMB_CONTACT_CLOSED,
                                .swapped = plan.swapped,
                                .shapes = plan.shapes,
                                .kind = &plan.flat};
    if (row.open)
        ask_eights(k, row, plan.what, c, out);
}

/* ---- one against many ------------------------------------------------------------------------ */

/* Write the verdicts of the frames of a chunk; is one UNKNOWN? */
static bool write_row_verdicts(const chunk *c, const fmb_packed_bits *bits, fmb_verdict *out)
{
    unsigned unknown = 0;
    for (size_t g = 0; 8 * g < c->n; g++) {
        const uint32_t *number = c->set->order + c->from + 8 * g;
        unsigned apart = bits[g].apart, meet = bits[g].meet;
        size_t n = c->n - 8 * g < 8 ? c->n - 8 * g : 8;
        for (size_t l = 0; l < n; l++)
            out[number[l]] = apart >> l & 1  ? FMB_INFEASIBLE
                             : meet >> l & 1 ? FMB_FEASIBLE
                                             : FMB_UNKNOWN;
        unknown |= ~(apart | meet) & ((1U << n) - 1);
    }
    return unknown != 0;
}

/* Decide the UNKNOWN verdicts of a row. */
static fmb_status decide_open_row(fmb_pair *k, const fmb_frames *a, size_t i, const fmb_frames *b,
                                  fmb_verdict *out)
{
    for (size_t j = 0; j < b->n; j++)
        if (out[j] == FMB_UNKNOWN)
            FMB_TRY(fmb_packed_decide(k, a, b, 1, &(fmb_frames_pair){(uint32_t)i, (uint32_t)j},
                                      &out[j]));
    return FMB_OK;
}

fmb_status fmb_frames_test_row(fmb_pair *k, const fmb_frames *a, size_t i, const fmb_frames *b,
                               fmb_verdict *verdict)
{
    if (!k || !fmb_packed_begin(k, a, b))
        return FMB_ERR_ARG;
    if (i >= a->n || (b->n > 0 && !verdict)) {
        snprintf(k->error, sizeof k->error, "%s", i >= a->n ? "no such frame" : "verdict is NULL");
        return FMB_ERR_ARG;
    }
    k->counts.pairs += b->n;
    const fmb_bounds box = bounds_of(a, i);
    bool open = false;
    for (size_t from = 0; from < b->n;) {
        chunk c;
        fmb_packed_bits bits[EIGHTS];
        from = begin_chunk(b, from, &c);
        ask_chunk(k, a, i, &box, &c, bits);
        open |= write_row_verdicts(&c, bits, verdict);
    }
    return open ? decide_open_row(k, a, i, b, verdict) : FMB_OK;
}

/* ---- all against all ------------------------------------------------------------------------- */

/* A query; told is called for one band at a time. */
typedef struct all_query {
    const fmb_frames *a, *b;
    bool within;  /* a and b are the same: only i < j */
    size_t words; /* of bits for a row */
    size_t rows;  /* of a band */
    fmb_frames_told *told;
    void *self;
    atomic_bool over; /* told returned false, or there was an error */
} all_query;

/* The results of a band, row by row: bits by number of the second frame; and pairs to report. */
typedef struct band {
    fmb_pair *k;
    fmb_mem mem;
    size_t first, rows;
    uint64_t *meet, *open;     /* [rows][words] */
    fmb_frames_pair *found[2]; /* that meet, that are UNKNOWN */
    size_t count[2], capacity[2];
} band;

/* Note the results of a row of a chunk, for a set of one kind: its numbers are in order, and chunks
 * begin at multiples of 8. */
static void note_bytes_of_chunk(const chunk *c, const fmb_packed_bits *bits, uint64_t *meet,
                                uint64_t *open)
{
    for (size_t g = 0; g < (c->n + 7) / 8; g++) {
        size_t byte = c->from / 8 + g;
        unsigned left = c->n - 8 * g < 8 ? (1U << (c->n - 8 * g)) - 1 : 0xff;
        unsigned unknown = ~(unsigned)(bits[g].meet | bits[g].apart) & left;
        meet[byte / 8] |= (uint64_t)(bits[g].meet & left) << byte % 8 * 8;
        if (unknown)
            open[byte / 8] |= (uint64_t)unknown << byte % 8 * 8;
    }
}

/* Note the results of a row of a chunk, for any set. */
static void note_bits_of_chunk(const chunk *c, const fmb_packed_bits *bits, uint64_t *meet,
                               uint64_t *open)
{
    const uint32_t *number = c->set->order + c->from;
    for (size_t g = 0; g < (c->n + 7) / 8; g++) {
        unsigned left = c->n - 8 * g < 8 ? (1U << (c->n - 8 * g)) - 1 : 0xff;
        unsigned met = bits[g].meet & left, unknown = ~(bits[g].meet | bits[g].apart) & left;
        for (unsigned both = met | unknown; both; both &= both - 1) {
            unsigned l = (unsigned)__builtin_ctz(both);
            size_t j = number[8 * g + l];
            (met >> l & 1 ? meet : open)[j / 64] |= UINT64_C(1) << j % 64;
        }
    }
}

/* Test all chunks; within one set, only those with a frame after the first of the band. */
static void ask_band(const all_query *x, band *w)
{
    void (*note)(const chunk *, const fmb_packed_bits *, uint64_t *, uint64_t *) =
        x->b->only >= 0 ? note_bytes_of_chunk : note_bits_of_chunk;
    fmb_bounds box[BAND];
    for (size_t r = 0; r < w->rows; r++)
        box[r] = bounds_of(x->a, w->first + r);
    for (size_t from = 0; from < x->b->n && !fmb_pair_is_cancelled(w->k);) {
        chunk c;
        size_t end = begin_chunk(x->b, from, &c);
        bool counts = !x->within || x->b->order[end - 1] > w->first;
        for (size_t r = 0; counts && r < w->rows; r++) {
            fmb_packed_bits bits[EIGHTS];
            ask_chunk(w->k, x->a, w->first + r, &box[r], &c, bits);
            note(&c, bits, w->meet + r * x->words, w->open + r * x->words);
        }
        from = end;
    }
}

/* Make room for the pairs of another word. */
static fmb_status make_room_for_word(band *w, bool unknown)
{
    return FMB_RESERVE(&w->mem, &w->found[unknown], &w->capacity[unknown], w->count[unknown] + 64);
}

/* Decide the open pairs of frame i in one word of the second set. */
static fmb_status decide_open_word(const all_query *x, band *w, size_t i, size_t word,
                                   uint64_t open, uint64_t *meet)
{
    fmb_status st = make_room_for_word(w, true);
    for (; st == FMB_OK && open; open &= open - 1) {
        int bit = __builtin_ctzll(open);
        fmb_frames_pair pair = {(uint32_t)i, (uint32_t)(64 * word + (size_t)bit)};
        fmb_verdict is = FMB_UNKNOWN;
        st = fmb_packed_decide(w->k, x->a, x->b, 1, &pair, &is);
        if (is == FMB_FEASIBLE)
            *meet |= UINT64_C(1) << bit;
        else if (is == FMB_UNKNOWN)
            w->found[true][w->count[true]++] = pair;
    }
    return st;
}

/* Note the pairs of frame i in one word of the second set that meet, and decide the open ones. */
static fmb_status note_pairs_of_word(const all_query *x, band *w, size_t i, size_t word,
                                     uint64_t meet, uint64_t open)
{
    fmb_status st = open ? decide_open_word(x, w, i, word, open, &meet) : FMB_OK;
    if (st == FMB_OK && meet)
        st = make_room_for_word(w, false);
    if (st != FMB_OK || !meet)
        return st;
    fmb_frames_pair *to = w->found[false] + w->count[false];
    for (; meet; meet &= meet - 1)
        *to++ =
            (fmb_frames_pair){(uint32_t)i, (uint32_t)(64 * word + (size_t)__builtin_ctzll(meet))};
    w->count[false] = (size_t)(to - w->found[false]);
    return FMB_OK;
}

static fmb_status note_pairs_of_band(const all_query *x, band *w)
{
    fmb_status st = FMB_OK;
    for (size_t r = 0; st == FMB_OK && r < w->rows; r++) {
        size_t i = w->first + r, from = x->within ? (i + 1) / 64 : 0;
        for (size_t word = from; st == FMB_OK && word < x->words; word++) {
            uint64_t asked = UINT64_MAX;
            if (x->within && word == from)
                asked <<= (i + 1) % 64;
            st = note_pairs_of_word(x, w, i, word, w->meet[r * x->words + word] & asked,
                                    w->open[r * x->words + word] & asked);
        }
    }
    return st;
}

/* Process the band that begins at row `first`. */
static fmb_status work_on_band(const all_query *x, band *w, size_t first)
{
    w->first = first;
    w->rows = x->a->n - first < x->rows ? x->a->n - first : x->rows;
    w->count[0] = w->count[1] = 0;
    memset(w->meet, 0, x->rows * x->words * sizeof *w->meet);
    memset(w->open, 0, x->rows * x->words * sizeof *w->open);
    ask_band(x, w);
    for (size_t r = 0; r < w->rows; r++)
        w->k->counts.pairs += x->within ? x->b->n - first - r - 1 : x->b->n;
    return note_pairs_of_band(x, w);
}

static bool tell_band(const all_query *x, const band *w)
{
    bool goes_on = true;
    for (int unknown = 0; goes_on && unknown < 2; unknown++)
        if (w->count[unknown] > 0)
            goes_on = x->told(x->self, unknown ? FMB_UNKNOWN : FMB_FEASIBLE, w->count[unknown],
                              w->found[unknown]);
    return goes_on;
}

/* ---- threads --------------------------------------------------------------------------------- */

static fmb_status open_bands(const all_query *x, fmb_pair *k, band *w)
{
    fmb_status st = FMB_OK;
    for (int t = 0; st == FMB_OK && t < k->threads; t++) {
        w[t].k = t == 0 ? k : k->workers[t - 1];
        fmb_mem_init(&w[t].mem, &k->mem.alloc, 0);
        w[t].meet = fmb_mem_get(&w[t].mem, x->rows * x->words, sizeof *w[t].meet);
        w[t].open =
            w[t].meet ? fmb_mem_get(&w[t].mem, x->rows * x->words, sizeof *w[t].open) : NULL;
        st = w[t].open ? FMB_OK : fmb_mem_status(&w[t].mem);
    }
    return st;
}

static void close_bands(const all_query *x, const fmb_pair *k, band *w)
{
    for (int t = 0; t < k->threads; t++) {
        fmb_mem_put(&w[t].mem, w[t].meet, x->rows * x->words, sizeof *w[t].meet);
        fmb_mem_put(&w[t].mem, w[t].open, x->rows * x->words, sizeof *w[t].open);
        for (int unknown = 0; unknown < 2; unknown++)
            fmb_mem_put(&w[t].mem, w[t].found[unknown], w[t].capacity[unknown],
                        sizeof *w[t].found[unknown]);
    }
}

typedef struct bands_round {
    all_query *x;
    fmb_pair *k;
    band *w; /* [threads] */
    fmb_status st;
} bands_round;

static void work_on_band_in_turn(void *self, size_t job, size_t thread)
{
    bands_round *r = self;
    all_query *x = r->x;
    band *w = &r->w[thread];
    fmb_status st = atomic_load(&x->over) ? FMB_OK : work_on_band(x, w, job * x->rows);
    fmb_threads_begin_turn(&r->k->running, job);
    if (!atomic_load(&x->over)) {
        r->st = st;
        if (st != FMB_OK || fmb_pair_is_cancelled(r->k) || !tell_band(x, w))
            atomic_store(&x->over, true);
    }
    fmb_threads_end_turn(&r->k->running);
}

/* Bands are processed in parallel, and reported in order. */
static fmb_status work_on_all_bands(all_query *x, fmb_pair *k, band *w)
{
    bands_round r = {x, k, w, FMB_OK};
    fmb_status st =
        fmb_packed_do(k, x->a->n / x->rows + (x->a->n % x->rows > 0), work_on_band_in_turn, &r);
    return st == FMB_OK ? r.st : st;
}

/* Bits of a band: at most this many words [8 bytes], but for a single row. */
enum { MOST_WORDS = 1 << 18 };

fmb_status fmb_frames_meet(fmb_pair *k, const fmb_frames *a, const fmb_frames *b,
                           fmb_frames_told *told, void *self)
{
    b = b ? b : a;
    if (!k || !told || !fmb_packed_begin(k, a, b))
        return FMB_ERR_ARG;
    all_query x = {.a = a, .b = b, .within = a == b, .told = told, .self = self};
    x.words = b->n / 64 + 1;
    x.rows = MOST_WORDS / x.words < 1      ? 1
             : MOST_WORDS / x.words < BAND ? MOST_WORDS / x.words
                                           : BAND;
    band *w;
    FMB_TRY(FMB_GET_ZERO(&k->mem, w, (size_t)k->threads));
    fmb_status st = open_bands(&x, k, w);
    FMB_THEN(st, work_on_all_bands(&x, k, w));
    close_bands(&x, k, w);
    fmb_mem_put(&k->mem, w, (size_t)k->threads, sizeof *w);
    return st;
}
