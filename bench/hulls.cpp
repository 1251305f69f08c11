/* hulls.cpp: convex hulls of 8 to 64 points in sets of frames, verdicts and contacts, beside
 * libccd's and FCL's GJK with EPA on the same pairs. usage: bench-hulls [PAIRS]
 *
 * A contact is a depth and its normal, for pairs that meet. Points are on spheres, or of small
 * integers, which touch. Times are this thread's CPU time, medians of passes in which ways take
 * turns [ns a pair]. An answer is wrong if its verdict is not the exact one, or the depth of a pair
 * that meets is off by more than 1e-6.
 */
#include <fcl/fcl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include <ccd/ccd.h>
#include <fmb/geometry.h>

namespace
{

using convex = fcl::Convex<double>;

enum { PASSES = 5 };

void must(fmb_status st)
{
    if (st != FMB_OK)
        std::exit(70);
}

struct hulls {
    int points;
    std::vector<double> x[2]; /* [pairs][points][3] */
    std::vector<fmb_frame> f[2];
    std::vector<std::unique_ptr<convex>> c[2];
};

/* The answers of a way; a depth is NaN if it gives none. */
struct answers {
    std::vector<fmb_verdict> verdict;
    std::vector<double> depth;
};

/* ---- pairs ----------------------------------------------------------------------------------- */

void draw_hull(std::mt19937_64 &g, bool whole, int points, std::vector<double> &out)
{
    std::uniform_real_distribution<double> real(-1, 1);
    double centre[3], x[3];
    for (double &at : centre)
        at = whole ? std::floor(4 * real(g)) : 1.2 * real(g);
    for (int i = 0; i < points; i++) {
        double length;
        do {
            for (double &at : x)
                at = real(g);
            length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        } while (length > 1 || length < 0.1);
        for (int j = 0; j < 3; j++)
            out.push_back(centre[j] + (whole ? std::round(3 * x[j]) : x[j] / length));
    }
}

hulls draw_pairs(std::size_t pairs, bool whole, int points)
{
    std::mt19937_64 g(static_cast<std::uint64_t>(points));
    hulls h;
    h.points = points;
    for (std::size_t i = 0; i < pairs; i++)
        for (auto &x : h.x)
            draw_hull(g, whole, points, x);
    for (int k = 0; k < 2; k++)
        for (std::size_t i = 0; i < pairs; i++) {
            const double *at = &h.x[k][i * static_cast<std::size_t>(points) * 3];
            h.f[k].push_back({FMB_SIMPLEX_BY_CORNERS, 3, points - 1, at, at + 3, nullptr});
            auto v = std::make_shared<std::vector<fcl::Vector3<double>>>();
            for (int p = 0; p < points; p++)
                v->emplace_back(at[3 * p], at[3 * p + 1], at[3 * p + 2]);
            /* support functions look at vertices alone, if there is no face */
            h.c[k].emplace_back(new convex(v, 0, std::make_shared<std::vector<int>>()));
        }
    return h;
}

/* ---- ways ------------------------------------------------------------------------------------ */

void ask_fmb(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, bool contact, answers &out)
{
    std::size_t n = out.verdict.size();
    static std::vector<double> normal;
    static std::vector<fmb_frames_pair> pair;
    normal.resize(3 * n);
    pair.resize(n);
    for (std::uint32_t i = 0; i < n; i++)
        pair[i] = {i, i};
    fmb_pair_answers to = {};
    to.size = sizeof to;
    to.verdict = out.verdict.data();
    if (contact) {
        to.depth = out.depth.data();
        to.normal = normal.data();
    }
    must(fmb_frames_test(k, a, b, n, pair.data(), &to));
}

struct cloud {
    const double *x;
    int n;
};

void support(const void *object, const ccd_vec3_t *way, ccd_vec3_t *out)
{
    const cloud *c = static_cast<const cloud *>(object);
    const double *best = c->x;
    double most = -INFINITY;
    for (int i = 0; i < c->n; i++) {
        const double *x = c->x + 3 * i;
        double at = x[0] * way->v[0] + x[1] * way->v[1] + x[2] * way->v[2];
        if (at > most) {
            most = at;
            best = x;
        }
    }
    ccdVec3Set(out, best[0], best[1], best[2]);
}

void ask_ccd(const hulls &h, bool contact, answers &out)
{
    ccd_t how;
    CCD_INIT(&how);
    how.support1 = how.support2 = support;
    how.max_iterations = 100;
    for (std::size_t i = 0; i < out.verdict.size(); i++) {
        cloud a = {h.f[0][i].origin, h.points}, b = {h.f[1][i].origin, h.points};
        ccd_real_t depth = NAN;
        ccd_vec3_t normal, place;
        bool meet = contact ? ccdGJKPenetration(&a, &b, &how, &depth, &normal, &place) == 0
                            : ccdGJKIntersect(&a, &b, &how) != 0;
        out.verdict[i] = meet ? FMB_FEASIBLE : FMB_INFEASIBLE;
        out.depth[i] = depth;
    }
}

void ask_fcl(const hulls &h, fcl::GJKSolverType solver, bool contact, answers &out)
{
    static const auto here = fcl::Transform3<double>::Identity();
    fcl::CollisionRequest<double> how;
    how.enable_contact = contact;
    how.num_max_contacts = 1;
    how.gjk_solver_type = solver;
    for (std::size_t i = 0; i < out.verdict.size(); i++) {
        fcl::CollisionResult<double> found;
        out.verdict[i] = FMB_UNKNOWN;
        try {
            fcl::collide(h.c[0][i].get(), here, h.c[1][i].get(), here, how, found);
            out.verdict[i] = found.isCollision() ? FMB_FEASIBLE : FMB_INFEASIBLE;
            out.depth[i] =
                contact && found.isCollision() ? found.getContact(0).penetration_depth : NAN;
        } catch (const std::exception &) {
        }
    }
}

/* ---- what is measured ------------------------------------------------------------------------ */

double cpu_ns()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

/* The truth is computed by the library's exact method. */
std::size_t count_wrong(const answers &said, const answers &truth, bool contact)
{
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < truth.verdict.size(); i++) {
        bool meet = truth.verdict[i] == FMB_FEASIBLE;
        wrong += said.verdict[i] != truth.verdict[i] ||
                 (contact && meet && !(std::fabs(said.depth[i] - truth.depth[i]) <= 1e-6));
    }
    return wrong;
}

