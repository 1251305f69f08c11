/* script.c: SMT-LIB scripts with several questions; see fmb/io.h.
 *
 * The commands of the text are found once, each flagged whether it is in force at the current
 * place, by levels of push. One incremental reading (reading.h) follows: a question (ask.c)
 * executes those commands that it has not executed yet, and a pop undoes them.
 */
#include <string.h>

#include "io/core/cursor.h"
#include "io/core/stream.h"
#include "io/smt2/script/script_private.h"

/* ---- finding commands ------------------------------------------------------------------------ */

static bool is_command(const fmb_script_command *k, const char *word)
{
    return fmb_span_is(k->word, word);
}

/* Find the parenthesis of a list after the word. */
static fmb_status find_inner_list(fmb_cursor *c, fmb_script_command *k)
{
    fmb_smt_token t;
    if (!is_command(k, "check-sat-assuming") && !is_command(k, "get-value"))
        return FMB_OK;
    fmb_status st = fmb_smt_expect(c, FMB_SMT_OPEN, "'(' of a list", &t);
    k->inner = (size_t)(t.at - k->text.p);
    return st == FMB_OK ? fmb_smt_leave(c, t.at) : st;
}

static fmb_status scan_commands(fmb_script *s, fmb_cursor *c)
{
    for (bool more = true; more;) {
        fmb_smt_token open, word;
        fmb_script_command k = {0};
        fmb_status st = fmb_smt_next(c, &open);
        if (st != FMB_OK || open.kind == FMB_SMT_END)
            return st;
        if (open.kind != FMB_SMT_OPEN)
            return fmb_io_expected(c, open.at, "'(' of a command");
        st = fmb_smt_expect(c, FMB_SMT_SYMBOL, "a command", &word);
        k.word = word.text;
        k.text.p = open.at;
        FMB_THEN(st, find_inner_list(c, &k));
        FMB_THEN(st, fmb_smt_leave(c, open.at));
        k.text.n = (size_t)(c->at - open.at);
        FMB_THEN(st, FMB_RESERVE(&s->mem, &s->command, &s->capacity, s->commands + 1));
        if (st != FMB_OK)
            return st;
        more = !is_command(&k, "exit");
        s->command[s->commands++] = k;
    }
    return FMB_OK;
}

/* ---- life ------------------------------------------------------------------------------------ */

void fmb_script_free(fmb_script *s)
{
    if (!s)
        return;
    if (s->reading.c.mem)
        fmb_smt_reading_drop(&s->reading);
    fmb_mem mem = s->mem;
    fmb_mem_put(&mem, s->text, s->size, 1);
    fmb_mem_put(&mem, s->command, s->capacity, sizeof *s->command);
    fmb_mem_put(&mem, s->level, s->level_capacity, sizeof *s->level);
    fmb_mem_put(&mem, s, 1, sizeof *s);
}

/* The text, which a script keeps. */
static fmb_status fill_script(fmb_script *s, const fmb_cursor *text)
{
    s->size = (size_t)(text->end - text->begin);
    FMB_TRY(FMB_GET(&s->mem, s->text, s->size));
    memcpy(s->text, text->begin, s->size);
    fmb_cursor c = fmb_io_cursor(s->text, s->size, &s->how, &s->mem, text->where);
    fmb_status st = fmb_io_check(&c);
    FMB_THEN(st, scan_commands(s, &c));
    s->scanned = c.tokens;
    s->reading = fmb_smt_reading_of(s->text, s->size, &s->how, &s->mem);
    return st;
}

static fmb_status parse_script(fmb_cursor *c, void *out)
{
    fmb_script *s;
    FMB_TRY(FMB_GET_ZERO(c->mem, s, 1));
    s->mem = *c->mem;
    s->how = *c->how;
    s->how.format = FMB_FORMAT_SMT2;
    s->asked = SIZE_MAX;
    fmb_status st = fill_script(s, c);
    if (st == FMB_OK)
        *(fmb_script **)out = s;
    else
        fmb_script_free(s);
    return st;
}

fmb_status fmb_script_parse(const char *text, size_t size, const fmb_reader *how, fmb_script **out,
                            fmb_where *where)
{
    return out ? fmb_parse_memory(text, size, how, parse_script, out, where)
               : fmb_io_refuse_argument(where, "out is NULL");
}

fmb_status fmb_script_read(FILE *in, const fmb_reader *how, fmb_script **out, fmb_where *where)
{
    return out ? fmb_parse_stream(in, how, parse_script, out, where)
               : fmb_io_refuse_argument(where, "out is NULL");
}

bool fmb_script_asks_often(const fmb_script *s)
{
    static const char *const words[] = {"push", "pop", "reset", "reset-assertions",
                                        "check-sat-assuming"};
    size_t checks = 0;
    bool often = false;
    for (size_t k = 0; s && k < s->commands; k++) {
        checks += is_command(&s->command[k], "check-sat");
        for (size_t i = 0; i < sizeof words / sizeof *words; i++)
            often = often || is_command(&s->command[k], words[i]);
    }
    return often || checks > 1;
}

/* ---- from question to question --------------------------------------------------------------- */

