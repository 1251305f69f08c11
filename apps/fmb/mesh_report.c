/* mesh_report.c: cells that meet as text, as CSV, and as one JSON object. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/pair.h>
#include <fmb/proximity.h>

#include "common/message.h"
#include "common/text.h"
#include "fmb/mesh_ask.h"
#include "fmb/show.h"
#include "fmb/stop.h"

/* A report on its way. */
typedef struct report {
    const mesh_ask *ask;
    const fmb_mesh *a, *b;
    const fmb_mesh_answer *answer;
    fmb_pair *pair;     /* NULL: nobody asks where */
    fmb_solver *solver; /* NULL: nor for all common points */
    bool grouped;       /* cells of one or both are of groups with names */
} report;

/* Lower, upper; x, y, z, t. */
typedef struct place_of_hit {
    char *end[8];
    int intervals;          /* 0: not known */
    fmb_generators *common; /* or NULL */
} place_of_hit;

/* ---- where ----------------------------------------------------------------------------------- */

/* A cell as a frame by its corners; number holds 12. */
static fmb_frame frame_of_cell(const fmb_mesh *m, size_t c, const double *speed, double *number)
{
    size_t corners = (size_t)fmb_mesh_corners(m);
    for (size_t k = 0; k < corners; k++)
        memcpy(number + 3 * k,
               fmb_mesh_points(m) + 3 * (size_t)fmb_mesh_indices(m)[c * corners + k],
               3 * sizeof *number);
    return (fmb_frame){.shape = FMB_SIMPLEX_BY_CORNERS,
                       .dim = 3,
                       .naxes = (int)corners - 1,
                       .origin = number,
                       .axes = number + 3,
                       .speed = speed};
}

static fmb_status common_points(const report *r, const fmb_frame *p, const fmb_frame *q,
                                place_of_hit *out)
{
    const fmb_frame both[2] = {*p, *q};
    return fmb_common(r->solver, both, &out->common, NULL);
}

static fmb_status find_place(const report *r, const fmb_mesh_hit *h, place_of_hit *out)
{
    double number[2][12], ends[8];
    int digits = r->ask->json ? 0 : r->ask->digits; /* JSON's doubles are decimals already */
    const double *motion = r->ask->moves ? r->ask->motion : NULL;
    fmb_frame p = frame_of_cell(r->a, h->a, NULL, number[0]);
    fmb_frame q = frame_of_cell(r->b, h->b, motion, number[1]);
    fmb_verdict v;
    fmb_pair_answers answers = {
        .size = sizeof answers, .verdict = &v, .world = ends, .time = ends + 6};
    *out = (place_of_hit){.intervals = 0};
    fmb_status st = r->solver ? common_points(r, &p, &q, out) : FMB_OK;
    if (st != FMB_OK || !r->pair)
        return st;
    st = fmb_pair_test(r->pair, 1, &p, &q, &answers);
    if (st == FMB_OK && v == FMB_FEASIBLE)
        out->intervals = motion ? 4 : 3;
    for (int i = 0; i < 2 * out->intervals; i++)
        out->end[i] = app_show_double(ends[i], digits, i % 2 == 0 ? APP_DOWN : APP_UP);
    return st;
}

static void forget_place(place_of_hit *p)
{
    for (int i = 0; i < 2 * p->intervals; i++)
        free(p->end[i]);
    fmb_generators_free(p->common);
}

/* ---- common points --------------------------------------------------------------------------- */

/* Coordinate j of point i: "p/q", ~0.333333; in JSON as a string, or an object. */
static void put_coordinate(const mesh_ask *ask, const fmb_generators *g, size_t i, int j)
{
    mpq_t q;
    mpq_init(q);
    fmb_generators_coordinate_q(g, i, j, q);
    if (ask->json) {
        json_t *number = app_json_number(q, ask->digits, APP_NEAREST);
        json_dumpf(number, stdout, JSON_ENCODE_ANY);
        json_decref(number);
    } else {
        char *text = app_number(q, ask->digits, APP_NEAREST);
        fputs(text, stdout);
        free(text);
    }
    mpq_clear(q);
}

/* All points, with texts before, between and behind their coordinates, and between points. */
typedef struct point_style {
    const char *open, *between, *close, *next;
} point_style;

