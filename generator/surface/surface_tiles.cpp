#include "generator/surface/surface_tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "generator/base/cross.h"

namespace pomona {

namespace {

constexpr int tile_edge = 4;              // quads
constexpr std::uint32_t run_length = 32;  // triangles

int tiles_along(int quads) { return (quads + tile_edge - 1) / tile_edge; }

bool is_triangle(const glm::uvec3& t, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return t.x == a && ((t.y == b && t.z == c) || (t.y == c && t.z == b));
}

/// The triangles behind `first` that could be one grid: of one surface, if surfaces have numbers, until one has no
/// vertex seen before.
struct TriangleRun {
  std::uint32_t end = 0;
  std::uint32_t first_vertex = 0, end_vertex = 0;
};

TriangleRun run_from(const DiffusionSurfaces& surfaces, std::uint32_t first) {
  const glm::uvec3& v = surfaces.triangle[first];
  TriangleRun run{first, std::min({v.x, v.y, v.z}), 0};
  for (; run.end < surfaces.triangle_count(); ++run.end) {
    const glm::uvec3& t = surfaces.triangle[run.end];
    if (!surfaces.surface.empty() && surfaces.surface[run.end] != surfaces.surface[first]) break;
    if (run.end > first && std::min({t.x, t.y, t.z}) >= run.end_vertex) break;
    run.end_vertex = std::max({run.end_vertex, t.x + 1, t.y + 1, t.z + 1});
  }
  return run;
}

/// Whether the triangles of the run are those of the grid.
bool has_triangles_of(const DiffusionSurfaces& surfaces, const TriangleRun& run, const QuadGrid& grid) {
  std::uint32_t t = grid.first_triangle;
  for (int j = 0; j < grid.bands(); ++j) {
    const bool from_pole = j == 0 && grid.starts_in_pole, to_pole = j == grid.rings - 2 && grid.ends_in_pole;
    for (int i = 0; i < grid.around; ++i) {
      const std::uint32_t a = grid.vertex(j, i), b = grid.vertex(j, i + 1), c = grid.vertex(j + 1, i + 1),
                          d = grid.vertex(j + 1, i);
      if (!from_pole && (t == run.end || !is_triangle(surfaces.triangle[t++], a, b, c))) return false;
      if (!to_pole && (t == run.end || !is_triangle(surfaces.triangle[t++], a, c, d))) return false;
    }
  }
  return t == run.end;
}

/// The grid that a run of triangles is. Its counts are guessed from its first triangles and the number of its
/// vertices; then all triangles are compared.
std::optional<QuadGrid> grid_of(const DiffusionSurfaces& surfaces, std::uint32_t first, const TriangleRun& run) {
  QuadGrid grid{.first_vertex = run.first_vertex, .first_triangle = first};
  const auto last_corner = [&](std::uint32_t t) {
    const glm::uvec3& v = surfaces.triangle[t];
    return static_cast<int>(std::max({v.x, v.y, v.z}) - run.first_vertex);
  };
  const auto is_at_start = [&](std::uint32_t t) {
    const glm::uvec3& v = surfaces.triangle[t];
    return t < run.end && std::min({v.x, v.y, v.z}) == run.first_vertex;
  };
  grid.starts_in_pole = last_corner(first) == 2;
  if (grid.starts_in_pole)
    while (is_at_start(first + static_cast<std::uint32_t>(grid.around))) ++grid.around;
  else
    grid.around = last_corner(first) - 1;
  if (grid.around < 3) return std::nullopt;

  const int of_rings = static_cast<int>(run.end_vertex - run.first_vertex) - (grid.starts_in_pole ? 1 : 0);
  grid.ends_in_pole = of_rings % grid.around == 1;
  grid.rings = of_rings / grid.around + (grid.starts_in_pole ? 1 : 0) + (grid.ends_in_pole ? 1 : 0);
  if (grid.rings < 3) return std::nullopt;
  for (const bool closed : {false, true}) {
    grid.closed_along = closed;
    if (closed && (grid.starts_in_pole || grid.ends_in_pole)) break;
    if (has_triangles_of(surfaces, run, grid)) return grid;
  }
  return std::nullopt;
}

}  // namespace

std::uint32_t QuadGrid::vertex(int ring, int spoke) const {
  if (closed_along) ring %= rings;
  spoke %= around;
  if (ring == 0 && starts_in_pole) return first_vertex;
  const int before = starts_in_pole ? 1 + (ring - 1) * around : ring * around;
  const bool last_pole = ring == rings - 1 && ends_in_pole;
  return first_vertex + static_cast<std::uint32_t>(last_pole ? before : before + spoke);
}

std::uint32_t QuadGrid::triangle(int band, int spoke) const {
  const int before = starts_in_pole && band > 0 ? around * (2 * band - 1) : 2 * around * band;
  return first_triangle + static_cast<std::uint32_t>(before + (is_fan(band) ? spoke : 2 * spoke));
}

SurfaceTiles::SurfaceTiles(const DiffusionSurfaces& surfaces, double step) : surfaces_(surfaces), step_(step) {
  triangle_.reserve(surfaces.triangle_count());
  for (std::uint32_t t = 0; t < surfaces.triangle_count();) {
    const TriangleRun run = run_from(surfaces, t);
    if (const auto grid = grid_of(surfaces, t, run))
      add_grid(*grid);
    else
      add_run(t, run.end);
    t = run.end;
  }
  block_.resize(tile_.size(), Known::unknown);
  cap_.resize(tile_.size(), {Known::unknown, Known::unknown});
  slab_.resize(tile_.size());
}

std::span<const std::uint32_t> SurfaceTiles::triangles(std::uint32_t tile) const {
  return std::span(triangle_).subspan(tile_[tile].begin, tile_[tile].end - tile_[tile].begin);
}

void SurfaceTiles::add_grid(const QuadGrid& grid) {
  const auto number = static_cast<std::int32_t>(layout_.size());
  Layout layout{.grid = grid,
                .first_band = grid.starts_in_pole ? 1 : 0,
                .end_band = grid.bands() - (grid.ends_in_pole ? 1 : 0),
                .first_tile = count()};
  layout.rows = tiles_along(layout.end_band - layout.first_band), layout.columns = tiles_along(grid.around);
  layout_.push_back(layout);
  for (int row = 0; row < layout.rows; ++row) {
    for (int column = 0; column < layout.columns; ++column) {
      const int band = layout.first_band + row * tile_edge, spoke = column * tile_edge;
      const auto begin = static_cast<std::uint32_t>(triangle_.size());
      for (int j = band; j < std::min(band + tile_edge, layout.end_band); ++j) {
        const std::uint32_t end = grid.triangle(j, std::min(spoke + tile_edge, grid.around));
        for (std::uint32_t t = grid.triangle(j, spoke); t < end; ++t) add_triangle(t);
      }
      add_tile({.grid = number, .row = row, .column = column, .begin = begin});
    }
  }
  for (const std::int32_t fan : {0, 1}) {
    if (!(fan == 0 ? grid.starts_in_pole : grid.ends_in_pole)) continue;
    const auto begin = static_cast<std::uint32_t>(triangle_.size());
    const std::uint32_t first = grid.triangle(fan == 0 ? 0 : grid.bands() - 1, 0);
    for (std::uint32_t t = first; t < first + static_cast<std::uint32_t>(grid.around); ++t) add_triangle(t);
    add_tile({.grid = number, .fan = fan, .begin = begin});
  }
}

void SurfaceTiles::add_run(std::uint32_t first, std::uint32_t end) {
  for (std::uint32_t t = first; t < end;) {
    const auto begin = static_cast<std::uint32_t>(triangle_.size());
    for (const std::uint32_t last = std::min(end, t + run_length); t < last; ++t) add_triangle(t);
    add_tile({.begin = begin});
  }
}

void SurfaceTiles::add_triangle(std::uint32_t triangle) {
  for (int k = 0; k < 3; ++k) {
    const glm::vec3& p = surfaces_.position[surfaces_.triangle[triangle][k]];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return;
  }
  triangle_.push_back(triangle);
}

void SurfaceTiles::add_tile(Tile tile) {
  tile.end = static_cast<std::uint32_t>(triangle_.size());
  tile_.push_back(tile);
}

glm::dvec3 SurfaceTiles::place(const QuadGrid& grid, int ring, int spoke) const {
  return glm::dvec3(surfaces_.position[grid.vertex(ring, spoke)]);
}

bool SurfaceTiles::are_clear(std::uint32_t one, std::uint32_t other) {
  if (tile_[one].grid >= 0 && tile_[one].grid == tile_[other].grid && share_a_clear_part(one, other)) return true;
  if (one == other) return false;
  return lies_beyond(slab_of(one), other) || lies_beyond(slab_of(other), one);
}

/// Whether both tiles lie in a cap, a fan and the row of tiles beside it, that meets itself nowhere.
bool SurfaceTiles::lie_in_clear_cap(std::uint32_t fan, std::uint32_t beside) {
  const Layout& layout = layout_[static_cast<std::size_t>(tile_[fan].grid)];
  const bool alone = fan == beside, at_end = tile_[fan].fan == 1;
  if (!alone && (tile_[beside].fan >= 0 || tile_[beside].row != (at_end ? layout.rows - 1 : 0))) return false;
  Known& clear = cap_[fan][alone ? 0 : 1];
  if (clear == Known::unknown) {
    const int all_bands = layout.end_band - layout.first_band;
    const int of_row = at_end ? all_bands - (layout.rows - 1) * tile_edge : std::min(tile_edge, all_bands);
    clear = is_clear_cap(layout, at_end, alone ? 1 : 1 + of_row) ? Known::yes : Known::no;
  }
  return clear == Known::yes;
}

/// Whether both tiles, of one grid, lie in a block of tiles or a cap that meets itself nowhere.
bool SurfaceTiles::share_a_clear_part(std::uint32_t first, std::uint32_t second) {
  const Tile &one = tile_[first], &other = tile_[second];
  if (one.fan >= 0) return lie_in_clear_cap(first, second);
  if (other.fan >= 0) return lie_in_clear_cap(second, first);

  // Blocks of 2 x 2 tiles that hold both.
  const Layout& layout = layout_[static_cast<std::size_t>(one.grid)];
  const auto way = [](int from, int to, int count, bool closed) {
    const int along = to - from;
    if (!closed || std::abs(along) <= count / 2) return along;
    return along > 0 ? along - count : along + count;
  };
  const int down = way(one.row, other.row, layout.rows, layout.grid.closed_along);
  const int right = way(one.column, other.column, layout.columns, true);
  if (std::abs(down) > 1 || std::abs(right) > 1) return false;
  const int row = down < 0 ? other.row : one.row, column = right < 0 ? other.column : one.column;
  for (int y = row; y >= row - (down == 0 ? 1 : 0); --y)
    for (int x = column; x >= column - (right == 0 ? 1 : 0); --x)
      if (is_clear_block(layout, y, x)) return true;
  return false;
}

/// Of a tile, the next one around, and those behind them along the grid. \param row, column at least -1.
bool SurfaceTiles::is_clear_block(const Layout& layout, int row, int column) {
  const QuadGrid& grid = layout.grid;
  if (column < 0) column += layout.columns;
  if (row < 0 && !grid.closed_along) return false;
  if (row < 0) row += layout.rows;
  Known& clear = block_[layout.first_tile + static_cast<std::uint32_t>(row * layout.columns + column)];
  if (clear == Known::unknown) {
    const auto quads = [](int tile, int count) { return std::min(tile_edge, count - tile * tile_edge); };
    const int all_bands = layout.end_band - layout.first_band;
    int bands = quads(row, all_bands),
        spokes = quads(column, grid.around) + quads((column + 1) % layout.columns, grid.around);
    if (row + 1 < layout.rows || grid.closed_along) bands += quads((row + 1) % layout.rows, all_bands);
    const int first_band = layout.first_band + row * tile_edge;
    clear = is_monotone(grid, first_band, bands, column * tile_edge, spokes) ? Known::yes : Known::no;
  }
  return clear == Known::yes;
}

bool SurfaceTiles::is_monotone(const QuadGrid& grid, int band, int bands, int spoke, int spokes) const {
  constexpr int max = 2 * tile_edge;
  if (spokes >= grid.around || (grid.closed_along && bands >= grid.rings)) return false;
  std::array<std::array<glm::dvec3, max + 1>, max + 1> at;
  for (int j = 0; j <= bands; ++j)
    for (int i = 0; i <= spokes; ++i)
      at[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = place(grid, band + j, spoke + i);
  const auto rows = static_cast<std::size_t>(bands), columns = static_cast<std::size_t>(spokes);

  // The mean steps around and along, and the linear map that takes them to (1, 0) and (0, 1).
  glm::dvec3 u(0), v(0);
  for (std::size_t j = 0; j <= rows; ++j) u += at[j][columns] - at[j][0];
  for (std::size_t i = 0; i <= columns; ++i) v += at[rows][i] - at[0][i];
  u /= (bands + 1) * spokes, v /= (spokes + 1) * bands;
  const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), area = uu * vv - uv * uv;
  if (!(area > 1e-4 * uu * vv)) return false;
  const glm::dvec3 a = (u * vv - v * uv) / area, b = (v * uu - u * uv) / area;

  // What rounding may take from the least eigenvalue: a step of the grid is off by less than 2 `step_`, so the matrix
  // has an error below 2 sqrt(3/2) step_ (|a| + |b|); and some reserve for doubles.
  const double least = 4 * step_ * (glm::length(a) + glm::length(b)) + 1e-3;
  const auto is_positive = [&](const glm::dvec3& around, const glm::dvec3& along) {
    const double x = glm::dot(a, around) - least, y = glm::dot(b, along) - least;
    const double mixed = 0.5 * (glm::dot(b, around) + glm::dot(a, along));
    return (x > 0) & (y > 0) & (x * y > mixed * mixed);
  };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const glm::dvec3 &p = at[j][i], &q = at[j][i + 1], &r = at[j + 1][i + 1], &s = at[j + 1][i];
      if (!is_positive(q - p, r - q) || !is_positive(r - s, s - p)) return false;
    }
  return true;
}

