// Strokes: polylines drawn in the view along -Z that cut straight through, as if with a bent knife.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// A polyline without crossings, swept along z; beyond its ends it goes on straight for ever. Each of its edges is a
/// facet of the cutting surface.
class Stroke {
 public:
  /// `points`: metres, at least two, no two in a row equal.
  explicit Stroke(std::vector<glm::dvec2> points);

  struct Place {
    double distance = 0;  ///< metres, positive to the right of the stroke
    int facet = 0;        ///< the one that is nearest
  };
  /// How far a point lies from the stroke, and on which side.
  Place nearest(const glm::dvec2& point) const;

  int facets() const { return static_cast<int>(facets_.size()); }

  /// One edge. `from` and `to` are where it ends along its direction, 0 and its length, or infinity.
  struct Facet {
    glm::dvec2 start{0}, direction{1, 0};
    double from = 0, to = 0;
    double along = 0;  ///< metres from the stroke's first point to the facet's start

    /// Metres from the start to the foot of the point's perpendicular.
    double along_of(const glm::dvec2& point) const;
  };
  const Facet& facet(int i) const { return facets_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<Facet> facets_;
};

/// The polyline without points that are nearer to the one before than a ten thousandth of the whole's extent, or in
/// line with their neighbours. Its ends stay.
std::vector<glm::dvec2> cleaned(const std::vector<glm::dvec2>& points);

/// True if the stroke crosses or touches itself, or where its ends go on straight within `reach` of the middle.
bool crosses_itself(const std::vector<glm::dvec2>& points, const glm::dvec2& middle, double reach);

}  // namespace pomona
