#include "cli/sketch/sample_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include "cli/sketch/picture_file.h"
#include "generator/base/color.h"
#include "generator/base/error.h"
#include "generator/base/number_text.h"
#include "generator/template/read/read_template.h"
#include "generator/template/read/sketch.h"
#include "generator/text/toml_document.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

// ---- Pictures ----

/// An image of the drawing, with its place.
struct PlacedPicture {
  TransparentImage shown;
  SvgTransform to_pixels;  ///< from the page to pixels
};

/// The pictures of a drawing, read on first use.
class Pictures {
 public:
  Pictures(const SvgDrawing& drawing, fs::path folder) : drawing_(drawing), folder_(std::move(folder)) {}

  /// The colour around a point of the page, in the topmost picture; nothing without a picture.
  /// \throws BadSketch if none is known to be there, and the place of one is not known.
  std::optional<Color> at(const glm::dvec2& point) {
    const SvgElement* lost = nullptr;
    for (std::size_t i = drawing_.elements.size(); i-- > 0;) {
      const SvgElement& element = drawing_.elements[i];
      if (element.tag != "image" || !element.drawn) continue;
      if (!fault_of(element).empty()) {
        lost = &element;
        continue;
      }
      const std::optional<Color> color = color_in(i, point);
      if (color) return color;
    }
    if (lost) {
      throw BadSketch(
          "lies beside the pictures whose place is known; that at " + place_of(drawing_, *lost) + " " + fault_of(*lost),
          "put it in anew (File > Import)");
    }
    return {};
  }

 private:
  /// Why it is not known where a picture lies; empty if it is.
  static std::string fault_of(const SvgElement& element) {
    const bool has_size = element.size.x > 0 && element.size.y > 0;
    return !element.fault.empty() || has_size ? element.fault : "does not say how large it is";
  }

  std::optional<Color> color_in(std::size_t index, const glm::dvec2& point) {
    const SvgElement& element = drawing_.elements[index];
    const std::optional<SvgTransform> own = inverse(element.to_page);
    if (!own) return {};
    const glm::dvec2 in_box = ((*own)(point)-element.position) / element.size;
    if (!(in_box.x >= 0 && in_box.x < 1 && in_box.y >= 0 && in_box.y < 1)) return {};

    const PlacedPicture& picture = placed(index);
    const glm::dvec2 pixel = picture.to_pixels(point);
    const auto x = static_cast<int>(std::floor(pixel.x)), y = static_cast<int>(std::floor(pixel.y));
    const Image& image = picture.shown.image;
    const bool is_inside = x >= 0 && y >= 0 && x < image.width && y < image.height;
    if (!is_inside || !is_opaque(picture.shown, x, y)) return {};
    return median(picture.shown, x, y);
  }

  const PlacedPicture& placed(std::size_t index) {
    const auto known = read_.find(index);
    if (known != read_.end()) return known->second;
    const SvgElement& element = drawing_.elements[index];
    PlacedPicture picture;
    picture.shown = read_linked_picture(element.href, folder_, place_of(drawing_, element));

    // The picture fills its box, or the largest part of it that keeps its shape.
    const glm::dvec2 pixels(picture.shown.image.width, picture.shown.image.height);
    glm::dvec2 scale = pixels / element.size;
    const SvgAspect& aspect = element.aspect;
    if (!aspect.stretches) scale = glm::dvec2(aspect.slices ? std::min(scale.x, scale.y) : std::max(scale.x, scale.y));
    const glm::dvec2 before = aspect.align * (pixels - scale * element.size);
    const SvgTransform fit{scale.x, 0, 0, scale.y, before.x, before.y};
    picture.to_pixels = fit * translation(-element.position) * inverse(element.to_page).value();
    return read_.emplace(index, std::move(picture)).first->second;
  }

  /// Transparent pixels around a fruit count as no picture, whatever their colour.
  static bool is_opaque(const TransparentImage& shown, int x, int y) {
    const auto width = static_cast<std::size_t>(shown.image.width);
    return shown.opacity[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] >= 128;
  }

  /// Takes a square of about a hundredth of the picture, so that speckles and glints do not count.
  static Color median(const TransparentImage& shown, int x, int y) {
    const Image& image = shown.image;
    const int reach = std::max(1, std::max(image.width, image.height) / 200);
    std::array<std::vector<std::uint8_t>, 3> channels;
    for (int v = std::max(0, y - reach); v <= std::min(image.height - 1, y + reach); ++v) {
      for (int u = std::max(0, x - reach); u <= std::min(image.width - 1, x + reach); ++u) {
        if (!is_opaque(shown, u, v)) continue;
        for (int c = 0; c < 3; ++c) channels[static_cast<std::size_t>(c)].push_back(image.at(u, v)[c]);
      }
    }
    glm::u8vec3 result;
    for (int c = 0; c < 3; ++c) {
      std::vector<std::uint8_t>& values = channels[static_cast<std::size_t>(c)];
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::nth_element(values.begin(), middle, values.end());
      result[c] = *middle;
    }
    return from_srgb8(result);
  }

  const SvgDrawing& drawing_;
  fs::path folder_;
  std::map<std::size_t, PlacedPicture> read_;
};

// ---- The template's text ----

/// Converts lines and columns of TOML, which count characters, to positions of bytes.
std::size_t offset_of(const std::string& text, const SourcePlace& place) {
  std::size_t at = 0;
  for (int line = 1; line < place.line && at < text.size(); ++at) line += text[at] == '\n';
  for (int column = 1; column < place.column && at < text.size(); ++column) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u) ++at;
  }
  return at;
}

