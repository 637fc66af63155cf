#include "generator/cut/section/segment_source.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace pomona {

namespace {

/// Next to surfaces of one colour edges may be this many times as long as the surfaces' own.
constexpr double plain_growth = 3;

}  // namespace

SizeSource source_of(const CutSegment& s, const SplitMesh& mesh, double contrast) {
  const Color &front_from = mesh.front_color[s.from_vertex], &front_to = mesh.front_color[s.to_vertex],
              &back_from = mesh.back_color[s.from_vertex], &back_to = mesh.back_color[s.to_vertex];
  const Color change = glm::max(glm::abs(front_to - front_from), glm::abs(back_to - back_from));
  const double max = static_cast<double>(std::max({change.x, change.y, change.z}));
  SizeSource source;
  source.size = std::clamp(std::sqrt(0.25 * contrast / std::max(max, 1e-6)), 1.0, plain_growth);
  source.left = 0.5f * (front_from + front_to);
  source.right = 0.5f * (back_from + back_to);
  return source;
}

}  // namespace pomona