/// \param bands the fan and those behind it.
bool SurfaceTiles::is_clear_cap(const Layout& layout, bool at_end, int bands) const {
  const QuadGrid& grid = layout.grid;
  const auto spokes = static_cast<std::size_t>(grid.around);
  const int pole_ring = at_end ? grid.rings - 1 : 0;
  const glm::dvec3 pole = place(grid, pole_ring, 0);
  std::vector<std::vector<glm::dvec3>> ring(static_cast<std::size_t>(bands));
  for (int k = 0; k < bands; ++k)
    for (int i = 0; i < grid.around; ++i)
      ring[static_cast<std::size_t>(k)].push_back(place(grid, pole_ring + (at_end ? -1 - k : 1 + k), i) - pole);

  // The plane across the mean normal, in which the rim turns counter-clockwise.
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i < spokes; ++i) normal += glm::cross(ring.back()[i], ring.back()[(i + 1) % spokes]);
  if (!(glm::length(normal) > 0)) return false;
  normal = glm::normalize(normal);
  const glm::dvec3 aside = std::fabs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(normal, aside)), y = glm::cross(normal, x);
  const auto flat = [&](std::size_t k, std::size_t i) {
    return glm::dvec2(glm::dot(ring[k][i % spokes], x), glm::dot(ring[k][i % spokes], y));
  };
  const auto turns = [&](const glm::dvec2& p, const glm::dvec2& q) {
    const double lengths = std::fabs(p.x) + std::fabs(p.y) + std::fabs(q.x) + std::fabs(q.y);
    return cross(p, q) > 8 * step_ * lengths + 64 * step_ * step_;
  };
  int runs_around = 0;
  for (std::size_t i = 0; i < spokes; ++i) {
    const glm::dvec2 rim = flat(ring.size() - 1, i), next = flat(ring.size() - 1, i + 1);
    if (!turns(flat(0, i), flat(0, i + 1)) || !turns(rim, next)) return false;
    runs_around += rim.y < 0 && next.y >= 0 ? 1 : 0;
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
      const glm::dvec2 a = flat(k, i), b = flat(k, i + 1), c = flat(k + 1, i), d = flat(k + 1, i + 1);
      // The diagonal runs from a quad's first corner along the grid: from the rim's side where the grid ends.
      const bool clear =
          at_end ? turns(d - c, b - c) && turns(b - c, a - c) : turns(c - a, d - a) && turns(d - a, b - a);
      if (!clear) return false;
    }
  }
  return runs_around == 1;
}

