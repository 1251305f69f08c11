/* mesh_report.c: cells that meet as text, as CSV, and as one JSON object. */
#include <inttypes.h>

#include "fmb/mesh_ask.h"

/* Hits of each kind. */
typedef struct tally {
    size_t of[FMB_MESH_COPLANAR + 1];
} tally;

static tally count_kinds(const fmb_mesh_answer *answer)
{
    tally t = {{0}};
    for (size_t i = 0; i < answer->hits; i++)
        t.of[answer->hit[i].how]++;
    return t;
}

static const char *word_of(const mesh_ask *ask, const fmb_mesh_hit *h)
{
    return ask->moves ? "meet" : fmb_mesh_how_text(h->how);
}

static void print_text(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                       const fmb_mesh_answer *answer)
{
    for (size_t i = 0; i < answer->hits; i++) {
        const fmb_mesh_hit *h = &answer->hit[i];
        printf("%-8s %zu %zu", word_of(ask, h), fmb_mesh_face(a, h->a), fmb_mesh_face(b, h->b));
        printf(h->shared > 0 ? " (%d common)\n" : "\n", h->shared);
    }
    tally t = count_kinds(answer);
    printf("%zu and %zu cells, %" PRIu64 " pairs tested: %zu meet", fmb_mesh_cells(a),
           fmb_mesh_cells(b), answer->tested, answer->hits);
    for (int k = FMB_MESH_COPLANAR; !ask->moves && k > FMB_MESH_APART; k--)
        if (t.of[k] > 0)
            printf(", %zu %s", t.of[k], fmb_mesh_how_text((fmb_mesh_how)k));
    printf(answer->stop == FMB_STOP_DONE ? "\n" : "; stopped (%s)\n", fmb_stop_text(answer->stop));
}

static void print_csv(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                      const fmb_mesh_answer *answer)
{
    puts("how,a,b,common");
    for (size_t i = 0; i < answer->hits; i++) {
        const fmb_mesh_hit *h = &answer->hit[i];
        printf("%s,%zu,%zu,%d\n", word_of(ask, h), fmb_mesh_face(a, h->a), fmb_mesh_face(b, h->b),
               h->shared);
    }
}

static void print_mesh_json(const char *key, const fmb_mesh *m)
{
    printf("  \"%s\": {\"cells\": %zu, \"vertices\": %zu, \"corners\": %d},\n", key,
           fmb_mesh_cells(m), fmb_mesh_vertices(m), fmb_mesh_corners(m));
}

static void print_json(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                       const fmb_mesh_answer *answer)
{
    puts("{");
    print_mesh_json("A", a);
    print_mesh_json("B", b);
    printf("  \"stop\": \"%s\",\n  \"tested\": %" PRIu64 ",\n  \"meet\": %zu,\n  \"hits\": [",
           fmb_stop_text(answer->stop), answer->tested, answer->hits);
    for (size_t i = 0; i < answer->hits; i++) {
        const fmb_mesh_hit *h = &answer->hit[i];
        printf("%s\n    {\"how\": \"%s\", \"a\": %zu, \"b\": %zu, \"common\": %d}",
               i > 0 ? "," : "", word_of(ask, h), fmb_mesh_face(a, h->a), fmb_mesh_face(b, h->b),
               h->shared);
    }
    puts(answer->hits > 0 ? "\n  ]\n}" : "]\n}");
}

void mesh_report(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                 const fmb_mesh_answer *answer)
{
    if (ask->json)
        print_json(ask, a, b, answer);
    else if (ask->csv)
        print_csv(ask, a, b, answer);
    else
        print_text(ask, a, b, answer);
}
