#include "render/picture/plate_sheet.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/common.hpp>

#include "generator/template/template.h"
#include "render/lettering/coverage.h"
#include "render/lettering/typeface.h"
#include "render/picture/paper.h"
#include "render/plate/labels.h"
#include "render/plate/scale_bar.h"

namespace pomona {

namespace {

constexpr double min_of_figure = 0.002;  // share that a part must cover to be numbered
constexpr double row_ems = 1.35;         // distance of the legend's lines
constexpr double beside_ems = 2.2;       // room for numbers to the left and to the right of a figure
constexpr double below_ems = 2.6;        // room for a figure's letter and scale below it
constexpr double fading = 0.16;          // share of a room's shorter side over which shadows fade along its edges
constexpr int ink_reach = 3;             // pixels from a part that its ink may cover

/// The opacity of a figure's pixel on the sheet: 1 for the fruit and its ink; shadows fade towards the edges of the
/// room, which would cut them off.
float share_laid(const SheetFigure& figure, int x, int y) {
  const int width = figure.picture.width, height = figure.picture.height;
  const double edge = std::min({x, y, width - 1 - x, height - 1 - y});
  const double inside = glm::smoothstep(0.0, fading * std::min(width, height), edge);
  if (inside >= 1 || figure.parts.part.empty()) return 1;
  for (const int dy : {-ink_reach, 0, ink_reach}) {
    for (const int dx : {-ink_reach, 0, ink_reach}) {
      const int px = std::clamp(x + dx, 0, width - 1), py = std::clamp(y + dy, 0, height - 1);
      if (figure.parts.at(px, py) >= 0) return 1;
    }
  }
  return static_cast<float>(inside);
}

/// A figure's pixels on the sheet: the difference from its own bare paper, added to the sheet's.
void lay_figure(const SheetFigure& figure, const glm::ivec2& corner, const Color& bare, const Paper& paper,
                Image& sheet) {
  for (int y = 0; y < figure.picture.height; ++y) {
    for (int x = 0; x < figure.picture.width; ++x) {
      const int sx = corner.x + x, sy = corner.y + y;
      if (sx < 0 || sy < 0 || sx >= sheet.width || sy >= sheet.height) continue;
      const Color more = from_srgb8(figure.picture.at(x, y)) - bare;
      const Color color = paper.at(sx, sy) + share_laid(figure, x, y) * more;
      sheet.pixels[static_cast<std::size_t>(sy) * sheet.width + sx] = to_srgb8(glm::clamp(color, Color(0), Color(1)));
    }
  }
}

}  // namespace

PlateSheet::PlateSheet(const Style& style, PlateText text, const std::vector<std::string>& part_names, int figures,
                       int width, int height)
    : style_(style),
      plate_(style.plate.value_or(PlateStyle{})),
      text_(std::move(text)),
      width_(width),
      height_(height),
      em_(0.8 * plate_.letter_size * std::min(width, height)) {
  // From the bottom: the species, the title, the legend in as many columns as fit.
  const double margin = plate_.margin * std::min(width, height);
  double below = height - margin;
  latin_ = below - 0.25 * em_;
  if (plate_.title && !text_.latin.empty()) below -= 1.6 * em_;
  title_ = below - 0.3 * em_;
  if (plate_.title) below -= 3.2 * em_;
  const Typeface italic("italic");
  double longest = 0;
  const std::set<std::string> names(part_names.begin(), part_names.end());
  for (const std::string& name : names) longest = std::max(longest, italic.width(words_of(name)));
  column_ = (longest + 3.2) * em_;
  columns_ = std::clamp(static_cast<int>((width - 2 * margin) / column_), 1, 4);
  const auto rows =
      static_cast<double>((names.size() + static_cast<std::size_t>(columns_) - 1) / static_cast<std::size_t>(columns_));
  legend_ = below - (rows - 0.9) * row_ems * em_;
  if (plate_.labels) below -= (rows + 0.6) * row_ems * em_;

  // The figures share the rest.
  const int across = figures > 1 ? 2 : 1, down = (figures + across - 1) / across;
  const glm::dvec2 cell((width - 2 * margin) / across, std::max((below - margin) / down, 1.0));
  for (int i = 0; i < figures; ++i) {
    const glm::dvec2 corner(margin + cell.x * (i % across), margin + cell.y * (i / across));
    const double beside = std::min(beside_ems * em_, 0.2 * cell.x), under = std::min(below_ems * em_, 0.3 * cell.y);
    rooms_.push_back(
        {glm::floor(corner + glm::dvec2(beside, 0)), glm::floor(corner + cell - glm::dvec2(beside, under))});
  }
}

double PlateSheet::hair() const { return std::max(plate_.leader_width * std::min(width_, height_), 0.7); }

std::vector<PlateSheet::Numbered> PlateSheet::numbered(const std::vector<SheetFigure>& figures) const {
  // Each part is numbered in the figure of which it covers the largest share.
  struct Place {
    std::string name;
    std::size_t figure;
    double share;
    ShownPart shown;
  };
  std::vector<Place> best;
  for (std::size_t f = 0; f < figures.size(); ++f) {
    const PartMap& map = figures[f].parts;
    if (map.part.empty()) continue;
    for (ShownPart& shown : shown_parts(map, min_of_figure, 0.0016 * std::min(width_, height_))) {
      const std::string name = words_of(map.names[static_cast<std::size_t>(shown.part)]);
      const double share = shown.area / static_cast<double>(map.part.size());
      const auto known = std::find_if(best.begin(), best.end(), [&](const Place& place) { return place.name == name; });
      if (known == best.end())
        best.push_back({name, f, share, std::move(shown)});
      else if (share > known->share)
        *known = {name, f, share, std::move(shown)};
    }
  }

  // Numbers continue from figure to figure.
  std::stable_sort(best.begin(), best.end(), [](const Place& a, const Place& b) { return a.figure < b.figure; });
  std::vector<Numbered> parts;
  for (Place& place : best) {
    parts.push_back({static_cast<int>(parts.size()) + 1, place.name, place.figure, std::move(place.shown)});
  }
  return parts;
}

void PlateSheet::add_numbers(const std::vector<Numbered>& parts, const SheetFigure& figure, std::size_t index,
                             std::vector<PlateLayer>& layers) const {
  const Typeface italic("italic");
  std::vector<LabelWish> wishes;
  for (const Numbered& part : parts) {
    if (part.figure != index) continue;
    const std::string text = std::to_string(part.number);
    wishes.push_back({part.shown, text, italic.width(text) * em_});
  }
  const glm::dvec2 size(figure.picture.width, figure.picture.height), corner = rooms_[index].low;
  for (const Label& label : placed_labels(std::move(wishes), {{0, 0}, size}, em_, 0.5 * em_)) {
    const glm::dvec2 from = label.leader + corner, to = label.tip + corner;
    add_leader(from, to, hair(), layers[0], layers[1]);
    layers[2].marks.push_back({italic.outline(label.text, label.start + corner, em_), label.text});
  }
}

void PlateSheet::add_bar(const SheetFigure& figure, std::size_t index, PlateLayer& letters) const {
  // The figure's letter is below its left corner, the bar below its middle.
  const Typeface italic("italic");
  const PlateBox& room = rooms_[index];
  const std::string letter(1, static_cast<char>('a' + static_cast<int>(index)));
  const double base = room.high.y + 1.6 * em_;
  letters.marks.push_back({italic.outline(letter, {room.low.x, base}, 1.15 * em_), letter});
  const ScaleLength scale = scale_length(0.3 * (room.high.x - room.low.x), figure.pixels_per_metre);
  if (!plate_.scale_bar || !(scale.pixels > 0)) return;

  const double length = scale.pixels, middle = 0.5 * (room.low.x + room.high.x);
  const glm::dvec2 a(middle - 0.5 * length, base), b(middle + 0.5 * length, base);
  const glm::dvec2 tick(0, 0.25 * em_), inset(0.5 * hair(), 0);
  letters.marks.push_back({line_outline(a, b, hair()), {}});
  letters.marks.push_back({line_outline(a + inset - tick, a + inset + tick, hair()), {}});
  letters.marks.push_back({line_outline(b - inset - tick, b - inset + tick, hair()), {}});
  const double em = 0.85 * em_;
  letters.marks.push_back(
      {italic.outline(scale.text, {middle - 0.5 * italic.width(scale.text) * em, base - 0.45 * em_}, em), scale.text});
}

void PlateSheet::add_legend(const std::vector<Numbered>& parts, PlateLayer& letters) const {
  // Centred columns, as many as the longest name allows.
  const Typeface italic("italic");
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t rows = (parts.size() + columns - 1) / columns;
  const std::size_t used = rows == 0 ? 0 : (parts.size() + rows - 1) / rows;
  const double left = 0.5 * (width_ - static_cast<double>(used) * column_);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const glm::dvec2 start(left + static_cast<double>(i / rows) * column_,
                           legend_ + static_cast<double>(i % rows) * row_ems * em_);
    const std::string number = std::to_string(parts[i].number);
    const double right = start.x + 1.5 * em_;
    letters.marks.push_back({italic.outline(number, {right - italic.width(number) * em_, start.y}, em_), number});
    letters.marks.push_back({italic.outline(parts[i].name, {right + 0.6 * em_, start.y}, em_), parts[i].name});
  }
}

