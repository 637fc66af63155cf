#include "generator/diffusion/pmvc/pmvc_diffuser.h"

#include "generator/diffusion/pmvc/cube_pmvc.h"
#include "generator/diffusion/pmvc/line_pmvc.h"
#include "generator/diffusion/pmvc/relaxed_lines.h"
#include "generator/diffusion/pmvc/values_off_surfaces.h"
#include "generator/diffusion/resolved_colors.h"

namespace pomona {

namespace {

/// `final` casts more lines where colours scatter by more than this; measured in docs/reports/diffusion.md.
constexpr int lines_where_colors_scatter = 352;
constexpr double max_scatter = 1.0 / 255;

LinePlan plan_for(Quality quality) {
  if (quality == Quality::draft) return {.lines = relaxed_draft_lines(), .more = {}};
  return {
      .lines = relaxed_final_lines(), .more = line_directions(lines_where_colors_scatter), .max_scatter = max_scatter};
}

/// 6 x 64^2 directions: within 0.02/255 RMS of four times as many.
constexpr int reference_texels = 64;

class PmvcField final : public ColorField {
 public:
  PmvcField(const DiffusionSurfaces& surfaces, const PmvcOptions& options)
      : surfaces_(surfaces), options_(options), tree_(make_surface_tree(surfaces)), hull_(hull_of(surfaces, tree_)) {}

  DiffusedColors at(std::span<const glm::vec3> points) const override {
    require_finite(points);
    const SidesOfPoints sides = sides_on_surfaces(surfaces_, tree_, points, options_.threads);
    const auto values_at = [&](std::span<const glm::vec3> off) { return values(off); };
    return resolved_colors(surfaces_, tree_, hull_, points, sides, values_off_surfaces(sides, points, values_at),
                           options_.threads);
  }

 private:
  std::vector<PmvcValue> values(std::span<const glm::vec3> points) const {
    if (options_.quality == Quality::reference) {
      return cube_pmvc(surfaces_, tree_, points, reference_texels, options_.threads);
    }
    return line_pmvc(surfaces_, tree_, points, plan_for(options_.quality), options_.threads);
  }

  const DiffusionSurfaces& surfaces_;
  PmvcOptions options_;
  SurfaceTree tree_;
  ColorHull hull_;
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
