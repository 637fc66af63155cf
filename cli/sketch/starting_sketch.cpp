#include "cli/sketch/starting_sketch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "generator/base/error.h"
#include "generator/base/number_text.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/base/xml_text.h"

namespace pomona {

namespace {

// Positions on the page (A4, landscape), millimetres.
const glm::dvec2 side_axis(74, 142), top_axis(220, 104);
constexpr double outer_radius = 40;

/// Shares that make folds differ, taken in turn, because variants are blends of folds.
constexpr std::array<double, 7> uneven = {0.00, 0.75, 0.30, 1.00, 0.15, 0.60, 0.45};

std::string number(double value) {
  const double rounded = std::floor(value * 100 + 0.5) / 100;
  return number_text(rounded + 0.0);
}

std::string point(const glm::dvec2& p) { return number(p.x) + "," + number(p.y); }

/// A point on the page; angles are counter-clockwise as seen, y points down.
glm::dvec2 around_top(double radius, double angle) {
  return top_axis + radius * glm::dvec2(reproducible::cos(angle), -reproducible::sin(angle));
}

/// A smooth closed path through the points (Catmull and Rom's spline).
std::string loop_through(const std::vector<glm::dvec2>& points) {
  const std::size_t n = points.size();
  std::string d = "M " + point(points[0]);
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 &before = points[(i + n - 1) % n], &from = points[i], &to = points[(i + 1) % n],
                     &after = points[(i + 2) % n];
    d += " C " + point(from + (to - before) / 6.0) + " " + point(to - (after - from) / 6.0) + " " + point(to);
  }
  return d + " Z";
}

/// Where the first fold line lies, as a share of a fold: `half`, at 0 and 180 degrees, passes through chambers.
double first_line(int folds) { return folds == 1 ? 0.4 : 0.25; }

/// Lobes between grooves at the fold lines, or one round loop.
std::string outline(double radius, int folds) {
  std::vector<glm::dvec2> points;
  const int lobes = std::max(folds, 1);
  const double first = folds > 0 ? first_line(folds) : 0;
  const int steps = std::max(4, 12 / lobes);
  for (int k = 0; k < lobes; ++k) {
    for (int i = 0; i < steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const double bulge = folds > 0 ? 4 * share * (1 - share) : uneven[static_cast<std::size_t>(i) % 7];
      const double fullness = folds > 0 ? 0.6 + 0.4 * uneven[static_cast<std::size_t>(k) % 7] : 0.8;
      points.push_back(around_top(radius * (0.94 + 0.07 * bulge * fullness), 2 * pi * (k + first + share) / lobes));
    }
  }
  return loop_through(points);
}

/// The chamber of fold k.
std::string chamber(int k, int folds) {
  const double middle = 2 * pi * (k + first_line(folds) + 0.5) / folds;
  const double half = std::min(0.36 * 2 * pi / folds, 1.0);
  const double fullness = uneven[static_cast<std::size_t>(k) % 7];
  const double inner = 13 + fullness, outer = 30 - 2.5 * fullness;
  std::vector<glm::dvec2> points;
  constexpr int corners = 10;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * pi * i / corners;
    const double radius = 0.5 * (inner + outer) + 0.5 * (outer - inner) * reproducible::cos(turn);
    const double narrowing = std::sqrt(radius / outer);
    points.push_back(around_top(radius, middle + half * (0.9 - 0.15 * fullness) * narrowing * reproducible::sin(turn)));
  }
  return loop_through(points);
}

std::string path(const std::string& id, const std::string& label, const std::string& color, const std::string& d) {
  return "    <path\n       inkscape:label=\"" + label + "\"\n       id=\"" + id +
         "\"\n       style=\"fill:none;stroke:" + color + ";stroke-width:0.6\"\n       d=\"" + d + "\" />\n";
}

std::string guide(const std::string& id, const std::string& label, const glm::dvec2& from, const glm::dvec2& to) {
  return "    <path\n       inkscape:label=\"" + label + "\"\n       id=\"" + id +
         "\"\n       style=\"fill:none;stroke:#0050ff;stroke-width:0.35;stroke-dasharray:2,1\"\n       d=\"M " +
         point(from) + " L " + point(to) + "\" />\n";
}

/// The picture, as large as its field of the page allows, around its axis, and locked.
std::string picture(const std::optional<SketchPicture>& shown, int view, const glm::dvec2& center) {
  if (!shown) return {};
  const double scale = std::min(130 / shown->size.x, 130 / shown->size.y);
  const glm::dvec2 size = scale * shown->size, at = center - 0.5 * size;
  return "    <image\n       inkscape:label=\"picture\"\n       id=\"picture-" + std::to_string(view) +
         "\"\n       sodipodi:insensitive=\"true\"\n       preserveAspectRatio=\"none\"\n       xlink:href=\"" +
         xml_escaped(shown->href) + "\"\n       x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" width=\"" +
         number(size.x) + "\" height=\"" + number(size.y) + "\" />\n";
}

