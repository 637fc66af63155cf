#include "bench/baselines/tetrahedral_poisson.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bench/baselines/tetrahedral_mesh.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/resolved_colors.h"
#include "generator/mesh/triangle_distance.h"

namespace pomona::bench {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;  // one row per unknown, one column per channel

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Values of the corners of tetrahedra: corners at one vertex share one value unless a surface separates them.
struct Values {
  std::vector<std::array<std::uint32_t, 4>> of_corner;  ///< one entry per tetrahedron
  std::size_t count = 0;
};

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// The corner of `other` that lies at the vertex of a shared face.
std::uint32_t corner_at(const TetrahedralMesh& mesh, std::uint32_t other, std::uint32_t vertex) {
  const auto& corner = mesh.corner[other];
  return static_cast<std::uint32_t>(std::find(corner.begin(), corner.end(), vertex) - corner.begin());
}

Values values_of(const TetrahedralMesh& mesh) {
  // Join across every face that lies on no surface.
  std::vector<std::uint32_t> parent(4 * mesh.corner.size());
  std::iota(parent.begin(), parent.end(), 0u);
  for (std::uint32_t t = 0; t < mesh.corner.size(); ++t) {
    for (std::uint32_t face = 0; face < 4; ++face) {
      const std::uint32_t other = mesh.neighbor[t][face];
      if (other == TetrahedralMesh::none || other < t || mesh.on_surface[t][face]) continue;
      for (std::uint32_t i = 0; i < 4; ++i) {
        if (i == face) continue;
        const std::uint32_t a = root_of(parent, 4 * t + i);
        const std::uint32_t b = root_of(parent, 4 * other + corner_at(mesh, other, mesh.corner[t][i]));
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
  }

  // Number them.
  Values values{std::vector<std::array<std::uint32_t, 4>>(mesh.corner.size()), 0};
  std::vector<std::uint32_t> number(parent.size(), TetrahedralMesh::none);
  for (std::uint32_t i = 0; i < parent.size(); ++i) {
    std::uint32_t& of_root = number[root_of(parent, i)];
    if (of_root == TetrahedralMesh::none) of_root = static_cast<std::uint32_t>(values.count++);
    values.of_corner[i / 4][i % 4] = of_root;
  }
  return values;
}

/// Colours that surfaces give to values: their sums and numbers.
struct Given {
  std::vector<glm::dvec3> sum;
  std::vector<double> count;
};

/// Reads colours off the surfaces for faces of tetrahedra that approximate them.
class Painter {
 public:
  Painter(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) : surfaces_(surfaces), tree_(tree) {}

  Given paint(const TetrahedralMesh& mesh, const Values& values) const {
    Given given{std::vector<glm::dvec3>(values.count, glm::dvec3(0)), std::vector<double>(values.count)};
    for (std::uint32_t t = 0; t < mesh.corner.size(); ++t) {
      for (std::uint32_t face = 0; face < 4; ++face) {
        if (!mesh.on_surface[t][face]) continue;
        const std::array<glm::dvec3, 3> place = places_of(mesh, t, face);
        const glm::dvec3 inwards = inwards_of(mesh, t, face, place);
        for (std::uint32_t i = 0, n = 0; i < 4; ++i) {
          if (i == face) continue;
          given.sum[values.of_corner[t][i]] += color_at(place[n++], place, inwards);
          given.count[values.of_corner[t][i]] += 1;
        }
      }
    }
    return given;
  }

 private:
  static std::array<glm::dvec3, 3> places_of(const TetrahedralMesh& mesh, std::uint32_t t, std::uint32_t face) {
    std::array<glm::dvec3, 3> place;
    for (std::uint32_t i = 0, n = 0; i < 4; ++i) {
      if (i != face) place[n++] = mesh.position[mesh.corner[t][i]];
    }
    return place;
  }

  static glm::dvec3 inwards_of(const TetrahedralMesh& mesh, std::uint32_t t, std::uint32_t face,
                               const std::array<glm::dvec3, 3>& place) {
    const glm::dvec3 normal = glm::normalize(glm::cross(place[1] - place[0], place[2] - place[0]));
    const glm::dvec3 apex = mesh.position[mesh.corner[t][face]];
    return glm::dot(apex - place[0], normal) < 0 ? -normal : normal;
  }

  /// The colour of the surface at one corner of a face, on the inner side. It is read a little towards the middle of
  /// the face, where the face's own surface is nearest even at a crease.
  glm::dvec3 color_at(const glm::dvec3& corner, const std::array<glm::dvec3, 3>& face,
                      const glm::dvec3& inwards) const {
    const glm::dvec3 middle = (face[0] + face[1] + face[2]) / 3.0;
    for (const double share : {0.001, 0.05, 0.3, 1.0}) {
      SurfaceSide at = nearest_side(surfaces_, tree_, glm::mix(corner, middle, share)).value();
      const auto [a, b, c] = corners(surfaces_, at.triangle);
      const double facing = glm::dot(glm::normalize(glm::cross(b - a, c - a)), inwards);
      at.side = facing < 0 ? SideOf::back : SideOf::front;
      at.barycentric = nearest_weights(corner, a, b, c);
      if (std::fabs(facing) > 0.5 || share == 1.0) return color_of(surfaces_, at);
    }
    return glm::dvec3(0);
  }

  const DiffusionSurfaces& surfaces_;
  const SurfaceTree& tree_;
};

/// The products of the gradients of a tetrahedron's four linear functions, times its volume.
Eigen::Matrix4d stiffness(const TetrahedralMesh& mesh, std::uint32_t t) {
  const auto& corner = mesh.corner[t];
  std::array<glm::dvec3, 4> p, gradient;
  for (std::size_t i = 0; i < 4; ++i) p[i] = mesh.position[corner[i]];
  const double six_volumes = glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0]));
  gradient[1] = glm::cross(p[2] - p[0], p[3] - p[0]) / six_volumes;
  gradient[2] = glm::cross(p[3] - p[0], p[1] - p[0]) / six_volumes;
  gradient[3] = glm::cross(p[1] - p[0], p[2] - p[0]) / six_volumes;
  gradient[0] = -(gradient[1] + gradient[2] + gradient[3]);
  Eigen::Matrix4d k;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      k(i, j) = std::fabs(six_volumes) / 6 *
                glm::dot(gradient[static_cast<std::size_t>(i)], gradient[static_cast<std::size_t>(j)]);
    }
  }
  return k;
}

