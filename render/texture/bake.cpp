#include "render/texture/bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/style/look.h"
#include "render/texture/charts.h"

namespace pomona {

namespace {

/// Linear colours of the texture while it is made; alpha tells which texels are inside a chart.
class Canvas {
 public:
  explicit Canvas(int side) : side_(side), color_(static_cast<std::size_t>(side) * side), filled_(color_.size(), 0) {}

  int side() const { return side_; }
  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < side_ && y < side_ && filled_[at(x, y)] != 0; }
  const Color& color(int x, int y) const { return color_[at(x, y)]; }
  void set(int x, int y, const Color& color) {
    color_[at(x, y)] = color;
    filled_[at(x, y)] = 1;
  }

  /// Grows the charts by one texel: what lies just outside takes the mean of its filled neighbours.
  void bleed() {
    const Canvas before = *this;
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x) {
        if (!has(x, y)) bleed_into(before, x, y);
      }
    }
  }

  Image image() const {
    Image image{side_, side_, {}};
    image.pixels.reserve(color_.size());
    for (const Color& color : color_) image.pixels.push_back(to_srgb8(color));
    return image;
  }

 private:
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * side_ + x; }

  void bleed_into(const Canvas& before, int x, int y) {
    Color sum(0.0f);
    int count = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (!before.has(x + dx, y + dy)) continue;
        sum += before.color(x + dx, y + dy);
        ++count;
      }
    }
    if (count > 0) set(x, y, sum / static_cast<float>(count));
  }

  int side_;
  std::vector<Color> color_;
  std::vector<std::uint8_t> filled_;
};

/// A chart's place in the texture.
struct Placement {
  const Chart& chart;
  glm::dvec2 corner;  ///< texels, margin included
  double scale;       ///< texels per metre

  glm::dvec2 texel(const glm::vec3& p) const { return corner + (chart.project(p) - chart.low) * scale; }
};

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 ab = b - a;
  const double squared = glm::dot(ab, ab);
  const double t = squared > 0 ? std::clamp(glm::dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + ab * t);
}

class Baker {
 public:
  Baker(const Solid& solid, const Style& style, const BakeOptions& options)
      : solid_(solid), style_(style), options_(options), look_(solid.noise, solid.details), canvas_(options.texels) {}

  BakedSolid bake() {
    const std::vector<Chart> charts = charts_of(solid_);
    const Packing packing = packed(charts, options_.texels, options_.margin);
    start_result();
    for (std::size_t c = 0; c < charts.size(); ++c) {
      const Placement placement{charts[c], glm::dvec2(packing.corner[c] + glm::ivec2(options_.margin)),
                                packing.texels_per_metre};
      paint(placement);
      if (style_.ink && charts[c].cut_face >= 0) ink(placement);
      add_mesh(placement);
    }
    for (int i = 0; i < options_.margin; ++i) canvas_.bleed();
    result_.texture = canvas_.image();
    return std::move(result_);
  }

 private:
  void start_result() {
    Solid& out = result_.solid;
    out = solid_;
    out.position.clear();
    out.normal.clear();
    out.color.clear();
    out.part.clear();
    out.guide.clear();
    out.triangle.clear();
    out.cut_face.clear();
    out.surface.clear();
  }

  void paint(const Placement& place) {
    for (const std::uint32_t t : place.chart.triangles) paint_triangle(place, solid_.triangle[t]);
  }

  /// Every texel whose centre lies in the triangle, or less than a texel outside so that no gap is left.
  void paint_triangle(const Placement& place, const glm::uvec3& v) {
    const std::array<glm::dvec2, 3> p = {place.texel(solid_.position[v.x]), place.texel(solid_.position[v.y]),
                                         place.texel(solid_.position[v.z])};
    const glm::dvec2 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const double area = e1.x * e2.y - e1.y * e2.x;
    const glm::ivec2 low(glm::floor(glm::min(p[0], glm::min(p[1], p[2])) - 0.5));
    const glm::ivec2 high(glm::ceil(glm::max(p[0], glm::max(p[1], p[2])) + 0.5));
    for (int y = std::max(0, low.y); y < std::min(canvas_.side(), high.y); ++y) {
      for (int x = std::max(0, low.x); x < std::min(canvas_.side(), high.x); ++x) {
        const glm::dvec2 q = glm::dvec2(x + 0.5, y + 0.5) - p[0];
        double b = area != 0 ? (q.x * e2.y - q.y * e2.x) / area : 0.0;
        double c = area != 0 ? (e1.x * q.y - e1.y * q.x) / area : 0.0;
        const bool inside = b >= 0 && c >= 0 && b + c <= 1;
        if (!inside && canvas_.has(x, y)) continue;
        b = std::clamp(b, 0.0, 1.0);
        c = std::clamp(c, 0.0, 1.0 - b);
        canvas_.set(x, y, color_at(place, v, b, c));
      }
    }
  }