std::string layer(const std::string& label, const std::string& id, const std::string& inside) {
  return "  <g\n     inkscape:groupmode=\"layer\"\n     inkscape:label=\"" + label + "\"\n     id=\"" + id + "\">\n" +
         inside + "  </g>\n";
}

std::string side_view(const StartingSketchOptions& options) {
  // The side view: its picture, if any, the axis, a scale and three curves, each from the axis to the axis.
  const auto from = [](const glm::dvec2& step, const char* rest) {
    return "M " + point(side_axis + step) + " " + rest;
  };
  std::string text = picture(options.side, 1, side_axis - glm::dvec2(0, 39));
  text += guide("side-axis", "axis", side_axis + glm::dvec2(0, 4), side_axis - glm::dvec2(0, 84));
  text += guide("side-scale", "scale 60mm", side_axis + glm::dvec2(-40, 12), side_axis + glm::dvec2(40, 12));
  text +=
      path("side-skin", "skin", "#c04020", from({0, 0}, "c 18,0 40,-15 40,-40 0,-24 -15,-40 -28,-40 -5,0 -8,4 -12,6"));
  text += path("side-flesh", "flesh", "#d89a2a",
               from({0, -5}, "c 14,0 34,-13 34,-35 0,-20 -12,-34 -23,-34 -4,0 -8,4 -11,6"));
  text += path("side-core", "core", "#6a8c2a", from({0, -10}, "c 5,0 8,-8 8,-28 0,-16 -2,-26 -8,-28"));
  if (options.side) {
    // The line for sampling the picture's colours lies just inside the skin.
    text += path("side-colors", "skin colours", "#8020c0",
                 from({2, -2}, "c 16,0 36,-15 36,-38 0,-23 -14,-38 -26,-38 -4,0 -6,3 -9,5"));
  }
  if (options.folds) {
    text += path("side-chamber", "chamber", "#20803c",
                 from({12, -42}, "c 0,-11 3,-18 8,-18 5,0 8,8 8,18 0,10 -3,20 -9,20 -5,0 -7,-10 -7,-20 z"));
  }
  return layer("side view", "layer-side", text);
}

std::string top_view(const StartingSketchOptions& options) {
  // The picture, the axis and the scale; fold lines where the walls are.
  const int folds = options.folds.value_or(0);
  std::string text = picture(options.top, 2, top_axis);
  text +=
      "    <circle\n       inkscape:label=\"axis\"\n       id=\"top-axis\"\n       style=\"fill:#0050ff\"\n"
      "       cx=\"" +
      number(top_axis.x) + "\" cy=\"" + number(top_axis.y) + "\" r=\"1\" />\n";
  text += guide("top-scale", "scale 60mm", top_axis + glm::dvec2(-40, 50), top_axis + glm::dvec2(40, 50));
  for (int k = 0; k < folds; ++k) {
    const std::string name = std::to_string(k + 1);
    text += guide("fold-" + name, "fold " + name, top_axis, around_top(46, 2 * pi * (k + first_line(folds)) / folds));
  }

  // Loops around the axis, then the chambers in a group of their own.
  text += path("top-skin", "skin", "#c04020", outline(outer_radius, folds));
  text += path("top-flesh", "flesh", "#d89a2a", outline(0.85 * outer_radius, folds));
  if (folds == 0) return layer("top view", "layer-top", text);
  std::string chambers;
  for (int k = 0; k < folds; ++k) {
    const std::string name = std::to_string(k + 1);
    chambers += path("chamber-" + name, "chamber " + name, "#20803c", chamber(k, folds));
  }
  text += "    <g\n     inkscape:label=\"chambers\"\n     id=\"chambers\">\n" + chambers + "    </g>\n";
  return layer("top view", "layer-top", text);
}

std::string notes(bool with_folds) {
  std::vector<std::string> lines = {
      "Side view: draw the right half of each curve, from pole to pole, over a picture of the fruit cut in half.",
      "Top view: draw closed loops around the axis, over a picture of the fruit cut across.",
      "The label of a curve (Object > Layers and Objects) is its name in the template. Move the axis to where it "
      "belongs.",
      "Draw \"scale 60mm\" along something whose length you know, and put that length into its label.",
  };
  if (with_folds)
    lines.emplace_back("Fold lines run from the axis outwards, one at each wall, numbered against the clock.");
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += "    <text x=\"10\" y=\"" + number(176 + 6.0 * static_cast<double>(i)) +
            "\" style=\"font-size:4px;font-family:sans-serif;fill:#606060\">" + xml_escaped(lines[i]) + "</text>\n";
  }
  return layer("notes (not read)", "layer-notes", text);
}

