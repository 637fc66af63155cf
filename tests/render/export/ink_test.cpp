// Ink in files: the strokes of an .svg and the ribbons of a .pov are those of the picture.
#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "render/export/pov.h"
#include "render/export/svg.h"
#include "render/picture/section_layout.h"
#include "render/strokes/lens.h"
#include "render/strokes/scene_strokes.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

constexpr StrokeOptions size{.width = 400, .height = 300};

std::vector<SceneStroke> strokes() {
  Style style = style_named("ink");
  style.inner_opacity = 1;
  return scene_strokes(testing::still_life(), style, size);
}

/// All numbers in a text.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    const bool begins = *at == '-' || (*at >= '0' && *at <= '9');
    const double number = begins ? std::strtod(at, &end) : 0;
    if (begins && end != at) numbers.push_back(number);
    at = begins && end != at ? end : at + 1;
  }
  return numbers;
}

std::string between(const std::string& text, const std::string& start, const std::string& stop, std::size_t& at) {
  const std::size_t first = text.find(start, at);
  if (first == std::string::npos) {
    at = std::string::npos;
    return {};
  }
  const std::size_t last = text.find(stop, first + start.size());
  at = last;
  return text.substr(first + start.size(), last - first - start.size());
}

/// The ends of a path's curves and round caps: stroke_outline() writes only "M", "C" and "A".
std::vector<glm::dvec2> nodes_of(const std::string& path) {
  std::vector<glm::dvec2> nodes;
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t next = std::min(path.find_first_of("MCAZ", at + 1), path.size());
    const std::vector<double> numbers = numbers_in(path.substr(at + 1, next - at - 1));
    const std::size_t step = path[at] == 'C' ? 6 : path[at] == 'A' ? 7 : 2;
    for (std::size_t i = step; i <= numbers.size(); i += step) nodes.emplace_back(numbers[i - 2], numbers[i - 1]);
    at = next;
  }
  return nodes;
}

/// The nodes of all paths of a layer.
std::vector<glm::dvec2> points_of_layer(const std::string& svg, const std::string& id) {
  const std::size_t start = svg.find("<g id=\"" + id + "\"");
  EXPECT_NE(start, std::string::npos) << id;
  if (start == std::string::npos) return {};
  const std::string layer = svg.substr(start, svg.find("</g>", start) - start);
  std::vector<glm::dvec2> points;
  for (std::size_t at = 0; at != std::string::npos;) {
    const std::vector<glm::dvec2> nodes = nodes_of(between(layer, " d=\"", "\"", at));
    points.insert(points.end(), nodes.begin(), nodes.end());
  }
  return points;
}

double distance_to(const std::vector<glm::dvec2>& points, const glm::dvec2& from) {
  double nearest = 1e9;
  for (const glm::dvec2& p : points) nearest = std::min(nearest, glm::distance(p, from));
  return nearest;
}

TEST(InkInSvg, EachStrokeEndsWhereItDoesInThePictureAndNothingElseIsDrawn) {
  const std::vector<SceneStroke> ink = strokes();
  ASSERT_GT(ink.size(), 5u);
  const std::string svg = write_svg(testing::still_life(), ink, {size.width, size.height}, "");
  for (const SceneStroke& stroke : ink) {
    const std::vector<glm::dvec2> points = points_of_layer(svg, "ink-" + std::to_string(stroke.instance + 1));
    for (const StrokePoint* end : {&stroke.points.front(), &stroke.points.back()}) {
      EXPECT_LE(distance_to(points, end->at), end->radius + 1);
    }
  }

  // Conversely: nothing is drawn beside the strokes.
  const Scene scene = testing::still_life();
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    std::vector<glm::dvec2> middles;
    double widest = 0;
    for (const SceneStroke& stroke : ink) {
      if (stroke.instance != i) continue;
      for (const StrokePoint& point : stroke.points) {
        middles.push_back(point.at);
        widest = std::max(widest, point.radius);
      }
    }
    if (middles.empty()) continue;
    for (const glm::dvec2& p : points_of_layer(svg, "ink-" + std::to_string(i + 1))) {
      EXPECT_LE(distance_to(middles, p), widest + 1);
    }
  }
}

