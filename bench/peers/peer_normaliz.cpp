/* peer_normaliz.cpp: Normaliz, which has a C++ interface only.
 *
 * On the cone { (t, x): A x <= b t, t >= 0 }: its extreme rays and maximal subspace, or support
 * hyperplanes and equations of the span of generators. A projection: drop the eliminated
 * coordinates of rays and subspace, then support hyperplanes of the cone that they span, whose
 * slice t = 1 is the projection. (Normaliz's own ProjectCone starts from the extreme rays as well:
 * it takes as long, and refuses the cone { 0 }.)
 *
 * Outside the clock: the cone, built of inequalities and equations, or of rays and lines (GMP
 * integers; Normaliz tries 64-bit ones first). Inside: the computation. One thread. No strict rows.
 */
#include <libnormaliz/libnormaliz.h>

#include <gmpxx.h>

extern "C" {
#include "peers.h"
}

namespace
{

using Cone = libnormaliz::Cone<mpz_class>;
using Table = std::vector<std::vector<mpz_class>>;
using libnormaliz::Type::InputType;
namespace Property = libnormaliz::ConeProperty;

struct State {
    Table inequalities, equations; /* or rays, lines */
    size_t n, keep;
    bool hull;
    Cone *cone;
    Table halves, wholes; /* the answer: (t, x), perhaps x's kept part only */
    bool are_rows;        /* the answer is rows >= 0, = 0; else rays and lines */
};

/* (b, -a) >= 0 or = 0; (t, x) */
std::vector<mpz_class> homogeneous(const problem_row &r, size_t n, bool hull)
{
    std::vector<mpz_class> row(n + 1);
    row[0] = mpz_class(r.a[n]);
    for (size_t j = 0; j < n; j++)
        row[j + 1] = hull ? mpz_class(r.a[j]) : mpz_class(-mpz_class(r.a[j]));
    return row;
}

void *open_cone(const problem *p, const peer_setup *setup)
{
    if (p->strict)
        return nullptr;
    libnormaliz::setVerboseDefault(false);
    libnormaliz::set_thread_limit(1);
    State *s = new State{};
    s->n = static_cast<size_t>(p->n);
    s->keep = static_cast<size_t>(p->keep);
    s->hull = setup->question == PEER_HULL;
    for (size_t i = 0; i < p->m; i++) {
        Table &to = p->rows[i].rel == FMB_EQ ? s->equations : s->inequalities;
        to.push_back(homogeneous(p->rows[i], s->n, s->hull));
    }
    std::vector<mpz_class> positive(s->n + 1);
    positive[0] = 1;
    if (!s->hull)
        s->inequalities.push_back(positive);
    return s;
}

void ready_cone(void *self)
{
    State *s = static_cast<State *>(self);
    delete s->cone;
    s->cone = new Cone(s->hull ? InputType::cone : InputType::inequalities, s->inequalities,
                       s->hull ? InputType::subspace : InputType::equations, s->equations);
}

/* ---- answers --------------------------------------------------------------------------------- */

void find_rays(State *s)
{
    s->cone->compute(Property::ExtremeRays, Property::MaximalSubspace);
    s->halves = s->cone->getExtremeRays();
    s->wholes = s->cone->getMaximalSubspace();
    s->are_rows = false;
}

void find_rows(State *s, Cone *cone)
{
    cone->compute(Property::SupportHyperplanes);
    s->halves = cone->getSupportHyperplanes();
    s->wholes = cone->getEquations();
    s->are_rows = true;
}

bool convert_cone(void *self)
try {
    State *s = static_cast<State *>(self);
    if (s->hull)
        find_rows(s, s->cone);
    else
        find_rays(s);
    return true;
} catch (const std::exception &) {
    return false;
}

void shorten(Table &rows, size_t width)
{
    for (auto &row : rows)
        row.resize(width);
}

/* Without any generators the projection is empty: -1 >= 0. */
bool project_cone(void *self)
try {
    State *s = static_cast<State *>(self);
    find_rays(s);
    shorten(s->halves, s->keep + 1);
    shorten(s->wholes, s->keep + 1);
    if (s->halves.empty() && s->wholes.empty()) {
        s->halves.emplace_back(s->keep + 1);
        s->halves[0][0] = -1;
        s->are_rows = true;
        return true;
    }
    Cone shadow(InputType::cone, s->halves, InputType::subspace, s->wholes);
    find_rows(s, &shadow);
    return true;
} catch (const std::exception &) {
    return false;
}

void add_rows(const State *s, fmb_system *out, const Table &rows, fmb_rel rel)
{
    size_t n = static_cast<size_t>(fmb_system_dim(out));
    mpz_t *a = integers_new(n + 1);
    for (const auto &row : rows) {
        for (size_t j = 0; j < n; j++) {
            mpz_set(a[j], row[j + 1].get_mpz_t());
            if (s->are_rows)
                mpz_neg(a[j], a[j]);
        }
        mpz_set(a[n], row[0].get_mpz_t());
        system_add_row(out, a, rel);
    }
    integers_free(a, n + 1);
}

fmb_system *fetch(const State *s, size_t n)
{
    fmb_system *out = system_of_dim(static_cast<int>(n));
    add_rows(s, out, s->halves, FMB_LE);
    add_rows(s, out, s->wholes, FMB_EQ);
    return out;
}

fmb_system *fetch_list(void *self)
{
    State *s = static_cast<State *>(self);
    return fetch(s, s->n);
}

fmb_system *fetch_slice(void *self)
{
    State *s = static_cast<State *>(self);
    return fetch(s, s->keep);
}

void close_cone(void *self)
{
    State *s = static_cast<State *>(self);
    delete s->cone;
    delete s;
}

/* ---- what they are asked --------------------------------------------------------------------- */

peer make_peer(fmb_system *(*fetch_answer)(void *))
{
    peer p = {};
    p.name = p.library = "normaliz";
    p.open = open_cone;
    p.ready = ready_cone;
    p.fetch = fetch_answer;
    p.close = close_cone;
    return p;
}

peer make_projector()
{
    peer p = make_peer(fetch_slice);
    p.project = project_cone;
    return p;
}

peer make_converter()
{
    peer p = make_peer(fetch_list);
    p.vertices = p.hull = convert_cone;
    return p;
}

} // namespace

const peer peer_normaliz = make_projector(), peer_normaliz_cones = make_converter();
