/* glpk_run.c: calling GLPK; see glpk_run.h.
 *
 * GLPK reads files by name, prints, and aborts when memory runs out or an assertion fails. So the
 * text goes through a nameless temporary file, the printed text into a log, and an abort is left by
 * a jump. After a jump GLPK's environment is good for nothing but being freed; it is only freed if
 * nobody else had it before, since all problem objects of the thread live there.
 */
#include "io/glpk_run.h"

#include <errno.h>
#include <setjmp.h>
#include <string.h>

/* ---- life ------------------------------------------------------------------------------------ */

static int keep(void *self, const char *s)
{
    fmb_glpk *g = self;
    size_t n = strlen(s);
    fmb_status st = fmb_mem_reserve(g->c->mem, (void **)&g->log, &g->capacity, g->size + n + 1, 1);
    if (st != FMB_OK) {
        g->lost = true;
        return 1;
    }
    memcpy(g->log + g->size, s, n + 1);
    g->size += n;
    return 1;
}

fmb_status fmb_glpk_open(fmb_glpk *g, fmb_cursor *c)
{
    *g = (fmb_glpk){.c = c};
    g->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!g->c_locale)
        return FMB_ERR_MEMORY;
    int made = glp_init_env();
    if (made > 1) {
        freelocale(g->c_locale);
        return FMB_ERR_MEMORY;
    }
    g->ours = made == 0;
    g->old_locale = uselocale(g->c_locale);
    g->term = glp_term_out(GLP_ON);
    glp_term_hook(keep, g);
    return FMB_OK;
}

void fmb_glpk_close(fmb_glpk *g)
{
    glp_term_hook(NULL, NULL);
    glp_term_out(g->term);
    if (g->ours)
        glp_free_env();
    uselocale(g->old_locale);
    freelocale(g->c_locale);
    fmb_mem_put(g->c->mem, g->log, g->capacity, 1);
}

/* ---- reading --------------------------------------------------------------------------------- */

static void jump(void *self)
{
    longjmp(*(jmp_buf *)self, 1);
}

static int read_file(const fmb_glpk *g, fmb_glpk_form form, glp_prob *p)
{
    glp_mpscp mps;
    if (form == FMB_GLPK_LP)
        return glp_read_lp(p, NULL, g->file);
    glp_init_mpscp(&mps);
    mps.tol_mps = 0; /* small numbers are no zeros */
    return glp_read_mps(p, form == FMB_GLPK_FIXED ? GLP_MPS_DECK : GLP_MPS_FILE, &mps, g->file);
}

/* GLPK gives up when memory runs out, or on an assertion that the text has made fail. */
static fmb_status aborted(const fmb_glpk *g)
{
    return g->log && strstr(g->log, "Assertion failed") ? FMB_ERR_PARSE : FMB_ERR_MEMORY;
}

static fmb_status read_guarded(fmb_glpk *g, fmb_glpk_form form, glp_prob **p)
{
    jmp_buf here;
    if (setjmp(here)) {
        glp_error_hook(NULL, NULL);
        *p = NULL;
        return aborted(g);
    }
    glp_error_hook(jump, &here);
    *p = glp_create_prob();
    int failed = read_file(g, form, *p);
    glp_error_hook(NULL, NULL);
    return failed ? FMB_ERR_PARSE : FMB_OK;
}

fmb_status fmb_glpk_read(fmb_glpk *g, fmb_glpk_form form, fmb_span text, glp_prob **p)
{
    FILE *f = tmpfile();
    if (!f)
        return FMB_ERR_IO;
    fmb_status st = FMB_OK;
    g->size = 0;
    if ((text.n > 0 && fwrite(text.p, 1, text.n, f) != text.n) || fflush(f) != 0)
        st = FMB_ERR_IO;
    rewind(f); /* where opening it once more shares the position */
    snprintf(g->file, sizeof g->file, "/dev/fd/%d", fileno(f));
    if (st == FMB_OK)
        st = read_guarded(g, form, p);
    int cause = errno;
    fclose(f);
    errno = cause;
    return st == FMB_OK && g->lost ? FMB_ERR_MEMORY : st;
}