TEST(InkInSvg, AStrokeOfOneOpacityIsOnePath) {
  std::vector<SceneStroke> ink = strokes();
  for (SceneStroke& stroke : ink) {
    for (StrokePoint& point : stroke.points) point.opacity = 1;
  }
  const std::string svg = write_svg(testing::still_life(), ink, {size.width, size.height}, "");
  std::size_t paths = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++paths;
  EXPECT_EQ(paths, ink.size());
}

struct Ribbons {
  std::vector<glm::dvec3> places;
  std::size_t triangles = 0;
};

/// The places, in scene units, and the triangles of the object "Ink".
Ribbons ribbons_of(const std::vector<NamedFile>& files) {
  const std::string& meshes = files[1].bytes;
  const std::string ink = meshes.substr(meshes.find("#declare Ink"));
  std::size_t at = files[0].bytes.find("a unit is 1e");
  const double unit = std::pow(10.0, std::strtod(files[0].bytes.c_str() + at + 12, nullptr));
  std::size_t scale_at = ink.rfind("scale ");
  const double scale = unit * std::strtod(ink.c_str() + scale_at + 6, nullptr);
  Ribbons ribbons;
  at = 0;
  while (true) {
    const std::vector<double> numbers = numbers_in(between(ink, "vertex_vectors {", "}", at));
    if (at == std::string::npos) break;
    for (std::size_t i = 1; i + 2 < numbers.size(); i += 3) {
      ribbons.places.push_back(scale * glm::dvec3(numbers[i], numbers[i + 1], numbers[i + 2]));
    }
    ribbons.triangles += static_cast<std::size_t>(numbers_in(between(ink, "face_indices {", "}", at)).front());
  }
  return ribbons;
}

TEST(InkInPov, RibbonsRunAlongTheStrokesOfThePicture) {
  const Scene scene = testing::still_life();
  const std::vector<SceneStroke> ink = strokes();
  const Ribbons ribbons =
      ribbons_of(write_pov(scene, "x", {}, {.width = size.width, .height = size.height, .strokes = ink}));
  std::size_t places = 0, triangles = 0;
  for (const SceneStroke& stroke : ink) {
    if (stroke.points.size() < 2) continue;
    places += 2 * stroke.points.size();
    triangles += 2 * (stroke.points.size() - 1);
  }
  ASSERT_EQ(ribbons.places.size(), places);
  EXPECT_EQ(ribbons.triangles, triangles);

  // Two places for each point of a stroke, one on each side.
  const Lens lens(scene.view, size.width, size.height);
  std::vector<glm::dvec2> middles;
  for (std::size_t i = 0; i + 1 < ribbons.places.size(); i += 2) {
    middles.push_back(0.5 * (glm::dvec2(lens.seen(ribbons.places[i])) + glm::dvec2(lens.seen(ribbons.places[i + 1]))));
  }
  for (const SceneStroke& stroke : ink) {
    for (const StrokePoint& point : stroke.points) EXPECT_LE(distance_to(middles, point.at), 0.1);
  }
}

/// The ribbon is perpendicular to the stroke and as wide, at any bend.
TEST(InkInPov, RibbonsAreAsWideAsTheStrokesOfThePicture) {
  const std::vector<StrokePoint> bent{{.at = {100, 100}, .radius = 2},
                                      {.at = {140, 120}, .radius = 3},
                                      {.at = {150, 160}, .radius = 2.5},
                                      {.at = {120, 190}, .radius = 2}};
  const std::vector<SceneStroke> ink{{.points = bent, .distance = std::vector<double>(bent.size(), 1.0)}};
  const Scene scene = testing::still_life();
  const Ribbons ribbons =
      ribbons_of(write_pov(scene, "x", {}, {.width = size.width, .height = size.height, .strokes = ink}));
  ASSERT_EQ(ribbons.places.size(), 2 * bent.size());
  const Lens lens(scene.view, size.width, size.height);
  for (std::size_t i = 0; i < bent.size(); ++i) {
    const glm::dvec2 left(lens.seen(ribbons.places[2 * i])), right(lens.seen(ribbons.places[2 * i + 1]));
    const glm::dvec2 along = bent[std::min(i + 1, bent.size() - 1)].at - bent[i > 0 ? i - 1 : 0].at;
    EXPECT_NEAR(glm::distance(left, right), 2 * bent[i].radius, 0.1) << i;
    EXPECT_NEAR(glm::dot(glm::normalize(left - right), glm::normalize(along)), 0, 0.05) << i;
  }
}

