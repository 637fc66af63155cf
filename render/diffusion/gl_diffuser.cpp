#include "render/diffusion/gl_diffuser.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "generator/base/error.h"
#include "generator/diffusion/resolved_colors.h"
#include "render/diffusion/gl_pmvc.h"

namespace pomona {

namespace {

/// Measured in docs/reports/diffusion.md.
LineSampling sampling_of(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {.lines = 64};
    case Quality::final:
      return {.lines = 192, .fine_lines = 1536, .max_scatter = 1.0 / 255};
    case Quality::reference:
      break;
  }
  return {.lines = 12288};  // as many directions as the reference on the CPU
}

/// A prepared fruit: data for the card, and for the points that the CPU resolves.
struct PreparedFruit {
  SurfaceTree tree;
  ColorHull hull;
  RaySurfaces rays;
};

PreparedFruit prepared(const DiffusionSurfaces& surfaces) {
  PreparedFruit fruit{make_surface_tree(surfaces), {}, {}};
  fruit.hull = hull_of(surfaces, fruit.tree);
  fruit.rays = ray_surfaces(surfaces, fruit.tree);
  return fruit;
}

/// The context and its programs, for one thread at a time.
class GlEngine {
 public:
  explicit GlEngine(std::unique_ptr<GlContext> context) : context_(std::move(context)) {
    const CurrentGl gl(*context_);
    caster_.emplace(gl, *context_);
  }
  ~GlEngine() {
    try {
      const CurrentGl gl(*context_);
      caster_.reset();
    } catch (const Error&) {
      // The driver has given up; with the context go its programs.
    }
  }
  GlEngine(const GlEngine&) = delete;
  GlEngine& operator=(const GlEngine&) = delete;

  std::string renderer() const { return context_->renderer(); }

  std::vector<std::vector<PmvcValue>> values(std::span<const RaySurfaces> fruits, std::span<const SightTask> tasks,
                                             const LineSampling& sampling) {
    const std::lock_guard<std::mutex> only(mutex_);
    const CurrentGl gl(*context_);
    return gl_pmvc(gl, *caster_, fruits, tasks, sampling);
  }

 private:
  std::unique_ptr<GlContext> context_;
  std::optional<GlRayCaster> caster_;
  std::mutex mutex_;
};

class GlField final : public ColorField {
 public:
  GlField(const DiffusionSurfaces& surfaces, std::shared_ptr<GlEngine> engine, const GlDiffuserOptions& options)
      : surfaces_(surfaces), engine_(std::move(engine)), options_(options), fruit_(prepared(surfaces)) {}

  DiffusedColors at(std::span<const glm::vec3> points) const override {
    require_finite(points);
    const SightTask task{0, points};
    const auto values = engine_->values({&fruit_.rays, 1}, {&task, 1}, sampling_of(options_.quality));
    return resolved_colors(surfaces_, fruit_.tree, fruit_.hull, points, values.front(), options_.threads);
  }

 private:
  const DiffusionSurfaces& surfaces_;
  std::shared_ptr<GlEngine> engine_;  // a field may outlive its diffuser
  GlDiffuserOptions options_;
  PreparedFruit fruit_;
};

class GlDiffuser final : public Diffuser {
 public:
  GlDiffuser(std::unique_ptr<GlContext> context, const GlDiffuserOptions& options)
      : engine_(std::make_shared<GlEngine>(std::move(context))), options_(options) {}

  const char* name() const override { return "gl"; }
  std::string device() const override { return engine_->renderer(); }

  std::unique_ptr<ColorField> field(const DiffusionSurfaces& surfaces) const override {
    return std::make_unique<GlField>(surfaces, engine_, options_);
  }

  std::vector<DiffusedColors> diffuse_all(std::span<const DiffusionTask> tasks) const override {
    for (const DiffusionTask& task : tasks) require_finite(task.points);

    // Each fruit once, however many sections it has.
    std::vector<const DiffusionSurfaces*> distinct;
    std::map<const DiffusionSurfaces*, std::size_t> index;
    std::vector<SightTask> sights;
    for (const DiffusionTask& task : tasks) {
      const auto [place, is_new] = index.emplace(task.surfaces, distinct.size());
      if (is_new) distinct.push_back(task.surfaces);
      sights.push_back({place->second, task.points});
    }
    std::vector<PreparedFruit> fruits(distinct.size());
    parallel_for(distinct.size(), options_.threads, [&](std::size_t i) { fruits[i] = prepared(*distinct[i]); });

    std::vector<RaySurfaces> rays;
    for (PreparedFruit& fruit : fruits) rays.push_back(std::move(fruit.rays));
    const auto values = engine_->values(rays, sights, sampling_of(options_.quality));
    std::vector<DiffusedColors> colors;
    for (std::size_t t = 0; t < tasks.size(); ++t) {
      const PreparedFruit& fruit = fruits[sights[t].fruit];
      colors.push_back(
          resolved_colors(*tasks[t].surfaces, fruit.tree, fruit.hull, tasks[t].points, values[t], options_.threads));
    }
    return colors;
  }

 private:
  std::shared_ptr<GlEngine> engine_;
  GlDiffuserOptions options_;
};

}  // namespace

std::unique_ptr<Diffuser> make_gl_diffuser(const GlDiffuserOptions& options) {
  auto context = options.route ? std::make_unique<GlContext>(*options.route) : std::make_unique<GlContext>();
  return std::make_unique<GlDiffuser>(std::move(context), options);
}

std::unique_ptr<Diffuser> make_diffuser_on_graphics_card(const GlDiffuserOptions& options) {
  std::unique_ptr<GlContext> context = GlContext::on_graphics_card();
  if (context == nullptr || context->version() < 45) return nullptr;
  return std::make_unique<GlDiffuser>(std::move(context), options);
}

}  // namespace pomona
