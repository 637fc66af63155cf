#include "render/plate/plate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/template/template.h"
#include "render/lettering/coverage.h"
#include "render/lettering/typeface.h"
#include "render/plate/scale_bar.h"

namespace pomona {

namespace {

constexpr double title_ems = 1.6, latin_ems = 1.15, scale_ems = 0.85;  // sizes relative to a label's
constexpr double title_spacing = 0.09;                                 // further space between capitals, ems of the
                                                                       // title
constexpr double min_share = 0.0008;                                   // share of the figure that a part must cover to
                                                                       // be named
constexpr double halo = 0.55;  // width of the paper's colour around a line on dark paint

/// The title at a size at which it fits.
double fitting(double em, double width, double room) { return width * em > room ? room / width : em; }

void lay(Image& image, const Coverage& cover, const Color& color, double opacity) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double share = opacity * cover.at(x, y);
      if (share <= 0) continue;
      glm::u8vec3& pixel = image.pixels[static_cast<std::size_t>(y) * image.width + x];
      pixel = to_srgb8(blended(from_srgb8(pixel), color, share));
    }
  }
}

/// The columns beside the drawing, as high as there is room.
PlateBox columns_beside(const PartMap& map, const PlateBox& room) {
  PlateBox box{{room.high.x, room.low.y}, {room.low.x, room.high.y}};
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      if (map.at(x, y) < 0) continue;
      box.low.x = std::min(box.low.x, static_cast<double>(x));
      box.high.x = std::max(box.high.x, x + 1.0);
    }
  }
  return box;
}

}  // namespace

void add_leader(const glm::dvec2& from, const glm::dvec2& tip, double hair, PlateLayer& halos, PlateLayer& lines) {
  lines.marks.push_back({line_outline(from, tip, hair), {}});
  lines.marks.push_back({disc_outline(tip, 1.7 * hair), {}});
  halos.marks.push_back({line_outline(from, tip, 2.6 * hair), {}});
  halos.marks.push_back({disc_outline(tip, 2.7 * hair), {}});
}

Plate::Plate(const Style& style, PlateText text, const std::vector<std::string>& part_names, int width, int height)
    : style_(style.plate.value()), paper_(style.paper), text_(std::move(text)), width_(width), height_(height) {
  const double side = std::min(width, height);
  const double margin = style_.margin * side;
  em_ = style_.letter_size * side;
  gap_ = 1.4 * em_;

  // Columns as wide as the longest name; from the bottom: the species, the title, the bar.
  double longest = 0;
  const Typeface italic("italic");
  for (const std::string& name : part_names) longest = std::max(longest, italic.width(words_of(name)));
  const double column = style_.labels && longest > 0 ? longest * em_ + gap_ + 0.3 * em_ : 0;
  double below = height - margin;
  latin_height_ = below - 0.25 * em_;
  if (style_.title && !text_.latin.empty()) below -= 1.5 * em_;
  title_height_ = below - 0.3 * em_;
  if (style_.title) below -= 2.2 * em_;
  bar_height_ = below - 0.4 * em_;
  if (style_.scale_bar) below -= 2.3 * em_;
  figure_.low = {margin + column, margin};
  figure_.high = {width - margin - column, std::max(below, margin + 1)};

  // On a very narrow sheet the figure keeps a third of it, and names may have to go.
  if (figure_.high.x - figure_.low.x < width / 3.0) figure_.low.x = width / 3.0, figure_.high.x = 2 * width / 3.0;
}

std::vector<Label> Plate::labels(const PartMap& map) const {
  if (!style_.labels) return {};
  const Typeface italic("italic");
  std::vector<LabelWish> wishes;
  for (ShownPart& part : shown_parts(map, min_share, 0.0016 * std::min(width_, height_))) {
    const std::string text = words_of(map.names[part.part]);
    const double width = italic.width(text) * em_;
    wishes.push_back({std::move(part), text, width});
  }

  // Beside the drawing, not beside the room for it.
  const PlateBox drawn = columns_beside(map, figure_);
  std::vector<Label> labels = placed_labels(std::move(wishes), drawn, em_, gap_ - 0.3 * em_);
  std::erase_if(labels, [&](const Label& label) { return label.bounds.low.x < 0 || label.bounds.high.x > width_; });
  return labels;
}

