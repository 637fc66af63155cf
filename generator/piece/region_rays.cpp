#include "generator/piece/region_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "generator/mesh/box.h"

namespace pomona {

namespace {

/// Columns: two directions across the rays, and that of the rays. The ratios of its entries do not occur in fruits.
glm::dmat3 ray_frame() {
  const glm::dvec3 along = glm::normalize(glm::dvec3(0.3819660113, 0.2763932023, 1));
  const glm::dvec3 across = glm::normalize(glm::cross(glm::dvec3(0.1458980338, 1, 0.0901699437), along));
  return {across, glm::cross(along, across), along};
}

/// A place where a ray enters or leaves something.
struct Passing {
  std::uint32_t ray = 0;
  std::int32_t what = 0;  ///< index of a region, or -1 - index of a piece
  double height = 0;      ///< along the ray
  std::int32_t into = 0;  ///< +1 or -1

  auto key() const { return std::tie(ray, height, what, into); }
};

/// A lattice of rays, and their crossings.
class RayLattice {
 public:
  RayLattice(const Box<double>& across, int rays) {
    const glm::dvec3 size = across.size();
    step_ = std::sqrt(size.x * size.y / rays);
    low_ = across.low;
    columns_ = static_cast<std::int64_t>(size.x / step_) + 1;
    rows_ = static_cast<std::int64_t>(size.y / step_) + 1;
  }

  double step() const { return step_; }
  glm::dvec2 place(std::uint32_t ray) const {
    return {low_.x + (static_cast<double>(ray % columns_) + 0.5) * step_,
            low_.y + (static_cast<double>(ray / columns_) + 0.5) * step_};
  }

  /// Every ray through a triangle crosses it once. Rays through an edge or a corner cross one of its triangles, because
  /// the side of an edge is computed from its ends in one order for all triangles.
  void pass(const std::array<glm::dvec3, 3>& corner, std::int32_t what) {
    const auto low = [&](int k) { return std::min({corner[0][k], corner[1][k], corner[2][k]}); };
    const auto high = [&](int k) { return std::max({corner[0][k], corner[1][k], corner[2][k]}); };
    // Only rays through the triangle's box, and a little beside it for rounding: most triangles are smaller than a
    // step.
    constexpr double slack = 1e-6;  // steps
    const auto first = [&](double v, double from) {
      return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil((v - from) / step_ - 0.5 - slack)));
    };
    const auto last = [&](double v, double from, std::int64_t count) {
      return std::min(count - 1, static_cast<std::int64_t>(std::floor((v - from) / step_ - 0.5 + slack)));
    };
    const std::int64_t top = first(low(1), low_.y), bottom = last(high(1), low_.y, rows_), left = first(low(0), low_.x),
                       right = last(high(0), low_.x, columns_);
    for (std::int64_t y = top; y <= bottom; ++y) {
      for (std::int64_t x = left; x <= right; ++x) {
        const auto ray = static_cast<std::uint32_t>(y * columns_ + x);
        const glm::dvec2 p = place(ray);
        const int turn = turn_around(corner, p);
        if (turn != 0) passings_.push_back({ray, what, height_at(corner, p), -turn});
      }
    }
  }

  /// Sorts ray by ray, upwards.
  std::vector<Passing> sorted() && {
    std::sort(passings_.begin(), passings_.end(), [](const Passing& a, const Passing& b) { return a.key() < b.key(); });
    return std::move(passings_);
  }

 private:
  static double side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }

  static bool is_left(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec2& p) {
    if (std::tie(a.x, a.y, a.z) <= std::tie(b.x, b.y, b.z)) return side(a, b, p) >= 0;
    return !(side(b, a, p) >= 0);
  }

  /// +1 if the triangle runs counter-clockwise around the ray as seen from its end, -1 if clockwise, 0 if it misses it.
  static int turn_around(const std::array<glm::dvec3, 3>& c, const glm::dvec2& p) {
    const int left = is_left(c[0], c[1], p) + is_left(c[1], c[2], p) + is_left(c[2], c[0], p);
    return left == 3 ? 1 : left == 0 ? -1 : 0;
  }

  static double height_at(const std::array<glm::dvec3, 3>& c, const glm::dvec2& p) {
    const glm::dvec3 share(side(c[1], c[2], p), side(c[2], c[0], p), side(c[0], c[1], p));
    const double sum = share.x + share.y + share.z;
    const double min = std::min({c[0].z, c[1].z, c[2].z}), max = std::max({c[0].z, c[1].z, c[2].z});
    if (sum == 0) return 0.5 * (min + max);
    return std::clamp((share.x * c[0].z + share.y * c[1].z + share.z * c[2].z) / sum, min, max);
  }

  glm::dvec3 low_{0};
  double step_ = 1;
  std::int64_t columns_ = 1, rows_ = 1;
  std::vector<Passing> passings_;
};

