/* peer_pplite.cpp: PPLite, the fastest published double description (Becchi, Zaffanella 2020,
 * doi 10.1016/j.ic.2020.104620).
 *
 * Outside the clock: the constraints, and for each run a fresh polyhedron they are pending in
 * (NNC if a row is strict). Inside: remove_higher_space_dims, then minimized constraints.
 */
#include <pplite/pplite.hh>

extern "C" {
#include "peers.h"
}

namespace
{

struct State {
    pplite::Cons rows;
    pplite::Poly body;
    pplite::dim_type n, keep;
    pplite::Topol topology;
    bool empty; /* the result has no point */
};

/* b - a.x >= 0, > 0 or = 0 */
pplite::Con constraint(const problem_row &r, pplite::dim_type n)
{
    using pplite::Con;
    pplite::Linear_Expr e(n);
    for (pplite::dim_type j = 0; j < n; j++) {
        e[j] = pplite::Integer(r.a[j]);
        neg_assign(e[j]);
    }
    return Con(e, pplite::Integer(r.a[n]),
               r.rel == FMB_EQ   ? Con::EQUALITY
               : r.rel == FMB_LT ? Con::STRICT_INEQUALITY
                                 : Con::NONSTRICT_INEQUALITY);
}

void *open_pplite(const problem *p, const peer_setup *)
{
    State *s = new State{};
    s->n = static_cast<pplite::dim_type>(p->n);
    s->keep = static_cast<pplite::dim_type>(p->keep);
    s->topology = p->strict ? pplite::Topol::NNC : pplite::Topol::CLOSED;
    for (size_t i = 0; i < p->m; i++)
        s->rows.push_back(constraint(p->rows[i], s->n));
    return s;
}

void ready_pplite(void *self)
{
    State *s = static_cast<State *>(self);
    s->body = pplite::Poly(s->n, pplite::Spec_Elem::UNIVERSE, s->topology);
    s->body.add_cons(s->rows);
}

bool project_pplite(void *self)
{
    State *s = static_cast<State *>(self);
    s->body.remove_higher_space_dims(s->keep);
    s->body.minimize();
    s->empty = s->body.is_empty();
    return true;
}

fmb_system *fetch_pplite(void *self)
{
    State *s = static_cast<State *>(self);
    fmb_system *out = system_of_dim(static_cast<int>(s->keep));
    mpz_t *a = integers_new(s->keep + 1);
    mpz_set_si(a[s->keep], -1);
    if (s->empty)
        system_add_row(out, a, FMB_LE);
    for (const pplite::Con &c : s->empty ? pplite::Cons() : s->body.copy_cons()) {
        for (pplite::dim_type j = 0; j < s->keep; j++) {
            c.coeff(pplite::Var(j)).get_mpz(a[j]);
            mpz_neg(a[j], a[j]);
        }
        c.inhomo_term().get_mpz(a[s->keep]);
        system_add_row(out, a,
                       c.is_equality()            ? FMB_EQ
                       : c.is_strict_inequality() ? FMB_LT
                                                  : FMB_LE);
    }
    integers_free(a, s->keep + 1);
    return out;
}

void close_pplite(void *self)
{
    delete static_cast<State *>(self);
}

peer make_peer()
{
    peer p = {};
    p.name = p.library = "pplite";
    p.open = open_pplite;
    p.ready = ready_pplite;
    p.project = project_pplite;
    p.fetch = fetch_pplite;
    p.close = close_pplite;
    return p;
}

} // namespace

const peer peer_pplite = make_peer();