void PlateSheet::add_title(PlateLayer& letters) const {
  const Typeface italic("italic"), capitals("capitals");
  const double room = width_ * (1 - 2 * plate_.margin), spacing = 0.09;
  const double wide = capitals.width(text_.title, spacing), long_latin = italic.width(text_.latin);
  const double em = std::min(2.1 * em_, room / std::max(wide, 1.0));
  const double latin_em = std::min(1.3 * em_, room / std::max(long_latin, 1.0));
  letters.marks.push_back(
      {capitals.outline(text_.title, {0.5 * (width_ - wide * em), title_}, em, spacing), text_.title});
  letters.marks.push_back(
      {italic.outline(text_.latin, {0.5 * (width_ - long_latin * latin_em), latin_}, latin_em), text_.latin});
}

std::vector<PlateLayer> PlateSheet::layers(const std::vector<SheetFigure>& figures) const {
  std::vector<PlateLayer> layers{{"halos", style_.paper, 0.55, {}},
                                 {"lines", plate_.letter_color, 0.9, {}},
                                 {"letters", plate_.letter_color, 1, {}}};
  const std::vector<Numbered> parts = plate_.labels ? numbered(figures) : std::vector<Numbered>();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    add_numbers(parts, figures[i], i, layers);
    add_bar(figures[i], i, layers[2]);
  }
  add_legend(parts, layers[2]);
  if (plate_.title) add_title(layers[2]);
  return layers;
}

Image PlateSheet::drawn(const std::vector<SheetFigure>& figures) const {
  const Paper paper(style_, width_, height_);
  Image sheet{width_, height_, std::vector<glm::u8vec3>(static_cast<std::size_t>(width_) * height_)};
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) sheet.pixels[static_cast<std::size_t>(y) * width_ + x] = to_srgb8(paper.at(x, y));
  }
  const Color bare = from_srgb8(to_srgb8(style_.paper));
  for (std::size_t i = 0; i < figures.size(); ++i) {
    lay_figure(figures[i], glm::ivec2(rooms_[i].low), bare, paper, sheet);
  }
  draw(layers(figures), sheet);
  return sheet;
}

}  // namespace pomona
