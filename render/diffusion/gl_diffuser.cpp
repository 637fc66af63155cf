#include "render/diffusion/gl_diffuser.h"

#include <future>
#include <optional>
#include <utility>

#include "generator/diffusion/resolved_colors.h"
#include "render/diffusion/asked_fruits.h"
#include "render/diffusion/gl_thread.h"

namespace pomona {

namespace {

/// The lines of each quality, measured in docs/reports/diffusion.md.
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

/// The context, its programs, and the fruits that it keeps.
class GlEngine {
 public:
  GlEngine(std::unique_ptr<GlContext> context, const GlDiffuserOptions& options)
      : options_(options), thread_(std::move(context)) {
    const auto set_up = [this](const CurrentGl& gl) {
      caster_.emplace(gl, thread_.context());
      on_card_.emplace(caster_->max_bytes());
    };
    thread_.start(set_up).get();
  }
  ~GlEngine() {
    const auto free_all = [this](const CurrentGl&) {
      on_card_.reset();
      caster_.reset();
    };
    thread_.start(free_all).wait();
  }
  GlEngine(const GlEngine&) = delete;
  GlEngine& operator=(const GlEngine&) = delete;

  std::string renderer() const { return thread_.context().renderer(); }

  /// Makes a fruit ready for later calls.
  void prepare(const DiffusionSurfaces& surfaces) { kept_.of(surfaces); }

  std::vector<DiffusedColors> diffuse(std::span<const DiffusionTask> tasks) {
    for (const DiffusionTask& task : tasks) require_finite(task.points);
    const std::vector<TaskSights> sights = sights_of_tasks(looked_at(tasks), tasks);
    const Threads within = tasks.size() > 1 ? Threads{1} : options_.threads;
    std::vector<DiffusedColors> colors(tasks.size());
    parallel_for(tasks.size(), options_.threads, [&](std::size_t t) {
      const auto& [surfaces, points] = tasks[t];
      const PreparedFruit& fruit = *sights[t].fruit;
      const SidesOfPoints sides = sides_on_surfaces(*surfaces, fruit.tree, points, sights[t].near_surface, within);
      colors[t] = resolved_colors(*surfaces, fruit.tree, fruit.hull, points, sides, sights[t].value, within);
    });
    return colors;
  }

 private:
  /// Makes fruits ready; the card works on those that are ready.
  std::vector<AskedFruit> looked_at(std::span<const DiffusionTask> tasks) {
    std::vector<AskedFruit> fruits = asked_fruits(tasks);
    ReadyQueue<AskedFruit*> ready;
    std::future<void> looked = thread_.start([&](const CurrentGl& gl) { look(gl, ready); });
    try {
      parallel_for(fruits.size(), options_.threads, [&](std::size_t i) {
        make_ready(fruits[i], tasks, kept_);
        ready.put(&fruits[i]);
      });
    } catch (...) {
      ready.close();
      looked.wait();
      throw;
    }
    ready.close();
    looked.get();
    return fruits;
  }

  /// Casts rays for all fruits as they become ready.
  void look(const CurrentGl& gl, ReadyQueue<AskedFruit*>& ready) {
    GlPmvc pmvc(gl, *caster_, *on_card_, sampling_of(options_.quality));
    std::vector<AskedFruit*> started;
    for (std::vector<AskedFruit*> next = ready.take(); !next.empty(); next = ready.take()) {
      std::vector<const SightTask*> tasks;
      for (const AskedFruit* asked : next) tasks.push_back(&asked->sight);
      pmvc.start(tasks);
      started.insert(started.end(), next.begin(), next.end());
    }
    std::vector<std::vector<PointSight>> seen = pmvc.finish();
    for (std::size_t i = 0; i < started.size(); ++i) started[i]->seen = std::move(seen[i]);
  }

  GlDiffuserOptions options_;
  KeptFruits kept_;
  GlThread thread_;

  // Used on that thread alone.
  std::optional<GlRayCaster> caster_;
  std::optional<GlFruits> on_card_;
};

class GlField final : public ColorField {
 public:
  GlField(const DiffusionSurfaces& surfaces, std::shared_ptr<GlEngine> engine)
      : surfaces_(surfaces), engine_(std::move(engine)) {
    engine_->prepare(surfaces);
  }

  DiffusedColors at(std::span<const glm::vec3> points) const override {
    const DiffusionTask task{&surfaces_, points};
    return std::move(engine_->diffuse({&task, 1}).front());
  }

 private:
  const DiffusionSurfaces& surfaces_;
  std::shared_ptr<GlEngine> engine_;  // a field may outlive its diffuser
};

class GlDiffuser final : public Diffuser {
 public:
  GlDiffuser(std::unique_ptr<GlContext> context, const GlDiffuserOptions& options)
      : engine_(std::make_shared<GlEngine>(std::move(context), options)) {}

  const char* name() const override { return "gl"; }
  std::string device() const override { return engine_->renderer(); }

  std::unique_ptr<ColorField> field(const DiffusionSurfaces& surfaces) const override {
    return std::make_unique<GlField>(surfaces, engine_);
  }

  std::vector<DiffusedColors> diffuse_all(std::span<const DiffusionTask> tasks) const override {
    return engine_->diffuse(tasks);
  }

 private:
  std::shared_ptr<GlEngine> engine_;
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
