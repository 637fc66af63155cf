#include "bench/unseen_facts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "generator/cut/cut.h"
#include "generator/cut/section/section_crumbs.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/mesh/box.h"
#include "generator/mesh/connected_vertices.h"
#include "generator/mesh/enclosures.h"
#include "generator/mesh/weld.h"

namespace pomona::bench {

namespace {

/// A membrane crosses a grain if more than this share of the grain's vertices lie on the other side.
constexpr double crossed = 0.04;

/// Metres: a membrane has less blur than this; a surface with more is a change of colour only.
constexpr float sharp = 3e-4f;

double area_of(const CrossSection& section, const glm::uvec3& t) {
  const glm::dvec3 a(section.position[t.x]), b(section.position[t.y]), c(section.position[t.z]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

/// Loose bits, and patches of one part, below these shares of a section are specks.
constexpr double small_bit = 10 * section_crumb, small_patch = section_crumb;

/// Nor is a patch a speck that has this share of what is usual for its part: a seed that the knife has grazed.
constexpr double grazed = 0.1;

/// A component of the section.
struct Patch {
  int part = 0;  ///< of its first triangle
  double area = 0;
};

/// Triangles are connected at common places, of one part only if `by_part`.
std::vector<Patch> components_of(const CrossSection& section, bool by_part) {
  const std::vector<std::uint32_t> place = weld(section.position);
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> known;
  DisjointSets joined(3 * section.triangle.size());
  std::vector<std::uint32_t> first(section.triangle.size());
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    const int part = by_part ? section.part[section.triangle[t].x] : 0;
    for (int k = 0; k < 3; ++k) {
      const auto next = static_cast<std::uint32_t>(known.size());
      const std::uint32_t corner = known.try_emplace({place[section.triangle[t][k]], part}, next).first->second;
      if (k == 0) first[t] = corner;
      joined.join(first[t], corner);
    }
  }
  std::map<std::uint32_t, Patch> found;
  for (std::size_t t = 0; t < first.size(); ++t) {
    Patch& patch = found.try_emplace(joined.root(first[t]), section.part[section.triangle[t].x]).first->second;
    patch.area += area_of(section, section.triangle[t]);
  }
  std::vector<Patch> components;
  for (const auto& [root, patch] : found) components.push_back(patch);
  return components;
}

/// The patch in which the middle of a part's area lies, smaller ones first: its usual size.
std::map<int, double> usual_areas(std::vector<Patch> patches) {
  std::sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.area < b.area; });
  std::map<int, double> total, before, usual;
  for (const Patch& patch : patches) total[patch.part] += patch.area;
  for (const Patch& patch : patches) {
    before[patch.part] += patch.area;
    if (2 * before[patch.part] >= total[patch.part]) usual.try_emplace(patch.part, patch.area);
  }
  return usual;
}

/// Number of loose bits and of patches that look like crumbs on a face of this area.
int speck_count(const CrossSection& section, double area) {
  const std::vector<Patch> bits = components_of(section, false), patches = components_of(section, true);
  const std::map<int, double> usual = usual_areas(patches);
  const auto is_small_bit = [&](const Patch& bit) { return bit.area < small_bit * area; };
  const auto is_small_patch = [&](const Patch& patch) {
    return patch.area < std::min(small_patch * area, grazed * usual.at(patch.part));
  };
  return static_cast<int>(std::count_if(bits.begin(), bits.end(), is_small_bit) +
                          std::count_if(patches.begin(), patches.end(), is_small_patch));
}

FaceFacts face_facts(const GrownFruit& grown, const char* knife, const Diffuser& diffuser) {
  const std::vector<Knife> knives{parse_knife(knife)};
  CutOptions options = coarse_cut;
  options.threads = {1};
  const CrossSection section =
      without_crumbs(colored(cut(grown.sheets, knives, options).section, grown.sheets, diffuser));
  FaceFacts facts;
  for (const glm::uvec3& t : section.triangle) facts.area += area_of(section, t);
  for (const glm::uvec3& t : section.triangle) {
    const double third = area_of(section, t) / (3 * facts.area);
    const bool right = section.position[t.x].x + section.position[t.y].x + section.position[t.z].x > 0;
    for (int k = 0; k < 3; ++k) {
      auto& [on_left, on_right] = facts.sides[section.part_names[static_cast<std::size_t>(section.part[t[k]])]];
      (right ? on_right : on_left) += third;
    }
  }
  facts.specks = speck_count(section, facts.area);
  return facts;
}

/// The walls of chambers: surfaces in folds between different parts, each loop a mesh.
Enclosures membranes_of(const DiffusionSurfaces& swept, const Template& fruit) {
  DisjointSets joined = connected_vertices(swept.vertex_count(), swept.triangle);
  std::vector<Enclosures::Triangle> triangles;
  for (std::size_t i = 0; i < swept.triangle_count(); ++i) {
    const glm::uvec3& t = swept.triangle[i];
    const auto surface = static_cast<std::size_t>(swept.surface[i]);
    if (surface >= fruit.surfaces.size() || fruit.surfaces[surface].type != SurfaceType::in_fold) continue;
    if (swept.front_part[i] == swept.back_part[i] || swept.blur[t.x] > sharp) continue;
    Enclosures::Triangle triangle;
    for (int k = 0; k < 3; ++k) triangle.corner[static_cast<std::size_t>(k)] = glm::dvec3(swept.position[t[k]]);
    triangle.mesh = joined.root(t.x);
    triangles.push_back(triangle);
  }
  return Enclosures(std::move(triangles));
}

/// One grain: its vertices, and its kind.
struct Grain {
  std::vector<std::uint32_t> vertices;
  std::size_t kind = 0;
};

std::vector<Grain> grains_of(const DiffusionSurfaces& grains) {
  DisjointSets joined = connected_vertices(grains.vertex_count(), grains.triangle);
  std::map<std::uint32_t, Grain> found;
  for (std::uint32_t v = 0; v < grains.vertex_count(); ++v) found[joined.root(v)].vertices.push_back(v);
  for (std::size_t i = 0; i < grains.triangle_count(); ++i)
    found[joined.root(grains.triangle[i].x)].kind = static_cast<std::size_t>(grains.surface[i]);
  std::vector<Grain> all;
  for (auto& [root, grain] : found) all.push_back(std::move(grain));
  return all;
}

bool is_crossed(const Grain& grain, const DiffusionSurfaces& grains, const Enclosures& membranes) {
  std::map<std::uint32_t, int> within;
  for (const std::uint32_t v : grain.vertices)
    for (const auto& [mesh, winding] : membranes.around(glm::dvec3(grains.position[v]))) ++within[mesh];
  const auto all = static_cast<double>(grain.vertices.size());
  return std::any_of(within.begin(), within.end(), [&](const auto& mesh) {
    return mesh.second > crossed * all && mesh.second < (1 - crossed) * all;
  });
}

glm::dvec3 middle_of(const Grain& grain, const DiffusionSurfaces& grains) {
  glm::dvec3 sum(0);
  for (const std::uint32_t v : grain.vertices) sum += glm::dvec3(grains.position[v]);
  return sum / static_cast<double>(grain.vertices.size());
}

/// The fold in which a place lies.
std::size_t fold_at(const FoldSymmetry& symmetry, const glm::dvec3& place) {
  constexpr double turn = 6.283185307179586;
  const double from = symmetry.fold_angles.front();
  double azimuth = std::atan2(-place.z, place.x);
  azimuth -= turn * std::floor((azimuth - from) / turn);
  const auto next = std::upper_bound(symmetry.fold_angles.begin() + 1, symmetry.fold_angles.end(), azimuth);
  return static_cast<std::size_t>(next - symmetry.fold_angles.begin()) - 1;
}

/// Whether grains of this kind grow in folds. Cores within grains are not counted.
bool in_folds(const Template& fruit, const std::string& kind) {
  return std::any_of(fruit.grains.begin(), fruit.grains.end(), [&](const GrainSketch& sketch) {
    return sketch.name == kind && fruit.surfaces[static_cast<std::size_t>(sketch.surface)].type == SurfaceType::in_fold;
  });
}

/// The folds that have a surface on which grains grow.
std::set<std::size_t> folds_for_grains(const Template& fruit) {
  std::set<std::size_t> folds;
  for (const GrainSketch& sketch : fruit.grains) {
    if (!in_folds(fruit, sketch.name)) continue;
    const std::vector<Curve>& loops = fruit.surfaces[static_cast<std::size_t>(sketch.surface)].horizontal;
    for (std::size_t k = 0; k < loops.size(); ++k)
      if (!loops[k].points.empty()) folds.insert(k);
  }
  return folds;
}

void add_grains(UnseenFacts& facts, const Template& fruit, const GrownFruit& grown) {
  const auto* symmetry = std::get_if<FoldSymmetry>(&fruit.symmetry);
  if (!symmetry) return;
  const Enclosures membranes = membranes_of(grown.swept, fruit);
  std::set<std::size_t> bearing;
  for (const Grain& grain : grains_of(grown.grains)) {
    if (!in_folds(fruit, grown.grains.surface_names[grain.kind])) continue;
    ++facts.grains;
    facts.crossings += is_crossed(grain, grown.grains, membranes);
    bearing.insert(fold_at(*symmetry, middle_of(grain, grown.grains)));
  }
  facts.chambers = static_cast<int>(folds_for_grains(fruit).size());
  for (const std::size_t fold : folds_for_grains(fruit)) facts.empty_chambers += !bearing.contains(fold);
}

glm::dvec3 srgb255(const Color& color) {
  glm::dvec3 value;
  for (int c = 0; c < 3; ++c) value[c] = 255 * srgb_from_linear(std::clamp<double>(color[c], 0, 1));
  return value;
}

/// Two parts that a surface divides, the smaller one first, and the mean difference of their colours there, sRGB in
/// 255ths.
std::map<std::pair<int, int>, glm::dvec3> differences_of(const DiffusionSurfaces& surfaces) {
  std::map<std::pair<int, int>, std::pair<glm::dvec3, double>> sums;
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    const auto [a, b] = std::minmax(surfaces.front_part[i], surfaces.back_part[i]);
    if (a == b) continue;
    auto& [sum, count] = sums[{a, b}];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = surfaces.triangle[i][k];
      const glm::dvec3 across = srgb255(surfaces.front_color[v]) - srgb255(surfaces.back_color[v]);
      sum += a == surfaces.front_part[i] ? across : -across;
      count += 1;
    }
  }
  std::map<std::pair<int, int>, glm::dvec3> means;
  for (const auto& [pair, sum] : sums) means[pair] = sum.first / sum.second;
  return means;
}