std::string svg_text(const StartingSketchOptions& options) {
  return R"svg(<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<svg
   width="297mm"
   height="210mm"
   viewBox="0 0 297 210"
   version="1.1"
   xmlns="http://www.w3.org/2000/svg"
   xmlns:xlink="http://www.w3.org/1999/xlink"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">
  <sodipodi:namedview
     id="namedview"
     inkscape:document-units="mm" />
)svg" + notes(options.folds.has_value()) +
         side_view(options) + top_view(options) + "</svg>\n";
}

/// A colour that can be taken from the picture again, if there is one.
std::string ramp(const StartingSketchOptions& options, const std::string& line, const std::string& stops) {
  if (!options.side) return stops;
  return "{ sample = \"#" + line + "\", along = " + stops + " }";
}

std::string toml_text(const StartingSketchOptions& options) {
  // The head says where curves and colours come from.
  const bool folds = options.folds.has_value();
  std::string text = "#:schema ./template.schema.json\n# Curves are drawn in " + options.name +
                     ".svg: \"#skin\" is the curve labelled \"skin\" there.\n";
  if (options.side) {
    text +=
        "# `pomona sketch " + options.name + ".toml --sample` takes the colours with a \"sample\" from its pictures.\n";
  }

  // Names, parts and symmetry.
  text += "format = 1\nname = \"" + options.name + "\"\ntitle = \"" + options.name + "\"\nsketch = \"" + options.name +
          ".svg\"\nparts = [\"skin\", \"flesh\", \"core\"" + (folds ? ", \"gel\"" : "") + "]\n\n[symmetry]\n";
  text += folds ? "kind = \"folds\"\nfolds = " + std::to_string(*options.folds) + "\n" : "kind = \"cylindrical\"\n";

  // The surfaces from the outside inwards: skin, flesh and core, and chambers in a fruit with folds.
  text += R"toml(
# The skin. Outside it is air: that side is hidden.
[[surface]]
name = "skin"
type = "around-axis"
vertical = "#skin"
horizontal = "#skin"

[surface.front]
part = "skin"
hidden = true
color = )toml" +
          ramp(options, "skin colours", R"([[0.0, "#b0301c"], [0.6, "#d05024"], [1.0, "#c8a040"]])") + R"toml(

[surface.back]
part = "flesh"
color = "#e8a058"

# Where the flesh changes its colour.
[[surface]]
name = "flesh"
type = "around-axis"
vertical = "#flesh"
horizontal = "#flesh"
blur = "1.2mm"
around = 64
along = 32
front = { part = "flesh", color = )toml" +
          ramp(options, "flesh", R"([[0.0, "#e8a058"], [1.0, "#ecc070"]])") + R"toml( }
back = { part = "flesh", color = "#f2cf8c" }

# The core. Without a horizontal curve it is round.
[[surface]]
name = "core"
type = "around-axis"
vertical = "#core"
blur = "0.6mm"
around = 32
along = 24
front = { part = "flesh", color = "#f6dca0" }
back = { part = "core", color = [[0.0, "#e8dc98"], [1.0, "#b8c070"]] }
)toml";
  if (!folds) return text;
  return text + R"toml(
# One chamber in each fold: the curves of the group "chambers", wherever they lie.
[[surface]]
name = "chamber"
type = "in-fold"
vertical = "#chamber"
horizontal = "#chambers"
blur = "0.2mm"
around = 28
along = 18
front = { part = "flesh", color = "#e09048" }
back = { part = "gel", color = [[0.0, "#b8a840"], [1.0, "#c8bc58"]] }
)toml";
}

}  // namespace

StartingSketch starting_sketch(const StartingSketchOptions& options) { return {svg_text(options), toml_text(options)}; }

std::string fruit_name(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
  if (file.extension() != ".toml") {
    throw Error(ExitStatus::usage,
                "\"" + file.string() + "\" is no file for a template: it wants a name that ends in .toml",
                "as in `pomona sketch kiwi.toml`");
  }
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), plain)) {
    throw Error(ExitStatus::usage, file.string() + ": \"" + name + "\" is not a plain name",
                "use a-z, 0-9, - and _, at most 64 of them");
  }
  return name;
}

}  // namespace pomona