/* ---- messages -------------------------------------------------------------------------------- */

/* A line of the log: "file:line: text" or just text. */
typedef struct message {
    long line;
    fmb_span text;
} message;

static message parse_message(const fmb_glpk *g, const char *p, const char *end)
{
    message m = {0, {p, (size_t)(end - p)}};
    size_t n = strlen(g->file);
    if (m.text.n <= n || memcmp(p, g->file, n) != 0 || p[n] != ':')
        return m;
    for (p += n + 1; p < end && *p >= '0' && *p <= '9'; p++)
        m.line = 10 * m.line + (*p - '0');
    p += p < end && *p == ':';
    p += p < end && *p == ' ';
    m.line = m.line > 0 ? m.line : 1; /* GLPK has not begun to read the first one */
    m.text = (fmb_span){p, (size_t)(end - p)};
    return m;
}

/* The message at *p, which moves on to the next; false at the end. */
static bool next_message(const fmb_glpk *g, const char **p, message *m)
{
    if (g->size == 0 || *p == g->log + g->size)
        return false;
    const char *end = g->log + g->size;
    const char *eol = memchr(*p, '\n', (size_t)(end - *p));
    eol = eol ? eol : end;
    *m = parse_message(g, *p, eol);
    *p = eol + (eol < end);
    return true;
}

static message last_message(const fmb_glpk *g)
{
    message m, last = {0, {"", 0}};
    for (const char *p = g->log; next_message(g, &p, &m);)
        last = m;
    return last;
}

/* Move the cursor, at the start of line *from, to the start of a later line. */
static void go_to_line(fmb_cursor *at, long *from, long line)
{
    for (; *from < line; ++*from)
        fmb_next_line(at);
}

/* What the message quotes, where the line has it; else the start of the line. */
static const char *blame(const fmb_cursor *line, fmb_span text)
{
    fmb_cursor end = *line;
    const char *open = memchr(text.p, '\'', text.n);
    const char *close = open ? memchr(open + 1, '\'', (size_t)(text.p + text.n - open - 1)) : NULL;
    if (!close || close == open + 1)
        return line->at;
    fmb_skip_line(&end);
    const char *found =
        memmem(line->at, (size_t)(end.at - line->at), open + 1, (size_t)(close - open - 1));
    return found ? found : line->at;
}

/* Bytes of a message that fit, whole characters only. */
static int fitting(fmb_span text)
{
    size_t n = text.n < 120 ? text.n : 120;
    while (n > 0 && n < text.n && ((unsigned char)text.p[n] & 0xC0) == 0x80)
        n--;
    return (int)n;
}

long fmb_glpk_line(const fmb_glpk *g)
{
    return last_message(g).line;
}

fmb_status fmb_glpk_fail(const fmb_glpk *g)
{
    message m = last_message(g);
    int n = fitting(m.text);
    if (m.line > 0) {
        fmb_cursor at = *g->c;
        at.at = at.begin;
        go_to_line(&at, &(long){1}, m.line);
        return fmb_io_fail(g->c, blame(&at, m.text), "%.*s", n, m.text.p);
    }
    return fmb_io_fail_whole(g->c, "GLPK cannot read this: %.*s", n, m.text.p);
}

static bool starts_with(fmb_span w, const char *word)
{
    size_t n = strlen(word);
    return w.n >= n && memcmp(w.p, word, n) == 0;
}

fmb_status fmb_glpk_warn(const fmb_glpk *g)
{
    message m;
    fmb_cursor at = *g->c;
    long line = 1;
    at.at = at.begin;
    for (const char *p = g->log; next_message(g, &p, &m);) {
        if (m.line == 0 || !starts_with(m.text, "warning: "))
            continue;
        m.text = (fmb_span){m.text.p + 9, m.text.n - 9};
        go_to_line(&at, &line, m.line);
        if (starts_with(m.text, "some extra field"))
            return fmb_io_fail(g->c, at.at, "expected at most two numbers a line in free MPS");
        if (!starts_with(m.text, "missing final end of line"))
            fmb_io_warn(g->c, at.at, "%.*s", fitting(m.text), m.text.p);
    }
    return FMB_OK;
}