const SurfaceTiles::Slab& SurfaceTiles::slab_of(std::uint32_t tile) {
  if (slab_[tile]) return *slab_[tile];
  Slab slab;
  for (const std::uint32_t t : triangles(tile)) {
    const glm::uvec3& v = surfaces_.triangle[t];
    const glm::dvec3 a(surfaces_.position[v.x]), b(surfaces_.position[v.y]), c(surfaces_.position[v.z]);
    slab.normal += glm::cross(b - a, c - a);
  }
  const double length = glm::length(slab.normal);
  if (length > 0) slab.normal /= length;
  slab.low = 1e300, slab.high = -1e300;
  for (const std::uint32_t t : triangles(tile)) {
    for (int k = 0; k < 3; ++k) {
      const double at = glm::dot(slab.normal, glm::dvec3(surfaces_.position[surfaces_.triangle[t][k]]));
      slab.low = std::min(slab.low, at), slab.high = std::max(slab.high, at);
    }
  }
  // Both sides may be off by less than a step each.
  slab.low -= 4 * step_, slab.high += 4 * step_;
  return slab_[tile].emplace(slab);
}

bool SurfaceTiles::lies_beyond(const Slab& slab, std::uint32_t tile) const {
  bool above = true, below = true;
  for (const std::uint32_t t : triangles(tile)) {
    for (int k = 0; k < 3; ++k) {
      const double at = glm::dot(slab.normal, glm::dvec3(surfaces_.position[surfaces_.triangle[t][k]]));
      above &= at > slab.high, below &= at < slab.low;
    }
    if (!above && !below) return false;
  }
  return true;
}

}  // namespace pomona
