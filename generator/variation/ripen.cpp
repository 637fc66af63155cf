#include "generator/variation/ripen.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "generator/base/gradient_noise.h"
#include "generator/base/parallel.h"
#include "generator/base/reproducible.h"

namespace pomona {

namespace {

bool is_none(const ColorShift& shift) { return shift.lightness == 0 && shift.chroma == 1 && shift.hue == 0; }

glm::dvec3 shifted(const glm::dvec3& lab, const ColorShift& shift) {
  const double c = reproducible::cos(shift.hue) * shift.chroma, s = reproducible::sin(shift.hue) * shift.chroma;
  return {lab.x + shift.lightness, c * lab.y - s * lab.z, s * lab.y + c * lab.z};
}

/// False for surfaces whose parts are not the template's.
template <typename Value>
bool names_one_of(std::int32_t part, const std::vector<Value>& parts) {
  return part >= 0 && static_cast<std::size_t>(part) < parts.size();
}

/// One part's way from unripe to overripe.
class PartRipening {
 public:
  PartRipening(const RipenessSketch::Part& sketch, const glm::dvec3& mean_drawn)
      : late_(sketch.late), keep_(sketch.keep), mean_(mean_drawn) {
    for (const auto& stop : sketch.stops) stops_.push_back({stop.at, glm::dvec3(to_oklab(stop.value))});
  }

  double late() const { return late_; }

  /// The drawn colour at its own ripeness.
  glm::dvec3 operator()(const glm::dvec3& drawn, double ripeness) const {
    const glm::dvec3 kept = keep_ * (drawn - mean_);
    Stop before{1, drawn}, after{1, drawn};  // the nearest stops to either side
    bool has_before = ripeness >= 1, has_after = ripeness <= 1;
    for (const Stop& stop : stops_) {
      const Stop moved{stop.at, stop.lab + kept};
      if (stop.at <= ripeness && (!has_before || stop.at > before.at)) before = moved, has_before = true;
      if (stop.at >= ripeness && (!has_after || stop.at < after.at)) after = moved, has_after = true;
    }
    if (!has_before) return after.lab;
    if (!has_after || before.at >= after.at) return before.lab;
    const double share = (ripeness - before.at) / (after.at - before.at);
    return before.lab + share * (after.lab - before.lab);
  }

 private:
  struct Stop {
    double at = 0;
    glm::dvec3 lab{0};
  };
  std::vector<Stop> stops_;
  double late_, keep_;
  glm::dvec3 mean_;
};

/// The part on one side of every vertex; no vertex is shared between surfaces.
std::vector<std::int32_t> parts_of_vertices(const DiffusionSurfaces& surfaces, SideOf side) {
  std::vector<std::int32_t> parts(surfaces.vertex_count(), -1);
  const std::vector<std::int32_t>& of_triangle = side == SideOf::front ? surfaces.front_part : surfaces.back_part;
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i)
    for (int k = 0; k < 3; ++k) parts[surfaces.triangle[i][k]] = of_triangle[i];
  return parts;
}

class Ripener {
 public:
  Ripener(DiffusionSurfaces surfaces, const Template& fruit, const SkinDepth& skin)
      : surfaces_(std::move(surfaces)),
        fruit_(fruit),
        skin_(skin),
        front_part_(parts_of_vertices(surfaces_, SideOf::front)),
        back_part_(parts_of_vertices(surfaces_, SideOf::back)) {}

  DiffusionSurfaces ripen(Threads threads) {
    find_parts();
    const std::vector<double> depth = depths(threads);
    parallel_for(surfaces_.vertex_count(), threads, [&](std::size_t v) {
      const double lateness = needs_place(v) ? lateness_at(glm::dvec3(surfaces_.position[v]), depth[v]) : 0;
      surfaces_.front_color[v] = changed(surfaces_.front_color[v], front_part_[v], lateness);
      surfaces_.back_color[v] = changed(surfaces_.back_color[v], back_part_[v], lateness);
    });
    return std::move(surfaces_);
  }

 private:
  void find_parts() {
    ripening_.resize(fruit_.parts.size());
    if (fruit_.individual.ripeness == 1) return;
    for (const RipenessSketch::Part& part : fruit_.ripeness.parts)
      ripening_[static_cast<std::size_t>(part.part)].emplace(part, mean_color(part.part));
  }

