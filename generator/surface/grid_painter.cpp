#include "generator/surface/grid_painter.h"

namespace pomona {

namespace {

/// The mean of a ramp around, for poles, which lie at every place around at once.
Color mean(const Ramp<Color>& around) {
  constexpr int samples = 64;
  Color sum(0);
  for (int i = 0; i < samples; ++i) sum += around((i + 0.5) / samples);
  return sum / static_cast<float>(samples);
}

}  // namespace

GridPainter::GridPainter(DiffusionSurfaces& surfaces, const std::string& name, const Side& front, const Side& back,
                         const Ramp<double>& blur)
    : surfaces_(surfaces),
      index_(static_cast<std::int32_t>(surfaces.surface_names.size())),
      front_(front),
      back_(back),
      blur_(blur),
      front_mean_(mean(front.color.around)),
      back_mean_(mean(back.color.around)) {
  surfaces_.surface_names.push_back(name);
}

void GridPainter::append(const SweptGrid& grid) {
  const auto first = static_cast<std::uint32_t>(surfaces_.vertex_count());
  for (std::size_t v = 0; v < grid.position.size(); ++v) append_vertex(grid, v);
  for (const glm::uvec3& t : grid.triangle) {
    surfaces_.triangle.push_back(t + glm::uvec3(first));
    surfaces_.surface.push_back(index_);
    surfaces_.front_part.push_back(front_.part);
    surfaces_.back_part.push_back(back_.part);
  }
}

void GridPainter::append_vertex(const SweptGrid& grid, std::size_t v) {
  const auto color = [&](const PaintedColor& paint, const Color& mean_around) {
    return paint.along(grid.along[v]) * (grid.is_pole[v] != 0 ? mean_around : paint.around(grid.around[v]));
  };
  surfaces_.position.emplace_back(grid.position[v]);
  surfaces_.front_color.push_back(color(front_.color, front_mean_));
  surfaces_.back_color.push_back(color(back_.color, back_mean_));
  surfaces_.blur.push_back(static_cast<float>(blur_(grid.along[v])));
  surfaces_.front_hidden.push_back(front_.hidden ? 1 : 0);
  surfaces_.back_hidden.push_back(back_.hidden ? 1 : 0);
}

}  // namespace pomona