/// How often one is in what, for the few things one is in at a time, and since which height.
class Surrounding {
 public:
  struct In {
    std::int32_t what = 0, times = 0;
    double since = 0;
  };

  void pass(std::int32_t what, std::int32_t into, double height) {
    const auto place = std::find_if(in_.begin(), in_.end(), [&](const In& entry) { return entry.what == what; });
    if (place == in_.end()) {
      in_.push_back({what, into, height});
    } else if ((place->times += into) == 0) {
      in_.erase(place);
    }
  }
  /// The smallest one; -1 if there is none.
  std::int32_t min() const {
    std::int32_t min = -1;
    for (const In& entry : in_) min = min < 0 ? entry.what : std::min(min, entry.what);
    return min;
  }
  /// 0 if one is in it, else the largest one; 0 if there is none.
  std::int32_t organ() const {
    std::int32_t last = 0;
    for (const In& entry : in_) {
      if (entry.times <= 0) continue;
      if (entry.what == 0) return 0;
      last = std::max(last, entry.what);
    }
    return last;
  }
  std::vector<In>& all() { return in_; }
  void clear() { in_.clear(); }

 private:
  std::vector<In> in_;
};

/// A stretch of a ray within a piece.
struct RayStretch {
  std::uint32_t ray = 0;
  std::size_t piece = 0;
  std::int32_t times = 0;  ///< how often the piece is around it
  double from = 0, to = 0;
};

/// Calls add(stretch, surrounding) for all stretches, `surrounding` without the pieces. A piece's stretches end where
/// it ends and where a region does, never where another piece does: so its sums are the same to the bit whichever
/// others are there.
template <typename Add>
void for_each_stretch(const std::vector<Passing>& passings, const Add& add) {
  Surrounding regions, pieces;
  for (std::size_t i = 0; i < passings.size(); ++i) {
    const Passing& now = passings[i];
    if (i == 0 || passings[i - 1].ray != now.ray) regions.clear(), pieces.clear();
    for (Surrounding::In& piece : pieces.all()) {
      if (now.what < 0 && now.what != piece.what) continue;
      if (now.height > piece.since)
        add(RayStretch{now.ray, static_cast<std::size_t>(-1 - piece.what), piece.times, piece.since, now.height},
            regions);
      piece.since = now.height;
    }
    (now.what < 0 ? pieces : regions).pass(now.what, now.into, now.height);
  }
}

/// Open pieces have no inside. \param seen gives a place in the frame of the rays
template <typename Seen>
void pass_pieces(RayLattice& lattice, std::span<const Solid> pieces, const Seen& seen) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].closed) continue;
    const std::vector<glm::vec3>& position = pieces[i].mesh.position;
    for (const glm::uvec3& t : pieces[i].mesh.triangle)
      lattice.pass({seen(position[t.x]), seen(position[t.y]), seen(position[t.z])}, -1 - static_cast<std::int32_t>(i));
  }
}

/// Moments of a stretch of a ray, per area of its cell and density.
Moments stretch(const glm::dvec2& p, double from, double to) {
  const double length = to - from, middle = 0.5 * (to * to - from * from),
               square = (to * to * to - from * from * from) / 3;
  Moments m;
  m.mass = length;
  m.first = {p.x * length, p.y * length, middle};
  m.second = {{p.x * p.x * length, p.x * p.y * length, p.x * middle},
              {p.x * p.y * length, p.y * p.y * length, p.y * middle},
              {p.x * middle, p.y * middle, square}};
  return m;
}