/// Compared where tissues meet, because there they have the same place and so the same ripeness.
TissueDrift worst_drift(const Template& variant, const GrownFruit& grown, VariantKey key) {
  TissueDrift worst;
  if (variant.variation.color.tissues.empty()) return worst;
  Template plain = variant;
  plain.individual = {};
  GrowOptions how;
  how.threads = {1};
  const GrownFruit uncolored = grow(plain, key, how);
  const auto drawn = differences_of(joined(uncolored.swept, uncolored.grains));
  const auto now = differences_of(joined(grown.swept, grown.grains));
  for (const auto& [pair, difference] : now) {
    for (const std::vector<int>& tissue : variant.variation.color.tissues) {
      const auto is_in = [&](int part) { return std::find(tissue.begin(), tissue.end(), part) != tissue.end(); };
      if (!is_in(pair.first) || !is_in(pair.second)) continue;
      const glm::dvec3 moved = glm::abs(difference - drawn.at(pair));
      const double drift = std::max({moved.x, moved.y, moved.z});
      const auto name = [&](int part) { return variant.parts[static_cast<std::size_t>(part)]; };
      if (drift >= worst.drift) worst = {name(pair.first), name(pair.second), drift};
    }
  }
  return worst;
}

std::vector<std::string> inner_parts_of(const Template& fruit) {
  std::set<int> parts;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    const bool outer = &surface != &fruit.surfaces.front() && (surface.front.hidden || surface.back.hidden) &&
                       surface.front.part == surface.back.part;
    if (outer) continue;  // stems, leaves
    parts.insert(surface.back.part);
    parts.insert(surface.front.part);
  }
  for (const GrainSketch& grain : fruit.grains) {
    if (!grain.front.hidden) parts.insert(grain.back.part);
  }
  std::vector<std::string> names;
  for (const int part : parts) names.push_back(fruit.parts[static_cast<std::size_t>(part)]);
  return names;
}

