#include "generator/cut/read_stroke.h"

#include <fstream>
#include <optional>
#include <system_error>

#include "generator/base/error.h"
#include "generator/base/nearest_name.h"
#include "generator/cut/stroke.h"
#include "generator/template/svg_drawing.h"
#include "generator/template/svg_path.h"

namespace pomona {

namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{64} << 20;
constexpr std::size_t most_points = 4096;
constexpr const char* wanted = "a stroke is written stroke:FILE.svg#id";

std::string text_of(const std::filesystem::path& file) {
  std::error_code wrong;
  if (!std::filesystem::is_regular_file(file, wrong)) {
    throw Error(ExitStatus::input_missing, {{{file.string(), 0, 0, ""}, "the stroke's file cannot be read", wanted}});
  }
  if (std::filesystem::file_size(file, wrong) > most_bytes || wrong) {
    throw Error(ExitStatus::bad_data, {{{file.string(), 0, 0, ""}, "the stroke's file is larger than 64 MiB", ""}});
  }
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const SvgElement& element_called(const SvgDrawing& drawing, const std::string& id) {
  std::vector<std::string> known;
  for (const SvgElement& element : drawing.elements) {
    if (!element.d) continue;
    if (element.id == id || element.label == id) return element;
    if (!element.id.empty()) known.push_back(element.id);
    if (!element.label.empty()) known.push_back(element.label);
  }
  const std::optional<std::string> meant = nearest_name(id, known);
  const std::string hint =
      meant ? "did you mean \"" + *meant + "\"?" : "name a path in Inkscape's Objects dialog, or by its id";
  throw Error(ExitStatus::bad_data,
              {{{drawing.file, 0, 0, ""}, "there is no path \"" + id.substr(0, 200) + "\"", hint}});
}

std::vector<glm::dvec2> points_of(const SvgDrawing& drawing, const SvgElement& element, const std::string& id,
                                  double scale) {
  const auto fail = [&](const std::string& what, const std::string& hint) {
    const SourcePlace place{drawing.file, element.line, element.column, ""};
    throw Error(ExitStatus::bad_data, {{place, "stroke \"" + id.substr(0, 200) + "\" " + what, hint}});
  };
  if (!element.fault.empty()) fail(element.fault, "");
  SvgPathOptions options;
  options.unit = scale;
  options.transform = element.to_page;
  const std::vector<Curve> curves = parse_svg_path(*element.d, options);
  if (curves.size() != 1) fail("is not one line but " + std::to_string(curves.size()), "break the path apart");
  if (curves[0].closed) fail("is closed", "a knife goes in on one side and out on the other: open the path");
  std::vector<glm::dvec2> points = cleaned(curves[0].points);
  if (points.size() < 2) fail("has no length", "draw a line");
  if (points.size() > most_points) fail("has more than 4096 points", "simplify the path");
  if (crosses_itself(points, {0, 0}, 0)) fail("crosses itself", "a knife's stroke must not meet itself");
  return points;
}

}  // namespace

std::vector<glm::dvec2> read_stroke(const std::filesystem::path& file, const std::string& id, double scale) {
  try {
    const SvgDrawing drawing = parse_svg(text_of(file), file.string());
    return points_of(drawing, element_called(drawing, id), id, scale);
  } catch (const BadSketch& bad) {
    throw Error(ExitStatus::bad_data, bad.what(), bad.hint);
  } catch (const BadPath& bad) {
    throw Error(ExitStatus::bad_data, {{{file.string(), 0, 0, ""}, "stroke \"" + id + "\" " + bad.what(), bad.hint}});
  }
}

}  // namespace pomona
