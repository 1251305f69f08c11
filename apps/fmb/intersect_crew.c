/* intersect_crew.c: a stream of pairs by several threads.
 *
 * The stream is cut into portions of complete lines, which are collected for a round; then each is
 * read, answered and reported by one thread, into memory, and the reports are printed in order. No
 * answer depends on where the cuts are. After a slow round portions become shorter, so that slow
 * pairs are reported soon, too. */
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "base/clock.h"
#include "base/line.h"
#include "common/message.h"
#include "common/signals.h"
#include "fmb/intersect.h"
#include "fmb/stop.h"

enum {
    ROUND = 4,           /* portions for each thread */
    MOST_LINES = 256,    /* of a portion */
    MOST_TEXT = 1 << 18, /* of a portion, unless a line is longer [bytes] */
};

static const double short_round = 0.05, long_round = 0.2; /* [s] */

typedef struct portion {
    FILE *in; /* into text, while it is filled */
    char *text, *report, *messages;
    size_t size, length, messages_length;
    long before, lines; /* number of lines before it, and in it */
    bool is_whole;      /* all of it was answered */
    intersect found;    /* counts */
    fmb_status read, asked;
    fmb_where where;
} portion;

typedef struct member {
    crew *crew;
    int number; /* from 1 on */
    intersect x;
    batch *b;
} member;

struct crew {
    intersect *x;
    member *member;     /* [x->ask->threads] */
    portion *portion;   /* [ROUND x->ask->threads] */
    size_t most, ready; /* number of portions; of full ones */
    atomic_size_t next; /* to be answered */
    long lines;         /* read so far */
    long each;          /* lines of a portion */
    bool is_over;       /* the rest does not count */
    fmb_status read, asked;
    fmb_where *where;
    progress progress;
    char *line;
    size_t size, capacity;
};

/* ---- a portion is answered ------------------------------------------------------------------- */

static void answer_portion(member *m, portion *p)
{
    fmb_reader reading = intersect_reader(m->x.ask);
    answering w = {.b = m->b};
    FILE *in = app_need(fmemopen(p->text, p->size, "r"));
    m->x = (intersect){.ask = m->x.ask, .solver = m->x.solver, .before = p->before};
    m->x.out = app_need(open_memstream(&p->report, &p->length));
    m->x.err = app_need(open_memstream(&p->messages, &p->messages_length));
    p->read = fmb_frame_reader_new(in, &reading, &w.lines);
    if (p->read == FMB_OK) {
        app_stop_reader(w.lines);
        p->read = answer_lines(&w, &m->x, &p->where);
        app_stop_reader(NULL);
    }
    p->asked = w.asked;
    p->is_whole = p->read == FMB_OK && p->asked == FMB_OK && !app_stop_asked();
    p->found = m->x;
    fmb_frame_reader_free(w.lines);
    fclose(m->x.out);
    fclose(m->x.err);
    fclose(in);
}

static void *answer_portions(void *self)
{
    member *m = self;
    crew *c = m->crew;
    app_stop_join(m->number, m->x.solver);
    batch_join(m->b);
    for (size_t i; (i = atomic_fetch_add(&c->next, 1)) < c->ready && !app_stop_asked();)
        answer_portion(m, &c->portion[i]);
    app_stop_leave();
    return NULL;
}

/* ---- a round --------------------------------------------------------------------------------- */

/* Signals are for the caller's thread alone. Where the system grants fewer threads, these do more.
 */
static void answer_round(crew *c)
{
    pthread_t thread[APP_MOST_THREADS];
    sigset_t held, before;
    size_t n = c->ready < c->most / ROUND ? c->ready : c->most / ROUND, threads = 0;
    atomic_store(&c->next, 0);
    app_signals_fill(&held);
    pthread_sigmask(SIG_BLOCK, &held, &before);
    while (threads + 1 < n &&
           pthread_create(&thread[threads], NULL, answer_portions, &c->member[threads + 1]) == 0)
        threads++;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    answer_portions(&c->member[0]);
    for (size_t i = 0; i < threads; i++)
        pthread_join(thread[i], NULL);
}

/* Report a portion; ends at the first one with an error, or cut off by a signal. */
static void report_portion(crew *c, portion *p)
{
    intersect *x = c->x;
    if (x->ask->json && x->tested > 0 && p->found.tested > 0)
        fputc(',', x->out);
    fwrite(p->report, 1, p->length, x->out);
    fwrite(p->messages, 1, p->messages_length, x->err);
    x->tested += p->found.tested;
    x->meeting += p->found.meeting;
    x->undecided += p->found.undecided;
    x->within += p->found.within;
    x->contradicted += p->found.contradicted;
    if (x->stop == FMB_STOP_DONE)
        x->stop = p->found.stop;
    if (p->is_whole)
        return;
    c->is_over = true;
    c->read = p->read;
    c->asked = p->asked;
    *c->where = p->where;
    c->where->line += p->before;
}

static void forget_portion(portion *p)
{
    free(p->text);
    free(p->report);
    free(p->messages);
    *p = (portion){0};
}

static void close_portion(crew *c)
{
    portion *p = &c->portion[c->ready];
    if (!p->in)
        return;
    fclose(p->in);
    p->in = NULL;
    c->ready++;
}

