#include "generator/knife/knife_kinds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/knife/knife_options.h"
#include "generator/knife/read_stroke.h"

namespace pomona {

namespace {

using std::string_view;
using std::filesystem::path;

constexpr int max_wedges = 360;
constexpr double largest_knife = 10;       // metres
constexpr double largest_scale = 1;        // metres per unit of a drawing
constexpr double millimetre_scale = 1e-3;  // metres per unit of a drawing, by default

/// Reads a count: digits only.
std::optional<int> parse_count(string_view text) {
  if (text.empty() || text.size() > 6) return std::nullopt;
  int count = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    count = 10 * count + (c - '0');
  }
  return count;
}

/// Reads a knife that has only a name.
template <typename Plain>
KnifeCut read_plain(const KnifeKind&, string_view, const path&) {
  return PlaneCut(Plain{});
}

KnifeCut read_plane(const KnifeKind&, string_view value, const path&) {
  const std::vector<string_view> parts = split_at_commas(value);
  if (parts.size() != 4) throw BadKnife("needs four values: a normal NX,NY,NZ and a distance D");
  glm::dvec3 normal(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> part = parse_number(parts[static_cast<std::size_t>(axis)]);
    if (!part) throw BadKnife("has a normal that is not three numbers");
    if (std::fabs(*part) > 1e100) throw BadKnife("has a normal of numbers beyond 1e100");
    normal[axis] = *part;
  }
  const std::optional<double> offset = parse_length(parts[3]);
  if (!offset) throw BadKnife("has a distance that is not a length such as 0.05 or 5cm");

  // Scale before measuring the length, so that tiny and huge normals keep their direction.
  const double largest = std::fmax(std::fabs(normal.x), std::fmax(std::fabs(normal.y), std::fabs(normal.z)));
  if (!(largest > 0)) throw BadKnife("has a normal of length zero");
  normal /= largest;
  return PlaneCut(PlaneKnife{{normal / std::sqrt(glm::dot(normal, normal)), *offset}});
}

KnifeCut read_wedges(const KnifeKind&, string_view value, const path&) {
  const int count = parse_count(value).value_or(0);
  if (count < 2 || count > max_wedges) {
    throw BadKnife("needs a number of wedges between 2 and " + std::to_string(max_wedges));
  }
  return PlaneCut(WedgeKnife{count});
}

/// \param expected "4mm, or a count", for messages.
double parse_thickness(string_view value, const std::string& expected) {
  const std::optional<double> thickness = parse_length(value);
  if (thickness && *thickness > 0) return *thickness;
  throw BadKnife("needs a thickness such as " + expected, "lengths are in mm, cm or m, and above 0");
}

SliceSize parse_slices(string_view value) {
  const std::string too_many = "asks for more than " + std::to_string(max_slices) + " slices";
  const bool is_count = !value.empty() && value.find_first_not_of("0123456789") == string_view::npos;
  if (is_count && value.size() > 6) throw BadKnife(too_many);
  if (const std::optional<int> count = parse_count(value)) {
    if (*count < 2) throw BadKnife("makes no cut: two pieces across are the fewest");
    if (*count > max_slices) throw BadKnife(too_many);
    return SliceCount{*count};
  }
  // Refuses a number that is no count, because nobody means metres.
  if (parse_number(value))
    throw BadKnife("has no unit", "write " + std::string(value) + "mm, or a whole number of slices");
  return SliceThickness{parse_thickness(value, "4mm, or a count")};
}

KnifeCut read_slices(const KnifeKind& kind, string_view value, const path&) {
  const std::vector<string_view> words = split_at_commas(value);
  const std::span<const string_view> further = std::span(words).subspan(1);
  const KnifeOptions options(further, kind.options);
  return PlaneCut(SliceKnife{parse_slices(words[0]), options.axis("along").value_or(1)});
}

/// Dice or sticks.
template <typename Sliced>
KnifeCut read_sliced(const KnifeKind&, string_view value, const path&) {
  return PlaneCut(Sliced{parse_slices(value)});
}

KnifeCut read_crinkle(const KnifeKind&, string_view value, const path&) {
  if (parse_number(value)) throw BadKnife("has no unit", "write " + std::string(value) + "mm");
  return PlaneCut(CrinkleKnife{parse_thickness(value, "6mm")});
}

/// Reads a path in a drawing: "FILE.svg#id,scale=2mm". All before the last # is the file's name, commas included.
struct NamedDrawing {
  path file;
  std::string id;
  std::vector<string_view> words;  ///< its options
};

NamedDrawing parse_drawing(string_view value) {
  // Separates the file, the path's name and the options.
  const std::size_t hash = std::min(value.rfind('#'), value.size());
  const std::size_t comma = std::min(value.find(',', hash), value.size());
  const string_view drawn = value.substr(0, comma);
  if (hash == value.size() || hash == 0) throw BadKnife("needs an SVG file and the path in it: FILE.svg#id");
  if (hash + 1 == drawn.size()) throw BadKnife("does not name a path in the file: FILE.svg#id");

  NamedDrawing drawing{std::string(drawn.substr(0, hash)), std::string(drawn.substr(hash + 1)), {}};
  if (comma < value.size()) drawing.words = split_at_commas(value.substr(comma + 1));
  return drawing;
}

KnifeCut read_stroke_knife(const KnifeKind& kind, string_view value, const path& folder) {
  const NamedDrawing drawing = parse_drawing(value);
  const KnifeOptions options(drawing.words, kind.options);
  const double scale = options.length("scale", largest_scale).value_or(millimetre_scale);
  return PlaneCut(StrokeKnife{read_stroke(folder / drawing.file, drawing.id, scale)});
}

KnifeCut read_revolve(const KnifeKind& kind, string_view value, const path& folder) {
  const NamedDrawing drawing = parse_drawing(value);
  const KnifeOptions options(drawing.words, kind.options);
  const double scale = options.length("scale", largest_scale).value_or(millimetre_scale);
  RevolveKnife knife;
  knife.at = options.place("at");
  knife.axis = options.direction("axis");
  knife.profile = read_profile(folder / drawing.file, drawing.id, scale);
  return ClosedCut(std::move(knife));
}

/// Reads a size in metres, and the options behind it: "24mm,at=0,4cm,3cm".
struct SizeAndOptions {
  double size;
  KnifeOptions options;
};

/// \throws BadKnife for other texts; it says that the knife needs `what`.
SizeAndOptions parse_sized(const KnifeKind& kind, string_view value, const std::string& what) {
  const std::vector<string_view> words = split_at_commas(value);
  const std::optional<double> size = parse_length(words[0]);
  if (!size || !(*size > 0) || *size > largest_knife) {
    const bool bare = parse_number(words[0]).value_or(0) > largest_knife;
    throw BadKnife("needs " + what + ", above 0 and up to 10m",
                   bare ? "without a unit it is metres: write " + std::string(words[0]) + "mm" : "");
  }
  return {*size, KnifeOptions(std::span(words).subspan(1), kind.options)};
}

KnifeCut read_ball(const KnifeKind& kind, string_view value, const path&) {
  const auto [diameter, options] = parse_sized(kind, value, "a diameter such as 24mm");
  return ClosedCut(BallKnife{diameter, options.place("at")});
}

KnifeCut read_core(const KnifeKind& kind, string_view value, const path&) {
  const auto [diameter, options] = parse_sized(kind, value, "a diameter such as 18mm");
  CoreKnife knife{.diameter = diameter, .depth = {}, .at = options.place("at"), .axis = options.direction("axis")};
  knife.depth = options.length("depth", largest_knife);
  return ClosedCut(knife);
}

KnifeCut read_bite(const KnifeKind& kind, string_view value, const path&) {
  const auto [width, options] = parse_sized(kind, value, "a width such as 40mm");
  return ClosedCut(BiteKnife{width, options.place("at")});
}

KnifeCut read_peel(const KnifeKind& kind, string_view value, const path&) {
  const auto [thickness, options] = parse_sized(kind, value, "a thickness such as 2mm");
  return ClosedCut(PeelKnife{thickness, options.length("spiral", largest_knife)});
}

std::vector<KnifeKind> make_kinds() {
  return {
      // These knives cut along planes, waves and drawn strokes.
      {"half", {"half"}, {}, "the plane z = 0", read_plain<HalfKnife>},
      {"across", {"across"}, {}, "the level plane at half the height", read_plain<AcrossKnife>},
      {"plane", {"plane:NX,NY,NZ,D"}, {}, "the points p with n.p = D, D a length along n", read_plane},
      {"wedges", {"wedges:N"}, {}, "N half-planes from the axis, the first towards +X", read_wedges},
      {"slices",
       {"slices:4mm", "slices:8"},
       {"along=x"},
       "level planes, or across x or z, so far apart or for so many slices",
       read_slices},
      {"dice",
       {"dice:12mm", "dice:4"},
       {},
       "planes across x, y and z, so far apart or for so many dice along each",
       read_sliced<DiceKnife>},
      {"sticks",
       {"sticks:6mm", "sticks:5"},
       {},
       "planes across x and z, so far apart or for so many sticks along each",
       read_sliced<StickKnife>},
      {"crinkle", {"crinkle:6mm"}, {}, "level waves along x, so far apart", read_crinkle},
      {"stroke",
       {"stroke:FILE.svg#id"},
       {"scale=2mm"},
       "a path drawn as seen from the front, straight through; one SVG unit is 1 mm",
       read_stroke_knife},
      // These knives cut along a closed surface.
      {"ball", {"ball:24mm"}, {"at=X,Y,Z"}, "a ball of this diameter, at the front of the skin", read_ball},
      {"core",
       {"core:18mm"},
       {"at=X,Y,Z", "axis=X,Y,Z", "depth=4cm"},
       "a cylinder of this diameter about the axis, right through",
       read_core},
      {"bite", {"bite:40mm"}, {"at=X,Y,Z"}, "a hollow with the marks of teeth, so wide", read_bite},
      {"revolve",
       {"revolve:FILE.svg#id"},
       {"scale=2mm", "at=X,Y,Z", "axis=X,Y,Z"},
       "a path swept around x = 0 of its drawing; one SVG unit is 1 mm",
       read_revolve},
      {"peel", {"peel:2mm"}, {"spiral=15mm"}, "so far below the skin, in one or as a strip so wide", read_peel},
  };
}

std::string written(const KnifeKind& kind) {
  std::string all;
  for (const std::string& way : kind.written) all += (all.empty() ? "" : ", ") + way;
  return all;
}

/// " [,axis=0,1,0] [,depth=4cm]"; empty for a kind without options.
std::string bracketed_options(const KnifeKind& kind) {
  std::string text;
  for (const std::string& option : kind.options) text += " [," + option + "]";
  return text;
}

}  // namespace

const std::vector<KnifeKind>& knife_kinds() {
  static const std::vector<KnifeKind> kinds = make_kinds();
  return kinds;
}

std::optional<std::string> drawing_of_knife(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const string_view name = text.substr(0, colon);
  const bool has_drawing = std::any_of(knife_kinds().begin(), knife_kinds().end(), [&](const KnifeKind& kind) {
    return kind.name == name && (kind.read == read_stroke_knife || kind.read == read_revolve);
  });
  if (!has_drawing || colon == text.size()) return {};
  return parse_drawing(text.substr(colon + 1)).file.string();
}

std::string written_with_options(const KnifeKind& kind) { return written(kind) + bracketed_options(kind); }

std::string known_knives() {
  std::string all;
  for (const KnifeKind& kind : knife_kinds()) all += (all.empty() ? "" : ", ") + written(kind);
  return all;
}

std::string knife_help() {
  constexpr std::size_t widest = 22;
  std::string lines;
  for (const KnifeKind& kind : knife_kinds()) {
    std::string line = "  " + written(kind);
    line.resize(std::max(line.size(), widest) + 2, ' ');
    lines += line + kind.help + bracketed_options(kind) + "\n";
  }
  return lines;
}

}  // namespace pomona
