#include "generator/knife/parse_knife.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "generator/base/units.h"
#include "generator/knife/read_stroke.h"

namespace pomona {

namespace {

constexpr int most_wedges = 360;

[[noreturn]] void fail(std::string_view text, const std::string& why, const std::string& hint = "") {
  refuse_knife(text, why, hint.empty() ? "a knife is one of: " + knives_as_written() : hint);
}

/// A whole number as users write counts: digits alone.
std::optional<int> parse_count(std::string_view text) {
  if (text.empty() || text.size() > 6) return std::nullopt;
  int count = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    count = 10 * count + (c - '0');
  }
  return count;
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

CuttingPlane parse_plane(std::string_view text, std::string_view values) {
  const std::vector<std::string_view> parts = split_at_commas(values);
  if (parts.size() != 4) fail(text, "needs four values: a normal NX,NY,NZ and a distance D");
  glm::dvec3 normal(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> value = parse_number(parts[static_cast<std::size_t>(axis)]);
    if (!value || std::fabs(*value) > 1e100) fail(text, "has a normal that is not three numbers");
    normal[axis] = *value;
  }
  const std::optional<double> offset = parse_length(parts[3]);
  if (!offset) fail(text, "has a distance that is not a length such as 0.05 or 5cm");

  // Scale before measuring the length, so that tiny and huge normals keep their direction.
  const double largest = std::fmax(std::fabs(normal.x), std::fmax(std::fabs(normal.y), std::fabs(normal.z)));
  if (!(largest > 0)) fail(text, "has a normal of length zero");
  normal /= largest;
  return {normal / std::sqrt(glm::dot(normal, normal)), *offset};
}

void parse_slices(Knife& knife, std::string_view text, std::string_view value) {
  const bool is_count = !value.empty() && value.find_first_not_of("0123456789") == std::string_view::npos;
  if (is_count && value.size() > 6) fail(text, "asks for more than " + std::to_string(most_slices) + " slices");
  if (const std::optional<int> count = parse_count(value)) {
    if (*count < 2) fail(text, "makes no cut: two pieces across are the fewest");
    if (*count > most_slices) fail(text, "asks for more than " + std::to_string(most_slices) + " slices");
    knife.count = *count;
    return;
  }
  const std::optional<double> thickness = parse_length(value);
  if (!thickness || !(*thickness > 0)) fail(text, "needs a thickness such as 4mm, or a count");
  knife.thickness = *thickness;
}

/// What follows a knife's first value: "at=1cm,2cm,0,depth=3cm". Values that are lists take the words up to the next
/// name.
class KnifeOptions {
 public:
  KnifeOptions(std::string_view text, std::span<const std::string_view> words) : text_(text) {
    for (const std::string_view word : words) {
      const std::size_t equals = word.find('=');
      if (equals != std::string_view::npos) {
        options_.push_back({word.substr(0, equals), {word.substr(equals + 1)}});
      } else if (!options_.empty()) {
        options_.back().values.push_back(word);
      } else {
        fail(text_, "has \"" + std::string(word) + "\" where an option such as at=0,4cm,0 should be");
      }
    }
  }

  /// A length above 0, and at most `most` metres; `otherwise` if the option is not there.
  double length(std::string_view name, double most, double otherwise) {
    const Option* option = take(name);
    if (!option) return otherwise;
    const std::optional<double> value =
        option->values.size() == 1 ? parse_length(option->values[0]) : std::optional<double>();
    if (!value || !(*value > 0) || *value > most) {
      fail(text_, "needs a length up to " + std::to_string(static_cast<int>(most)) + "m for " + std::string(name));
    }
    return *value;
  }

  /// Three lengths, each within 100 m.
  std::optional<glm::dvec3> place(std::string_view name) {
    return triple(name, parse_length, " such as " + std::string(name) + "=0,4cm,0");
  }

  /// Three numbers, made to a unit vector.
  std::optional<glm::dvec3> direction(std::string_view name) {
    std::optional<glm::dvec3> way = triple(name, parse_number, " such as " + std::string(name) + "=0,1,0");
    if (way && !(glm::length(*way) > 1e-6)) fail(text_, "has an axis of length zero");
    return way ? glm::normalize(*way) : way;
  }

  /// \throws Error (usage) for an option that nobody has asked for; `known` says which there are.
  void finish(const std::string& known) const {
    for (const Option& option : options_) {
      if (!option.taken) fail(text_, "has no option \"" + std::string(option.name) + "\"", "it has " + known);
    }
  }

 private:
  struct Option {
    std::string_view name;
    std::vector<std::string_view> values;
    bool taken = false;
  };

  const Option* take(std::string_view name) {
    const Option* found = nullptr;
    for (Option& option : options_) {
      if (option.name != name) continue;
      if (found) fail(text_, "says " + std::string(name) + " twice");
      option.taken = true;
      found = &option;
    }
    return found;
  }

  template <typename Parse>
  std::optional<glm::dvec3> triple(std::string_view name, const Parse& parse, const std::string& example) {
    const Option* option = take(name);
    if (!option) return std::nullopt;
    glm::dvec3 values(0);
    for (int i = 0; i < 3; ++i) {
      const std::optional<double> value =
          option->values.size() == 3 ? parse(option->values[static_cast<std::size_t>(i)]) : std::optional<double>();
      if (!value || std::fabs(*value) > 100) fail(text_, "needs three values," + example);
      values[i] = *value;
    }
    return values;
  }

