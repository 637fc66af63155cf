#include "render/diffusion/gl_pmvc.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>

#include "generator/base/morton.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

/// A point of a task.
struct Asked {
  std::size_t task = 0;
  std::uint32_t point = 0;
};

/// The points of a task along a Morton curve.
std::vector<Asked> in_order(std::size_t task, std::span<const glm::vec3> points) {
  if (points.empty()) return {};
  glm::dvec3 low(points.front()), high = low;
  for (const glm::vec3& point : points) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
  keyed.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    keyed.emplace_back(morton_code(glm::dvec3(points[i]), low, high), i);
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<Asked> order;
  order.reserve(keyed.size());
  for (const auto& [code, point] : keyed) order.push_back({task, point});
  return order;
}

/// A run of fruits that is on the card, and the tasks in it.
class PmvcRun {
 public:
  PmvcRun(const CurrentGl& gl, const GlRayCaster& caster, std::span<const RaySurfaces> fruits, std::size_t first_fruit,
          std::span<const SightTask> tasks)
      : gl_(gl),
        caster_(caster),
        fruits_(fruits),
        first_(first_fruit),
        tasks_(tasks),
        uploaded_(uploaded(gl, fruits)) {}

  /// The values of the points in `asked`, in that order; neighbours in it share a work-group.
  std::vector<Sight> sights(std::span<const Asked> asked, int lines) const {
    std::vector<PointGroup> groups;
    std::size_t task = tasks_.size();
    for (const Asked& one : asked) {
      const std::size_t fruit = tasks_[one.task].fruit - first_;
      if (one.task != task || groups.back().eye.size() == PointGroup::size) {
        groups.push_back({fruit, static_cast<std::uint32_t>(fruits_[fruit].used_parts.size()), {}});
      }
      task = one.task;
      groups.back().eye.push_back(fruits_[fruit].normalized(tasks_[one.task].points[one.point]));
    }
    return caster_.along(gl_, uploaded_, groups, lines);
  }

  PmvcValue value(const Asked& one, const Sight& sight, int lines) const {
    const RaySurfaces& fruit = fruits_[tasks_[one.task].fruit - first_];
    return {glm::dvec3(sight.mean), fruit.used_parts[sight.heaviest],
            static_cast<double>(sight.weight) * (2 * pi / lines) * fruit.scale};
  }

 private:
  const CurrentGl& gl_;
  const GlRayCaster& caster_;
  std::span<const RaySurfaces> fruits_;  ///< fruits of this run
  std::size_t first_;                    ///< index of the first of them among all
  std::span<const SightTask> tasks_;     ///< all
  GlFruits uploaded_;
};

}  // namespace

std::vector<std::vector<PmvcValue>> gl_pmvc(const CurrentGl& gl, const GlRayCaster& caster,
                                            std::span<const RaySurfaces> fruits, std::span<const SightTask> tasks,
                                            const LineSampling& sampling) {
  std::vector<std::vector<PmvcValue>> values;
  for (const SightTask& task : tasks) values.emplace_back(task.points.size());

  const std::vector<std::size_t> border = runs_that_fit(fruits, caster.max_bytes());
  for (std::size_t r = 0; r + 1 < border.size(); ++r) {
    std::vector<Asked> asked;
    for (std::size_t t = 0; t < tasks.size(); ++t) {
      if (tasks[t].fruit < border[r] || tasks[t].fruit >= border[r + 1]) continue;
      const std::vector<Asked> order = in_order(t, tasks[t].points);
      asked.insert(asked.end(), order.begin(), order.end());
    }
    const PmvcRun run(gl, caster, fruits.subspan(border[r], border[r + 1] - border[r]), border[r], tasks);

    // Everything once; once more, along more lines, where colours scatter.
    std::vector<Asked> rough;
    const std::vector<Sight> sights = run.sights(asked, sampling.lines);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      values[asked[i].task][asked[i].point] = run.value(asked[i], sights[i], sampling.lines);
      const bool scatters = static_cast<double>(sights[i].scatter) > sampling.max_scatter;
      if (sampling.fine_lines > 0 && scatters) rough.push_back(asked[i]);
    }
    const std::vector<Sight> finer = run.sights(rough, sampling.fine_lines);
    for (std::size_t i = 0; i < rough.size(); ++i) {
      values[rough[i].task][rough[i].point] = run.value(rough[i], finer[i], sampling.fine_lines);
    }
  }
  return values;
}

}  // namespace pomona
