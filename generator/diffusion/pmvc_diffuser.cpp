#include "generator/diffusion/pmvc_diffuser.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>

#include "generator/base/error.h"
#include "generator/diffusion/cube_pmvc.h"
#include "generator/diffusion/line_pmvc.h"
#include "generator/diffusion/nearest_side.h"

namespace pomona {

namespace {

/// A point nearer than this to a surface, in parts of the surfaces' size, is on it.
constexpr double on_surface = 1e-5;

/// Lines for 2 directions each; measured in docs/diffusion.md.
constexpr int draft_lines = 64;
constexpr int final_lines = 640;

/// 6 x 64^2 directions: within 0.02/255 RMS of four times as many.
constexpr int reference_texels = 64;

void require_finite(std::span<const glm::vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y) && std::isfinite(points[i].z)) continue;
    throw Error(ExitStatus::bad_data, "diffusion: point " + std::to_string(i) + " has a coordinate that is not finite");
  }
}

/// The least and the greatest of the surfaces' colours, channel by channel.
struct Hull {
  Color low, high;
};

Hull hull_of(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) {
  const glm::uvec3& any = surfaces.triangle[tree.order.front()];
  Hull hull{surfaces.front_color[any.x], surfaces.front_color[any.x]};
  for (const std::uint32_t triangle : tree.order) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = surfaces.triangle[triangle][k];
      const Color &front = surfaces.front_color[vertex], &back = surfaces.back_color[vertex];
      hull.low = glm::min(hull.low, glm::min(front, back));
      hull.high = glm::max(hull.high, glm::max(front, back));
    }
  }
  return hull;
}

class PmvcField final : public ColorField {
 public:
  PmvcField(const DiffusionSurfaces& surfaces, const PmvcOptions& options)
      : surfaces_(surfaces), options_(options), tree_(make_surface_tree(surfaces)), hull_(hull_of(surfaces, tree_)) {}

  DiffusedColors at(std::span<const glm::vec3> points) const override {
    require_finite(points);
    const std::vector<PmvcValue> seen = values(points);

    // On a surface, and where nothing is seen, the nearest side decides.
    DiffusedColors colors{std::vector<Color>(points.size()), std::vector<std::int32_t>(points.size())};
    parallel_for(points.size(), options_.threads, [&](std::size_t i) {
      const double radius = seen[i].weight > 0 ? on_surface * tree_.size : std::numeric_limits<double>::infinity();
      const std::optional<SurfaceSide> nearest = nearest_side(surfaces_, tree_, glm::dvec3(points[i]), radius);
      const Color color(nearest ? color_of(surfaces_, *nearest) : seen[i].color);
      colors.color[i] = glm::clamp(color, hull_.low, hull_.high);
      colors.part[i] = nearest ? part_of(surfaces_, *nearest) : seen[i].part;
    });
    return colors;
  }

 private:
  std::vector<PmvcValue> values(std::span<const glm::vec3> points) const {
    if (options_.quality == Quality::reference) {
      return cube_pmvc(surfaces_, tree_, points, reference_texels, options_.threads);
    }
    const int lines = options_.quality == Quality::draft ? draft_lines : final_lines;
    return line_pmvc(surfaces_, tree_, points, lines, options_.threads);
  }

  const DiffusionSurfaces& surfaces_;
  PmvcOptions options_;
  SurfaceTree tree_;
  Hull hull_;
};

class PmvcDiffuser final : public Diffuser {
 public:
  explicit PmvcDiffuser(const PmvcOptions& options) : options_(options) {}

  const char* name() const override { return "cpu"; }

  std::unique_ptr<ColorField> field(const DiffusionSurfaces& surfaces) const override {
    return std::make_unique<PmvcField>(surfaces, options_);
  }

  std::vector<DiffusedColors> diffuse_all(std::span<const DiffusionTask> tasks) const override {
    std::vector<DiffusedColors> colors(tasks.size());
    parallel_for(tasks.size(), options_.threads,
                 [&](std::size_t i) { colors[i] = diffuse(*tasks[i].surfaces, tasks[i].points); });
    return colors;
  }

 private:
  PmvcOptions options_;
};

}  // namespace

std::unique_ptr<Diffuser> make_pmvc_diffuser(const PmvcOptions& options) {
  return std::make_unique<PmvcDiffuser>(options);
}

}  // namespace pomona
