#include "render/export/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "generator/base/base64.h"
#include "generator/base/xml_text.h"
#include "render/image/png.h"
#include "render/marks/marks.h"
#include "render/picture/marks_on_picture.h"
#include "render/picture/paper.h"
#include "render/picture/section_patches.h"
#include "render/picture/section_strokes.h"
#include "render/picture/stroke_outline.h"

namespace pomona {

namespace {

/// A side of the sheet: in pixels, or in millimetres if the pixels per inch are known.
std::string side_text(int pixels, double dpi) {
  return dpi > 0 ? hundredths(25.4 * pixels / dpi) + "mm" : std::to_string(pixels);
}

std::string opening(const SvgSheet& sheet, const std::string& provenance) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n"
         "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n     width=\"" +
         side_text(sheet.width, sheet.dpi) + "\" height=\"" + side_text(sheet.height, sheet.dpi) + "\" viewBox=\"0 0 " +
         std::to_string(sheet.width) + " " + std::to_string(sheet.height) + "\">\n  <title>" + xml_escaped(provenance) +
         "</title>\n";
}

std::string layer_start(const std::string& id, const std::string& label) {
  return "  <g id=\"" + id + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + xml_escaped(label) + "\">\n";
}

/// A stroke as stretches of nearly equal opacity, each from the end of the last.
std::vector<std::vector<StrokePoint>> by_opacity(const std::vector<StrokePoint>& stroke) {
  const auto level = [](const StrokePoint& point) { return static_cast<int>(std::floor(5 * point.opacity + 0.5)); };
  std::vector<std::vector<StrokePoint>> stretches;
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    const bool another = i == 0 || level(stroke[i]) != level(stroke[i - 1]);
    if (another && i > 0) stretches.back().push_back(stroke[i]);
    if (another) stretches.emplace_back();
    stretches.back().push_back(stroke[i]);
  }
  return stretches;
}

/// `strength` times the mean opacity of each stretch's points.
std::string path_text(const std::vector<StrokePoint>& stroke, const Color& ink, double strength) {
  std::string text;
  for (const std::vector<StrokePoint>& stretch : by_opacity(stroke)) {
    const std::string outline = stroke_outline(stretch);
    double opacity = 0;
    for (const StrokePoint& point : stretch) opacity += point.opacity;
    opacity = std::clamp(strength * opacity / static_cast<double>(stretch.size()), 0.0, 1.0);
    if (outline.empty() || opacity < 0.02) continue;
    text += "    <path fill=\"" + to_hex(ink) + "\"";
    if (opacity < 0.995) text += " fill-opacity=\"" + hundredths(opacity) + "\"";
    text += " d=\"" + outline + "\"/>\n";
  }
  return text;
}

std::string outline_path(const Outline& outline) {
  std::string text;
  for (const std::vector<glm::dvec2>& line : outline) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += (i == 0 ? "M" : i == 1 ? "L" : " ") + hundredths(line[i].x) + " " + hundredths(line[i].y);
    }
    if (!line.empty()) text += "Z";
  }
  return text;
}

/// One layer; opacity is that of the whole, so that overlaps are not darker.
std::string plate_text(std::span<const PlateLayer> plate) {
  if (plate.empty()) return {};
  std::string text = layer_start("plate", "plate");
  for (const PlateLayer& layer : plate) {
    text += "    <g id=\"plate-" + layer.name + "\" fill=\"" + to_hex(layer.color) + "\" opacity=\"" +
            hundredths(layer.opacity) + "\">\n";
    for (const PlateMark& mark : layer.marks) {
      const std::string path = outline_path(mark.outline);
      if (path.empty()) continue;
      text += "      <path";
      if (!mark.text.empty()) text += " aria-label=\"" + xml_escaped(mark.text) + "\"";
      text += " d=\"" + path + "\"/>\n";
    }
    text += "    </g>\n";
  }
  return text + "  </g>\n";
}

/// Hatching as filled paths, stipple as circles.
std::string marks_text(std::span<const Mark> marks, const Color& ink) {
  if (marks.empty()) return {};
  std::string text = layer_start("marks", "marks") + "    <g fill=\"" + to_hex(ink) + "\">\n";
  for (const Mark& mark : marks) {
    if (mark.size() == 1) {
      text += "      <circle cx=\"" + hundredths(mark[0].at.x) + "\" cy=\"" + hundredths(mark[0].at.y) + "\" r=\"" +
              hundredths(mark[0].radius) + "\"/>\n";
      continue;
    }
    const std::string outline = stroke_outline(stroke_of(mark));
    if (!outline.empty()) text += "      <path d=\"" + outline + "\"/>\n";
  }
  return text + "    </g>\n  </g>\n";
}

/// A layer that holds a picture.
std::string picture_text(const std::string& layer, const Image& image) {
  return layer_start(layer, layer) + "    <image width=\"" + std::to_string(image.width) + "\" height=\"" +
         std::to_string(image.height) + "\" xlink:href=\"data:image/png;base64," + base64(write_png(image)) +
         "\"/>\n  </g>\n";
}

/// The sheet: one colour, or a picture of its grain and brown edges, on a layer that can be hidden.
std::string paper_text(const Style& style, int width, int height) {
  if (style.grain > 0 || style.vignette > 0) {
    const Paper paper(style, width, height);
    return picture_text(
        "paper", with_marks({width, height, std::vector<glm::u8vec3>(static_cast<std::size_t>(width) * height)}, paper,
                            {}, {.wash = 0}, Color(0)));
  }
  return layer_start("paper", "paper") + "    <rect width=\"" + std::to_string(width) + "\" height=\"" +
         std::to_string(height) + "\" fill=\"" + to_hex(style.paper) + "\"/>\n  </g>\n";
}