void crew_flush(crew *c)
{
    double begin = fmb_monotonic_seconds();
    close_portion(c);
    if (c->ready == 0)
        return;
    answer_round(c);
    for (size_t i = 0; i < c->ready; i++) {
        c->is_over |= c->portion[i].report == NULL;
        if (!c->is_over)
            report_portion(c, &c->portion[i]);
        forget_portion(&c->portion[i]);
    }
    c->ready = 0;
    progress_show(&c->progress, c->x);
    double seconds = fmb_monotonic_seconds() - begin;
    if (seconds < short_round && c->each < MOST_LINES)
        c->each *= 2;
    else if (seconds > long_round && c->each > 1)
        c->each /= 2;
}

/* ---- the stream is cut ----------------------------------------------------------------------- */

/* The portion for the next line. */
static portion *open_portion(crew *c)
{
    portion *p = &c->portion[c->ready];
    if (!p->in) {
        p->in = app_need(open_memstream(&p->text, &p->size));
        p->before = c->lines;
    }
    return p;
}

static void count_line(crew *c, portion *p)
{
    c->lines++;
    p->lines++;
    if (p->lines < c->each && ftell(p->in) < MOST_TEXT)
        return;
    close_portion(c);
    if (c->ready == c->most)
        crew_flush(c);
}

/* Read the next line, with its end; size 0 at the end of the stream. Of a line that is too long,
 * limit + 1 bytes are kept, so that its reader refuses it. */
static void fetch_line(crew *c, FILE *in)
{
    enum { LEAST = 1024, MOST = 1 << 30 };
    size_t most = c->x->ask->max_input > 0 ? c->x->ask->max_input : FMB_READER_MAX_BYTES;
    bool more = true;
    for (c->size = 0; more;) {
        size_t n = c->size < LEAST ? LEAST : c->size < MOST ? c->size : MOST;
        if (c->size + n > c->capacity) {
            c->capacity = 2 * (c->size + n);
            c->line = app_need(realloc(c->line, c->capacity));
        }
        size_t got = fmb_fetch_part_of_line(in, c->line + c->size, n);
        c->size += got;
        more = got > 0 && c->line[c->size - 1] != '\n';
        c->size = c->size > most ? most + 1 : c->size;
    }
}

/* The start of a stream has a special meaning: before a later line an empty one is inserted. */
static void put_line(crew *c)
{
    portion *p = open_portion(c);
    if (p->lines == 0 && p->before > 0) {
        fputc('\n', p->in);
        p->before--;
    }
    fwrite(c->line, 1, c->size, p->in);
    count_line(c, p);
}

static void cut_text(crew *c, FILE *in)
{
    do {
        errno = 0;
        fetch_line(c, in);
        if (c->size > 0 && !app_stop_asked() && !c->is_over)
            put_line(c);
    } while (c->size > 0 && !app_stop_asked() && !c->is_over);
    c->read = c->is_over ? c->read : ferror(in) ? FMB_ERR_IO : FMB_OK;
}

/* Pairs in binary are read here, and written anew. */
static void cut_binary(crew *c, FILE *in)
{
    fmb_reader reading = intersect_reader(c->x->ask);
    const fmb_frame_line *line = NULL;
    fmb_frame_reader *lines = NULL;
    fmb_where where = {0};
    fmb_status st = fmb_frame_reader_new(in, &reading, &lines);
    do {
        errno = 0;
        app_stop_reader(lines); /* a round takes its place */
        st = st == FMB_OK ? fmb_frame_reader_next(lines, &line, &where) : st;
        if (st == FMB_OK && line && !c->is_over) {
            portion *p = open_portion(c);
            st = fmb_frame_pairs_write(p->in, 1, &line->frame[0], &line->frame[1]);
            count_line(c, p);
        }
    } while (st == FMB_OK && line && !app_stop_asked() && !c->is_over);
    int cause = errno;
    app_stop_reader(NULL);
    fmb_frame_reader_free(lines);
    crew_flush(c);
    if (!c->is_over && st != FMB_OK && !app_stop_asked()) {
        c->read = st;
        *c->where = where;
    }
    errno = cause;
}

fmb_status crew_answer(crew *c, FILE *in, fmb_where *where, fmb_status *asked)
{
    c->where = where;
    c->progress = progress_begin(c->x->ask);
    int first = getc(in);
    if (first != EOF)
        ungetc(first, in);
    if (first == 'f')
        cut_binary(c, in);
    else
        cut_text(c, in);
    int cause = errno;
    if (!c->is_over)
        crew_flush(c);
    progress_end(&c->progress);
    *asked = c->asked;
    errno = cause;
    return c->read;
}

/* ---- life ------------------------------------------------------------------------------------ */

crew *crew_new(intersect *x)
{
    crew *c = app_need(calloc(1, sizeof *c));
    size_t threads = (size_t)x->ask->threads;
    c->x = x;
    c->each = 1;
    c->most = ROUND * threads;
    c->member = app_need(calloc(threads, sizeof *c->member));
    c->portion = app_need(calloc(c->most + 1, sizeof *c->portion));
    for (size_t i = 0; i < threads; i++) {
        member *m = &c->member[i];
        *m = (member){.crew = c, .number = (int)i, .x = {.ask = x->ask}};
        if (intersect_solver(x->ask, &m->x.solver) != FMB_OK)
            app_need(NULL);
        m->b = batch_new(&m->x);
    }
    return c;
}

void crew_free(crew *c)
{
    if (!c)
        return;
    for (int i = 0; i < c->x->ask->threads; i++) {
        batch_free(c->member[i].b);
        fmb_solver_free(c->member[i].x.solver);
    }
    free(c->member);
    free(c->portion);
    free(c->line);
    free(c);
}
