/* features.c: see features.h. */
#include "solve/prepare/features.h"

#ifdef FMB_ABLATE
fmb_features_watcher fmb_features_watch;
#endif

/* Does the row hold where all variables are 0? */
static bool holds_at_origin(const fmb_derived *r, size_t n)
{
    int side = fmb_vec_sgn(&r->v, n);
    return side >= 0 && !(r->strict && side == 0) && !(r->equality && side != 0);
}

static size_t count_dropped_variables(const fmb_elim *e, const fmb_derived *r)
{
    size_t dropped = 0;
    for (size_t w = 0; w < e->var_words; w++)
        dropped += fmb_ones64(r->names[w] & e->candidates[w]);
    return dropped;
}

static void note_row(const fmb_reduced_part *h, const fmb_derived *r, fmb_features *f)
{
    size_t n = (size_t)h->e.n, nonzero = (size_t)fmb_elim_count_variables(&h->e, r);
    size_t dropped = count_dropped_variables(&h->e, r);
    f->entries += nonzero;
    f->equalities += r->equality;
    f->bounds += nonzero == 1;
    f->kept_rows += dropped == 0;
    f->dropped_rows += dropped == nonzero;
    f->homogeneous += fmb_vec_sgn(&r->v, n) == 0;
    f->has_origin &= holds_at_origin(r, n);
}

static void note_remaining_rows(const fmb_reduced_part *h, fmb_features *f)
{
    const fmb_elim *e = &h->e;
    f->rows = e->live.size;
    f->has_origin = true;
    for (size_t i = 0; i < e->live.size; i++)
        note_row(h, &e->row[e->live.row[i]], f);
}

/* An equality counts as a row of either sign. */
static void note_column(const fmb_reduced_part *h, size_t j, fmb_features *f)
{
    size_t up = 0, down = 0;
    for (size_t i = 0; i < h->e.live.size; i++) {
        const fmb_derived *r = &h->e.row[h->e.live.row[i]];
        int sign = fmb_vec_sgn(&r->v, j);
        up += sign > 0 || (sign < 0 && r->equality);
        down += sign < 0 || (sign > 0 && r->equality);
    }
    if (up * down == 0)
        return;
    size_t pairs = up * down, growth = pairs > up + down ? pairs - up - down : 0;
    f->most_pairs = pairs > f->most_pairs ? pairs : f->most_pairs;
    f->least_growth = growth < f->least_growth ? growth : f->least_growth;
}

fmb_features fmb_features_of(const fmb_reduced_part *reduced)
{
    fmb_features f = {
        .kept = reduced->kept, .variables = reduced->p->n, .is_wide = reduced->p->wide};
    f.columns = (size_t)reduced->p->n - (size_t)reduced->e.rounds;
    note_remaining_rows(reduced, &f);
    f.least_growth = SIZE_MAX;
    for (int j = 0; j < reduced->e.n; j++)
        if (fmb_set_has(reduced->e.candidates, (size_t)j))
            note_column(reduced, (size_t)j, &f);
    if (f.most_pairs == 0)
        f.least_growth = 0;
    f.minor_bits = fmb_elim_minor_bits(&reduced->e);
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
