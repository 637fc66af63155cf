#include "generator/diffusion/walk/walk_diffuser.h"

#include <utility>

#include "generator/base/error.h"

namespace pomona {

namespace {

DiffusedColors colors_of(WalkResult result) { return {std::move(result.color), std::move(result.part)}; }

class WalkField final : public ColorField {
 public:
  WalkField(const DiffusionSurfaces& surfaces, const WalkOptions& options) : walks_(surfaces, options) {}

  DiffusedColors at(std::span<const glm::vec3> points) const override { return colors_of(walks_.at(points)); }

 private:
  WalkOnSpheres walks_;
};

class WalkDiffuser final : public Diffuser {
 public:
  explicit WalkDiffuser(const WalkOptions& options) : options_(options) {}

  const char* name() const override { return "walk"; }

  std::unique_ptr<ColorField> field(const DiffusionSurfaces& surfaces) const override {
    return std::make_unique<WalkField>(surfaces, options_);
  }

  std::vector<DiffusedColors> diffuse_all(std::span<const DiffusionTask> tasks) const override {
    std::size_t total = 0, before = 0;
    for (const DiffusionTask& task : tasks) total += task.points.size();

    std::vector<DiffusedColors> colors;
    for (const DiffusionTask& task : tasks) {
      WalkOptions options = options_;
      if (options_.progress) {
        options.progress = [&](std::size_t done, std::size_t) { options_.progress(before + done, total); };
      }
      colors.push_back(colors_of(WalkOnSpheres(*task.surfaces, options).at(task.points)));
      before += task.points.size();
    }
    return colors;
  }

 private:
  WalkOptions options_;
};

}  // namespace

double standard_error_of(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return 4;
    case Quality::final:
      return 1;
    case Quality::reference:
      return 0.3;
  }
  return 1;
}

std::unique_ptr<Diffuser> make_walk_diffuser(const WalkOptions& options) {
  if (!(options.standard_error > 0)) {
    throw Error(ExitStatus::usage, "walk on spheres: the standard error to reach must be above 0");
  }
  return std::make_unique<WalkDiffuser>(options);
}

}  // namespace pomona
