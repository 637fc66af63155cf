// Small parts of surfaces, and which of them provably do not cross.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The grid of a swept surface, as sweep/swept_grid.h numbers its vertices and triangles.
struct QuadGrid {
  std::uint32_t first_vertex = 0, first_triangle = 0;
  int around = 0;  ///< spokes
  int rings = 0;   ///< poles included
  bool starts_in_pole = false, ends_in_pole = false;
  bool closed_along = false;  ///< the last ring is followed by the first

  int bands() const { return closed_along ? rings : rings - 1; }
  bool is_fan(int band) const { return (band == 0 && starts_in_pole) || (band == rings - 2 && ends_in_pole); }
  std::uint32_t vertex(int ring, int spoke) const;
  std::uint32_t triangle(int band, int spoke) const;  ///< the first of that quad, or the fan's
};

/// The tiles of all finite triangles: patches of 4 x 4 quads and fans of grids, and short runs of what is no grid.
class SurfaceTiles {
 public:
  /// \param step metres: every coordinate may be off by half of it, and a bit of rounding in doubles.
  SurfaceTiles(const DiffusionSurfaces& surfaces, double step);

  std::uint32_t count() const { return static_cast<std::uint32_t>(tile_.size()); }
  std::span<const std::uint32_t> triangles(std::uint32_t tile) const;  ///< ascending

  /// Whether a proof is found that no triangle of the one tile crosses any of the other, which may be the same:
  /// - A rectangle of a grid meets itself nowhere if one linear map takes the steps of each of its triangles back to
  ///   steps along the grid so well that the symmetric part of what results is positive definite: as a function on the
  ///   grid, the mapped surface is monotone, (A f(x) - A f(y)) . (x - y) > 0, so no two places coincide.
  /// - A fan with bands around it meets itself nowhere if all its triangles turn one way, seen along its mean normal,
  ///   and its rim runs around the pole once: then the triangles cover what the rim encloses once.
  /// - Tiles do not meet if one lies beyond the other's slab along its mean normal.
  bool are_clear(std::uint32_t one, std::uint32_t other);

 private:
  struct Tile {
    std::int32_t grid = -1;  ///< or -1
    int row = 0, column = 0;
    std::int32_t fan = -1;  ///< 0 at the start of a grid, 1 at its end; -1 if it is no fan
    std::uint32_t begin = 0, end = 0;
  };
  /// How a grid is divided, its fans left out.
  struct Layout {
    QuadGrid grid;
    int first_band = 0, end_band = 0;
    int rows = 0, columns = 0;
    std::uint32_t first_tile = 0;
  };
  struct Slab {
    glm::dvec3 normal{0};
    double low = 0, high = 0;
  };
  enum class Known : std::uint8_t { unknown, no, yes };

  void add_grid(const QuadGrid& grid);
  void add_tile(Tile tile);
  void add_triangle(std::uint32_t triangle);
  void add_run(std::uint32_t first, std::uint32_t end);
  bool share_a_clear_part(std::uint32_t one, std::uint32_t other);
  bool lie_in_clear_cap(std::uint32_t fan, std::uint32_t beside);
  bool is_clear_block(const Layout& layout, int row, int column);
  bool is_clear_cap(const Layout& layout, bool at_end, int bands) const;
  bool is_monotone(const QuadGrid& grid, int band, int bands, int spoke, int spokes) const;
  const Slab& slab_of(std::uint32_t tile);
  bool lies_beyond(const Slab& slab, std::uint32_t tile) const;
  glm::dvec3 place(const QuadGrid& grid, int ring, int spoke) const;

  const DiffusionSurfaces& surfaces_;
  double step_;
  std::vector<std::uint32_t> triangle_;  // tile by tile
  std::vector<Tile> tile_;
  std::vector<Layout> layout_;             // per grid
  std::vector<Known> block_;               // per tile: of it and the next in either direction
  std::vector<std::array<Known, 2>> cap_;  // per tile that is a fan: alone, and with the first row of tiles
  std::vector<std::optional<Slab>> slab_;  // per tile
};

}  // namespace pomona
