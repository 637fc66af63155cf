#include "render/diffusion/gl_pmvc.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "generator/base/units.h"

namespace pomona {

namespace {

/// Points that keep a large card busy while more fruits are uploaded.
constexpr std::size_t enough_points = 16384;

PointSight point_sight(const SightTask& task, const Sight& sight, int lines) {
  const double weight = static_cast<double>(sight.weight) * (2 * pi / lines) * task.frame->scale;
  return {{glm::dvec3(sight.mean), task.frame->used_parts[sight.heaviest], weight}, sight.near_surface};
}

}  // namespace

GlPmvc::GlPmvc(const CurrentGl& gl, const GlRayCaster& caster, GlFruits& fruits, const LineSampling& sampling)
    : gl_(gl), caster_(caster), fruits_(fruits), sampling_(sampling), lines_(GlRayCaster::lines(gl, sampling.lines)) {}

void GlPmvc::start(std::span<const SightTask* const> tasks) {
  std::size_t first = tasks_.size(), points = 0;
  for (const SightTask* task : tasks) {
    const bool is_new = !fruits_.place(task->fruit);
    if (is_new) {
      const std::shared_ptr<const RaySurfaces> surfaces = task->surfaces();
      if (!fruits_.add(gl_, task->fruit, *surfaces)) {
        // Make room: let the card finish its work.
        cast(first);
        settle();
        first = tasks_.size();
        fruits_.clear();
        fruits_.add(gl_, task->fruit, *surfaces);
      }
    }
    tasks_.push_back(task);
    sights_.emplace_back();
    points += task->eye.size();
    if (!is_new || points < enough_points) continue;
    cast(first);
    first = tasks_.size();
    points = 0;
  }
  cast(first);
}

std::vector<std::vector<PointSight>> GlPmvc::finish() {
  settle();
  return std::move(sights_);
}

std::vector<PointGroup> GlPmvc::groups_of(const SightTask& task, std::span<const glm::vec3> eyes) const {
  const FruitPlace place = *fruits_.place(task.fruit);
  const auto parts = static_cast<std::uint32_t>(task.frame->used_parts.size());
  std::vector<PointGroup> groups;
  for (std::size_t i = 0; i < eyes.size(); i += PointGroup::size) {
    groups.push_back({place, parts, eyes.subspan(i, std::min(PointGroup::size, eyes.size() - i))});
  }
  return groups;
}

/// Casts rays from all points of the tasks from `first` on.
void GlPmvc::cast(std::size_t first) {
  std::vector<PointGroup> groups;
  for (std::size_t t = first; t < tasks_.size(); ++t) {
    const std::vector<PointGroup> own = groups_of(*tasks_[t], tasks_[t]->eye);
    groups.insert(groups.end(), own.begin(), own.end());
  }
  if (groups.empty()) return;
  under_way_.push_back({first, tasks_.size() - first, caster_.cast(gl_, fruits_, groups, lines_)});
}

/// Waits for running work; then casts more lines where colours scatter.
void GlPmvc::settle() {
  std::vector<Rough> rough;
  for (const UnderWay& started : under_way_) {
    std::vector<Rough> more = read(started);
    std::move(more.begin(), more.end(), std::back_inserter(rough));
  }
  under_way_.clear();

  std::vector<PointGroup> groups;
  for (const Rough& own : rough) {
    const std::vector<PointGroup> more = groups_of(*tasks_[own.task], own.eye);
    groups.insert(groups.end(), more.begin(), more.end());
  }
  if (groups.empty()) return;
  const GlLines fine = GlRayCaster::lines(gl_, sampling_.fine_lines);
  const std::vector<Sight> seen = GlRayCaster::read(gl_, caster_.cast(gl_, fruits_, groups, fine));
  std::size_t next = 0;
  for (const Rough& own : rough) {
    for (const std::size_t i : own.point) {
      sights_[own.task][i] = point_sight(*tasks_[own.task], seen[next++], sampling_.fine_lines);
    }
  }
}

/// Stores the sights in `sights_`; returns the points where colours scatter.
std::vector<GlPmvc::Rough> GlPmvc::read(const UnderWay& started) {
  const std::vector<Sight> seen = GlRayCaster::read(gl_, started.rays);
  std::vector<Rough> rough;
  std::size_t next = 0;
  for (std::size_t t = started.first; t < started.first + started.count; ++t) {
    Rough& own = rough.emplace_back(Rough{t, {}, {}});
    for (std::size_t i = 0; i < tasks_[t]->eye.size(); ++i) {
      const Sight& sight = seen[next++];
      sights_[t].push_back(point_sight(*tasks_[t], sight, sampling_.lines));
      if (sampling_.fine_lines == 0 || static_cast<double>(sight.scatter) <= sampling_.max_scatter) continue;
      own.point.push_back(i);
      own.eye.push_back(tasks_[t]->eye[i]);
    }
  }
  return rough;
}

}  // namespace pomona