  glm::dvec3 mean_color(std::int32_t part) const {
    glm::dvec3 sum(0);
    std::size_t count = 0;
    const auto add = [&](const Color& color) { sum += glm::dvec3(to_oklab(color)), ++count; };
    for (std::size_t v = 0; v < surfaces_.vertex_count(); ++v) {
      if (front_part_[v] == part) add(surfaces_.front_color[v]);
      if (back_part_[v] == part) add(surfaces_.back_color[v]);
    }
    return count > 0 ? sum / static_cast<double>(count) : sum;
  }

  const PartRipening* ripening_of(std::int32_t part) const {
    if (!names_one_of(part, ripening_) || !ripening_[static_cast<std::size_t>(part)]) return nullptr;
    return &*ripening_[static_cast<std::size_t>(part)];
  }

  bool needs_place(std::size_t v) const { return ripening_of(front_part_[v]) || ripening_of(back_part_[v]); }

  /// Of the vertices that ripen by their place; where lateness stops changing, depths are no longer told apart.
  std::vector<double> depths(Threads threads) const {
    std::vector<double> depth(surfaces_.vertex_count(), 0.0);
    const auto& stops = fruit_.ripeness.depth.stops;
    if (stops.size() < 2) return depth;
    std::vector<std::size_t> vertices;
    std::vector<glm::dvec3> places;
    for (std::size_t v = 0; v < depth.size(); ++v) {
      if (!needs_place(v)) continue;
      vertices.push_back(v);
      places.emplace_back(surfaces_.position[v]);
    }
    const std::vector<double> found = skin_.depths(places, stops.back().at, threads);
    for (std::size_t i = 0; i < vertices.size(); ++i) depth[vertices[i]] = found[i];
    return depth;
  }

  double lateness_at(const glm::dvec3& place, double depth) const {
    const RipenessSketch& sketch = fruit_.ripeness;
    double lateness = sketch.height(skin_.height(place)) + sketch.depth(depth);
    if (sketch.patches > 0)
      lateness += sketch.patches * gradient_noise(place / sketch.patch_size, fruit_.individual.patches);
    return lateness;
  }

  Color changed(const Color& color, std::int32_t part, double lateness) const {
    const PartRipening* ripening = ripening_of(part);
    const double ripeness =
        ripening ? own_ripeness(fruit_.individual.ripeness, lateness + ripening->late(), fruit_.ripeness.spread) : 1;
    const std::vector<ColorShift>& shifts = fruit_.individual.shifts;
    const ColorShift shift = names_one_of(part, shifts) ? shifts[static_cast<std::size_t>(part)] : ColorShift{};
    if (ripeness == 1 && is_none(shift)) return color;

    const glm::dvec3 drawn = to_oklab(color);
    const glm::dvec3 lab = ripeness != 1 ? (*ripening)(drawn, ripeness) : drawn;
    if (lab == drawn && is_none(shift)) return color;
    return from_oklab_within_gamut(glm::vec3(is_none(shift) ? lab : shifted(lab, shift)));
  }

  DiffusionSurfaces surfaces_;
  const Template& fruit_;
  const SkinDepth& skin_;
  std::vector<std::int32_t> front_part_, back_part_;
  std::vector<std::optional<PartRipening>> ripening_;  // per part
};

}  // namespace

double own_ripeness(double ripeness, double lateness, double spread) {
  const double late = std::clamp(lateness, 0.0, 1.0);
  if (ripeness < 1) return 1 - std::clamp((1 - ripeness) * (1 + spread) - spread * (1 - late), 0.0, 1.0);
  return 1 + std::clamp((ripeness - 1) * (1 + spread) - spread * late, 0.0, 1.0);
}

bool has_own_colors(const Template& fruit) {
  const Individual& individual = fruit.individual;
  return (individual.ripeness != 1 && fruit.ripeness.declared()) || !individual.shifts.empty();
}

DiffusionSurfaces ripened(DiffusionSurfaces surfaces, const Template& fruit, const SkinDepth& skin, Threads threads) {
  if (!has_own_colors(fruit)) return surfaces;
  return Ripener(std::move(surfaces), fruit, skin).ripen(threads);
}

}  // namespace pomona