/// The position behind the string that begins here.
std::size_t end_of_string(const std::string& text, std::size_t at) {
  const char quote = text.at(at);
  for (++at; at < text.size() && text[at] != quote; ++at) {
    if (quote == '"' && text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

/// The position behind the array that begins here; its strings and comments may contain brackets.
std::size_t end_of_array(const std::string& text, std::size_t at) {
  int depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at);
      continue;
    }
    if (c == '#') at = std::min(text.find('\n', at), text.size() - 1);
    if (c == '[') ++depth;
    if (c == ']' && --depth == 0) return at + 1;
    ++at;
  }
  return at;
}

/// A range of the text and its replacement.
struct Edit {
  std::size_t from = 0, to = 0;
  std::string text;
};

std::string place_in_words(int k, int count) {
  if (k + 1 == count) return "1.0";
  const double place = std::floor(1000.0 * k / (count - 1) + 0.5) / 1000;
  return k == 0 ? "0.0" : number_text(place);
}

std::string stops_in_words(const std::vector<Color>& colors) {
  std::string text = "[";
  for (std::size_t k = 0; k < colors.size(); ++k) {
    text += (k == 0 ? "[" : ", [") + place_in_words(static_cast<int>(k), static_cast<int>(colors.size())) + ", \"" +
            to_hex(colors[k]) + "\"]";
  }
  return text + "]";
}

// ---- Both ----

class Sampler {
 public:
  Sampler(const std::string& text, const Sketch& sketch, const fs::path& folder)
      : text_(text), sketch_(sketch), pictures_(sketch.drawing(), folder) {}

  void sample_sides(const TomlTable& table) {
    for (const char* side : {"front", "back"}) {
      const TomlValue value = table.get(side);
      if (!value.is(TomlNode::Kind::table)) continue;
      const TomlValue color = value.table().get("color");
      if (color.is(TomlNode::Kind::table)) sample_color(color);
    }
  }

  const std::vector<Edit>& edits() const { return edits_; }

 private:
  void sample_color(const TomlValue& color) {
    const TomlTable table = color.table();
    const TomlValue sample = table.get("sample"), along = table.get("along");
    if (!sample.is(TomlNode::Kind::string) || !sample.text().starts_with("#")) return;
    const std::vector<Color> colors = colors_along(sample, table.get("stops").integer(9, 2, 64));
    if (colors.empty()) return;
    if (along.given()) {
      const std::size_t from = offset_of(text_, along.place());
      const std::size_t to = text_.at(from) == '[' ? end_of_array(text_, from) : end_of_string(text_, from);
      edits_.push_back({from, to, stops_in_words(colors)});
      return;
    }
    if (text_[offset_of(text_, color.place())] != '{') {
      return sample.error("has nowhere to put its colours",
                          "write it as color = { sample = \"" + sample.text() + "\" }");
    }
    const std::size_t end = end_of_string(text_, offset_of(text_, sample.place()));
    edits_.push_back({end, end, ", along = " + stops_in_words(colors)});
  }

  std::vector<Color> colors_along(const TomlValue& sample, int stops) {
    std::vector<Color> colors;
    try {
      for (const glm::dvec2& point : sketch_.page_points(sample.text().substr(1), stops)) {
        const std::optional<Color> color = pictures_.at(point);
        if (!color) {
          sample.error("lies beside the picture at " +
                           std::to_string(100 * colors.size() / (static_cast<std::size_t>(stops) - 1)) +
                           " % of its length",
                       "draw that line over the picture, or put a picture under it");
          return {};
        }
        colors.push_back(*color);
      }
    } catch (const BadSketch& bad) {
      sample.error(bad.what(), bad.hint);
      return {};
    }
    return colors;
  }

  const std::string& text_;
  const Sketch& sketch_;
  Pictures pictures_;
  std::vector<Edit> edits_;
};

std::string edited(std::string text, std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.from > b.from; });
  for (const Edit& edit : edits) text.replace(edit.from, edit.to - edit.from, edit.text);
  return text;
}

/// Reads only what sampling needs; reading the whole template reports other mistakes.
std::vector<Edit> sampled_edits(const std::string& text, const fs::path& file) {
  // A sketch that cannot be read is a mistake where the template names it.
  TomlDocument document(text, file.string());
  const TomlTable root = document.root();
  const TomlValue named = root.need("sketch");
  std::optional<Sketch> sketch;
  try {
    if (named.is(TomlNode::Kind::string)) sketch.emplace(read_sketch(file.parent_path(), named.text(), 1e-3));
  } catch (const BadSketch& bad) {
    named.error(bad.what(), bad.hint);
  }

  // The sides of all surfaces and grains, in the template's order within each kind.
  std::vector<Edit> edits;
  if (sketch) {
    Sampler sampler(text, *sketch, file.parent_path());
    for (const char* kind : {"surface", "grains"}) {
      for (const TomlTable& table : root.get(kind).tables()) {
        sampler.sample_sides(table.called(std::string(kind) + " \"" + table.get("name").text() + "\""));
      }
    }
    edits = sampler.edits();
  }
  document.throw_if_noted();
  return edits;
}

}  // namespace

SampledTemplate sample_colors(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::vector<Edit> edits = sampled_edits(text, file);
  if (edits.empty()) {
    throw Error(ExitStatus::bad_data,
                {{{file.string(), 0, 0, {}},
                  "no colour of it is sampled",
                  "write color = { sample = \"#NAME\" } with the label of a line over the picture"}});
  }
  SampledTemplate sampled{edited(text, edits), static_cast<int>(edits.size())};
  parse_template(sampled.toml, file.string());
  return sampled;
}

}  // namespace pomona