/// Layers around an axis that bends lie on both sides of it, if not always of the straight line that divides sides.
std::set<std::string> parts_in_folds_of(const Template& fruit) {
  std::set<int> in_folds, around;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    if (surface.type != SurfaceType::in_fold) around.insert({surface.front.part, surface.back.part});
    if (surface.type == SurfaceType::in_fold) in_folds.insert({surface.front.part, surface.back.part});
  }
  for (const GrainSketch& grain : fruit.grains) {
    const bool folds = fruit.surfaces[static_cast<std::size_t>(grain.surface)].type == SurfaceType::in_fold;
    (folds ? in_folds : around).insert(grain.back.part);
  }
  std::set<std::string> names;
  for (const int part : in_folds)
    if (!around.contains(part)) names.insert(fruit.parts[static_cast<std::size_t>(part)]);
  return names;
}

}  // namespace

UnseenFruit::UnseenFruit(Template fruit)
    : fruit_(std::move(fruit)),
      variation_(fruit_),
      inner_parts_(inner_parts_of(fruit_)),
      parts_in_folds_(parts_in_folds_of(fruit_)) {}

UnseenFacts UnseenFruit::facts(int seed) const {
  const VariantKey key{static_cast<std::uint64_t>(seed), 0};
  GrowOptions how;
  how.threads = {1};
  how.as_drawn = seed == 0;
  const Template variant = seed == 0 ? variant_of(fruit_, key, how) : variant_of(variation_, key, how);
  const GrownFruit grown = grow(variant, key, how);
  const auto diffuser = make_pmvc_diffuser({Quality::draft, {1}});

  UnseenFacts facts;
  facts.folds = fold_count(variant);
  facts.diagonal = glm::length(box_around(grown.swept.position).size());
  facts.half = face_facts(grown, "half", *diffuser);
  facts.across = face_facts(grown, "across", *diffuser);
  add_grains(facts, variant, grown);
  facts.worst_drift = worst_drift(variant, grown, key);
  return facts;
}

}  // namespace pomona::bench