  std::string_view text_;
  std::vector<Option> options_;
};

/// The file and the path's name in FILE.svg#id.
std::pair<std::filesystem::path, std::string> parse_drawn(std::string_view text, std::string_view word) {
  const std::size_t hash = word.rfind('#');
  if (hash == std::string_view::npos || hash == 0) fail(text, "needs an SVG file and the path in it: FILE.svg#id");
  if (hash + 1 == word.size()) fail(text, "does not name a path in the file: FILE.svg#id");
  return {std::string(word.substr(0, hash)), std::string(word.substr(hash + 1))};
}

/// FILE.svg#id and its options. A comma may be part of the file's name: what comes before the last # is.
void parse_drawing(Knife& knife, std::string_view text, std::string_view value, const std::filesystem::path& folder) {
  const std::size_t hash = std::min(value.rfind('#'), value.size());
  const std::size_t comma = std::min(value.find(',', hash), value.size());
  const auto [file, id] = parse_drawn(text, value.substr(0, comma));
  std::vector<std::string_view> words;
  if (comma < value.size()) words = split_at_commas(value.substr(comma + 1));
  KnifeOptions options(text, words);
  const double scale = options.length("scale", 1, 1e-3);
  if (knife.kind == Knife::Kind::stroke) {
    options.finish("one such as scale=2mm");
    knife.stroke = read_stroke(folder / file, id, scale);
  } else {
    knife.solid.at = options.place("at");
    knife.solid.axis = options.direction("axis");
    options.finish("scale=2mm, at=X,Y,Z and axis=X,Y,Z");
    knife.solid.profile = read_profile(folder / file, id, scale);
  }
}

constexpr double largest_solid = 10;  // metres

/// A size and options: "24mm,at=0,4cm,3cm".
void parse_solid(Knife& knife, std::string_view text, std::string_view value, const std::string& what) {
  const std::vector<std::string_view> words = split_at_commas(value);
  const std::optional<double> size = parse_length(words[0]);
  if (!size || !(*size > 0) || *size > largest_solid) fail(text, "needs " + what + ", above 0 and up to 10m");
  SolidShape& solid = knife.solid;
  solid.size = *size;
  KnifeOptions options(text, std::span(words).subspan(1));
  if (knife.kind == Knife::Kind::peel) {
    solid.spiral = options.length("spiral", largest_solid, 0);
    options.finish("spiral=15mm");
    return;
  }
  solid.at = options.place("at");
  if (knife.kind != Knife::Kind::core) return options.finish("at=X,Y,Z");
  solid.axis = options.direction("axis");
  solid.depth = options.length("depth", largest_solid, 0);
  options.finish("at=X,Y,Z, axis=X,Y,Z and depth=4cm");
}

/// Knives that cut by a closed surface and have a size, and what it is called.
struct SizedKnife {
  std::string_view name;
  Knife::Kind kind;
  const char* size;
};
constexpr SizedKnife sized_knives[] = {{"ball", Knife::Kind::ball, "a diameter such as 24mm"},
                                       {"core", Knife::Kind::core, "a diameter such as 18mm"},
                                       {"bite", Knife::Kind::bite, "a width such as 40mm"},
                                       {"peel", Knife::Kind::peel, "a thickness such as 2mm"}};

}  // namespace

std::string knives_as_written() {
  return "half, across, plane:NX,NY,NZ,D, wedges:N, slices:4mm, slices:8, dice:12mm, sticks:6mm, crinkle:6mm, "
         "stroke:FILE.svg#id, ball:24mm, core:18mm, bite:40mm, revolve:FILE.svg#id, peel:2mm";
}

Knife parse_knife(std::string_view text, const std::filesystem::path& folder) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  const std::string_view value = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  Knife knife;
  knife.text = std::string(text);

  if ((name == "half" || name == "across") && colon == std::string_view::npos) {
    knife.kind = name == "half" ? Knife::Kind::half : Knife::Kind::across;
  } else if (name == "plane") {
    knife.kind = Knife::Kind::plane;
    knife.plane = parse_plane(text, value);
  } else if (name == "wedges") {
    knife.kind = Knife::Kind::wedges;
    knife.count = parse_count(value).value_or(0);
    if (knife.count < 2 || knife.count > most_wedges) {
      fail(text, "needs a number of wedges between 2 and " + std::to_string(most_wedges));
    }
  } else if (name == "slices" || name == "dice" || name == "sticks") {
    knife.kind = name == "slices" ? Knife::Kind::slices : name == "dice" ? Knife::Kind::dice : Knife::Kind::sticks;
    parse_slices(knife, text, value);
  } else if (name == "stroke" || name == "revolve") {
    knife.kind = name == "stroke" ? Knife::Kind::stroke : Knife::Kind::revolve;
    parse_drawing(knife, text, value, folder);
  } else if (name == "crinkle") {
    knife.kind = Knife::Kind::crinkle;
    parse_slices(knife, text, value);
    if (knife.count > 0) fail(text, "needs a thickness such as 6mm");
  } else {
    const auto sized = std::find_if(std::begin(sized_knives), std::end(sized_knives),
                                    [&](const SizedKnife& known) { return known.name == name; });
    if (sized == std::end(sized_knives)) fail(text, "is not one this program has");
    knife.kind = sized->kind;
    parse_solid(knife, text, value, sized->size);
  }
  return knife;
}

}  // namespace pomona
