/* peer_normaliz.cpp: Normaliz, which has a C++ interface only.
 *
 * On the cone { (t, x): A x <= b t, t >= 0 }: its extreme rays and maximal subspace, their
 * coordinates that go dropped, support hyperplanes of the cone over the rest; the projection is the
 * slice t = 1. (Normaliz's own ProjectCone starts from the extreme rays as well: it takes as long,
 * and refuses the cone { 0 }.)
 *
 * Outside the clock: the cone, built of inequalities and equations (GMP integers; Normaliz tries
 * 64-bit ones first). Inside: the computation. One thread. No strict rows.
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
    Table inequalities, equations;
    size_t n, keep;
    Cone *cone;
    Table facets, hull; /* the projection: rows >= 0, rows = 0 */
    bool empty;         /* no generators at all */
};

/* (b, -a), >= 0 or = 0 */
std::vector<mpz_class> homogeneous(const problem_row &r, size_t n)
{
    std::vector<mpz_class> row(n + 1);
    row[0] = mpz_class(r.a[n]);
    for (size_t j = 0; j < n; j++)
        row[j + 1] = -mpz_class(r.a[j]);
    return row;
}

void *open_cone(const problem *p, const peer_setup *)
{
    if (p->strict)
        return nullptr;
    libnormaliz::setVerboseDefault(false);
    libnormaliz::set_thread_limit(1);
    State *s = new State{};
    s->n = static_cast<size_t>(p->n);
    s->keep = static_cast<size_t>(p->keep);
    for (size_t i = 0; i < p->m; i++) {
        Table &to = p->rows[i].rel == FMB_EQ ? s->equations : s->inequalities;
        to.push_back(homogeneous(p->rows[i], s->n));
    }
    std::vector<mpz_class> positive(s->n + 1);
    positive[0] = 1;
    s->inequalities.push_back(positive);
    return s;
}

void ready_cone(void *self)
{
    State *s = static_cast<State *>(self);
    delete s->cone;
    s->cone =
        new Cone(InputType::inequalities, s->inequalities, InputType::equations, s->equations);
}

Table shortened(const Table &rows, size_t width)
{
    Table out;
    for (const auto &row : rows)
        out.emplace_back(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(width));
    return out;
}

bool project_cone(void *self)
try {
    State *s = static_cast<State *>(self);
    s->cone->compute(Property::ExtremeRays, Property::MaximalSubspace);
    Table rays = shortened(s->cone->getExtremeRays(), s->keep + 1);
    Table lines = shortened(s->cone->getMaximalSubspace(), s->keep + 1);
    s->empty = rays.empty() && lines.empty();
    if (s->empty)
        return true;
    Cone shadow(InputType::cone, rays, InputType::subspace, lines);
    shadow.compute(Property::SupportHyperplanes);
    s->facets = shadow.getSupportHyperplanes();
    s->hull = shadow.getEquations();
    return true;
} catch (const std::exception &) {
    return false;
}

void add_rows(fmb_system *out, const Table &rows, size_t keep, fmb_rel rel)
{
    mpz_t *a = integers_new(keep + 1);
    for (const auto &row : rows) {
        for (size_t j = 0; j < keep; j++)
            mpz_neg(a[j], row[j + 1].get_mpz_t());
        mpz_set(a[keep], row[0].get_mpz_t());
        system_add_row(out, a, rel);
    }
    integers_free(a, keep + 1);
}

fmb_system *fetch_slice(void *self)
{
    State *s = static_cast<State *>(self);
    fmb_system *out = system_of_dim(static_cast<int>(s->keep));
    Table nothing(1, std::vector<mpz_class>(s->keep + 1));
    nothing[0][0] = -1;
    add_rows(out, s->empty ? nothing : s->facets, s->keep, FMB_LE);
    if (!s->empty)
        add_rows(out, s->hull, s->keep, FMB_EQ);
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
    p.project = project_cone;
    p.fetch = fetch_slice;
    p.close = close_cone;
    return p;
}

} // namespace

const peer peer_normaliz = make_peer();
