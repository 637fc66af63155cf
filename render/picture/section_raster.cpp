#include "render/picture/section_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace pomona {

namespace {

constexpr std::int64_t unit = 256;               // fixed-point steps a pixel
constexpr std::int64_t step = unit / 4;          // between samples
constexpr std::int64_t first_sample = unit / 8;  // of a pixel's samples
constexpr int band_rows = 32;                    // rows that one task draws

std::int64_t side(const FixedPoint& a, const FixedPoint& b, const FixedPoint& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Samples exactly on an edge belong to the triangle that has it as its top or left one.
bool owns_edge(const FixedPoint& a, const FixedPoint& b) { return a.y == b.y ? b.x > a.x : b.y < a.y; }

std::vector<PaperTriangle> on_paper(const CrossSection& section, const std::vector<PlacedFace>& faces) {
  std::vector<PaperTriangle> triangles;
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    // Corners go to the nearest fixed point; faces that are not shown are left out.
    PaperTriangle triangle{.face = section.cut[t]};
    if (!faces[triangle.face].shown) continue;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = section.triangle[t][i];
      const glm::dvec2 p = faces[triangle.face].to_paper(section.position[v]);
      triangle.corner[i] = {static_cast<std::int64_t>(std::floor(p.x * unit + 0.5)),
                            static_cast<std::int64_t>(std::floor(p.y * unit + 0.5))};
      triangle.color[i] = section.color[v];
      triangle.vertex[i] = v;
    }

    // All triangles turn the same way, and those without area cover nothing.
    triangle.area = side(triangle.corner[0], triangle.corner[1], triangle.corner[2]);
    if (triangle.area < 0) {
      std::swap(triangle.corner[1], triangle.corner[2]);
      std::swap(triangle.color[1], triangle.color[2]);
      std::swap(triangle.vertex[1], triangle.vertex[2]);
      triangle.area = -triangle.area;
    }
    if (triangle.area > 0) triangles.push_back(triangle);
  }
  return triangles;
}

struct PixelBox {
  std::int64_t x0, y0, x1, y1;  // inclusive
};

PixelBox box_of(const PaperTriangle& t, int width, int height) {
  const auto [xl, xh] = std::minmax({t.corner[0].x, t.corner[1].x, t.corner[2].x});
  const auto [yl, yh] = std::minmax({t.corner[0].y, t.corner[1].y, t.corner[2].y});
  const auto clamped = [](std::int64_t v, int limit) { return std::clamp<std::int64_t>(v, 0, limit - 1); };
  return {clamped(xl / unit, width), clamped(yl / unit, height), clamped(xh / unit, width), clamped(yh / unit, height)};
}

/// No sample of the pixel can be inside: one edge has it all on its outer side.
bool misses(const PaperTriangle& t, std::int64_t px, std::int64_t py) {
  const FixedPoint center{px * unit + unit / 2, py * unit + unit / 2};
  for (int i = 0; i < 3; ++i) {
    const FixedPoint &a = t.corner[i], &b = t.corner[(i + 1) % 3];
    const std::int64_t most = (std::abs(b.x - a.x) + std::abs(b.y - a.y)) * (unit / 2);
    if (side(a, b, center) + most < 0) return true;
  }
  return false;
}

/// Adds what `weight` says of the three corners' guides.
void add_guides(const std::vector<DetailGuide>& guide, const PaperTriangle& t, const glm::dvec3& weight,
                SectionPixel& pixel) {
  for (int i = 0; i < 3; ++i) {
    const DetailGuide& corner = guide[t.vertex[i]];
    const auto share = static_cast<float>(weight[i]);
    pixel.guide_sum.to_skin += corner.to_skin * share;
    pixel.guide_sum.layer += corner.layer * share;
    pixel.guide_sum.share += corner.share * share;
  }
}

/// Adds the triangle's samples in one pixel.
void cover(const PaperTriangle& t, const std::vector<DetailGuide>& guide, std::int64_t px, std::int64_t py,
           SectionPixel& pixel) {
  if (misses(t, px, py)) return;
  glm::dvec3 weight(0);
  for (int s = 0; s < section_samples; ++s) {
    const FixedPoint p{px * unit + first_sample + step * (s % 4), py * unit + first_sample + step * (s / 4)};
    std::array<std::int64_t, 3> e{};
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
      const FixedPoint &a = t.corner[(i + 1) % 3], &b = t.corner[(i + 2) % 3];
      e[i] = side(a, b, p);
      inside = inside && (e[i] > 0 || (e[i] == 0 && owns_edge(a, b)));
    }
    const auto own = static_cast<std::uint16_t>(1u << s);
    if (!inside || (pixel.covered & own) != 0) continue;
    pixel.covered |= own;
    const auto area = static_cast<double>(t.area);
    for (int i = 0; i < 3; ++i) {
      const double share = static_cast<double>(e[i]) / area;
      pixel.color_sum += t.color[i] * share;
      weight[i] += share;
    }
    pixel.samples = std::min(pixel.samples + 1, section_samples);
    pixel.face = t.face;
  }
  if (!guide.empty()) add_guides(guide, t, weight, pixel);
}

}  // namespace

SectionRaster::SectionRaster(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height)
    : section_(section),
      width_(width),
      height_(height),
      triangles_(on_paper(section, faces)),
      touching_((static_cast<std::size_t>(height) + band_rows - 1) / band_rows) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const PixelBox box = box_of(triangles_[t], width, height);
    for (std::int64_t band = box.y0 / band_rows; band <= box.y1 / band_rows; ++band)
      touching_[static_cast<std::size_t>(band)].push_back(t);
  }
}

PictureRows SectionRaster::rows(std::size_t band) const {
  const int low = static_cast<int>(band) * band_rows;
  return {low, std::min(height_, low + band_rows)};
}

std::vector<SectionPixel> SectionRaster::pixels(std::size_t band) const {
  const PictureRows rows = this->rows(band);
  std::vector<SectionPixel> pixels(static_cast<std::size_t>(width_) * (rows.to - rows.from));
  for (const std::uint32_t t : touching_[band]) {
    const PixelBox box = box_of(triangles_[t], width_, height_);
    const std::int64_t y1 = std::min<std::int64_t>(box.y1, rows.to - 1);
    for (std::int64_t y = std::max<std::int64_t>(box.y0, rows.from); y <= y1; ++y) {
      for (std::int64_t x = box.x0; x <= box.x1; ++x)
        cover(triangles_[t], section_.guide, x, y, pixels[static_cast<std::size_t>((y - rows.from) * width_ + x)]);
    }
  }
  return pixels;
}

}  // namespace pomona
