#include "generator/cut/section/face_patches.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"

namespace pomona {

namespace {

/// Finds patches, and which bodies they lie in.
class PatchFinder {
 public:
  PatchFinder(const Face& face, const DiffusionSurfaces& surfaces, const Bodies& bodies)
      : face_(face), surfaces_(surfaces), bodies_(bodies) {}

  FacePatches find() {
    find_patches();
    find_open_bodies();
    find_windings();
    for (const std::int32_t body : found_.open_body) fill(body);
    for (std::vector<std::uint32_t>& triangles : found_.triangle) std::sort(triangles.begin(), triangles.end());
    return std::move(found_);
  }

 private:
  static constexpr std::uint32_t unset = 0xffffffffu;

  std::size_t triangle_count() const { return face_.triangle.size(); }

  void find_patches() {
    found_.patch_of.assign(triangle_count(), unset);

    // Each triangle without a patch begins one, which spreads over edges that are no constraints.
    std::vector<std::uint32_t> stack;
    for (std::uint32_t seed = 0; seed < triangle_count(); ++seed) {
      if (found_.patch_of[seed] != unset) continue;
      const auto number = static_cast<std::uint32_t>(found_.count());
      found_.triangle.emplace_back();
      found_.patch_of[seed] = number;
      stack.push_back(seed);
      while (!stack.empty()) {
        const std::uint32_t t = stack.back();
        stack.pop_back();
        found_.triangle[number].push_back(t);
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int32_t other = face_.neighbor[t][i];
          if (other < 0 || face_.constrained[t][i]) continue;
          const auto o = static_cast<std::uint32_t>(other);
          if (found_.patch_of[o] != unset) continue;
          found_.patch_of[o] = number;
          stack.push_back(o);
        }
      }
    }
  }

  /// Finds open bodies. A boundary is closed if at every vertex as many of its segments end as begin.
  void find_open_bodies() {
    struct End {
      std::int32_t body;
      std::uint32_t vertex;
      int balance;
    };

    // Collect where segments of each body begin and end.
    std::vector<End> ends;
    for (const EdgeUse& use : face_.edges) {
      const std::int32_t body = bodies_.of_triangle[face_.segment[use.segment].source];
      if (body == Bodies::none) continue;
      const int to_high = begins_low(use) ? 1 : -1;
      ends.push_back({body, use.low, -to_high});
      ends.push_back({body, use.high, to_high});
    }

    // A body is open if they do not balance at some vertex.
    std::sort(ends.begin(), ends.end(),
              [](const End& a, const End& b) { return std::tie(a.body, a.vertex) < std::tie(b.body, b.vertex); });
    for (std::size_t i = 0; i < ends.size();) {
      const End first = ends[i];
      int sum = 0;
      for (; i < ends.size() && ends[i].body == first.body && ends[i].vertex == first.vertex; ++i)
        sum += ends[i].balance;
      if (sum != 0 && (found_.open_body.empty() || found_.open_body.back() != first.body))
        found_.open_body.push_back(first.body);
    }
  }

  /// True if the segment, turned so that its body lies on its left, runs from the edge's low to its high vertex.
  bool begins_low(const EdgeUse& use) const {
    const bool front_visible = surfaces_.is_hidden(face_.segment[use.segment].source, SideOf::back);
    return use.forward == front_visible;
  }

