/* cones_normaliz.cpp: Normaliz, on the cone over the polyhedron: extreme rays and maximal subspace
 * of { (t, x): A x <= b t, t >= 0 }, or support hyperplanes and equations of what generators span.
 * Outside the clock: the cone. One thread; GMP integers, 64-bit ones first. */
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
    size_t n;
    bool hull;
    Cone *cone;
    Table halves, wholes; /* the answer: (t, x) */
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

bool convert_cone(void *self)
try {
    State *s = static_cast<State *>(self);
    if (s->hull) {
        s->cone->compute(Property::SupportHyperplanes);
        s->halves = s->cone->getSupportHyperplanes();
        s->wholes = s->cone->getEquations();
    } else {
        s->cone->compute(Property::ExtremeRays, Property::MaximalSubspace);
        s->halves = s->cone->getExtremeRays();
        s->wholes = s->cone->getMaximalSubspace();
    }
    return true;
} catch (const std::exception &) {
    return false;
}

void add_rows(const State *s, fmb_system *out, const Table &rows, fmb_rel rel)
{
    mpz_t *a = integers_new(s->n + 1);
    for (const auto &row : rows) {
        for (size_t j = 0; j < s->n; j++) {
            mpz_set(a[j], row[j + 1].get_mpz_t());
            if (s->hull)
                mpz_neg(a[j], a[j]);
        }
        mpz_set(a[s->n], row[0].get_mpz_t());
        system_add_row(out, a, rel);
    }
    integers_free(a, s->n + 1);
}

fmb_system *fetch_list(void *self)
{
    State *s = static_cast<State *>(self);
    fmb_system *out = system_of_dim(static_cast<int>(s->n));
    add_rows(s, out, s->halves, FMB_LE);
    add_rows(s, out, s->wholes, FMB_EQ);
    return out;
}

void close_cone(void *self)
{
    State *s = static_cast<State *>(self);
    delete s->cone;
    delete s;
}

peer make_peer()
{
    peer p = {};
    p.name = p.library = "normaliz";
    p.open = open_cone;
    p.ready = ready_cone;
    p.vertices = p.hull = convert_cone;
    p.fetch = fetch_list;
    p.close = close_cone;
    return p;
}

} // namespace

const peer peer_normaliz_cones = make_peer();