static void put_points(const mesh_ask *ask, const fmb_generators *g, const point_style *style)
{
    for (size_t i = 0; i < fmb_generators_size(g); i++) {
        fputs(i > 0 ? style->next : "", stdout);
        fputs(style->open, stdout);
        for (int j = 0; j < fmb_generators_dim(g); j++) {
            fputs(j > 0 ? style->between : "", stdout);
            put_coordinate(ask, g, i, j);
        }
        fputs(style->close, stdout);
    }
}

/* ---- a hit ----------------------------------------------------------------------------------- */

static const char *word_of(const report *r, const fmb_mesh_hit *h)
{
    return r->ask->moves ? "meet" : fmb_mesh_how_text(h->how);
}

static bool has_groups(const fmb_mesh *m)
{
    size_t c = 0;
    while (c < fmb_mesh_cells(m) && !fmb_mesh_group(m, c))
        c++;
    return c < fmb_mesh_cells(m);
}

/* A name between quotes, each of which within it is written as `inner`; nothing without a name. */
static void put_group(const char *name, app_text_use use, const char *inner)
{
    char *text = name ? app_text(name, use) : NULL;
    for (const char *p = text; p && *p; p++) {
        fputs(p == text ? "\"" : "", stdout);
        if (*p == '"')
            fputs(inner, stdout);
        else
            putchar(*p);
    }
    fputs(text ? "\"" : "", stdout);
    free(text);
}

static void print_groups(const report *r, const fmb_mesh_hit *h)
{
    const char *a = fmb_mesh_group(r->a, h->a), *b = fmb_mesh_group(r->b, h->b);
    fputs(a || b ? " of " : "", stdout);
    fputs(a ? "" : b ? "none" : "", stdout);
    put_group(a, APP_TEXT_TERMINAL, "\\\"");
    fputs(a || b ? " and " : "", stdout);
    put_group(b, APP_TEXT_TERMINAL, "\\\"");
    fputs(a && !b ? "none" : "", stdout);
}

static void print_group_as_json(const char *name)
{
    char *text = name ? app_text(name, APP_TEXT_JSON) : NULL;
    json_t *value = app_need(text ? json_string(text) : json_null());
    json_dumpf(value, stdout, JSON_ENCODE_ANY);
    json_decref(value);
    free(text);
}

static void print_hit(const report *r, const fmb_mesh_hit *h, const place_of_hit *p)
{
    static const char *const before[] = {" in", " x", " x", " at"};
    printf("%-8s %zu %zu", word_of(r, h), fmb_mesh_face(r->a, h->a), fmb_mesh_face(r->b, h->b));
    if (h->shared > 0)
        printf(" (%d common)", h->shared);
    if (r->grouped)
        print_groups(r, h);
    for (int i = 0; i < p->intervals; i++)
        printf("%s [%s, %s]", before[i], p->end[2 * i], p->end[2 * i + 1]);
    if (p->common)
        put_points(r->ask, p->common, &(point_style){" (", ", ", ")", ""});
    putchar('\n');
}

static void print_hit_as_csv(const report *r, const fmb_mesh_hit *h, const place_of_hit *p)
{
    printf("%s,%zu,%zu,%d", word_of(r, h), fmb_mesh_face(r->a, h->a), fmb_mesh_face(r->b, h->b),
           h->shared);
    for (int i = 0; i < 2 * p->intervals; i++)
        printf(",%s", p->end[i]);
    fputs(r->solver ? "," : "", stdout);
    if (p->common)
        put_points(r->ask, p->common, &(point_style){"", " ", "", ";"});
    for (int i = 0; r->grouped && i < 2; i++) {
        putchar(',');
        put_group(i == 0 ? fmb_mesh_group(r->a, h->a) : fmb_mesh_group(r->b, h->b), APP_TEXT_JSON,
                  "\"\"");
    }
    putchar('\n');
}

static void print_hit_as_json(const report *r, const fmb_mesh_hit *h, const place_of_hit *p)
{
    printf("%s\n    {\"how\": \"%s\", \"a\": %zu, \"b\": %zu, \"common\": %d",
           h == r->answer->hit ? "" : ",", word_of(r, h), fmb_mesh_face(r->a, h->a),
           fmb_mesh_face(r->b, h->b), h->shared);
    for (int i = 0; i < p->intervals; i++)
        printf("%s[%s, %s]",
               i == 0   ? ", \"world\": ["
               : i == 3 ? "], \"time\": "
                        : ", ",
               p->end[2 * i], p->end[2 * i + 1]);
    fputs(p->intervals == 3 ? "]" : "", stdout);
    if (p->common) {
        fputs(", \"points\": [", stdout);
        put_points(r->ask, p->common, &(point_style){"[", ", ", "]", ", "});
        putchar(']');
    }
    if (r->grouped) {
        fputs(", \"groups\": [", stdout);
        print_group_as_json(fmb_mesh_group(r->a, h->a));
        fputs(", ", stdout);
        print_group_as_json(fmb_mesh_group(r->b, h->b));
        putchar(']');
    }
    putchar('}');
}

