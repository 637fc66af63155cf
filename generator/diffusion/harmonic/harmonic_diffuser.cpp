#include "generator/diffusion/harmonic/harmonic_diffuser.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/diffusion/harmonic/solve_field.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/resolved_colors.h"

namespace pomona {

namespace {

/// A point nearer than this to a surface, in parts of the surfaces' size, is on it.
constexpr double on_surface = 1e-5;

/// Points that one task looks up.
constexpr std::size_t points_at_once = 256;

FieldSampler solve(const DiffusionSurfaces& surfaces, const GridOptions& options) {
  return solved_field(prepared_field(surfaces, options), options);
}

class HarmonicField final : public ColorField {
 public:
  HarmonicField(const DiffusionSurfaces& surfaces, const HarmonicOptions& options)
      : surfaces_(surfaces),
        threads_(options.threads),
        tree_(make_surface_tree(surfaces)),
        hull_(hull_of(surfaces, tree_)),
        sampler_(solve(surfaces, grid_options(surfaces, options))) {}

  DiffusedColors at(std::span<const glm::vec3> points) const override {
    require_finite(points);
    DiffusedColors colors{std::vector<Color>(points.size()), std::vector<std::int32_t>(points.size())};
    parallel_for((points.size() + points_at_once - 1) / points_at_once, threads_, [&](std::size_t chunk) {
      const std::size_t end = std::min(points.size(), (chunk + 1) * points_at_once);
      for (std::size_t i = chunk * points_at_once; i < end; ++i) {
        const auto [color, part] = at(points[i]);
        colors.color[i] = glm::clamp(color, hull_.low, hull_.high);
        colors.part[i] = part;
      }
    });
    return colors;
  }

 private:
  std::pair<Color, std::int32_t> at(const glm::vec3& point) const {
    const std::optional<FieldSample> found = sampler_.at(point);

    // On a surface, and where nothing is in sight, the nearest side decides.
    const double radius = found ? on_surface * tree_.size : std::numeric_limits<double>::infinity();
    if (!found || found->distance <= 2 * radius) {
      if (const auto nearest = nearest_side(surfaces_, tree_, glm::dvec3(point), radius)) {
        return {Color(color_of(surfaces_, *nearest)), part_of(surfaces_, *nearest)};
      }
    }
    return {found->color, found->side ? part_of_side(*found->side) : nearest_part(point)};
  }

  std::int32_t part_of_side(std::uint32_t side) const {
    return (side % 2 == 0 ? surfaces_.front_part : surfaces_.back_part)[side / 2];
  }

  std::int32_t nearest_part(const glm::vec3& point) const {
    return part_of(surfaces_, *nearest_side(surfaces_, tree_, glm::dvec3(point)));
  }

  const DiffusionSurfaces& surfaces_;
  Threads threads_;
  SurfaceTree tree_;
  ColorHull hull_;
  FieldSampler sampler_;
};

class HarmonicDiffuser final : public Diffuser {
 public:
  explicit HarmonicDiffuser(const HarmonicOptions& options) : options_(options) {}

  const char* name() const override { return "harmonic"; }

  std::unique_ptr<ColorField> field(const DiffusionSurfaces& surfaces) const override {
    return std::make_unique<HarmonicField>(surfaces, options_);
  }

 private:
  HarmonicOptions options_;
};

}  // namespace

std::unique_ptr<Diffuser> make_harmonic_diffuser(const HarmonicOptions& options) {
  return std::make_unique<HarmonicDiffuser>(options);
}

}  // namespace pomona
