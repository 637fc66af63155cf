#include "generator/variation/ripen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "generator/base/clipped_normal.h"
#include "generator/base/gradient_noise.h"
#include "generator/base/parallel.h"
#include "generator/base/reproducible.h"

namespace pomona {

namespace {

bool is_none(const ColorShift& shift) { return shift.lightness == 0 && shift.chroma == 1 && shift.hue == 0; }

/// How much of its way to black or white a colour may go at most: what is drawn pale or dark keeps its shades, where
/// all that went farther would end as one flat white or black. Tissues, which move as one, go a little less far than
/// the colours in them.
constexpr double most_of_room = 0.75, most_of_tissue = 0.7;

/// `value` moved, between 0 and 1; without effect on the move where the room is large.
double within_room(double value, double by) {
  const double room = most_of_room * std::max(0.0, by > 0 ? 1 - value : value);
  return value + std::clamp(by, -room, room);
}

glm::dvec3 shifted(const glm::dvec3& lab, const ColorShift& shift) {
  const double c = reproducible::cos(shift.hue) * shift.chroma, s = reproducible::sin(shift.hue) * shift.chroma;
  return {within_room(lab.x, shift.lightness), c * lab.y - s * lab.z, s * lab.y + c * lab.z};
}

/// False for surfaces with parts that the template does not have.
template <typename Value>
bool names_one_of(std::int32_t part, const std::vector<Value>& parts) {
  return part >= 0 && static_cast<std::size_t>(part) < parts.size();
}

/// The colours of one part from unripe to overripe.
class PartRipening {
 public:
  PartRipening(const RipenessSketch::Part& sketch, const glm::dvec3& mean_drawn)
      : late_(sketch.late), keep_(sketch.keep), mean_(mean_drawn) {
    for (const auto& stop : sketch.stops) stops_.push_back({stop.at, glm::dvec3(to_oklab(stop.value))});
  }

  double late() const { return late_; }

  /// The drawn colour at this ripeness.
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

/// The sRGB curve and its inverse as tables: faster than powers, and exact inverses of each other.
class SrgbTable {
 public:
  SrgbTable() {
    for (std::size_t i = 0; i < linear_.size(); ++i) linear_[i] = linear_from_srgb(static_cast<double>(i) / steps);
  }

  double to_linear(double encoded) const {
    const double place = std::clamp(encoded, 0.0, 1.0) * steps;
    const auto at = std::min(static_cast<std::size_t>(place), linear_.size() - 2);
    return linear_[at] + (place - static_cast<double>(at)) * (linear_[at + 1] - linear_[at]);
  }

  double to_srgb(double linear) const {
    const auto after = std::upper_bound(linear_.begin() + 1, linear_.end() - 1, std::clamp(linear, 0.0, 1.0));
    const auto at = static_cast<std::size_t>(after - linear_.begin()) - 1;
    const double share = (std::clamp(linear, 0.0, 1.0) - linear_[at]) / (linear_[at + 1] - linear_[at]);
    return (static_cast<double>(at) + share) / steps;
  }

