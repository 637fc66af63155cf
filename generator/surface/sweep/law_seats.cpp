#include "generator/surface/sweep/law_seats.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "generator/base/units.h"
#include "generator/surface/sweep/grid_place.h"

namespace pomona {

namespace {

constexpr int tally_steps = 2048;  // along the vertical curve

/// Near a pole a lattice would go on for ever, ever finer: its girth is at least this share of the largest.
constexpr double least_girth = 0.03;

/// The number of seats, or of tiers of several seats, below each place of the vertical curve.
class SeatTally {
 public:
  SeatTally(const LawSketch& law, const Curve& vertical) : law_(law) {
    const Curve even = resampled(vertical, tally_steps + 1);
    for (const glm::dvec2& p : even.points) girth_ = std::max(girth_, p.x);
    for (const glm::dvec2& p : even.points) radius_.push_back(std::max(p.x, least_girth * girth_));
    const double step = length(vertical) / tally_steps;
    below_.push_back(0);
    for (int i = 0; i < tally_steps; ++i) {
      const double share = (i + 0.5) / tally_steps;
      const bool inside = share >= law.from && share <= law.to;
      below_.push_back(below_.back() + (inside ? step * per_metre(share, radius_at(share)) : 0));
    }
  }

  double all() const { return below_.back(); }

  /// The share of the vertical curve below which so many are.
  double place_of(double number) const {
    const auto next = std::upper_bound(below_.begin(), below_.end(), number);
    if (next == below_.begin()) return law_.from;
    if (next == below_.end()) return law_.to;
    const auto after = static_cast<std::size_t>(next - below_.begin());
    const double share = (number - below_[after - 1]) / (below_[after] - below_[after - 1]);
    return (static_cast<double>(after - 1) + share) / tally_steps;
  }

  double radius_at(double share) const {
    const double at = std::clamp(share, 0.0, 1.0) * tally_steps, node = std::min(std::floor(at), tally_steps - 1.0);
    const auto i = static_cast<std::size_t>(node);
    return radius_[i] + (at - node) * (radius_[i + 1] - radius_[i]);
  }

  double spacing_at(double share) const {
    if (law_.kind != LawSketch::Kind::parastichies) return law_.spacing(share);
    const double across = beside_whole_turns(law_.low_pair * law_.divergence), rise = law_.low_pair * lattice_rise();
    return radius_at(share) * std::sqrt(across * across + rise * rise);
  }

 private:
  /// The rise from one seat of the lattice to the next, per radius, at which steps of both families are equally long.
  double lattice_rise() const {
    const double low = beside_whole_turns(law_.low_pair * law_.divergence);
    const double high = beside_whole_turns(law_.high_pair * law_.divergence);
    const double m = law_.low_pair, n = law_.high_pair;
    return std::sqrt((low * low - high * high) / (n * n - m * m));
  }

  /// Seats, or tiers, per length of the curve.
  double per_metre(double share, double radius) const {
    const double spacing = law_.spacing(share);
    switch (law_.kind) {
      case LawSketch::Kind::spiral:
        return 2 * pi * radius / (spacing * spacing * 0.8660254037844386);  // each has the area of a triangular lattice
      case LawSketch::Kind::parastichies:
        return 1 / (radius * lattice_rise());
      case LawSketch::Kind::rows:
      case LawSketch::Kind::whorls:
        return 1 / spacing;
      case LawSketch::Kind::cluster:
        break;
    }
    return 0;  // its seats lie on no surface
  }

  const LawSketch& law_;
  double girth_ = 0;
  std::vector<double> radius_, below_;
};

int seats_of_tier(const LawSketch& law) {
  return law.kind == LawSketch::Kind::rows || law.kind == LawSketch::Kind::whorls ? law.count : 1;
}

LawSeat seat_at(const SeatTally& tally, double number, double azimuth) {
  const double along = tally.place_of(number);
  return {along, azimuth, tally.spacing_at(along)};
}

/// The k-th seat of a tier; nothing beyond the band's end.
std::vector<LawSeat> tier_of(const LawSketch& law, const SeatTally& tally, int tier) {
  std::vector<LawSeat> seats;
  for (int k = 0; k < seats_of_tier(law); ++k) {
    double number = tier + 0.5, azimuth = law.start + 2 * pi * k / law.count;
    if (law.kind == LawSketch::Kind::spiral || law.kind == LawSketch::Kind::parastichies)
      azimuth = law.start + tier * law.divergence;
    if (law.kind == LawSketch::Kind::whorls) azimuth += tier * law.turn;
    if (law.kind == LawSketch::Kind::rows && k % 2 == 1) number += law.stagger;
    if (number > tally.all()) continue;
    LawSeat seat = seat_at(tally, number, azimuth);
    if (law.kind == LawSketch::Kind::rows) seat.azimuth += law.twist * (seat.along - law.from) / (law.to - law.from);
    seats.push_back(seat);
  }
  return seats;
}

LawSeat shifted(LawSeat seat, double jitter, const RandomStream& random, std::uint64_t number, const SeatTally& tally,
                double length) {
  const double reach = jitter * seat.spacing;
  seat.along += reach * (2 * random.uniform(2 * number) - 1) / length;
  seat.along = std::clamp(seat.along, 0.0, 1.0);
  seat.azimuth += reach * (2 * random.uniform(2 * number + 1) - 1) / tally.radius_at(seat.along);
  return seat;
}

}  // namespace

double law_room(const LawSketch& law, const Curve& vertical) {
  return SeatTally(law, vertical).all() * seats_of_tier(law);
}

std::vector<LawSeat> law_seats(const LawSketch& law, const Curve& vertical, const RandomStream& random) {
  const SeatTally tally(law, vertical);
  const double size = length(vertical);
  std::vector<LawSeat> seats;
  for (int tier = 0; tier + 0.5 <= tally.all(); ++tier) {
    for (const LawSeat& seat : tier_of(law, tally, tier))
      seats.push_back(law.jitter > 0 ? shifted(seat, law.jitter, random, seats.size(), tally, size) : seat);
  }
  return seats;
}

RandomStream law_draws(const LawSketch& law, VariantKey key) { return {key, "law/" + law.name}; }

std::vector<Dart> seated_darts(const LawSketch& law, const Curve& vertical, const SweptGrid& grid,
                               const GrainSketch& sketch, const GrainDraws& draws, VariantKey key) {
  const GridPlaces places(grid);
  const std::vector<LawSeat> seats = law_seats(law, vertical, law_draws(law, key));
  std::vector<Dart> darts;
  for (std::size_t n = 0; n < seats.size(); ++n) {
    const GridPoint point = places.at(seats[n].along, seats[n].azimuth);
    const double density = density_at(sketch, {point.position, point.normal, seats[n].along, 0, 1});
    if (density <= draws.places.uniform(draws_per_candidate * n + 5)) continue;
    Dart dart;
    dart.normal = sketch.on_front ? point.normal : -point.normal;
    dart.center = point.position - dart.normal * sketch.stance.sink;
    dart.tangent = unit_across(point.uphill, dart.normal);
    dart.number = n;
    dart.along = seats[n].along;
    dart.spacing = seats[n].spacing;
    dart.pose = grain_pose(sketch, dart, draws);
    darts.push_back(dart);
  }
  return darts;
}

}  // namespace pomona