TEST(SheetOfSvg, IsAsLargeAsItsPixelsPerInchSay) {
  const Scene scene = testing::still_life();
  const auto size_of = [&](const SvgSheet& sheet, const std::string& side, std::string& unit) {
    std::size_t at = 0;
    const std::string text = between(write_svg(scene, {}, sheet, ""), side + "=\"", "\"", at);
    unit = text.substr(text.find_first_not_of("0123456789."), std::string::npos);
    return std::strtod(text.c_str(), nullptr);
  };
  std::string unit;
  EXPECT_NEAR(size_of({400, 300, 100}, "width", unit), 101.6, 0.005);
  EXPECT_EQ(unit, "mm");
  EXPECT_NEAR(size_of({400, 300, 100}, "height", unit), 76.2, 0.005);
  EXPECT_EQ(unit, "mm");
}

TEST(MarksInSvg, AreALayerWhereThereAreAnyAndElseNone) {
  const Scene scene = testing::still_life();
  EXPECT_EQ(write_svg(scene, {}, {size.width, size.height}, "").find("marks"), std::string::npos);
  const SvgMarks dots{.marks = {{{.at = {20, 30}, .radius = 1.5}}, {{.at = {50.25, 60}, .radius = 2}}}};
  const std::string svg = write_svg(scene, {}, {size.width, size.height}, "", {}, dots);
  const std::size_t layer = svg.find("<g id=\"marks\"");
  ASSERT_NE(layer, std::string::npos);
  std::size_t at = layer;
  EXPECT_EQ(numbers_in(between(svg, "<circle", "/>", at)), (std::vector<double>{20, 30, 1.5}));
  EXPECT_EQ(numbers_in(between(svg, "<circle", "/>", at)), (std::vector<double>{50.25, 60, 2}));
}

/// Each patch is "Mx yldx dy dx dyz" in tenths of a pixel. Their total area is that of the face, once in coarse patches
/// and once in finer ones above.
TEST(PatchesInSvg, AreAsLargeAsTheirFace) {
  const CrossSection disc = testing::disc_section(1);
  const SectionPictureOptions paper{.width = 320, .height = 240};
  const std::string svg =
      write_section_svg(disc, testing::some_noise({0.6f, 0.02f, 0.02f}), InkStyle{}, style_named("plain"), paper, "");
  std::size_t at = svg.find("<g id=\"colours\"");
  ASSERT_NE(at, std::string::npos);
  const auto twice_area = [](const glm::dvec2& a, const glm::dvec2& b) { return std::abs(a.x * b.y - a.y * b.x); };
  double drawn = 0;
  while (true) {
    const std::string path = between(svg, " d=\"M", "\"", at);
    if (at == std::string::npos || path.find('l') == std::string::npos) break;
    const std::vector<double> numbers = numbers_in(path);
    ASSERT_EQ(numbers.size() % 6, 0u);
    for (std::size_t i = 0; i < numbers.size(); i += 6)
      drawn += 0.005 * twice_area({numbers[i + 2], numbers[i + 3]}, {numbers[i + 4], numbers[i + 5]});
  }
  const PlacedFace face = lay_out(disc, {paper.width, paper.height}, paper.margin * paper.height)[0];
  double whole = 0;
  for (const glm::uvec3& t : disc.triangle) {
    const glm::dvec2 a = face.to_paper(disc.position[t.x]);
    whole += 0.5 * twice_area(face.to_paper(disc.position[t.y]) - a, face.to_paper(disc.position[t.z]) - a);
  }
  EXPECT_NEAR(drawn / whole, 2, 0.02);
}

}  // namespace
}  // namespace pomona