class ExcessSum {
 public:
  ExcessSum(std::span<const Solid> pieces, const PartRegions& regions, const glm::dvec3& origin)
      : pieces_(pieces), regions_(regions), origin_(origin) {}

  std::vector<Moments> run(std::span<const double> excess, int rays) const {
    RayLattice lattice(lattice_box(), rays);
    for (std::size_t r = 0; r < regions_.region.size(); ++r) {
      const PartRegions::Region& region = regions_.region[r];
      for (std::size_t t = region.first; t < region.first + region.count; ++t)
        lattice.pass(seen(regions_.position, regions_.triangle[t]), static_cast<std::int32_t>(r));
    }
    pass_pieces(lattice, pieces_, [&](const glm::vec3& place) { return seen(place); });
    std::vector<Moments> sums = summed(lattice, excess);
    for (Moments& m : sums) m = turned_back(m, lattice.step() * lattice.step());
    return sums;
  }

 private:
  glm::dvec3 seen(const glm::vec3& place) const { return (glm::dvec3(place) - origin_) * frame_; }
  std::array<glm::dvec3, 3> seen(const std::vector<glm::vec3>& position, const glm::uvec3& t) const {
    return {seen(position[t.x]), seen(position[t.y]), seen(position[t.z])};
  }

  Box<double> lattice_box() const {
    Box<double> box;
    for (const glm::uvec3& t : regions_.triangle) {
      for (int k = 0; k < 3; ++k) box.add(seen(regions_.position[t[k]]));
    }
    return box;
  }

  std::vector<Moments> summed(RayLattice& lattice, std::span<const double> excess) const {
    std::vector<Moments> sums(pieces_.size());
    for_each_stretch(std::move(lattice).sorted(), [&](const RayStretch& at, const Surrounding& regions) {
      const std::int32_t region = regions.min();
      if (region < 0 || excess[static_cast<std::size_t>(region)] == 0) return;
      sums[at.piece].add(stretch(lattice.place(at.ray), at.from, at.to),
                         at.times * excess[static_cast<std::size_t>(region)]);
    });
    return sums;
  }

  Moments turned_back(const Moments& m, double cell) const {
    return {cell * m.mass, cell * (frame_ * m.first), cell * (frame_ * m.second * glm::transpose(frame_))};
  }

  std::span<const Solid> pieces_;
  const PartRegions& regions_;
  glm::dvec3 origin_;
  glm::dmat3 frame_ = ray_frame();
};

}  // namespace

std::vector<std::map<std::int32_t, double>> organ_ray_volumes(std::span<const Solid> pieces,
                                                              std::span<const Enclosures::Triangle> skins,
                                                              const RegionRayOptions& options) {
  std::vector<std::map<std::int32_t, double>> sums(pieces.size());
  if (skins.empty()) return sums;
  const glm::dmat3 frame = ray_frame();
  Box<double> box;
  for (const Enclosures::Triangle& t : skins)
    for (const glm::dvec3& p : t.corner) box.add(p * frame);

  RayLattice lattice(box, options.rays);
  for (const Enclosures::Triangle& t : skins)
    lattice.pass({t.corner[0] * frame, t.corner[1] * frame, t.corner[2] * frame}, static_cast<std::int32_t>(t.mesh));
  pass_pieces(lattice, pieces, [&](const glm::vec3& place) { return glm::dvec3(place) * frame; });

  const double cell = lattice.step() * lattice.step();
  for_each_stretch(std::move(lattice).sorted(), [&](const RayStretch& at, const Surrounding& organs) {
    sums[at.piece][organs.organ()] += cell * at.times * (at.to - at.from);
  });
  return sums;
}

std::vector<Moments> excess_moments(std::span<const Solid> pieces, const PartRegions& regions,
                                    std::span<const double> excess, const glm::dvec3& origin,
                                    const RegionRayOptions& options) {
  const bool none = std::all_of(excess.begin(), excess.end(), [](double e) { return e == 0; });
  if (none || regions.triangle.empty()) return std::vector<Moments>(pieces.size());
  return ExcessSum(pieces, regions, origin).run(excess, options.rays);
}

}  // namespace pomona