/// Marks above the style's wash of paint.
std::string marked_text(const Image& painted, const InkStyle& ink, const Style& style) {
  const std::vector<Mark> marks = marks_of(painted, style.paper, *style.marks);
  const Color color = style.ink_color.value_or(ink.color);
  const Paper paper(style, painted.width, painted.height);
  const std::string wash =
      style.marks->wash > 0 ? picture_text("wash", with_marks(painted, paper, {}, *style.marks, color)) : std::string();
  return wash + marks_text(marks, color);
}

/// A triangle in tenths of a pixel.
std::string patch_path(const SectionPatch& patch) {
  const auto tenths = [](double v) { return static_cast<int>(std::floor(10 * v + 0.5)); };
  std::string text;
  glm::ivec2 before(0);
  for (int i = 0; i < 3; ++i) {
    const glm::ivec2 at(tenths(patch.corner[i].x), tenths(patch.corner[i].y)), step = at - before;
    text += (i == 0 ? "M" : i == 1 ? "l" : " ") + std::to_string(step.x) + " " + std::to_string(step.y);
    before = at;
  }
  return text + "z";
}

/// Patches of one colour in one path each, with a line of that colour around them, in tenths of a pixel.
std::string paths_text(const std::vector<SectionPatch>& patches, int hair) {
  std::map<std::array<std::uint8_t, 3>, std::string> colors;
  for (const SectionPatch& patch : patches) {
    colors[{patch.color.r, patch.color.g, patch.color.b}] += patch_path(patch);
  }
  std::string text = "      <g stroke-width=\"" + std::to_string(hair) + "\">\n";
  for (const auto& [color, path] : colors) {
    const std::string hex = to_hex(from_srgb8({color[0], color[1], color[2]}));
    text += "        <path fill=\"" + hex + "\" stroke=\"" + hex + "\" d=\"" + path + "\"/>\n";
  }
  return text + "      </g>\n";
}

/// A layer "colours" with a group per part. Programs leave seams between neighbours, through which coarser patches of
/// nearly the same colours show, which reach over their own.
std::string patches_text(const CrossSection& section, const std::vector<SectionPatch>& coarse,
                         const std::vector<SectionPatch>& fine) {
  std::map<std::int32_t, std::array<std::vector<SectionPatch>, 2>> parts;
  for (const SectionPatch& patch : coarse) parts[patch.part][0].push_back(patch);
  for (const SectionPatch& patch : fine) parts[patch.part][1].push_back(patch);
  std::string text = layer_start("colours", "colours");
  for (const auto& [part, patches] : parts) {
    text += "    <g id=\"part-" + std::to_string(part + 1) + "\" inkscape:label=\"" +
            xml_escaped(section.part_names[static_cast<std::size_t>(part)]) +
            "\" transform=\"scale(.1)\" stroke-linejoin=\"round\">\n" + paths_text(patches[0], 8) +
            paths_text(patches[1], 1) + "    </g>\n";
  }
  return text + "  </g>\n";
}

}  // namespace

std::string write_svg(const Scene& scene, std::span<const SceneStroke> strokes, const SvgSheet& sheet,
                      const std::string& provenance, std::span<const PlateLayer> plate, const SvgMarks& marks) {
  std::vector<std::string> layers(scene.instances.size());
  for (const SceneStroke& stroke : strokes) {
    layers[stroke.instance] += path_text(stroke.points, stroke.color, 1);
  }
  std::string text = opening(sheet, provenance) + marks_text(marks.marks, marks.ink);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].empty()) continue;
    text += layer_start("ink-" + std::to_string(i + 1), scene.instances[i].name) + layers[i] + "  </g>\n";
  }
  return text + plate_text(plate) + "</svg>\n";
}

std::string write_section_svg(const CrossSection& section, const Look& look, const InkStyle& ink, const Style& style,
                              const SectionPictureOptions& options, const std::string& provenance) {
  const SectionSheet sheet(section, style, options);
  const std::vector<PlacedFace>& faces = sheet.faces();
  std::string text = opening({options.width, options.height, options.dpi}, provenance);
  text += paper_text(style, options.width, options.height);
  if (style.marks) {
    text += marked_text(paint_faces(section, faces, look, ink, style, options), ink, style);
  } else {
    PatchOptions fine{.width = options.width, .height = options.height, .threads = options.threads}, coarse = fine;
    coarse.finest = 6;
    coarse.coarsest = 40;
    text += patches_text(section, section_patches(section, faces, look, style, coarse),
                         section_patches(section, faces, look, style, fine));
  }
  const std::string around = plate_text(sheet.plate_layers());
  if (!style.ink) return text + around + "</svg>\n";

  // Inner lines below the rims.
  const Color color = style.ink_color.value_or(ink.color);
  const double side = std::min(options.width, options.height);
  const std::vector<SectionStroke> strokes = section_strokes(section, faces, ink, style, side);
  std::vector<std::string> inner(faces.size()), rims(faces.size());
  for (const SectionStroke& stroke : strokes) {
    const double strength = stroke.rim ? 1.0 : style.inner_opacity;
    (stroke.rim ? rims : inner)[stroke.face] += path_text(stroke.points, color, strength);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (inner[i].empty() && rims[i].empty()) continue;
    const std::string number = std::to_string(i + 1);
    text += layer_start("face-" + number, "face " + number) + inner[i] + rims[i] + "  </g>\n";
  }
  return text + around + "</svg>\n";
}

}  // namespace pomona
