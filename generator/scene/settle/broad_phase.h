// Broad phase: which bodies are near a point. A hashed grid of their centres answers.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/common.hpp>
#include <glm/fwd.hpp>
#include <glm/vec3.hpp>

namespace pomona {

class BroadPhase {
 public:
  /// \param cell width of a cell, metres; visit() reaches at least this far.
  /// \param expected number of bodies that will be added, about.
  explicit BroadPhase(double cell, std::size_t expected = 0);

  void add(std::size_t body, const glm::dvec3& center);

  /// Calls visit(body) for every body whose centre is within a cell's width along each axis, and for some that are
  /// farther away.
  template <typename Visit>
  void visit(const glm::dvec3& center, const Visit& visit) const {
    const glm::i64vec3 cell = cell_of(center);
    for (std::int64_t z = cell.z - 1; z <= cell.z + 1; ++z)
      for (std::int64_t y = cell.y - 1; y <= cell.y + 1; ++y)
        for (std::int64_t x = cell.x - 1; x <= cell.x + 1; ++x)
          for (const Entry& entry : buckets_[bucket({x, y, z})])
            if (entry.cell == glm::i64vec3(x, y, z)) visit(entry.body);
  }

 private:
  struct Entry {
    glm::i64vec3 cell;
    std::size_t body;
  };
  glm::i64vec3 cell_of(const glm::dvec3& center) const { return glm::i64vec3(glm::floor(center / width_)); }
  std::size_t bucket(const glm::i64vec3& cell) const;

  double width_;                             ///< width of a cell, metres
  std::vector<std::vector<Entry>> buckets_;  ///< their number is a power of two
};

}  // namespace pomona
