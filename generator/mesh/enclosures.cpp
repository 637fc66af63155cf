#include "generator/mesh/enclosures.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "generator/base/cross.h"

namespace pomona {

namespace {

glm::dvec2 on_ground(const glm::dvec3& p) { return {p.x, p.z}; }

/// True if the edge passes the point on its +x side. Taken from its lower z up, so that both triangles at an edge
/// agree to the bit.
bool passes(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  const glm::dvec2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
  return p.x < low.x + (p.y - low.y) / (high.y - low.y) * (high.x - low.x);
}

/// +1 where the upward ray from p leaves through the triangle, -1 where it enters, 0 where it does not meet it.
int crossing(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p) {
  const glm::dvec2 a = on_ground(t[0]), b = on_ground(t[1]), c = on_ground(t[2]), q = on_ground(p);
  if ((passes(a, b, q) != passes(b, c, q)) == passes(c, a, q)) return 0;
  const glm::dvec2 ab = b - a, ac = c - a, aq = q - a;
  const double area = cross(ab, ac);
  if (area == 0) return 0;
  const double s = cross(aq, ac) / area, u = cross(ab, aq) / area;
  const double height = t[0].y + s * (t[1].y - t[0].y) + u * (t[2].y - t[0].y);
  if (height <= p.y) return 0;
  return area < 0 ? 1 : -1;  // x and z turn against each other seen from above
}

}  // namespace

Enclosures::Enclosures(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  if (triangles_.empty()) return;
  glm::dvec2 high = low_ = on_ground(triangles_.front().corner[0]);
  for (const Triangle& t : triangles_) {
    for (const glm::dvec3& p : t.corner) {
      low_ = glm::min(low_, on_ground(p));
      high = glm::max(high, on_ground(p));
    }
  }
  across_ = 1 + static_cast<int>(std::sqrt(static_cast<double>(triangles_.size()) / 4));
  set_cells(high);
  // Triangles that lie over many columns get fewer of them, so that entries take memory in proportion to triangles.
  constexpr std::size_t max_entries = 32;  // per triangle
  while (across_ > 1 && count_entries() > max_entries * triangles_.size()) {
    across_ = (across_ + 1) / 2;
    set_cells(high);
  }
  fill_columns();
}

void Enclosures::set_cells(const glm::dvec2& high) {
  cell_ = glm::max(high - low_, glm::dvec2(1e-300)) / static_cast<double>(across_);
}

template <typename Visit>
void Enclosures::visit_columns(const Triangle& t, const Visit& visit) const {
  const glm::dvec2 a = on_ground(t.corner[0]), b = on_ground(t.corner[1]), c = on_ground(t.corner[2]);
  const glm::dvec2 from = glm::min(a, glm::min(b, c)), to = glm::max(a, glm::max(b, c));
  const int left = column(from.x, 0), right = column(to.x, 0), last = column(to.y, 1);
  for (int z = column(from.y, 1); z <= last; ++z) visit(z * across_ + left, z * across_ + right);
}

std::size_t Enclosures::count_entries() const {
  std::size_t count = 0;
  for (const Triangle& t : triangles_)
    visit_columns(t, [&](int first, int last) { count += static_cast<std::size_t>(last - first + 1); });
  return count;
}

void Enclosures::fill_columns() {
  start_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(across_) + 1, 0);
  for (const Triangle& t : triangles_) {
    visit_columns(t, [&](int first, int last) {
      for (int at = first; at <= last; ++at) ++start_[static_cast<std::size_t>(at) + 1];
    });
  }
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  entry_.resize(start_.back());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    visit_columns(triangles_[i], [&](int first, int last) {
      for (int at = first; at <= last; ++at) entry_[next[static_cast<std::size_t>(at)]++] = i;
    });
  }
}

int Enclosures::column(double v, int axis) const {
  return static_cast<int>(std::clamp((v - low_[axis]) / cell_[axis], 0.0, static_cast<double>(across_ - 1)));
}

std::span<const std::uint32_t> Enclosures::over(const glm::dvec3& point) const {
  if (triangles_.empty()) return {};
  const auto at = static_cast<std::size_t>(column(point.z, 1) * across_ + column(point.x, 0));
  return std::span(entry_).subspan(start_[at], start_[at + 1] - start_[at]);
}

std::vector<std::pair<std::uint32_t, int>> Enclosures::around(const glm::dvec3& point) const {
  std::vector<std::pair<std::uint32_t, int>> windings;
  for (const std::uint32_t number : over(point)) {
    const Triangle& t = triangles_[number];
    const int by = crossing(t.corner, point);
    if (by == 0) continue;
    const auto place = std::lower_bound(windings.begin(), windings.end(), std::pair(t.mesh, -1000000));
    if (place != windings.end() && place->first == t.mesh)
      place->second += by;
    else
      windings.insert(place, {t.mesh, by});
  }
  std::erase_if(windings, [](const auto& w) { return w.second == 0; });
  return windings;
}

}  // namespace pomona
