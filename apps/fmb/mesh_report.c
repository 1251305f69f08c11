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

/* The state of a report. */
typedef struct report {
    const mesh_ask *ask;
    const fmb_mesh *a, *b;
    const fmb_mesh_answer *answer;
    fmb_pair *pair;     /* NULL: places are not requested */
    fmb_solver *solver; /* NULL: neither are common points, or distances */
    bool grouped;       /* cells of one or both are of groups with names */
    bool measures;      /* distances of cells that are apart are requested */
} report;

/* Lower, upper; x, y, z, t. */
typedef struct place_of_hit {
    char *end[8];
    int intervals;          /* 0: not known */
    fmb_generators *common; /* or NULL */
    near_found near;        /* its distance, or nothing */
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

static fmb_status ask_exactly(const report *r, const fmb_mesh_hit *h, const fmb_frame *p,
                              const fmb_frame *q, place_of_hit *out)
{
    const fmb_frame both[2] = {*p, *q};
    fmb_status st = FMB_OK;
    if (r->ask->common)
        st = fmb_common(r->solver, both, &out->common, NULL);
    if (st == FMB_OK && r->measures && h->how == FMB_MESH_APART)
        st = fmb_distance(r->solver, both, FMB_NORM_EUCLIDEAN, &out->near.distance, NULL);
    return st;
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
    fmb_status st = r->solver ? ask_exactly(r, h, &p, &q, out) : FMB_OK;
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
    near_clear(&p->near);
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
    return r->ask->moves && h->how != FMB_MESH_APART ? "meet" : fmb_mesh_how_text(h->how);
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

static void print_groups_as_json(const report *r, const fmb_mesh_hit *h)
{
    if (!r->grouped)
        return;
    fputs(", \"groups\": [", stdout);
    print_group_as_json(fmb_mesh_group(r->a, h->a));
    fputs(", ", stdout);
    print_group_as_json(fmb_mesh_group(r->b, h->b));
    putchar(']');
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
    near_print(&(near_ask){.digits = r->ask->digits}, &p->near, stdout);
}

static void print_hit_as_csv(const report *r, const fmb_mesh_hit *h, const place_of_hit *p)
{
    printf("%s,%zu,%zu,%d", word_of(r, h), fmb_mesh_face(r->a, h->a), fmb_mesh_face(r->b, h->b),
           h->shared);
    for (int i = 0; r->pair && i < (r->ask->moves ? 8 : 6); i++)
        printf(",%s", i < 2 * p->intervals ? p->end[i] : "");
    if (r->measures) {
        double length = fmb_proximity_length(p->near.distance);
        char *text = app_show_double(length, 0, APP_NEAREST);
        printf(",%s", text);
        free(text);
    }
    fputs(r->ask->common ? "," : "", stdout);
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
    near_print_json(&(near_ask){.digits = r->ask->digits}, &p->near, stdout);
    if (p->common) {
        fputs(", \"points\": [", stdout);
        put_points(r->ask, p->common, &(point_style){"[", ", ", "]", ", "});
        putchar(']');
    }
    print_groups_as_json(r, h);
    putchar('}');
}

/* ---- what stands around ---------------------------------------------------------------------- */

static size_t count_apart(const report *r)
{
    size_t n = 0;
    for (size_t i = 0; i < r->answer->hits; i++)
        n += r->answer->hit[i].how == FMB_MESH_APART;
    return n;
}

static void print_counts(const report *r)
{
    size_t of[FMB_MESH_COPLANAR + 1] = {0};
    for (size_t i = 0; i < r->answer->hits; i++)
        of[r->answer->hit[i].how]++;
    printf("%zu and %zu cells, %" PRIu64 " pairs tested: %zu meet", fmb_mesh_cells(r->a),
           fmb_mesh_cells(r->b), r->answer->tested, r->answer->hits - of[FMB_MESH_APART]);
    for (int k = FMB_MESH_COPLANAR; !r->ask->moves && k > FMB_MESH_APART; k--)
        if (of[k] > 0)
            printf(", %zu %s", of[k], fmb_mesh_how_text((fmb_mesh_how)k));
    if (r->ask->within)
        printf("; %zu near", of[FMB_MESH_APART]);
    putchar('\n');
}

static void print_csv_head(const report *r)
{
    printf("how,a,b,common%s%s%s%s%s\n",
           r->pair ? ",x_lower,x_upper,y_lower,y_upper,z_lower,z_upper" : "",
           r->pair && r->ask->moves ? ",t_lower,t_upper" : "", r->measures ? ",distance" : "",
           r->ask->common ? ",points" : "", r->grouped ? ",group_a,group_b" : "");
}

static void print_mesh_as_json(const char *key, const fmb_mesh *m)
{
    printf("  \"%s\": {\"cells\": %zu, \"vertices\": %zu, \"corners\": %d},\n", key,
           fmb_mesh_cells(m), fmb_mesh_vertices(m), fmb_mesh_corners(m));
}

static void print_json_of_both(const report *r, fmb_stop stop, uint64_t tested)
{
    puts("{");
    print_mesh_as_json("A", r->a);
    print_mesh_as_json("B", r->b);
    printf("  \"stop\": \"%s\",\n  \"tested\": %" PRIu64 ",\n", fmb_stop_text(stop), tested);
}

static void print_json_head(const report *r)
{
    print_json_of_both(r, r->answer->stop, r->answer->tested);
    if (r->ask->within)
        printf("  \"within\": \"%s\",\n  \"near\": %zu,\n", r->ask->within, count_apart(r));
    printf("  \"meet\": %zu,\n  \"hits\": [", r->answer->hits - count_apart(r));
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
    r.measures = ask->where && ask->within;
    fmb_pair_options o = {.size = sizeof o};
    fmb_status st = FMB_OK;
    o.tightest = true;
    if (ask->where)
        st = fmb_pair_new(3, &o, NULL, &r.pair);
    if (st == FMB_OK && (ask->common || r.measures))
        st = fmb_solver_new(NULL, NULL, &r.solver);
    if (st == FMB_OK)
        st = print_report(&r);
    fmb_pair_free(r.pair);
    fmb_solver_free(r.solver);
    if (st != FMB_OK)
        return app_status_error(st);
    return app_stop_asked() ? APP_UNDECIDED : code;
}

/* ---- the distance ---------------------------------------------------------------------------- */

static void print_nearest(const report *r, const fmb_mesh_nearest *n, const near_found *found)
{
    const fmb_mesh_hit h = {.a = n->a, .b = n->b};
    if (found->distance) {
        printf("nearest  %zu %zu", fmb_mesh_face(r->a, h.a), fmb_mesh_face(r->b, h.b));
        if (r->grouped)
            print_groups(r, &h);
        putchar('\n');
        near_print(&r->ask->near, found, stdout);
    }
    printf("%zu and %zu cells, %" PRIu64 " pairs tested\n", fmb_mesh_cells(r->a),
           fmb_mesh_cells(r->b), n->tested);
}

static void print_nearest_as_json(const report *r, const fmb_mesh_nearest *n,
                                  const near_found *found)
{
    const fmb_mesh_hit h = {.a = n->a, .b = n->b};
    print_json_of_both(r, n->stop, n->tested);
    fputs("  \"nearest\": ", stdout);
    if (found->distance) {
        printf("{\"a\": %zu, \"b\": %zu", fmb_mesh_face(r->a, h.a), fmb_mesh_face(r->b, h.b));
        near_print_json(&r->ask->near, found, stdout);
        print_groups_as_json(r, &h);
        puts("}\n}");
    } else {
        puts("null\n}");
    }
}

/* The row is that of the frames whose distance it is. */
static fmb_status find_row(const report *r, const fmb_mesh_nearest *n, fmb_system **row)
{
    double number[2][12];
    const fmb_frame f[2] = {
        frame_of_cell(r->a, n->a, NULL, number[0]),
        frame_of_cell(r->b, n->b, r->ask->moves ? r->ask->motion : NULL, number[1])};
    return fmb_separate(r->solver, f, FMB_CONTACT_CLOSED, row, NULL);
}

int mesh_report_nearest(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                        const fmb_mesh_nearest *nearest, int code)
{
    report r = {.ask = ask, .a = a, .b = b, .grouped = has_groups(a) || has_groups(b)};
    near_found found = {.distance = nearest->distance};
    fmb_status st = fmb_solver_new(NULL, NULL, &r.solver);
    if (st == FMB_OK && found.distance)
        st = find_row(&r, nearest, &found.row);
    if (st == FMB_OK)
        (ask->json ? print_nearest_as_json : print_nearest)(&r, nearest, &found);
    fmb_system_free(found.row);
    fmb_solver_free(r.solver);
    return st == FMB_OK ? code : app_status_error(st);
}
