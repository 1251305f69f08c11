/* sets.c: the law of sets of frames (law.h): what a set and its scaled twin say, one against many
 * and all against all, is what fmb_pair_test says of each pair of plain frames. Up to twenty
 * frames: some kinds have more than eight, whose common box is asked first.
 */
#include <fmb/frames.h>
#include <stdlib.h>

#include "property/scale/bodies.h"

enum { MOST_FRAMES = 20 };

typedef struct drawn_set {
    int dim;
    size_t n;
    body body[MOST_FRAMES];
    fmb_verdict verdict[MOST_FRAMES][MOST_FRAMES]; /* i <= j */
} drawn_set;

/* Both orders of two frames have one verdict. */
static fmb_verdict verdict_of(const drawn_set *s, size_t i, size_t j)
{
    return i < j ? s->verdict[i][j] : s->verdict[j][i];
}

static void draw_set(law_source *g, drawn_set *s)
{
    int power[BODIES_MOST_DIM], most = law_draw(g, 1, 7);
    bool moves = law_draw(g, 0, 1);
    s->dim = law_draw(g, 1, 3);
    s->n = (size_t)law_draw(g, 1, MOST_FRAMES);
    bodies_draw_powers(g, s->dim, false, power);
    for (size_t i = 0; i < s->n; i++)
        bodies_draw_body(g, s->dim, most, moves, power, &s->body[i]);
}

static void ask_pairs(fmb_pair *k, drawn_set *s)
{
    for (size_t i = 0; i < s->n; i++)
        for (size_t j = i; j < s->n; j++)
            must(fmb_pair_test(k, 1, &s->body[i].frame[0], &s->body[j].frame[0],
                               &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                                   .verdict = &s->verdict[i][j]}));
}

static fmb_frames *make_set(const drawn_set *s, int scaled)
{
    fmb_frame f[MOST_FRAMES];
    fmb_frames *out = NULL;
    for (size_t i = 0; i < s->n; i++)
        f[i] = s->body[i].frame[scaled];
    must(fmb_frames_new(s->dim, s->n, f, NULL, &out));
    return out;
}

static bool same_rows(fmb_pair *k, const drawn_set *s, const fmb_frames *set, char why[LAW_WHY])
{
    for (size_t i = 0; i < s->n; i++) {
        fmb_verdict out[MOST_FRAMES];
        must(fmb_frames_test_row(k, set, i, set, out));
        for (size_t j = 0; j < s->n; j++)
            if (out[j] != verdict_of(s, i, j))
                return law_broken(why, "one against many", (int)verdict_of(s, i, j), (int)out[j]);
    }
    return true;
}

/* Pairs that were told of. */
typedef struct told_pairs {
    bool meet[MOST_FRAMES][MOST_FRAMES], unknown;
} told_pairs;

static bool note_pairs(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair)
{
    told_pairs *t = self;
    t->unknown = t->unknown || verdict != FMB_FEASIBLE;
    for (size_t k = 0; k < n; k++)
        t->meet[pair[k].a][pair[k].b] = true;
    return true;
}

static bool same_meetings(fmb_pair *k, const drawn_set *s, const fmb_frames *set, char why[LAW_WHY])
{
    told_pairs t = {.unknown = false};
    must(fmb_frames_meet(k, set, NULL, note_pairs, &t));
    for (size_t i = 0; i < s->n; i++)
        for (size_t j = i + 1; j < s->n; j++)
            if (t.meet[i][j] != (s->verdict[i][j] == FMB_FEASIBLE))
                return law_broken(why, "all against all", (int)s->verdict[i][j], t.meet[i][j]);
    return !t.unknown || law_broken(why, "a pair is left open", 0, 1);
}

bool law_of_sets(law_source *g, char why[LAW_WHY])
{
    drawn_set s;
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    bool good = true;
    o.contact = (fmb_contact)law_draw(g, 0, 1);
    draw_set(g, &s);
    must(fmb_pair_new(s.dim, &o, NULL, &k));
    ask_pairs(k, &s);
    for (int scaled = 0; good && scaled < 2; scaled++) {
        fmb_frames *set = make_set(&s, scaled);
        good = same_rows(k, &s, set, why) && same_meetings(k, &s, set, why);
        fmb_frames_free(set);
    }
    fmb_pair_free(k);
    return good;
}