/* ---- what stands around ---------------------------------------------------------------------- */

static void print_counts(const report *r)
{
    size_t of[FMB_MESH_COPLANAR + 1] = {0};
    for (size_t i = 0; i < r->answer->hits; i++)
        of[r->answer->hit[i].how]++;
    printf("%zu and %zu cells, %" PRIu64 " pairs tested: %zu meet", fmb_mesh_cells(r->a),
           fmb_mesh_cells(r->b), r->answer->tested, r->answer->hits);
    for (int k = FMB_MESH_COPLANAR; !r->ask->moves && k > FMB_MESH_APART; k--)
        if (of[k] > 0)
            printf(", %zu %s", of[k], fmb_mesh_how_text((fmb_mesh_how)k));
    putchar('\n');
}

static void print_csv_head(const report *r)
{
    printf("how,a,b,common%s%s%s%s\n",
           r->pair ? ",x_lower,x_upper,y_lower,y_upper,z_lower,z_upper" : "",
           r->pair && r->ask->moves ? ",t_lower,t_upper" : "", r->solver ? ",points" : "",
           r->grouped ? ",group_a,group_b" : "");
}

static void print_mesh_as_json(const char *key, const fmb_mesh *m)
{
    printf("  \"%s\": {\"cells\": %zu, \"vertices\": %zu, \"corners\": %d},\n", key,
           fmb_mesh_cells(m), fmb_mesh_vertices(m), fmb_mesh_corners(m));
}

static void print_json_head(const report *r)
{
    puts("{");
    print_mesh_as_json("A", r->a);
    print_mesh_as_json("B", r->b);
    printf("  \"stop\": \"%s\",\n  \"tested\": %" PRIu64 ",\n  \"meet\": %zu,\n  \"hits\": [",
           fmb_stop_text(r->answer->stop), r->answer->tested, r->answer->hits);
}

static void print_json_end(const report *r)
{
    puts(r->answer->hits > 0 ? "\n  ]\n}" : "]\n}");
}

/* ---- the report ------------------------------------------------------------------------------ */

/* One way to print it. head and end may be NULL. */
typedef struct manner {
    void (*head)(const report *r);
    void (*hit)(const report *r, const fmb_mesh_hit *h, const place_of_hit *p);
    void (*end)(const report *r);
} manner;

static fmb_status print_report(const report *r)
{
    static const manner text = {NULL, print_hit, print_counts},
                        csv = {print_csv_head, print_hit_as_csv, NULL},
                        json = {print_json_head, print_hit_as_json, print_json_end};
    const manner *m = r->ask->json ? &json : r->ask->csv ? &csv : &text;
    fmb_status st = FMB_OK;
    if (m->head)
        m->head(r);
    for (size_t i = 0; st == FMB_OK && i < r->answer->hits && !app_stop_asked(); i++) {
        place_of_hit p;
        st = find_place(r, &r->answer->hit[i], &p);
        if (st == FMB_OK)
            m->hit(r, &r->answer->hit[i], &p);
        forget_place(&p);
    }
    if (m->end)
        m->end(r);
    return st;
}

int mesh_report(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                const fmb_mesh_answer *answer, int code)
{
    report r = {.ask = ask, .a = a, .b = b, .answer = answer};
    r.grouped = has_groups(a) || has_groups(b);
    fmb_pair_options o = {.size = sizeof o};
    fmb_status st = FMB_OK;
    o.tightest = true;
    if (ask->where)
        st = fmb_pair_new(3, &o, NULL, &r.pair);
    if (st == FMB_OK && ask->common)
        st = fmb_solver_new(NULL, NULL, &r.solver);
    if (st == FMB_OK)
        st = print_report(&r);
    fmb_pair_free(r.pair);
    fmb_solver_free(r.solver);
    if (st != FMB_OK)
        return app_status_error(st);
    return app_stop_asked() ? APP_UNDECIDED : code;
}