  /// Fills patches with an open body: of the sets that its boundary does not separate, those that mostly see its
  /// inside.
  void fill(std::int32_t body) {
    // Find the connected sets of patches, and those that reach the rim.
    const auto patches = static_cast<std::uint32_t>(found_.count());
    DisjointSets sets(patches);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (face_.neighbor[t][i] < 0 || side_of_body(body, t, i) != 0) continue;
        sets.join(found_.patch_of[t], found_.patch_of[static_cast<std::size_t>(face_.neighbor[t][i])]);
      }
    }
    std::vector<std::uint8_t> outside(patches, 0);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (const std::int32_t other : face_.neighbor[t]) {
        if (other < 0) outside[sets.root(found_.patch_of[t])] = 1;
      }
    }

    const std::vector<double> visible = visible_less_hidden(body, sets);
    for (std::uint32_t p = 0; p < patches; ++p) {
      const std::uint32_t root = sets.root(p);
      if (!outside[root] && visible[root] > 0) change(found_.inside[p], body, 1);
    }
  }

  /// For each set of patches, by its root: the length of the body's visible sides less that of its hidden sides. Where
  /// both sides of the boundary lie in the set they cancel, and are left out, because rounding would decide.
  std::vector<double> visible_less_hidden(std::int32_t body, DisjointSets sets) const {
    std::vector<double> visible(found_.count(), 0);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int inside_here = side_of_body(body, t, i);
        if (inside_here == 0) continue;
        const std::uint32_t here = sets.root(found_.patch_of[t]);
        const std::int32_t other = face_.neighbor[t][i];
        if (other >= 0 && sets.root(found_.patch_of[static_cast<std::size_t>(other)]) == here) continue;
        visible[here] += inside_here * distance(face_, ends_of(t, i).first, ends_of(t, i).second);
      }
    }
    return visible;
  }

  /// The number of the body's segments along the edge that have the triangle inside, less those that have it outside.
  int side_of_body(std::int32_t body, std::size_t triangle, std::size_t edge) const {
    if (!face_.constrained[triangle][edge]) return 0;
    const auto [p, q] = ends_of(triangle, edge);
    int sum = 0;
    for (const EdgeUse& use : face_.uses(p, q)) {
      if (bodies_.of_triangle[face_.segment[use.segment].source] == body) sum += begins_low(use) == (p < q) ? 1 : -1;
    }
    return sum;
  }

  std::pair<std::uint32_t, std::uint32_t> ends_of(std::size_t triangle, std::size_t edge) const {
    return {face_.corner(triangle, edge), face_.corner(triangle, edge + 1)};
  }

  /// Walks from patch to patch, from outside; a step across a boundary enters or leaves its body.
  void find_windings() {
    // Patches at the rim of the triangulation lie outside everything.
    found_.inside.resize(found_.count());
    std::vector<std::uint8_t> reached(found_.count(), 0);
    std::vector<std::uint32_t> queue;
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (const std::int32_t other : face_.neighbor[t]) {
        const std::uint32_t p = found_.patch_of[t];
        if (other >= 0 || reached[p]) continue;
        reached[p] = 1;
        queue.push_back(p);
      }
    }

    // Each patch that is reached tells its neighbours across the boundaries between them.
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t from = queue[next];
      for (const std::uint32_t t : found_.triangle[from]) {
        for (std::size_t i = 0; i < 3; ++i) {
          if (!face_.constrained[t][i] || face_.neighbor[t][i] < 0) continue;
          const std::uint32_t to = found_.patch_of[static_cast<std::size_t>(face_.neighbor[t][i])];
          if (reached[to]) continue;
          reached[to] = 1;
          found_.inside[to] = across(found_.inside[from], t, i);
          queue.push_back(to);
        }
      }
    }
  }

  std::vector<BodyWinding> across(std::vector<BodyWinding> inside, std::size_t triangle, std::size_t edge) const {
    const auto [p, q] = ends_of(triangle, edge);
    for (const EdgeUse& use : face_.uses(p, q)) {
      const std::int32_t body = bodies_.of_triangle[face_.segment[use.segment].source];
      if (body == Bodies::none || found_.is_open(body)) continue;

      // The triangle lies left of the edge from p to q: inside, if the segment has that direction.
      change(inside, body, begins_low(use) == (p < q) ? -1 : 1);
    }
    return inside;
  }

  static void change(std::vector<BodyWinding>& inside, std::int32_t body, int by) {
    const auto place = std::lower_bound(inside.begin(), inside.end(), body,
                                        [](const BodyWinding& w, std::int32_t b) { return w.body < b; });
    if (place == inside.end() || place->body != body) {
      inside.insert(place, {body, by});
    } else if ((place->winding += by) == 0) {
      inside.erase(place);
    }
  }

  const Face& face_;
  const DiffusionSurfaces& surfaces_;
  const Bodies& bodies_;
  FacePatches found_;
};

}  // namespace

bool FacePatches::is_open(std::int32_t body) const {
  return std::binary_search(open_body.begin(), open_body.end(), body);
}

Regions FacePatches::regions() const { return {std::vector<Regions::Patch>(count()), patch_of}; }

FacePatches patches_of(const Face& face, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  return PatchFinder(face, surfaces, bodies).find();
}

}  // namespace pomona
