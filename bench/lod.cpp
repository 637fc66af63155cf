// Levels of detail of half of every fruit: number of triangles, deviation, time. If meshoptimizer is installed, its
// levels are shown beside ours; it regards neither colours nor a bound.
//   lod [--error SHARE] [--color SHARE] [--levels N] [--knife KNIFE] [--quick] [NAME...]
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#ifdef POMONA_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include "bench/exit_status.h"
#include "bench/fruits.h"
#include "bench/text_table.h"
#include "bench/timing.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "generator/piece/lod/levels_of_detail.h"
#include "generator/piece/piece_facts.h"
#include "generator/piece/slice.h"
#include "tests/piece/level_deviation.h"

namespace pomona::bench {
namespace {

struct Run {
  LodOptions lod{.levels = 3};
  std::string knife = "half";
  bool is_quick = false;
};

/// The largest piece that the knife leaves; the whole fruit without one.
Solid piece_of(const std::string& name, const std::string& knife) {
  const BenchFruit fruit = grow_fruit(name);
  std::vector<Knife> knives;
  if (knife != "whole") knives.push_back(parse_knife(knife));
  const auto diffuser = make_pmvc_diffuser({});
  return slice({fruit.grown, fruit.drawn, knives, name}, diffuser.get()).pieces.front();
}

std::size_t open_edges(const SolidMesh& mesh) {
  std::size_t open = 0;
  const auto edges = sorted_half_edges(welded_triangles(weld(mesh.position), mesh.triangle));
  for_each_edge(edges, [&](std::span<const HalfEdge> edge) { open += balance(edge) != 0 ? 1 : 0; });
  return open;
}

/// Number of triangles, except needles, that face against the sum of their vertices' normals.
std::size_t turned_triangles(const SolidMesh& mesh) {
  std::size_t turned = 0;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const auto [a, b, c] = mesh.corners(t);
    const glm::dvec3 area = mesh.area_vector(t);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    glm::dvec3 normal(0);
    for (int i = 0; i < 3; ++i) normal += glm::dvec3(mesh.normal[mesh.triangle[t][i]]);
    if (glm::length(area) > 1e-3 * longest * longest && glm::dot(area, normal) < 0) ++turned;
  }
  return turned;
}

struct Method {
  std::string name;
  std::vector<Solid> levels;
  double milliseconds = 0;
};

#ifdef POMONA_MESHOPTIMIZER
/// The solid with these corners; each triangle belongs to the face that its first corner belonged to.
Solid level_of(const Solid& solid, const std::vector<unsigned>& corners) {
  std::vector<std::size_t> triangle_at(solid.mesh.position.size(), 0);
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t)
    for (int i = 0; i < 3; ++i) triangle_at[solid.mesh.triangle[t][i]] = t;
  Solid level = solid;
  level.mesh.triangle.clear(), level.mesh.cut_face.clear(), level.mesh.surface.clear();
  double six = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    level.mesh.triangle.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    level.mesh.cut_face.push_back(solid.mesh.cut_face[triangle_at[corners[i]]]);
    level.mesh.surface.push_back(solid.mesh.surface[triangle_at[corners[i]]]);
    const auto [a, b, c] = level.mesh.corners(level.mesh.triangle.size() - 1);
    six += glm::dot(a, glm::cross(b, c));
  }
  level.volume = six / 6;
  return level;
}

Method by_meshoptimizer(const Solid& solid, int levels) {
  std::vector<unsigned> corners;
  for (const glm::uvec3& t : solid.mesh.triangle) corners.insert(corners.end(), {t.x, t.y, t.z});
  std::vector<std::vector<unsigned>> simplified(static_cast<std::size_t>(levels));
  Method method{.name = "meshoptimizer", .levels = {}};
  method.milliseconds = median_time(3, [&] {
                          for (std::size_t k = 0; k < simplified.size(); ++k) {
                            simplified[k].resize(corners.size());
                            const std::size_t wanted = 3 * (solid.mesh.triangle.size() >> (k + 1));
                            simplified[k].resize(meshopt_simplify(simplified[k].data(), corners.data(), corners.size(),
                                                                  &solid.mesh.position[0].x, solid.mesh.position.size(),
                                                                  sizeof(glm::vec3), wanted, 1e30f, 0, nullptr));
                          }
                        }).processor;
  for (const std::vector<unsigned>& level : simplified) method.levels.push_back(level_of(solid, level));
  return method;
}
#endif

Method by_pomona(const Solid& solid, const LodOptions& options) {
  Method method{.name = "pomona", .levels = {}};
  method.milliseconds = median_time(3, [&] { method.levels = levels_of_detail(solid, options); }).processor;
  return method;
}

void add_rows(const Solid& solid, const Run& run, const Method& method, TextTable& table) {
  const PieceFacts facts = facts_of(solid);
  const double size = glm::length(facts.high - facts.low);
  std::size_t wanted = solid.mesh.triangle.size();
  for (const Solid& level : method.levels) {
    wanted /= 2;
    const LevelDeviation off = run.is_quick ? LevelDeviation{} : deviation(level, solid, size / 200);
    const bool is_first = &level == &method.levels.front();
    table.rows.push_back({is_first ? solid.name : "", is_first ? method.name : "",
                          is_first ? std::to_string(solid.mesh.triangle.size()) : "", std::to_string(wanted),
                          std::to_string(level.mesh.triangle.size()), number(100 * off.distance / size, 2),
                          number(off.color_rms, 1), number(100 * (level.volume / solid.volume - 1), 2),
                          std::to_string(open_edges(level.mesh)), std::to_string(turned_triangles(level.mesh)),
                          is_first ? number(method.milliseconds, 0) : ""});
  }
}

}  // namespace
}  // namespace pomona::bench

int main(int argc, char** argv) {
  using namespace pomona;
  CLI::App app("Levels of detail: triangles, errors, time");
  bench::Run run;
  std::vector<std::string> names;
  app.add_option("--levels", run.lod.levels, "How many");
  app.add_option("--error", run.lod.error, "How far surface and borders may stray, of the solid's size");
  app.add_option("--color", run.lod.color_error, "How far colours may");
  app.add_option("--knife", run.knife, "The largest piece of which; whole: none");
  app.add_flag("--quick", run.is_quick, "Neither distances nor colours");
  app.add_option("NAME", names, "Templates; none means all");
  CLI11_PARSE(app, argc, argv);
  return bench::exit_status_of([&] {
    bench::TextTable table{{"fruit", "by", "triangles", "wanted", "level", "distance, % of size", "colour, rms of 255",
                            "volume, %", "open edges", "turned", "ms"},
                           {}};
    for (const std::string& name : bench::fruit_names(names)) {
      const Solid solid = bench::piece_of(name, run.knife);
      bench::add_rows(solid, run, bench::by_pomona(solid, run.lod), table);
#ifdef POMONA_MESHOPTIMIZER
      bench::add_rows(solid, run, bench::by_meshoptimizer(solid, run.lod.levels), table);
#endif
    }
    std::printf("%s", bench::markdown(table).c_str());
    return 0;
  });
}