 private:
  static constexpr int steps = 1024;
  std::array<double, steps + 1> linear_{};
};

/// The mean colour of one part's sides, OKLab; nothing if there are none.
std::optional<glm::dvec3> mean_color(const DiffusionSurfaces& surfaces, const std::vector<std::int32_t>& front_part,
                                     const std::vector<std::int32_t>& back_part, std::int32_t part) {
  glm::dvec3 sum(0);
  std::size_t count = 0;
  const auto add = [&](const Color& color) { sum += glm::dvec3(to_oklab(color)), ++count; };
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    if (front_part[v] == part) add(surfaces.front_color[v]);
    if (back_part[v] == part) add(surfaces.back_color[v]);
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

/// For each part the leading part of its tissue; -1 without a tissue.
std::vector<std::int32_t> leads_of(const Template& fruit) {
  std::vector<std::int32_t> leads(fruit.parts.size(), -1);
  for (const std::vector<int>& tissue : fruit.variation.color.tissues)
    for (const int part : tissue) leads[static_cast<std::size_t>(part)] = tissue.front();
  return leads;
}

class Ripener {
 public:
  Ripener(DiffusionSurfaces surfaces, const Template& fruit, const SkinDepth& skin,
          const std::vector<glm::dvec3>& colors)
      : surfaces_(std::move(surfaces)),
        fruit_(fruit),
        skin_(skin),
        leads_(leads_of(fruit)),
        tissue_colors_(colors),
        front_part_(parts_of_vertices(surfaces_, SideOf::front)),
        back_part_(parts_of_vertices(surfaces_, SideOf::back)) {}

  DiffusionSurfaces ripen(Threads threads) {
    find_parts();
    find_rooms();
    find_moves();
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
      ripening_[static_cast<std::size_t>(part.part)].emplace(
          part, leads_a_tissue(part.part)
                    ? tissue_colors_[static_cast<std::size_t>(part.part)]
                    : mean_color(surfaces_, front_part_, back_part_, part.part).value_or(glm::dvec3(0)));
  }

  bool leads_a_tissue(int part) const {
    const std::vector<std::vector<int>>& tissues = fruit_.variation.color.tissues;
    return std::any_of(tissues.begin(), tissues.end(), [&](const auto& tissue) { return tissue.front() == part; });
  }

  /// True if a part shares a tissue with others.
  bool is_of_tissue(std::int32_t part) const {
    return names_one_of(part, leads_) && leads_[static_cast<std::size_t>(part)] >= 0;
  }

  const PartRipening* ripening_of(std::int32_t part) const {
    if (!names_one_of(part, ripening_) || !ripening_[static_cast<std::size_t>(part)]) return nullptr;
    return &*ripening_[static_cast<std::size_t>(part)];
  }

  bool ripens(std::int32_t part) const {
    if (ripening_of(part)) return true;
    return is_of_tissue(part) && ripening_of(leads_[static_cast<std::size_t>(part)]);
  }

  bool needs_place(std::size_t v) const { return ripens(front_part_[v]) || ripens(back_part_[v]); }

  /// Depths of the vertices that ripen by their place. Depths beyond which lateness does not change are equal.
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

  double ripeness_at(const PartRipening* ripening, double lateness) const {
    if (!ripening) return 1;
    return own_ripeness(fruit_.individual.ripeness, lateness + ripening->late(), fruit_.ripeness.spread);
  }

  ColorShift shift_of(std::int32_t part) const {
    const std::vector<ColorShift>& shifts = fruit_.individual.shifts;
    return names_one_of(part, shifts) ? shifts[static_cast<std::size_t>(part)] : ColorShift{};
  }

  /// How much each part of a tissue ripens by itself. Not at all within what variants stray by themselves, where its
  /// parts stay as unlike as drawn; wholly 0.15 farther. No move of the drawn colours is right there: it would be cut
  /// short by the palest part, and green flesh would stay pink around a core that turns to cyan.
  double share_alone() const {
    constexpr double rounding = 1e-9;
    const double strays = max_clipped_normal * fruit_.variation.color.ripeness + rounding;
    return std::clamp((std::fabs(fruit_.individual.ripeness - 1) - strays) / 0.15, 0.0, 1.0);
  }

  /// \param own how the colour ripens, or null. Its shift is the tissue's.
  Color ripened_alone(const Color& color, const PartRipening* own, double lateness, std::int32_t leading) const {
    const double ripeness = ripeness_at(own, lateness);
    const Color ripe = ripeness != 1 ? in_gamut((*own)(to_oklab(color), ripeness)) : color;
    return moved(ripe, move_of(leading, 1));
  }

  Color changed_with_tissue(const Color& color, std::int32_t part, double lateness) const {
    const std::int32_t leading = leads_[static_cast<std::size_t>(part)];
    const Color together = moved(color, move_of(leading, ripeness_at(ripening_of(leading), lateness)));
    const double share = share_alone();
    if (share == 0) return together;
    const Color alone = ripened_alone(color, ripening_of(part), lateness, leading);
    return together + static_cast<float>(share) * (alone - together);
  }

  Color changed(const Color& color, std::int32_t part, double lateness) const {
    if (is_of_tissue(part)) return changed_with_tissue(color, part, lateness);
    const PartRipening* ripening = ripening_of(part);
    const double ripeness = ripeness_at(ripening, lateness);
    const ColorShift shift = shift_of(part);
    if (ripeness == 1 && is_none(shift)) return color;

    const glm::dvec3 drawn = to_oklab(color);
    const glm::dvec3 lab = ripeness != 1 ? (*ripening)(drawn, ripeness) : drawn;
    if (lab == drawn && is_none(shift)) return color;
    return from_oklab_within_gamut(glm::vec3(is_none(shift) ? lab : shifted(lab, shift)));
  }

  static Color in_gamut(const glm::dvec3& lab) { return from_oklab_within_gamut(glm::vec3(lab)); }

  /// How far the mean colours of a tissue can move in each channel of sRGB, down and up.
  struct Room {
    glm::dvec3 below{1}, above{1};
  };

  void find_rooms() {
    rooms_.resize(leads_.size());
    for (std::size_t part = 0; part < leads_.size(); ++part) {
      if (leads_[part] < 0 || tissue_colors_[part] == glm::dvec3(0)) continue;
      const Color mean = in_gamut(tissue_colors_[part]);
      Room& room = rooms_[static_cast<std::size_t>(leads_[part])];
      for (int c = 0; c < 3; ++c) {
        const double encoded = srgb_from_linear(mean[c]);
        room.below[c] = std::min(room.below[c], most_of_tissue * encoded);
        room.above[c] = std::min(room.above[c], most_of_tissue * (1 - encoded));
      }
    }
  }

  /// How far the colours of a tissue move in sRGB at a ripeness of its leading part. Visible differences stay: no
  /// colour moves farther than the palest and the darkest of the tissue can.
  glm::dvec3 move_at(std::int32_t leading, double ripeness) const {
    const glm::dvec3& mean = tissue_colors_[static_cast<std::size_t>(leading)];
    const PartRipening* ripening = ripening_of(leading);
    const glm::dvec3 ripe = ripening && ripeness != 1 ? (*ripening)(mean, ripeness) : mean;
    const ColorShift shift = shift_of(leading);
    const glm::dvec3 lab = is_none(shift) ? ripe : shifted(ripe, shift);
    if (lab == mean) return glm::dvec3(0);
    const Color before = in_gamut(mean), after = in_gamut(lab);
    const Room& room = rooms_[static_cast<std::size_t>(leading)];
    glm::dvec3 by;
    for (int c = 0; c < 3; ++c)
      by[c] = std::clamp(srgb_from_linear(after[c]) - srgb_from_linear(before[c]), -room.below[c], room.above[c]);
    return by;
  }

  /// Moves at evenly spaced ripenesses; vertices interpolate between them.
  void find_moves() {
    moves_.resize(leads_.size());
    for (std::size_t part = 0; part < leads_.size(); ++part) {
      if (leads_[part] != static_cast<std::int32_t>(part)) continue;
      for (int i = 0; i <= 2 * moves_of_one; ++i)
        moves_[part].push_back(move_at(leads_[part], static_cast<double>(i) / moves_of_one));
    }
  }

  glm::dvec3 move_of(std::int32_t leading, double ripeness) const {
    const std::vector<glm::dvec3>& moves = moves_[static_cast<std::size_t>(leading)];
    const double place = std::clamp(ripeness, 0.0, 2.0) * moves_of_one;
    const auto at = std::min(static_cast<std::size_t>(place), moves.size() - 2);
    const double share = place - static_cast<double>(at);
    return moves[at] + share * (moves[at + 1] - moves[at]);
  }

  Color moved(const Color& color, const glm::dvec3& by) const {
    if (by == glm::dvec3(0)) return color;
    Color result;
    for (int c = 0; c < 3; ++c)
      result[c] = static_cast<float>(srgb_.to_linear(within_room(srgb_.to_srgb(color[c]), by[c])));
    return result;
  }

  DiffusionSurfaces surfaces_;
  const Template& fruit_;
  const SkinDepth& skin_;
  static constexpr int moves_of_one = 128;  // for a ripeness of 1

  SrgbTable srgb_;
  std::vector<std::vector<glm::dvec3>> moves_;    ///< per leading part
  std::vector<Room> rooms_;                       ///< per leading part
  std::vector<std::int32_t> leads_;               ///< per part
  const std::vector<glm::dvec3>& tissue_colors_;  ///< per part
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

std::vector<glm::dvec3> tissue_colors(const DiffusionSurfaces& swept, const DiffusionSurfaces& grains,
                                      const Template& fruit) {
  std::vector<glm::dvec3> colors(fruit.parts.size(), glm::dvec3(0));
  for (const DiffusionSurfaces* surfaces : {&grains, &swept}) {
    if (fruit.variation.color.tissues.empty()) break;
    const std::vector<std::int32_t> front = parts_of_vertices(*surfaces, SideOf::front),
                                    back = parts_of_vertices(*surfaces, SideOf::back);
    for (const std::vector<int>& tissue : fruit.variation.color.tissues) {
      for (const int part : tissue) {
        const std::optional<glm::dvec3> mean = mean_color(*surfaces, front, back, part);
        if (mean) colors[static_cast<std::size_t>(part)] = *mean;
      }
    }
  }
  return colors;
}

DiffusionSurfaces ripened(DiffusionSurfaces surfaces, const Template& fruit, const SkinDepth& skin,
                          const std::vector<glm::dvec3>& leads, Threads threads) {
  if (!has_own_colors(fruit)) return surfaces;
  return Ripener(std::move(surfaces), fruit, skin, leads).ripen(threads);
}

}  // namespace pomona
