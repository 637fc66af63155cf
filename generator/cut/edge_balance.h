// Tests whether a mesh whose triangles come one by one is closed, by position.
#pragma once

#include <bit>
#include <cstdint>

#include <glm/vec3.hpp>

namespace pomona {

/// Adds up a hash of every directed edge of a mesh, by position. The sum is zero if every edge has an opposite edge; if
/// not, it is zero only with a probability of 2^-64.
class EdgeBalance {
 public:
  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const std::uint64_t ha = fingerprint(a), hb = fingerprint(b), hc = fingerprint(c);
    add_edge(ha, hb);
    add_edge(hb, hc);
    add_edge(hc, ha);
  }
  void add(const EdgeBalance& other) { sum_ += other.sum_; }
  bool closed() const { return sum_ == 0; }

 private:
  static std::uint64_t mixed(std::uint64_t x) {
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  static std::uint64_t fingerprint(const glm::vec3& p) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) h = mixed(h + 0x9e3779b97f4a7c15u + std::bit_cast<std::uint32_t>(p[i] + 0.0f));
    return h;
  }

  void add_edge(std::uint64_t a, std::uint64_t b) { sum_ += a < b ? mixed(a + 3 * b) : 0 - mixed(b + 3 * a); }
  std::uint64_t sum_ = 0;
};

}  // namespace pomona