  Color color_at(const Placement& place, const glm::uvec3& v, double b, double c) const {
    const auto fb = static_cast<float>(b), fc = static_cast<float>(c);
    const Color plain = solid_.color[v.x] * (1 - fb - fc) + solid_.color[v.y] * fb + solid_.color[v.z] * fc;
    if (!style_.noise) return plain;
    const glm::dvec3 position = glm::dvec3(solid_.position[v.x]) * (1 - b - c) + glm::dvec3(solid_.position[v.y]) * b +
                                glm::dvec3(solid_.position[v.z]) * c;
    LookPlace looked_at{.position = position, .footprint = 1.0 / place.scale};
    if (place.chart.cut_face < 0) looked_at.face = DetailFace::skin;
    if (!solid_.guide.empty())
      looked_at.guide = interpolated(solid_.guide[v.x], solid_.guide[v.y], solid_.guide[v.z], fb, fc);
    return look_(plain, looked_at);
  }

  /// Lines on a cut face: of the segments that lie in its plane.
  void ink(const Placement& place) {
    const glm::dvec3 normal = glm::cross(place.chart.u, place.chart.v);
    const glm::vec3& on_face = solid_.position[solid_.triangle[place.chart.triangles.front()].x];
    const double level = glm::dot(normal, glm::dvec3(on_face));
    const double size = glm::length(place.chart.high - place.chart.low);
    for (const Solid::InkSegment& segment : solid_.ink_segments) {
      const bool in_plane = std::abs(glm::dot(normal, glm::dvec3(segment.a)) - level) < 1e-5 * size &&
                            std::abs(glm::dot(normal, glm::dvec3(segment.b)) - level) < 1e-5 * size;
      if (in_plane) ink_segment(place, segment, size);
    }
  }

  void ink_segment(const Placement& place, const Solid::InkSegment& segment, double size) {
    const double width = (segment.rim ? style_.outline_width : style_.inner_width) * solid_.ink.width * size;
    const double opacity = segment.rim ? 1.0 : style_.inner_opacity;
    const double reach = 0.5 * width * place.scale;  // texels
    const glm::dvec2 a = place.texel(segment.a), b = place.texel(segment.b);
    const glm::ivec2 low(glm::floor(glm::min(a, b) - reach - 1.0)), high(glm::ceil(glm::max(a, b) + reach + 1.0));
    for (int y = std::max(0, low.y); y < std::min(canvas_.side(), high.y); ++y) {
      for (int x = std::max(0, low.x); x < std::min(canvas_.side(), high.x); ++x) {
        if (!canvas_.has(x, y)) continue;
        const double distance = distance_to_segment({x + 0.5, y + 0.5}, a, b);
        const auto cover = static_cast<float>(opacity * std::clamp(reach + 0.5 - distance, 0.0, 1.0));
        // The darker of what is there and this line: segments of one stroke overlap at their ends.
        const Color inked = glm::mix(canvas_.color(x, y), solid_.ink.color, cover);
        if (cover > 0) canvas_.set(x, y, glm::min(canvas_.color(x, y), inked));
      }
    }
  }

  void add_mesh(const Placement& place) {
    Solid& out = result_.solid;
    std::map<std::uint32_t, std::uint32_t> known;
    for (const std::uint32_t t : place.chart.triangles) {
      glm::uvec3 copied;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t original = solid_.triangle[t][k];
        const auto [vertex, added] = known.try_emplace(original, static_cast<std::uint32_t>(out.position.size()));
        copied[k] = vertex->second;
        if (!added) continue;
        out.position.push_back(solid_.position[original]);
        out.normal.push_back(solid_.normal[original]);
        out.color.push_back(solid_.color[original]);
        out.part.push_back(solid_.part[original]);
        if (!solid_.guide.empty()) out.guide.push_back(solid_.guide[original]);
        result_.uv.push_back(glm::vec2(place.texel(solid_.position[original]) / static_cast<double>(canvas_.side())));
      }
      out.triangle.push_back(copied);
      out.cut_face.push_back(solid_.cut_face[t]);
      out.surface.push_back(solid_.surface[t]);
    }
  }

  const Solid& solid_;
  const Style& style_;
  const BakeOptions& options_;
  Look look_;
  Canvas canvas_;
  BakedSolid result_;
};

}  // namespace

BakedSolid baked(const Solid& solid, const Style& style, const BakeOptions& options) {
  return Baker(solid, style, options).bake();
}

}  // namespace pomona
