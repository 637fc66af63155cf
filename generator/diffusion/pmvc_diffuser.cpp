#include "generator/diffusion/pmvc_diffuser.h"

#include "generator/diffusion/cube_pmvc.h"
#include "generator/diffusion/line_pmvc.h"
#include "generator/diffusion/settled_colors.h"

namespace pomona {

namespace {

/// Lines for 2 directions each; measured in docs/diffusion.md.
constexpr int draft_lines = 64;
constexpr int final_lines = 640;

/// 6 x 64^2 directions: within 0.02/255 RMS of four times as many.
constexpr int reference_texels = 64;

class PmvcField final : public ColorField {
 public:
  PmvcField(const DiffusionSurfaces& surfaces, const PmvcOptions& options)
      : surfaces_(surfaces), options_(options), tree_(make_surface_tree(surfaces)), hull_(hull_of(surfaces, tree_)) {}

  DiffusedColors at(std::span<const glm::vec3> points) const override {
    require_finite(points);
    return settled_colors(surfaces_, tree_, hull_, points, values(points), options_.threads);
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