/// The equations of all values that no surface gives.
struct System {
  std::vector<std::uint32_t> row;  ///< one entry per value; `none` for those given
  Matrix matrix;
  Columns right;
};

System system_of(const TetrahedralMesh& mesh, const Values& values, const Given& given) {
  System system{std::vector<std::uint32_t>(values.count, TetrahedralMesh::none), {}, {}};
  Eigen::Index unknowns = 0;
  for (std::size_t v = 0; v < values.count; ++v) {
    if (given.count[v] == 0) system.row[v] = static_cast<std::uint32_t>(unknowns++);
  }
  system.right = Columns::Zero(unknowns, 3);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t t = 0; t < mesh.corner.size(); ++t) {
    const Eigen::Matrix4d k = stiffness(mesh, t);
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t row = system.row[values.of_corner[t][static_cast<std::size_t>(i)]];
      if (row == TetrahedralMesh::none) continue;
      for (int j = 0; j < 4; ++j) {
        const std::uint32_t value = values.of_corner[t][static_cast<std::size_t>(j)];
        if (system.row[value] != TetrahedralMesh::none) {
          entries.emplace_back(row, system.row[value], k(i, j));
        } else {
          const glm::dvec3 color = given.sum[value] / given.count[value];
          for (int c = 0; c < 3; ++c) system.right(row, c) -= k(i, j) * color[c];
        }
      }
    }
  }
  system.matrix.resize(unknowns, unknowns);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

struct Solved {
  Columns values;
  double residual = 0;
  bool is_good = false;
};

