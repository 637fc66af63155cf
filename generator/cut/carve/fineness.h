// How fine a closed knife's surface should be at each point.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// A point, and the length that edges should have there.
struct FinenessSource {
  glm::dvec3 place{0};
  double size = 0;
};

/// The wanted edge length at a point: the minimum over all sources of (size of the source + distance from it *
/// grading). The result does not depend on the order of the sources.
class Fineness {
 public:
  /// \param grading growth of the size per metre of distance.
  Fineness(std::vector<FinenessSource> sources, double grading);

  /// The size at a point, at most `max`, metres.
  double at(const glm::dvec3& place, double max) const;

 private:
  struct Node {
    Box<double> box;
    double min = 0;           ///< size of all sources in it
    std::uint32_t first = 0;  ///< leaf: first source; else: left child, which the right one follows
    std::uint32_t count = 0;  ///< leaf: sources; else 0
  };

  /// From its sources or children, which must be filled already.
  void fill(Node& node) const;

  std::vector<FinenessSource> source_;
  std::vector<Node> node_;
  double grading_ = 0;
};

}  // namespace pomona
