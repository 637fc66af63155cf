#include "generator/compose/cluster_seats.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/variation/species_key.h"

namespace pomona {

namespace {

constexpr double packed = 0.82;  // of the spacing: how near darts may be before they are pushed apart
constexpr int pushes = 40;

/// The room between the hollow and the envelope.
class ClusterRoom {
 public:
  explicit ClusterRoom(const LawSketch& law) : law_(law), points_(law.envelope.points) {
    for (const glm::dvec2& p : points_) widest_ = std::max(widest_, p.x);
  }

  double low() const { return points_.front().y; }
  double high() const { return points_.back().y; }
  double widest() const { return widest_; }

  /// From the hollow to the envelope, or the hollow where there is no room between.
  double farthest(double height) const {
    const auto above =
        std::upper_bound(points_.begin(), points_.end(), height, [](double y, const glm::dvec2& p) { return y < p.y; });
    if (above == points_.begin()) return std::max(points_.front().x, law_.hollow);
    if (above == points_.end()) return std::max(points_.back().x, law_.hollow);
    const glm::dvec2 &a = *(above - 1), &b = *above;
    return std::max(a.x + (height - a.y) / (b.y - a.y) * (b.x - a.x), law_.hollow);
  }

  double share(double height) const { return high() > low() ? (height - low()) / (high() - low()) : 0.5; }

  double volume() const {
    double sum = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const double a = std::max(points_[i - 1].x, law_.hollow), b = std::max(points_[i].x, law_.hollow);
      const double ring = (a * a + a * b + b * b) / 3 - law_.hollow * law_.hollow;
      sum += pi * ring * (points_[i].y - points_[i - 1].y);
    }
    return sum;
  }

  /// The nearest place within.
  glm::dvec3 within(glm::dvec3 p) const {
    p.y = std::clamp(p.y, low(), high());
    const double radius = std::sqrt(p.x * p.x + p.z * p.z);
    const double wanted = std::clamp(radius, law_.hollow, farthest(p.y));
    if (radius == 0) return {wanted, p.y, 0};
    p.x *= wanted / radius;
    p.z *= wanted / radius;
    return p;
  }

 private:
  const LawSketch& law_;
  const std::vector<glm::dvec2>& points_;
  double widest_ = 0;
};

std::vector<glm::dvec3> thrown(const LawSketch& law, const ClusterRoom& room, const RandomStream& random) {
  std::vector<glm::dvec3> seats;
  const auto throws = static_cast<std::uint64_t>(2000 + 60 * cluster_room(law));
  for (std::uint64_t n = 0; n < throws; ++n) {
    const double height = room.low() + random.uniform(3 * n) * (room.high() - room.low());
    const double radius = room.widest() * std::sqrt(random.uniform(3 * n + 1));
    if (radius > room.farthest(height) || radius < law.hollow) continue;
    const double azimuth = 2 * pi * random.uniform(3 * n + 2);
    const glm::dvec3 dart(radius * reproducible::cos(azimuth), height, -radius * reproducible::sin(azimuth));
    const double apart = packed * law.spacing(room.share(height));
    const bool is_free = std::all_of(seats.begin(), seats.end(), [&](const glm::dvec3& seat) {
      const glm::dvec3 way = dart - seat;
      return glm::dot(way, way) > apart * apart;
    });
    if (is_free) seats.push_back(dart);
  }
  return seats;
}

std::vector<glm::dvec3> pushed_apart(std::vector<glm::dvec3> seats, const LawSketch& law, const ClusterRoom& room) {
  for (int push = 0; push < pushes; ++push) {
    std::vector<glm::dvec3> next = seats;
    for (std::size_t i = 0; i < seats.size(); ++i) {
      const double apart = law.spacing(room.share(seats[i].y));
      for (std::size_t j = 0; j < seats.size(); ++j) {
        const glm::dvec3 way = seats[i] - seats[j];
        const double distance = glm::length(way);
        if (distance > 0 && distance < apart) next[i] += way * (0.25 * (apart - distance) / distance);
      }
    }
    for (std::size_t i = 0; i < seats.size(); ++i) seats[i] = room.within(next[i]);
  }
  return seats;
}

}  // namespace

double cluster_room(const LawSketch& law) {
  // Balls of this diameter fill at most three quarters of any room, but their middles may lie on its walls.
  double least = law.spacing.stops.front().value;
  for (const auto& stop : law.spacing.stops) least = std::min(least, stop.value);
  const ClusterRoom room(law);
  const double across = room.widest() + 0.5 * least, high = room.high() - room.low() + least;
  const double grown = std::min(pi * across * across * high, 4 * room.volume() + 8 * least * least * least);
  return grown / (0.5 * least * least * least);
}

std::vector<glm::dvec3> cluster_seats(const LawSketch& law, VariantKey key) {
  const ClusterRoom room(law);
  std::vector<glm::dvec3> seats = thrown(law, room, RandomStream({}, "law/" + law.name));
  if (!is_drawn(key)) {
    const RandomStream random(key, "law/" + law.name);
    const double turn = 2 * pi * random.uniform(0), c = reproducible::cos(turn), s = reproducible::sin(turn);
    for (std::size_t i = 0; i < seats.size(); ++i) {
      glm::dvec3& p = seats[i];
      p = {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
      const double reach = law.jitter * law.spacing(room.share(p.y));
      for (int k = 0; k < 3; ++k) p[k] += reach * (2 * random.uniform(1 + 3 * i + static_cast<std::uint64_t>(k)) - 1);
      p = room.within(p);
    }
  }
  return pushed_apart(std::move(seats), law, room);
}

}  // namespace pomona
