#include "generator/surface/sweep.h"

#include <cstdint>

#include "generator/surface/swept_grid.h"

namespace pomona {

namespace {

/// The mean of a ramp around, for poles, which lie at every place around at once.
Color mean(const Ramp<Color>& around) {
  constexpr int samples = 64;
  Color sum(0);
  for (int i = 0; i < samples; ++i) sum += around((i + 0.5) / samples);
  return sum / static_cast<float>(samples);
}

/// Appends a sketch's grids, painted.
class Painter {
 public:
  Painter(DiffusionSurfaces& surfaces, const SurfaceSketch& sketch, std::int32_t index)
      : surfaces_(surfaces),
        sketch_(sketch),
        index_(index),
        front_mean_(mean(sketch.front.color.around)),
        back_mean_(mean(sketch.back.color.around)) {}

  void append(const SweptGrid& grid) {
    const auto first = static_cast<std::uint32_t>(surfaces_.vertex_count());
    for (std::size_t v = 0; v < grid.position.size(); ++v) append_vertex(grid, v);
    for (const glm::uvec3& t : grid.triangle) {
      surfaces_.triangle.push_back(t + glm::uvec3(first));
      surfaces_.surface.push_back(index_);
      surfaces_.front_part.push_back(sketch_.front.part);
      surfaces_.back_part.push_back(sketch_.back.part);
    }
  }

 private:
  void append_vertex(const SweptGrid& grid, std::size_t v) {
    const auto color = [&](const PaintedColor& paint, const Color& mean_around) {
      return paint.along(grid.along[v]) * (grid.is_pole[v] != 0 ? mean_around : paint.around(grid.around[v]));
    };
    surfaces_.position.emplace_back(grid.position[v]);
    surfaces_.front_color.push_back(color(sketch_.front.color, front_mean_));
    surfaces_.back_color.push_back(color(sketch_.back.color, back_mean_));
    surfaces_.blur.push_back(static_cast<float>(sketch_.blur(grid.along[v])));
    surfaces_.front_hidden.push_back(sketch_.front.hidden ? 1 : 0);
    surfaces_.back_hidden.push_back(sketch_.back.hidden ? 1 : 0);
  }

  DiffusionSurfaces& surfaces_;
  const SurfaceSketch& sketch_;
  std::int32_t index_;
  Color front_mean_, back_mean_;
};

}  // namespace

DiffusionSurfaces sweep(const Template& fruit, const SweepOptions& options) {
  DiffusionSurfaces surfaces;
  surfaces.part_names = fruit.parts;
  for (const SurfaceSketch& sketch : fruit.surfaces) {
    Painter painter(surfaces, sketch, static_cast<std::int32_t>(surfaces.surface_names.size()));
    surfaces.surface_names.push_back(sketch.name);
    for (const SweptGrid& grid : swept_grids(fruit, sketch, options)) painter.append(grid);
  }
  return surfaces;
}

}  // namespace pomona
