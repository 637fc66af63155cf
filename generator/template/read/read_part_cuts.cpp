#include "generator/template/read/read_part_cuts.h"

#include <algorithm>
#include <cstddef>

#include "generator/template/curve_faults.h"

namespace pomona {

namespace {

bool is_inner(const Side& front, const Side& back, int part) {
  return back.part == part && front.part != part && !front.hidden && !back.hidden;
}

bool is_blurred(const SurfaceSketch& surface) {
  const auto& stops = surface.blur.along.stops;
  return std::any_of(stops.begin(), stops.end(), [](const auto& stop) { return stop.value > 0; });
}

bool is_closed(const SurfaceSketch& surface) {
  return surface.type == SurfaceType::in_fold || !fault_of_open_ends(surface.vertical);
}

void check_spared(const TomlValue& value, const Template& fruit, int part) {
  bool has_shell = !fruit.meshes.empty();  // meshes are checked when they are cut
  for (const SurfaceSketch& surface : fruit.surfaces) {
    if (!is_inner(surface.front, surface.back, part)) continue;
    has_shell = true;
    if (is_blurred(surface))
      value.error("spares what lies behind surface \"" + surface.name + "\", which is blurred",
                  "leave out the surface's blur");
    if (!is_closed(surface))
      value.error("spares what lies behind surface \"" + surface.name + "\", which is open",
                  "draw its vertical curve from the axis to the axis");
  }
  for (const GrainSketch& grains : fruit.grains) {
    if (!is_inner(grains.front, grains.back, part)) continue;
    has_shell = true;
    if (grains.blur > 0)
      value.error("spares grains \"" + grains.name + "\", which are blurred", "leave out the grains' blur");
  }
  if (!has_shell)
    value.error("spares a part that no surface encloses", "draw a closed surface with the part on its back side alone");
}

}  // namespace

PartCuts read_part_cuts(const TomlTable& table, const Template& fruit) {
  PartCuts cuts;
  for (std::size_t i = 0; i < fruit.parts.size(); ++i) {
    if (!table.has(fruit.parts[i])) continue;
    const TomlValue cut = table.get(fruit.parts[i]).table().get("cut");
    const std::size_t what = cut.choice({"through", "spare", "hold"});
    if (what == 1) {
      cuts.spared.push_back(static_cast<int>(i));
      check_spared(cut, fruit, cuts.spared.back());
    } else if (what == 2) {
      cuts.held.push_back(static_cast<int>(i));
    }
  }
  return cuts;
}

}  // namespace pomona