Plate::ScaleBar Plate::scale_bar(double pixels_per_metre) const {
  ScaleBar bar;
  if (!style_.scale_bar) return bar;
  const ScaleLength scale = scale_length(0.3 * (figure_.high.x - figure_.low.x), pixels_per_metre);
  if (!(scale.pixels > 0)) return bar;
  bar.metres = scale.metres;
  bar.text = scale.text;
  bar.length = scale.pixels;
  bar.start = {0.5 * (width_ - bar.length), bar_height_};
  return bar;
}

double Plate::hair() const { return std::max(style_.leader_width * std::min(width_, height_), 0.7); }

void Plate::add_labels(const PartMap& map, PlateLayer& halos, PlateLayer& lines, PlateLayer& letters) const {
  const Typeface italic("italic");
  for (const Label& label : labels(map)) {
    letters.marks.push_back({italic.outline(label.text, label.start, em_), label.text});
    add_leader(label.leader, label.tip, hair(), halos, lines);
  }
}

void Plate::add_scale_bar(double pixels_per_metre, PlateLayer& letters) const {
  const ScaleBar bar = scale_bar(pixels_per_metre);
  if (!(bar.length > 0)) return;

  // The bar ends at the outer edges of its ticks.
  const glm::dvec2 a = bar.start, b = bar.start + glm::dvec2(bar.length, 0);
  const glm::dvec2 tick(0, 0.28 * em_), inset(0.5 * hair(), 0);
  letters.marks.push_back({line_outline(a, b, hair()), {}});
  letters.marks.push_back({line_outline(a + inset - tick, a + inset + tick, hair()), {}});
  letters.marks.push_back({line_outline(b - inset - tick, b - inset + tick, hair()), {}});
  const Typeface italic("italic");
  const double em = scale_ems * em_, width = italic.width(bar.text) * em;
  letters.marks.push_back({italic.outline(bar.text, {0.5 * (width_ - width), bar.start.y - 0.55 * em_}, em), bar.text});
}

void Plate::add_title(PlateLayer& letters) const {
  if (!style_.title) return;
  const Typeface italic("italic"), capitals("capitals");
  const double room = width_ * (1 - 2 * style_.margin);
  const double wide = capitals.width(text_.title, title_spacing), long_latin = italic.width(text_.latin);
  const double em = fitting(title_ems * em_, wide, room), latin_em = fitting(latin_ems * em_, long_latin, room);
  const glm::dvec2 start(0.5 * (width_ - wide * em), title_height_);
  letters.marks.push_back({capitals.outline(text_.title, start, em, title_spacing), text_.title});
  const glm::dvec2 latin_start(0.5 * (width_ - long_latin * latin_em), latin_height_);
  letters.marks.push_back({italic.outline(text_.latin, latin_start, latin_em), text_.latin});
}

std::vector<PlateLayer> Plate::layers(const PartMap& map, double pixels_per_metre) const {
  // A border in the paper's colour separates lines from dark paint.
  PlateLayer halos{"halos", paper_, halo, {}}, lines{"lines", style_.letter_color, 0.9, {}};
  PlateLayer letters{"letters", style_.letter_color, 1, {}};
  add_labels(map, halos, lines, letters);
  add_scale_bar(pixels_per_metre, letters);
  add_title(letters);
  return {halos, lines, letters};
}

void draw(const std::vector<PlateLayer>& layers, Image& image) {
  for (const PlateLayer& layer : layers) {
    Coverage cover(image.width, image.height);
    for (const PlateMark& mark : layer.marks) cover.fill(mark.outline);
    lay(image, cover, layer.color, layer.opacity);
  }
}

}  // namespace pomona
