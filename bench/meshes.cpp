/* meshes.cpp: cells of a surface that meet beyond what they share, beside CGAL's self_intersections
 * (predicates exact, as ours). usage: bench-meshes FILE...
 *
 * Equal points are made one, polygons are cut, and CGAL orients the triangles, for both. Times are
 * of the processor, medians of five turns in which the two alternate: of ours the making of the
 * mesh (trees, which CGAL's makes, too) counted, and not counted. A file with more than one
 * connected surface through a point is the same problem for both, as CGAL copies the point; then
 * the numbers of pairs may differ, as they share no longer what they did.
 */
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmb/mesh.h>

namespace
{

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

constexpr int TURNS = 5;
constexpr double LEAST_SECONDS = 0.03; // of a turn

void must(fmb_status st)
{
    if (st != FMB_OK) {
        std::fprintf(stderr, "bench-meshes: %s\n", fmb_status_text(st));
        std::exit(70);
    }
}

/* ---- the triangles of a file ----------------------------------------------------------------- */

struct soup {
    std::vector<double> point;
    std::vector<std::uint32_t> corner;
};

/* False: it cannot be read, or has no triangles. Triangles with two equal corners are left out. */
bool read_soup(const char *path, soup &out)
{
    std::FILE *in = std::fopen(path, "rb");
    fmb_mesh *mesh = nullptr;
    const fmb_status st =
        in ? fmb_mesh_read(in, fmb_mesh_format_of_name(path), nullptr, &mesh, nullptr) : FMB_ERR_IO;
    if (in)
        std::fclose(in);
    if (st != FMB_OK || fmb_mesh_corners(mesh) != 3) {
        std::fprintf(stderr, "bench-meshes: %s: %s\n", path,
                     st != FMB_OK ? fmb_status_text(st) : "no triangles");
        fmb_mesh_free(mesh);
        return false;
    }
    std::map<std::array<double, 3>, std::uint32_t> number;
    std::vector<std::uint32_t> of(fmb_mesh_vertices(mesh));
    for (std::size_t v = 0; v < of.size(); v++) {
        const double *x = fmb_mesh_points(mesh) + 3 * v;
        const auto found = number.emplace(std::array<double, 3>{x[0], x[1], x[2]},
                                          static_cast<std::uint32_t>(number.size()));
        of[v] = found.first->second;
        if (found.second)
            out.point.insert(out.point.end(), x, x + 3);
    }
    for (std::size_t c = 0; c < fmb_mesh_cells(mesh); c++) {
        const std::uint32_t *v = fmb_mesh_indices(mesh) + 3 * c;
        const std::uint32_t a = of[v[0]], b = of[v[1]], d = of[v[2]];
        if (a != b && b != d && d != a)
            out.corner.insert(out.corner.end(), {a, b, d});
    }
    fmb_mesh_free(mesh);
    return !out.corner.empty();
}

surface make_surface(const soup &s)
{
    std::vector<kernel::Point_3> point;
    std::vector<std::vector<std::size_t>> triangle;
    for (std::size_t v = 0; v < s.point.size(); v += 3)
        point.emplace_back(s.point[v], s.point[v + 1], s.point[v + 2]);
    for (std::size_t c = 0; c < s.corner.size(); c += 3)
        triangle.push_back({s.corner[c], s.corner[c + 1], s.corner[c + 2]});
    processing::orient_polygon_soup(point, triangle);
    surface out;
    processing::polygon_soup_to_polygon_mesh(point, triangle, out);
    return out;
}

/* ---- two ways -------------------------------------------------------------------------------- */

double seconds()
{
    std::timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::size_t ask_cgal(const surface &m)
{
    std::vector<std::pair<surface::Face_index, surface::Face_index>> found;
    processing::self_intersections(m, std::back_inserter(found));
    return found.size();
}

fmb_mesh *make_mesh(const soup &s)
{
    fmb_mesh *out;
    must(fmb_mesh_new(3, s.point.size() / 3, s.point.data(), s.corner.size() / 3, s.corner.data(),
                      nullptr, &out));
    return out;
}

std::size_t ask_fmb(const fmb_mesh *m)
{
    fmb_mesh_answer a = {};
    a.size = sizeof a;
    must(fmb_mesh_meet(m, nullptr, nullptr, &a));
    const std::size_t hits = a.hits;
    fmb_mesh_answer_clear(&a);
    return hits;
}

std::size_t make_and_ask(const soup &s)
{
    fmb_mesh *m = make_mesh(s);
    const std::size_t hits = ask_fmb(m);
    fmb_mesh_free(m);
    return hits;
}

template <class way> double time_of(way ask, int repeats)
{
    const double begin = seconds();
    for (int i = 0; i < repeats; i++)
        ask();
    return (seconds() - begin) / repeats;
}

double median(std::vector<double> x)
{
    std::sort(x.begin(), x.end());
    return x[x.size() / 2];
}

/* The ratio with the making counted. */
double race(const char *path, const soup &s)
{
    const surface theirs = make_surface(s);
    fmb_mesh *ours = make_mesh(s);
    const std::size_t pairs[2] = {ask_cgal(theirs), ask_fmb(ours)};
    const double once = time_of([&] { ask_cgal(theirs); }, 1);
    const int repeats = std::max(1, std::min(200000, static_cast<int>(LEAST_SECONDS / once)));
    std::vector<double> took[3];
    for (int turn = 0; turn < TURNS; turn++) {
        took[0].push_back(time_of([&] { ask_cgal(theirs); }, repeats));
        took[1].push_back(time_of([&] { make_and_ask(s); }, repeats));
        took[2].push_back(time_of([&] { ask_fmb(ours); }, repeats));
    }
    fmb_mesh_free(ours);
    const double cgal = median(took[0]), made = median(took[1]) / cgal;
    const std::string name(path);
    std::printf("%-32s %8zu %10.1f %7.3f %7.3f %9zu%s\n",
                name.substr(name.find_last_of('/') + 1).c_str(), s.corner.size() / 3, 1e6 * cgal,
                made, median(took[2]) / cgal, pairs[1],
                pairs[0] == pairs[1] ? "" : ("  CGAL: " + std::to_string(pairs[0])).c_str());
    std::fflush(stdout);
    return made;
}

} // namespace

int main(int argc, char **argv)
{
    double sum = 0, worst = 0;
    int files = 0, slower = 0;
    std::printf("%-32s %8s %10s %7s %7s %9s\n", "", "cells", "CGAL us", "ours", "no tree", "pairs");
    for (int i = 1; i < argc; i++) {
        soup s;
        if (!read_soup(argv[i], s))
            continue;
        const double ratio = race(argv[i], s);
        sum += std::log(ratio);
        worst = std::max(worst, ratio);
        slower += ratio > 1;
        files++;
    }
    if (files > 0)
        std::printf("%d files: %.3f of CGAL's time in the geometric mean, worst %.2f, %d above 1\n",
                    files, std::exp(sum / files), worst, slower);
    return files > 0 ? 0 : 66;
}
