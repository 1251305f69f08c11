/* features.c: see features.h. */
#include "solve/prepare/features.h"

#ifdef FMB_ABLATE
fmb_features_watcher fmb_features_watch;
#endif

static int count_kept_variables(const fmb_reduced_part *h)
{
    int kept = 0;
    for (int j = 0; j < h->p->n; j++)
        kept += h->place[h->p->var[j]] >= 0;
    return kept;
}

static void note_given_rows(const fmb_part *p, fmb_features *f)
{
    f->given = p->m;
    for (size_t i = 0; i < p->m; i++) {
        f->is_strict |= p->rel[i] == FMB_LT;
        f->is_wide |= fmb_vec_is_wide(&p->row[i]);
    }
}

/* Does the row hold where all variables are 0? */
static bool holds_at_origin(const fmb_derived *r, size_t n)
{
    int side = fmb_vec_sgn(&r->v, n);
    return side >= 0 && !(r->strict && side == 0) && !(r->equality && side != 0);
}

static void note_rows_left(const fmb_elim *e, fmb_features *f)
{
    bool wide = false, all_long = true;
    f->rows = e->live.size;
    f->has_origin = true;
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        size_t nonzero = (size_t)fmb_elim_count_variables(e, r);
        f->entries += nonzero;
        f->bounds += nonzero == 1;
        wide |= fmb_vec_is_wide(&r->v);
        all_long &= fmb_vec_is_wide(&r->v) || r->v.bits > FMB_LAZY_BITS;
        f->has_origin &= holds_at_origin(r, (size_t)e->n);
    }
    f->is_long = wide || all_long;
}

static size_t freedom_of_cone(size_t rows, size_t dimensions)
{
    size_t beyond = rows > dimensions ? rows - dimensions : 0;
    return beyond > dimensions ? dimensions : beyond;
}

fmb_features fmb_features_of(const fmb_reduced_part *reduced)
{
    fmb_features f = {.kept = count_kept_variables(reduced), .variables = reduced->p->n};
    f.columns = (size_t)reduced->p->n - (size_t)reduced->e.rounds;
    note_given_rows(reduced->p, &f);
    note_rows_left(&reduced->e, &f);
    f.minor_bits = fmb_elim_minor_bits(&reduced->e);
    f.freedom = freedom_of_cone(f.rows, f.columns + 1);
#ifdef FMB_ABLATE
    if (fmb_features_watch.hear)
        fmb_features_watch.hear(fmb_features_watch.self, &f, reduced);
#endif
    return f;
}

#define FMB_FEATURE_NAME(id, name, value) [FMB_FEATURE_##id] = name,
static const char *const NAME[] = {FMB_FEATURE_VALUES(FMB_FEATURE_NAME)};

const char *fmb_features_name(fmb_feature_id which)
{
    return NAME[which];
}

#define FMB_FEATURE_CASE(id, name, value)                                                          \
    case FMB_FEATURE_##id:                                                                         \
        return (double)(value);

double fmb_features_value(const fmb_features *f, fmb_feature_id which)
{
    switch (which) {
        FMB_FEATURE_VALUES(FMB_FEATURE_CASE)
    case FMB_FEATURE_COUNT:
        break;
    }
    return 0;
}