static fmb_status fail_at_command(fmb_script *s, const fmb_script_command *k, const char *what,
                                  fmb_where *where)
{
    fmb_where at;
    fmb_cursor c = fmb_io_cursor(s->text, s->size, &s->how, &s->mem, &at);
    fmb_status st = fmb_io_fail(&c, k->text.p, "%s", what);
    if (where)
        *where = at;
    return st;
}

/* The number of a push or pop, 1 if there is none. */
static size_t count_of_levels(const fmb_script_command *k)
{
    size_t n = 0;
    bool any = false;
    for (const char *p = k->word.p + k->word.n, *end = k->text.p + k->text.n; p < end; p++) {
        any = any || fmb_is_digit((unsigned char)*p);
        if (fmb_is_digit((unsigned char)*p) && n < SIZE_MAX / 20)
            n = 10 * n + (size_t)(*p - '0');
    }
    return any ? n : 1;
}

static bool is_declaration(const fmb_script_command *k)
{
    return k->word.n > 7 &&
           (memcmp(k->word.p, "declare", 7) == 0 || memcmp(k->word.p, "define-", 7) == 0);
}

/* ---- what has been read ---------------------------------------------------------------------- */

void fmb_script_drop_reading(fmb_script *s)
{
    fmb_smt_reading_drop(&s->reading);
    s->read = s->marked = s->told = s->knew = 0;
}

/* Return to the first `levels` levels. A reading that began with facts found after that place is
 * discarded, as it knew too much. */
static void return_to_level(fmb_script *s, size_t levels)
{
    if (s->marked <= levels)
        return;
    const fmb_script_level *l = &s->level[levels];
    if (l->at < s->knew) {
        fmb_script_drop_reading(s);
        return;
    }
    fmb_smt_reading_return(&s->reading, &l->mark);
    s->read = l->at;
    s->told = s->told < l->at ? s->told : l->at;
    s->marked = levels;
}

/* No command from `from` on is in force, except global declarations. */
static void forget_commands(fmb_script *s, size_t from, bool all)
{
    for (size_t k = from; k < s->at; k++)
        s->command[k].counts =
            s->command[k].counts && !all && s->global && is_declaration(&s->command[k]);
}

static fmb_status push_levels(fmb_script *s, size_t n)
{
    if (n > s->size)
        return FMB_ERR_PARSE;
    for (; n > 0; n--) {
        FMB_TRY(FMB_RESERVE(&s->mem, &s->level, &s->level_capacity, s->levels + 1));
        s->level[s->levels++] = (fmb_script_level){.at = s->at};
    }
    return FMB_OK;
}

static fmb_status run_script_command(fmb_script *s, fmb_script_command *k, fmb_where *where)
{
    size_t n = count_of_levels(k);
    if (is_command(k, "push")) {
        fmb_status st = push_levels(s, n);
        return st == FMB_ERR_PARSE
                   ? fail_at_command(s, k, "expected fewer levels than the text has bytes", where)
                   : st;
    }
    if (is_command(k, "pop")) {
        if (n > s->levels)
            return fail_at_command(s, k, "expected a push for each pop", where);
        s->levels -= n;
        return_to_level(s, s->levels);
        if (n > 0)
            forget_commands(s, s->level[s->levels].at, false);
    } else if (is_command(k, "reset") || is_command(k, "reset-assertions")) {
        s->levels = 0;
        fmb_script_drop_reading(s);
        forget_commands(s, 0, is_command(k, "reset"));
        s->global = s->global && !is_command(k, "reset");
    } else if (is_command(k, "set-option")) {
        const char *global = memmem(k->text.p, k->text.n, ":global-declarations", 20);
        if (global)
            s->global = memmem(global, (size_t)(k->text.p + k->text.n - global), "true", 4) != NULL;
    } else {
        k->counts = true;
    }
    return FMB_OK;
}

fmb_script_kind fmb_script_kind_of(const fmb_script_command *k)
{
    static const struct {
        const char *word;
        fmb_script_kind kind;
    } table[] = {{"check-sat", FMB_SCRIPT_CHECK},          {"check-sat-using", FMB_SCRIPT_CHECK},
                 {"check-sat-assuming", FMB_SCRIPT_CHECK}, {"get-model", FMB_SCRIPT_MODEL},
                 {"get-value", FMB_SCRIPT_VALUE},          {"get-unsat-core", FMB_SCRIPT_CORE}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (is_command(k, table[i].word))
            return table[i].kind;
    return FMB_SCRIPT_END;
}

fmb_status fmb_script_next(fmb_script *s, fmb_script_kind *out, fmb_where *where)
{
    if (!s || !out)
        return fmb_io_refuse_argument(where, s ? "out is NULL" : "s is NULL");
    while (s->at < s->commands) {
        fmb_script_command *k = &s->command[s->at];
        fmb_script_kind kind = fmb_script_kind_of(k);
        FMB_TRY(kind ? FMB_OK : run_script_command(s, k, where));
        if (kind == FMB_SCRIPT_CHECK)
            s->asked = s->at;
        s->at++;
        if (kind) {
            *out = kind;
            return FMB_OK;
        }
    }
    *out = FMB_SCRIPT_END;
    return FMB_OK;
}