void measure(bool whole, int points, std::size_t pairs)
{
    hulls h = draw_pairs(pairs, whole, points);
    fmb_frames *a = nullptr, *b = nullptr;
    fmb_pair *k = nullptr, *exact = nullptr;
    fmb_pair_options o = {};
    o.size = sizeof o;
    must(fmb_frames_new(3, pairs, h.f[0].data(), nullptr, &a));
    must(fmb_frames_new(3, pairs, h.f[1].data(), nullptr, &b));
    must(fmb_pair_new(3, &o, nullptr, &k));
    o.method = FMB_PAIR_EXACT;
    must(fmb_pair_new(3, &o, nullptr, &exact));
    answers truth = {std::vector<fmb_verdict>(pairs), std::vector<double>(pairs)};
    ask_fmb(exact, a, b, true, truth);
    struct way {
        const char *name;
        std::function<void(bool, answers &)> ask;
    } ways[] = {{"fmb", [&](bool c, answers &out) { ask_fmb(k, a, b, c, out); }},
                {"libccd", [&](bool c, answers &out) { ask_ccd(h, c, out); }},
                {"fcl-ccd", [&](bool c, answers &out) { ask_fcl(h, fcl::GST_LIBCCD, c, out); }},
                {"fcl-own", [&](bool c, answers &out) { ask_fcl(h, fcl::GST_INDEP, c, out); }}};
    for (bool contact : {false, true}) {
        std::vector<double> ns[4];
        std::size_t wrong[4];
        for (int pass = 0; pass < PASSES; pass++)
            for (int i = 0; i < 4; i++) {
                answers said = truth;
                double start = cpu_ns();
                ways[i].ask(contact, said);
                ns[i].push_back((cpu_ns() - start) / static_cast<double>(pairs));
                wrong[i] = count_wrong(said, truth, contact);
            }
        std::printf("%-7s %2d points %-8s", whole ? "integer" : "sphere", points,
                    contact ? "contact" : "verdict");
        for (int i = 0; i < 4; i++) {
            std::sort(ns[i].begin(), ns[i].end());
            std::printf("  %s %7.0f (%zu wrong)", ways[i].name, ns[i][PASSES / 2], wrong[i]);
        }
        std::printf("\n");
    }
    fmb_frames_free(a);
    fmb_frames_free(b);
    fmb_pair_free(k);
    fmb_pair_free(exact);
}

} // namespace

int main(int argc, char **argv)
{
    std::size_t pairs = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000;
    for (bool whole : {false, true})
        for (int points : {8, 16, 32, 64})
            measure(whole, points, pairs);
}
