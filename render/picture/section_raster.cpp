#include "render/picture/section_raster.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace pomona {

namespace {

constexpr std::int64_t unit = 256;               // fixed-point steps a pixel
constexpr int across = 4;                        // samples along a pixel's side
constexpr std::int64_t step = unit / across;     // between samples
constexpr std::int64_t first_sample = unit / 8;  // position of a pixel's first sample
constexpr int band_rows = 32;                    // rows that one task draws

/// The nearest fixed point.
glm::i64vec2 fixed(const glm::dvec2& p) { return glm::i64vec2(glm::floor(p * double{unit} + 0.5)); }

std::vector<PaperTriangle> on_paper(const CrossSection& section, const std::vector<PlacedFace>& faces) {
  std::vector<PaperTriangle> triangles;
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    // Leaves out hidden faces and triangles without area; the others get the same orientation.
    const PlacedFace& face = faces[section.cut[t]];
    if (!face.shown) continue;
    const auto raster_of = [&](const glm::uvec3& v) {
      const auto point = [&](int i) { return fixed(face.to_paper(section.position[v[i]])); };
      return TriangleRaster<std::int64_t>(point(0), point(1), point(2));
    };
    glm::uvec3 v = section.triangle[t];
    if (!raster_of(v).is_clockwise()) std::swap(v.y, v.z);
    const PaperTriangle triangle{raster_of(v), v, section.cut[t]};
    if (triangle.raster.area() > 0) triangles.push_back(triangle);
  }
  return triangles;
}

/// The pixels of some rows that have samples in the triangle's bounding box.
PixelBox touched(const PaperTriangle& t, int width, const PictureRows& rows) {
  const PixelBox box =
      t.raster.box({first_sample, step, {0, across * rows.from, across * width - 1, across * rows.to - 1}});
  if (box.empty()) return {};
  return {box.left / across, box.top / across, box.right / across, box.bottom / across};
}

/// Adds the three corners' guides, weighted.
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
void cover(const PaperTriangle& t, const CrossSection& section, const glm::i64vec2& place, SectionPixel& pixel) {
  const glm::i64vec2 corner = place * unit;
  if (t.raster.misses(corner + unit / 2, unit / 2)) return;
  glm::dvec3 weight(0);
  for (int s = 0; s < section_samples; ++s) {
    const glm::i64vec2 sample = corner + first_sample + step * glm::i64vec2(s % across, s / across);
    const auto shares = t.raster.shares(sample, EdgeRule::top_left);
    const auto own = static_cast<std::uint16_t>(1u << s);
    if (!shares || (pixel.covered & own) != 0) continue;
    pixel.covered |= own;
    const glm::dvec3 share = glm::dvec3(*shares) / static_cast<double>(t.raster.area());
    for (int i = 0; i < 3; ++i) pixel.color_sum += glm::dvec3(section.color[t.vertex[i]]) * share[i];
    weight += share;
    pixel.samples = std::min(pixel.samples + 1, section_samples);
    pixel.face = t.face;
  }
  if (!section.guide.empty()) add_guides(section.guide, t, weight, pixel);
}

}  // namespace

SectionRaster::SectionRaster(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height)
    : section_(section),
      width_(width),
      height_(height),
      triangles_(on_paper(section, faces)),
      touching_((static_cast<std::size_t>(height) + band_rows - 1) / band_rows) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const PixelBox box = touched(triangles_[t], width, {0, height});
    for (int band = box.top / band_rows; !box.empty() && band <= box.bottom / band_rows; ++band)
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
    const PixelBox box = touched(triangles_[t], width_, rows);
    for (int y = box.top; y <= box.bottom; ++y) {
      for (int x = box.left; x <= box.right; ++x)
        cover(triangles_[t], section_, {x, y}, pixels[static_cast<std::size_t>(y - rows.from) * width_ + x]);
    }
  }
  return pixels;
}

}  // namespace pomona
