// Strokes: polylines drawn in the view along -Z that cut straight through, as if with a bent knife.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// A polyline that does not cross itself, extruded along z. Beyond its ends it goes on straight without end. Each of
/// its edges is a facet of the cutting surface.
class Stroke {
 public:
  /// \param points metres, at least two; neighbours differ.
  explicit Stroke(std::vector<glm::dvec2> points);

  struct Place {
    double distance = 0;  ///< metres, positive to the right of the stroke
    int facet = 0;        ///< the nearest facet
  };
  /// The signed distance of a point from the stroke, and the nearest facet.
  Place nearest(const glm::dvec2& point) const;

  int facets() const { return static_cast<int>(facets_.size()); }

  /// One edge.
  struct Facet {
    glm::dvec2 start{0}, direction{1, 0};
    double from = 0, to = 0;  ///< its ends along its direction, metres from `start`: 0 and its length, or infinity
    double along = 0;         ///< distance from the stroke's first point to `start` along the stroke, metres

    /// The distance from the start to the foot of the point's perpendicular, metres.
    double along_of(const glm::dvec2& point) const;
  };
  const Facet& facet(int i) const { return facets_[static_cast<std::size_t>(i)]; }

  /// A box around neighbouring facets, so that not each of them is asked how near it is.
  struct Run {
    glm::dvec2 low{0}, high{0};
  };

 private:
  static constexpr std::size_t run_length = 8;  // facets

  void find_runs();
  std::size_t nearest_facet(const glm::dvec2& point) const;

  std::vector<Facet> facets_;
  std::vector<Run> runs_;  // of all facets but the last
};

/// The polyline without points that are nearer to the point before than a ten thousandth of the whole's size, and
/// without points in line with their neighbours. Its ends stay.
std::vector<glm::dvec2> cleaned(const std::vector<glm::dvec2>& points);

/// True if the stroke, with its straight extensions up to a distance `reach` from the middle, crosses or touches
/// itself.
bool crosses_itself(const std::vector<glm::dvec2>& points, const glm::dvec2& middle, double reach);

}  // namespace pomona