Solved solve(const System& system) {
  if (system.right.rows() == 0) return {system.right, 0, true};
  const Eigen::SimplicialLDLT<Matrix> factors(system.matrix);
  if (factors.info() != Eigen::Success) return {};
  Solved solved{factors.solve(system.right), 0, true};
  for (int c = 0; c < 3; ++c) {
    const double size = system.right.col(c).norm();
    const double wrong = (system.matrix * solved.values.col(c) - system.right.col(c)).norm();
    if (size > 0) solved.residual = std::max(solved.residual, wrong / size);
  }
  return solved;
}

/// Finds the tetrahedron around a point by a grid of buckets.
class Finder {
 public:
  Finder(const TetrahedralMesh& mesh, const Box<double>& box) : mesh_(mesh), low_(box.low) {
    const double longest = std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
    along_ = std::max(1, static_cast<int>(std::cbrt(static_cast<double>(mesh.corner.size()))));
    per_length_ = along_ / longest;
    buckets_.resize(static_cast<std::size_t>(along_) * along_ * along_);
    for (std::uint32_t t = 0; t < mesh.corner.size(); ++t) insert(t);
  }

  struct Place {
    std::uint32_t tetrahedron = 0;
    std::array<double, 4> weight{};
  };
  std::optional<Place> find(const glm::dvec3& point) const {
    // A point on a face must not be lost by rounding: take the tetrahedron in which it lies deepest.
    constexpr double slack = 1e-9;
    std::optional<Place> best;
    double max = -slack;
    for (const std::uint32_t t : buckets_[bucket_at(index_of(point))]) {
      const std::array<double, 4> weight = weights(t, point);
      const double min = *std::min_element(weight.begin(), weight.end());
      if (min < max) continue;
      max = min;
      best = Place{t, weight};
    }
    return best;
  }

 private:
  glm::ivec3 index_of(const glm::dvec3& p) const {
    return glm::clamp(glm::ivec3((p - low_) * per_length_), glm::ivec3(0), glm::ivec3(along_ - 1));
  }

  std::size_t bucket_at(const glm::ivec3& i) const {
    return static_cast<std::size_t>(i.x + along_ * (i.y + along_ * i.z));
  }

  void insert(std::uint32_t t) {
    glm::dvec3 low = mesh_.position[mesh_.corner[t][0]], high = low;
    for (const std::uint32_t v : mesh_.corner[t]) {
      low = glm::min(low, mesh_.position[v]);
      high = glm::max(high, mesh_.position[v]);
    }
    const glm::ivec3 first = index_of(low), last = index_of(high);
    for (int z = first.z; z <= last.z; ++z) {
      for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) buckets_[bucket_at({x, y, z})].push_back(t);
      }
    }
  }

  std::array<double, 4> weights(std::uint32_t t, const glm::dvec3& p) const {
    const auto& corner = mesh_.corner[t];
    const glm::dvec3 a = mesh_.position[corner[0]], b = mesh_.position[corner[1]] - a,
                     c = mesh_.position[corner[2]] - a, d = mesh_.position[corner[3]] - a, q = p - a;
    const double whole = glm::dot(b, glm::cross(c, d));
    const double wb = glm::dot(q, glm::cross(c, d)) / whole, wc = glm::dot(q, glm::cross(d, b)) / whole,
                 wd = glm::dot(q, glm::cross(b, c)) / whole;
    return {1 - wb - wc - wd, wb, wc, wd};
  }

  const TetrahedralMesh& mesh_;
  glm::dvec3 low_;
  int along_ = 1;
  double per_length_ = 1;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace

struct TetrahedralPoisson::Solution {
  Solution(const DiffusionSurfaces& of, SurfaceTree&& with, TetrahedralMesh&& between, double distance)
      : surfaces(of),
        tree(std::move(with)),
        hull(hull_of(of, tree)),
        mesh(std::move(between)),
        values(values_of(mesh)),
        finder(mesh, tree.levels.back().front()),
        approximation(distance) {}

  /// The equations, their solution, and its cost.
  void solve_for(PoissonCost& cost, std::string& why_not);

  Color color_at(const glm::dvec3& point) const;
  bool is_beyond(std::uint32_t tetrahedron, const SurfaceSide& side) const;

