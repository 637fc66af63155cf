#include "render/picture/section_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/base/error.h"
#include "generator/cut/section/guide_lattice.h"
#include "render/marks/marks.h"
#include "render/picture/marks_on_picture.h"
#include "render/picture/paper.h"
#include "render/picture/section_raster.h"
#include "render/picture/section_strokes.h"
#include "render/style/look.h"

namespace pomona {

namespace {

std::vector<PlacedFace> laid_out_in(const PlateBox& box, const CrossSection& section, double gap) {
  std::vector<PlacedFace> faces = lay_out(section, box.high - box.low, gap);
  for (PlacedFace& face : faces) face.corner += box.low;
  return faces;
}

/// The ink of some of the picture's rows.
struct InkLayers {
  InkLayer rim, inner;

  /// Inner lines lie over the colour, the rim above them.
  Color over(Color color, const Color& ink, double inner_opacity, int x, int y) const {
    color += (ink - color) * static_cast<float>(inner.at(x, y) * inner_opacity);
    color += (ink - color) * static_cast<float>(rim.at(x, y));
    return color;
  }
};

InkLayers inked(const std::vector<SectionStroke>& strokes, int width, PictureRows rows) {
  InkLayers layers{{width, rows}, {width, rows}};
  for (const SectionStroke& stroke : strokes) (stroke.rim ? layers.rim : layers.inner).draw(stroke.points);
  return layers;
}

/// The picture with both layers of ink over it.
Image with_ink_layers(Image image, const InkLayers& layers, const Color& ink, double inner_opacity) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      glm::u8vec3& pixel = image.pixels[static_cast<std::size_t>(y) * image.width + x];
      pixel = to_srgb8(layers.over(from_srgb8(pixel), ink, inner_opacity, x, y));
    }
  }
  return image;
}

/// The faces in the style's marks instead of in paint.
Image draw_faces_in_marks(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look,
                          const InkStyle& ink, const Style& style, const SectionPictureOptions& options) {
  const Image painted = paint_faces(section, faces, look, ink, style, options);
  const Paper paper(style, options.width, options.height);
  const Color ink_color = style.ink_color.value_or(ink.color);
  Image image = with_marks(painted, paper, marks_of(painted, style.paper, *style.marks), *style.marks, ink_color);
  if (!style.ink) return image;
  const double side = std::min(options.width, options.height);
  return with_ink_layers(std::move(image),
                         inked(section_strokes(section, faces, ink, style, side), options.width, {0, options.height}),
                         ink_color, style.inner_opacity);
}

}  // namespace

Image paint_faces(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look,
                  const InkStyle& ink, Style style, const SectionPictureOptions& options) {
  style.ink = false;
  style.marks.reset();
  return draw_faces(section, faces, look, ink, style, options);
}

SectionSheet::SectionSheet(const CrossSection& section, const Style& style, const SectionPictureOptions& options)
    : section_(section), outside_(options.outside), width_(options.width), height_(options.height) {
  const auto fits = [](int side) { return side >= 1 && side <= max_picture_side; };
  if (!fits(options.width) || !fits(options.height)) {
    throw Error(ExitStatus::usage, "a picture must be 1 to " + std::to_string(max_picture_side) + " pixels each way");
  }

  const double side = std::min(options.width, options.height);
  if (style.plate)
    plate_.emplace(style, options.text, parts_in(section, options.outside), options.width, options.height);
  faces_ = plate_ ? laid_out_in(plate_->figure(), section, 0.02 * side)
                  : lay_out(section, {options.width, options.height}, options.margin * side);
}

std::vector<PlateLayer> SectionSheet::plate_layers() const {
  if (!plate_) return {};
  // All faces have one scale.
  const auto shown = std::find_if(faces_.begin(), faces_.end(), [](const PlacedFace& face) { return face.shown; });
  PartMap map = section_parts(section_, faces_, width_, height_);
  add_rims(map, section_, faces_, outside_);
  return plate_->layers(map, shown == faces_.end() ? 0 : shown->scale);
}

Image draw_faces(const CrossSection& section, const std::vector<PlacedFace>& faces, const Look& look,
                 const InkStyle& ink, const Style& style, const SectionPictureOptions& options) {
  if (style.marks) return draw_faces_in_marks(section, faces, look, ink, style, options);

  const double side = std::min(options.width, options.height);
  const SectionRaster raster(section, faces, options.width, options.height);
  const Paper paper(style, options.width, options.height);
  const Color ink_color = style.ink_color.value_or(ink.color);
  const std::vector<SectionStroke> strokes =
      style.ink ? section_strokes(section, faces, ink, style, side) : std::vector<SectionStroke>{};

  // Band by band, so that a large picture needs little more than its own bytes: flat colours first; then, pixel by
  // pixel, the colour's noise, the paper around it, the ink above it.
  const auto width = static_cast<std::size_t>(options.width);
  Image image{options.width, options.height, std::vector<glm::u8vec3>(width * options.height)};
  parallel_for(raster.bands(), options.threads, [&](std::size_t band) {
    const PictureRows rows = raster.rows(band);
    const std::vector<SectionPixel> pixels = raster.pixels(band);
    const InkLayers layers = inked(strokes, style.ink ? options.width : 0, rows);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const int x = static_cast<int>(i % width), y = rows.from + static_cast<int>(i / width);
      const SectionPixel& pixel = pixels[i];

      // The fruit covers the paper by its share of the pixel's samples.
      Color color = paper.at(x, y);
      if (pixel.samples > 0) {
        const PlacedFace& face = faces[pixel.face];
        const Color mean(pixel.color_sum / static_cast<double>(pixel.samples));
        LookPlace place{.position = face.to_fruit({x + 0.5, y + 0.5}), .footprint = 1.0 / face.scale};
        place.guide = guide_at(section.guide_lattice.get(), place.position,
                               scaled(pixel.guide_sum, 1.0f / static_cast<float>(pixel.samples)));
        const Color fresh = style.noise ? look(mean, place) : mean;
        const Color fruit = paper.painted(fresh, x, y);
        color += (fruit - color) * (static_cast<float>(pixel.samples) / section_samples);
      }

      if (style.ink) color = layers.over(color, ink_color, style.inner_opacity, x, y);
      image.pixels[rows.from * width + i] = to_srgb8(color);
    }
  });
  return image;
}

Image draw_section(const CrossSection& section, const Look& look, const InkStyle& ink, const Style& style,
                   const SectionPictureOptions& options) {
  const SectionSheet sheet(section, style, options);
  Image image = draw_faces(section, sheet.faces(), look, ink, style, options);
  draw(sheet.plate_layers(), image);
  return image;
}

}  // namespace pomona
