/* select.c: the systems of each line of a report. */
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb-qualify/rules/report.h"

static bool selects(const void *self, const study_sample *s)
{
    const qualify_select *w = self;
    const study_class *c = &s->class;
    if (w->file || s->file)
        return s->file && (w->file ? w->file == s->file : w->dim == FILES || w->dim == ANY);
    int kind = 2 * (int)c->shape[0] + (int)c->shape[1];
    return (w->dim == ANY || w->dim == c->dim) && (w->moves == ANY || w->moves == c->moves) &&
           (w->kind == ANY || w->kind == kind) && (w->meets == ANY || w->meets == c->meets);
}

static study_digest digest(const qualify_plan *p, size_t way, const qualify_select *which)
{
    study_digest d;
    size_t base = way - way % p->sets;
    if (study_digest_make(&p->grid, way, base, selects, which, &d) != FMB_OK)
        app_need(NULL);
    return d;
}

study_digest qualify_digest(const qualify_plan *p, size_t way, const qualify_select *which)
{
    study_digest d = digest(p, way, which);
    if (which->dim <= FILES || which->meets != ANY || !p->meeting[1])
        return d;
    qualify_select meeting = *which;
    meeting.meets = 1;
    study_digest m = digest(p, way, &meeting);
    m.systems = d.systems;
    m.decided = d.decided;
    m.stopped = d.stopped;
    m.refused = d.refused;
    m.wrong = d.wrong;
    m.timed = d.timed;
    m.base_gave_up = d.base_gave_up;
    m.gave_up = d.gave_up;
    m.total = d.total;
    m.median = d.median;
    m.chance = d.chance;
    return m;
}

static bool same(const qualify_select *a, const qualify_select *b)
{
    return a->dim == b->dim && a->moves == b->moves && a->kind == b->kind && a->meets == b->meets &&
           a->file == b->file;
}

/* The line that a sample belongs to. */
static qualify_select line_of(const study_sample *s, bool detail)
{
    const study_class *c = &s->class;
    if (s->file)
        return (qualify_select){FILES, ANY, ANY, ANY, detail ? s->file : NULL};
    if (detail)
        return (qualify_select){c->dim, c->moves, 2 * (int)c->shape[0] + (int)c->shape[1], c->meets,
                                NULL};
    return (qualify_select){c->dim, c->moves, ANY, ANY, NULL};
}

/* The samples of a line are consecutive: a new line begins where line_of changes. */
void qualify_each(const qualify_plan *p, bool detail, void *self,
                  void (*use)(void *self, const qualify_plan *p, const qualify_select *which))
{
    qualify_select last = {0};
    for (size_t k = 0; k < p->grid.complete; k++) {
        qualify_select line = line_of(&p->grid.sample[k], detail);
        if (k == 0 || !same(&line, &last))
            use(self, p, &line);
        last = line;
    }
}

char *qualify_select_text(const qualify_select *w)
{
    static const char *const KIND[] = {"CC", "CT", "TC", "TT"};
    char *text = NULL;
    size_t size;
    if (w->file || w->dim == FILES)
        return app_need(strdup(w->file ? w->file : "files"));
    FILE *f = app_need(open_memstream(&text, &size));
    fprintf(f, "D%d %s", w->dim, w->moves ? "dynamic" : "static");
    if (w->kind != ANY)
        fprintf(f, " %s", KIND[w->kind]);
    if (w->meets != ANY)
        fprintf(f, " %s", w->meets ? "meeting" : "apart");
    fclose(f);
    return app_need(text);
}