  const DiffusionSurfaces& surfaces;
  SurfaceTree tree;
  ColorHull hull;
  TetrahedralMesh mesh;
  Values values;
  Finder finder;
  double approximation;           ///< metres: how far the mesh may be from the surfaces
  std::vector<glm::dvec3> color;  ///< one entry per value
};

void TetrahedralPoisson::Solution::solve_for(PoissonCost& cost, std::string& why_not) {
  const Given given = Painter(surfaces, tree).paint(mesh, values);
  const System system = system_of(mesh, values, given);
  const Solved solved = solve(system);
  constexpr double largest_residual = 1e-9;
  if (!solved.is_good || !(solved.residual < largest_residual)) {
    why_not = "the equations have no accurate solution";
    return;
  }
  for (std::size_t v = 0; v < values.count; ++v) {
    const Eigen::Index row = system.row[v];
    color.push_back(given.count[v] > 0
                        ? given.sum[v] / given.count[v]
                        : glm::dvec3(solved.values(row, 0), solved.values(row, 1), solved.values(row, 2)));
  }

  cost.tetrahedra = mesh.corner.size();
  cost.unknowns = static_cast<std::size_t>(system.right.rows());
  cost.residual = solved.residual;
  for (const glm::dvec3& c : color) {
    const glm::dvec3 beyond = glm::max(c - glm::dvec3(hull.high), glm::dvec3(hull.low) - c);
    cost.overshoot = std::max({cost.overshoot, beyond.x, beyond.y, beyond.z});
  }
  // Single precision and 32-bit numbers: places and colours, corners, values and neighbours.
  cost.storage_bytes = 12 * mesh.position.size() + 12 * color.size() + 3 * 16 * mesh.corner.size();
}

/// Whether a tetrahedron lies on the other side of a triangle.
bool TetrahedralPoisson::Solution::is_beyond(std::uint32_t tetrahedron, const SurfaceSide& side) const {
  glm::dvec3 middle(0);
  for (const std::uint32_t v : mesh.corner[tetrahedron]) middle += 0.25 * mesh.position[v];
  const auto [a, b, c] = corners(surfaces, side.triangle);
  return (glm::dot(middle - a, glm::cross(b - a, c - a)) < 0) != (side.side == SideOf::back);
}

Color TetrahedralPoisson::Solution::color_at(const glm::dvec3& point) const {
  const std::optional<Finder::Place> place = finder.find(point);
  if (!place) return Color(color_of(surfaces, nearest_side(surfaces, tree, point).value()));
  const std::optional<SurfaceSide> near = nearest_side(surfaces, tree, point, approximation);
  if (near && is_beyond(place->tetrahedron, *near)) return Color(color_of(surfaces, *near));
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < 4; ++i) sum += place->weight[i] * color[values.of_corner[place->tetrahedron][i]];
  return Color(sum);
}

TetrahedralPoisson::TetrahedralPoisson(const DiffusionSurfaces& surfaces, const PoissonOptions& options) {
  // Mesh.
  SurfaceTree tree = make_surface_tree(surfaces);
  const double cell_size = options.cell_size * tree.size;
  const auto start = std::chrono::steady_clock::now();
  TetrahedralMeshing meshing = make_tetrahedral_mesh(surfaces, cell_size);
  cost_.meshing_seconds = seconds_since(start);
  why_not_ = meshing.why_not;
  if (!meshing.mesh) return;

  // Solve.
  const auto meshed = std::chrono::steady_clock::now();
  auto solution = std::make_unique<Solution>(surfaces, std::move(tree), std::move(*meshing.mesh), cell_size / 20);
  solution->solve_for(cost_, why_not_);
  cost_.solving_seconds = seconds_since(meshed);
  if (why_not_.empty()) solution_ = std::move(solution);
}

TetrahedralPoisson::~TetrahedralPoisson() = default;

std::vector<Color> TetrahedralPoisson::at(std::span<const glm::vec3> points) const {
  require_finite(points);
  std::vector<Color> colors;
  colors.reserve(points.size());
  for (const glm::vec3& point : points) colors.push_back(solution_->color_at(glm::dvec3(point)));
  return colors;
}

}  // namespace pomona::bench
