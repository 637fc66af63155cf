#include "generator/template/read/sketch.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/units.h"
#include "tests/base/german_locale.h"

namespace pomona {
namespace {

using testing::HasSubstr;

const std::string page = R"(width="200mm" height="100mm" viewBox="0 0 200 100")";

/// A drawing whose side view has its axis at x = 10 and whose top view has it at 50,50, unless the views contain an
/// axis.
std::string svg(const std::string& side, const std::string& top = "", const std::string& attributes = page) {
  const std::string side_axis = side.find("\"axis\"") == std::string::npos ? R"(<path id="axis" d="M10,0V-60"/>)" : "";
  const std::string top_axis =
      top.find("\"axis\"") == std::string::npos ? R"(<circle inkscape:label="axis" cx="50" cy="50" r="1"/>)" : "";
  return "<svg " + attributes + ">\n<g inkscape:label=\"side view\">\n" + side_axis + side +
         "\n</g>\n<g inkscape:label=\"top view\">\n" + top_axis + top + "\n</g>\n</svg>\n";
}

Sketch sketch(const std::string& text, std::optional<double> unit = {}) { return {parse_svg(text, "x.svg"), unit}; }

/// The points of a curve "c", in millimetres.
std::vector<glm::dvec2> points(const Sketch& sketch, SketchView view = SketchView::side) {
  std::vector<glm::dvec2> points = sketch.curve(view, "c", 10000).curve.points;
  for (glm::dvec2& p : points) p *= 1000;
  return points;
}

void expect_points(const std::vector<glm::dvec2>& found, const std::vector<glm::dvec2>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(glm::distance(found[i], wanted[i]), 1e-5) << i;
}

std::string message_of(const std::string& text, const std::string& name = "c") {
  try {
    sketch(text).curve(SketchView::side, name, 65536);
  } catch (const BadSketch& bad) {
    EXPECT_FALSE(bad.hint.empty());
    return bad.what();
  }
  return "";
}

TEST(Sketch, curves_stand_relative_to_the_axis_and_upwards) {
  expect_points(points(sketch(svg(R"(<path id="c" d="M 10,-5 L 30,-10 L 25,-40"/>)"))), {{0, 5}, {20, 10}, {15, 40}});
  expect_points(points(sketch(svg("", R"(<path id="c" d="M 60,50 L 50,40 L 45,60 Z"/>)")), SketchView::top),
                {{10, 0}, {0, 10}, {-5, -10}});
}

TEST(Sketch, relative_commands_are_understood) {
  expect_points(points(sketch(svg(R"(<path id="c" d="m 10,0 5,-5 h 3 v -2 l -1,-1"/>)"))),
                {{0, 0}, {5, 5}, {8, 5}, {8, 7}, {7, 8}});
}

TEST(Sketch, transforms_of_groups_and_shapes_are_applied) {
  // The innermost first: (1,2) -> scaled (2,4) -> turned (-4,2) -> moved (96,52); the axis is at 10,0.
  const auto found = points(sketch(svg(
      R"(<g transform='translate(100,50)'><g transform='rotate(90)'><path id="c" transform='scale(2)' d="M1,2 L0,0"/></g></g>)")));
  expect_points(found, {{86, -52}, {90, -50}});
  EXPECT_THAT(message_of(svg(R"(<g transform='rotate(x)'><path id="c" d="M0,0L1,1"/></g>)")),
              HasSubstr("cannot be read"));
}

TEST(Sketch, arcs_and_circles_are_flattened_where_they_lie) {
  // A circle of radius 10; its group scales it to an ellipse and then turns it.
  const auto found =
      points(sketch(svg("", R"(<g transform='translate(50,50) rotate(30) scale(2,1)'><circle id="c" r="10"/></g>)")),
             SketchView::top);
  EXPECT_GT(found.size(), 40u);
  const double c = std::sqrt(0.75), s = 0.5;
  for (std::size_t i = 0; i < found.size(); ++i) {
    // y is up now: turned the other way.
    const auto in_ellipse = [&](const glm::dvec2& p) {
      return glm::length(glm::dvec2((c * p.x - s * p.y) / 20, (s * p.x + c * p.y) / 10));
    };
    EXPECT_NEAR(in_ellipse(found[i]), 1, 1e-6);
    EXPECT_GT(in_ellipse(0.5 * (found[i] + found[(i + 1) % found.size()])), 1 - 1.1e-3);  // 0.01 mm of 10
  }
  const auto half = points(sketch(svg(R"(<path id="c" d="M10,0 a 10,10 0 0 0 0,-20"/>)")));
  for (const glm::dvec2& p : half) EXPECT_NEAR(glm::distance(p, glm::dvec2(0, 10)), 10, 1e-5);
  EXPECT_NEAR(half[half.size() / 2].x, 10, 0.1);
}

TEST(Sketch, basic_shapes_are_curves) {
  expect_points(points(sketch(svg(R"(<line id="c" x1="10" y1="0" x2="20" y2="-5"/>)"))), {{0, 0}, {10, 5}});
  expect_points(points(sketch(svg(R"(<polyline id="c" points="10,0 20,-5 10,-9"/>)"))), {{0, 0}, {10, 5}, {0, 9}});
  expect_points(points(sketch(svg(R"(<polygon id="c" points="11,0 20,-5 11,-9"/>)"))), {{1, 0}, {10, 5}, {1, 9}});
  expect_points(points(sketch(svg(R"(<rect id="c" x="11" y="-9" width="3" height="4"/>)"))),
                {{1, 9}, {4, 9}, {4, 5}, {1, 5}});
  const auto closed = [](const std::string& shape) {
    return sketch(svg(shape)).curve(SketchView::side, "c", 10000).curve;
  };
  EXPECT_FALSE(closed(R"(<polyline id="c" points="10,0 20,-5 10,-9"/>)").closed);
  EXPECT_TRUE(closed(R"(<polygon id="c" points="11,0 20,-5 11,-9"/>)").closed);
  // Flattened within 0.01 mm of a circumference of 48 mm.
  EXPECT_NEAR(std::abs(signed_area(closed(R"(<ellipse id="c" cx="30" rx="10" ry="5"/>)"))), pi * 50e-6, 4.8e-7);
  EXPECT_NEAR(std::abs(signed_area(closed(R"(<rect id="c" x="20" width="8" height="6" rx="2"/>)"))),
              (48 - (4 - pi) * 4) * 1e-6, 1e-7);
}

TEST(Sketch, clones_are_drawn_where_they_stand) {
  const std::string original =
      R"(<g transform='translate(5,0)'><path id="o" transform='scale(2)' d="M1,0 L2,-3"/></g>)";
  // A clone shows the original without its group, 2,0 to 4,-6, and moves it by 20,-10.
  expect_points(points(sketch(svg(original + R"(<use id="c" x="20" y="-10" href="#o"/>)"))), {{12, 10}, {14, 16}});
  expect_points(points(sketch(svg(original + R"(<use id="c" transform='translate(20,-10)' xlink:href="#o"/>)"))),
                {{12, 10}, {14, 16}});
}

TEST(Sketch, names_are_labels_or_ids_and_forgiving) {
  for (const char* name : {"inner wall", "Inner_Wall", "inner-wall"}) {
    const Sketch drawn = sketch(svg(R"(<path inkscape:label="Inner wall" id="path12" d="M10,0 L20,-5"/>)"));
    EXPECT_EQ(drawn.curve(SketchView::side, name, 100).curve.points.size(), 2u) << name;
    EXPECT_EQ(drawn.curve(SketchView::side, "path12", 100).title, "curve \"Inner wall\" (x.svg:3:32)");
  }
  EXPECT_THAT(message_of(svg(R"(<path id="cc" d="M0,0"/>)"), "cd"), HasSubstr("\"cd\" is missing in the side view"));
}

TEST(Sketch, hidden_layers_count) {
  expect_points(points(sketch(svg(R"(<g style="display:none"><path id="c" display="none" d="M10,0 L20,-5"/></g>)"))),
                {{0, 0}, {10, 5}});
  EXPECT_THAT(message_of(svg(R"(<defs><path id="c" d="M10,0 L20,-5"/></defs>)")), HasSubstr("missing"));
}

TEST(Sketch, a_tilted_axis_is_put_upright) {
  // The axis runs along 3,-4: a point 5 to its right, at 4,3, comes to lie at 5,0.
  const auto found = points(sketch(svg(R"(<path id="axis" d="M10,0 l30,-40"/><path id="c" d="M14,3 L44,-37"/>)")));
  expect_points(found, {{5, 0}, {5, 50}});
}

TEST(Sketch, the_axis_from_above_may_be_a_dot_or_a_cross) {
  for (const char* axis :
       {R"(<ellipse id="axis" cx="30" cy="20" rx="1" ry="2"/>)", R"(<path id="axis" d="M29,19 L31,21 M29,21 L31,19"/>)",
        R"(<g id="axis"><path d="M28,20h4"/><path d="M30,18v4"/></g>)",
        R"(<path id="axis" sodipodi:type="arc" sodipodi:cx="30" sodipodi:cy="20" d="M31,20 L30,21"/>)"}) {
    expect_points(points(sketch(svg("", std::string(axis) + R"(<path id="c" d="M30,20 L32,19"/>)")), SketchView::top),
                  {{0, 0}, {2, 1}});
  }
}

TEST(Sketch, sizes_come_from_a_known_length_the_unit_or_the_page) {
  const std::string curve = R"(<path id="c" d="M10,0 L20,0"/>)";
  const auto width = [&](const std::string& text, std::optional<double> unit = {}) {
    return points(sketch(text, unit)).back().x;
  };
  EXPECT_NEAR(width(svg(curve)), 10, 1e-5);
  EXPECT_NEAR(width(svg(curve, "", R"(width="100mm" viewBox="0 0 50 50")")), 20, 1e-5);
  EXPECT_NEAR(width(svg(curve, "", R"(width="10cm" height="5cm" viewBox="0 0 50 50")")), 10, 1e-5);
  EXPECT_NEAR(width(svg(curve, "", R"(width="4in")")), 10 * 25.4 / 96, 1e-5);
  EXPECT_NEAR(width(svg(curve), 0.005), 50, 1e-5);
  EXPECT_NEAR(width(svg(curve + R"(<path id="scale 6cm" d="M0,0 L30,40"/>)"), 0.005), 12, 1e-5);
  EXPECT_NEAR(width(svg(curve + R"(<g transform='scale(2)'><path id="scale=60mm" d="M0,0 h30"/></g>)")), 10, 1e-5);
  EXPECT_NEAR(width(svg(curve + R"(<path id="scales" d="M0,0 h3"/><path id="scale outer" d="M0,0 h3"/>)")), 10, 1e-5);
  EXPECT_THAT(message_of(svg(curve + R"(<path id="scale 60" d="M0,0 h3"/>)")), HasSubstr("does not say how long"));
  EXPECT_THAT(message_of(svg(curve + R"(<path id="scale 60mm" d="M0,0h3"/><path id="scale 6cm" d="M0,0h3"/>)")),
              HasSubstr("several scale lines"));
  EXPECT_THAT(message_of(svg(curve, "", "width=\"300\"")), HasSubstr("how large"));
}

TEST(Sketch, fold_lines_give_angles_against_the_clock) {
  const auto angles = sketch(svg("", R"(<path id="fold 1" d="M50,50 h30"/><path id="fold 2" d="M50,30 V50"/>
      <path inkscape:label="Fold 3" d="M50,50 l-20,20"/>)"))
                          .fold_angles(3);
  EXPECT_EQ(angles, (std::vector<double>{0, radians(90), radians(225)}));
  EXPECT_TRUE(sketch(svg("")).fold_angles(3).empty());
  // A wall just below the right is still the first one.
  EXPECT_EQ(sketch(svg("", R"(<path id="fold 1" d="M50,50 l30,0.1"/>)")).fold_angles(1), std::vector<double>{0});
}

TEST(Sketch, a_first_fold_below_the_right_turns_the_view) {
  // Walls at -30, 90 and 200 degrees, and a curve along the first of them.
  const Sketch drawn = sketch(svg("", R"(<path id="fold 1" d="M50,50 l17.320508,10"/><path id="fold 2" d="M50,50 v-20"/>
      <path id="fold 3" d="M50,50 l-18.793852,6.8404029"/><path id="c" d="M50,50 l17.320508,10"/>)"));
  const auto angles = drawn.fold_angles(3);
  ASSERT_EQ(angles.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(angles[k], radians(std::vector<double>{0, 120, 230}[k]), 1e-5);
  const auto along = points(drawn, SketchView::top);
  EXPECT_LT(glm::distance(along.back(), glm::dvec2(20, 0)), 1e-3);

  // If they are numbered clockwise, it is still a mistake.
  EXPECT_THROW(sketch(svg("", R"(<path id="fold 1" d="M50,50 l17,10"/><path id="fold 2" d="M50,50 l-19,7"/>
      <path id="fold 3" d="M50,50 v-20"/>)"))
                   .fold_angles(3),
               BadSketch);
}

TEST(Sketch, groups_give_all_their_curves) {
  const Sketch drawn =
      sketch(svg("", R"(<g id="c"><circle cx="60" cy="50" r="2"/><g><circle cx="40" r="2"/></g></g>)"));
  EXPECT_TRUE(drawn.is_group(SketchView::top, "c"));
  EXPECT_EQ(drawn.group(SketchView::top, "c", 10000).size(), 2u);
}

TEST(Sketch, numbers_do_not_depend_on_the_locale) {
  const std::string text = svg(R"(<path id="c" transform='scale(1.5,2.5)' d="M10.5,0 L20.25,-5.75"/>)");
  const auto plain = points(sketch(text));
  const GermanLocale german;
  EXPECT_EQ(points(sketch(text)), plain);
}

// ---- Hostile files ----

TEST(HostileSketch, entities_are_not_expanded) {
  std::string bomb =
      "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">"
      "<!ENTITY x SYSTEM \"file:///etc/passwd\">]>\n";
  EXPECT_EQ(message_of(bomb + svg(R"(<path id="c" d="M10,0 L20,-5"/>)")), "");
  EXPECT_THAT(message_of(bomb + svg(R"(<path id="c" d="&b;"/>)")), HasSubstr("\"&\""));
}

TEST(HostileSketch, depth_and_numbers_are_limited) {
  std::string deep, wide;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  EXPECT_THAT(message_of("<svg>" + deep), HasSubstr("not XML"));
  std::string nested = svg(deep.substr(0, 300) + R"(<path id="c" d="M0,0"/>)" + [] {
    std::string ends;
    for (int i = 0; i < 100; ++i) ends += "</g>";
    return ends;
  }());
  EXPECT_THAT(message_of(nested), HasSubstr("more than 64 groups"));
  std::string closed = deep;
  for (int i = 0; i < 100000; ++i) closed += "</g>";
  EXPECT_THAT(message_of(svg(closed)), HasSubstr("more than 64 groups"));
  for (int i = 0; i < 500000; ++i) wide += "<g/>";
  EXPECT_THAT(message_of(svg(wide)), HasSubstr("more than 200000 elements"));
  EXPECT_THAT(message_of(std::string((std::size_t{64} << 20) + 1, ' ')), HasSubstr("64 MiB"));
}

TEST(HostileSketch, clones_of_clones_end) {
  EXPECT_THAT(message_of(svg(R"(<use id="c" href="#d"/><use id="d" href="#c"/>)")), HasSubstr("clone of itself"));
  std::string laughs = R"(<g id="l0"/>)";
  for (int i = 1; i < 15; ++i) {
    laughs += "<g id=\"l" + std::to_string(i) + "\">";
    for (int k = 0; k < 10; ++k) laughs += "<use href=\"#l" + std::to_string(i - 1) + "\"/>";
    laughs += "</g>";
  }
  EXPECT_THAT(message_of(svg(laughs), "l14"), HasSubstr("too many"));
}

TEST(HostileSketch, long_paths_and_odd_numbers_are_errors) {
  std::string path = "M0,0";
  for (int i = 0; i < 300000; ++i) path += i % 2 ? "h1" : "v1";
  EXPECT_THAT(message_of(svg("<path id=\"c\" d=\"" + path.substr(0, 250000) + "\"/>")), HasSubstr("65536 points"));
  EXPECT_THAT(message_of(svg("<path id=\"c\" d=\"" + path + path + "\"/>")), HasSubstr("256 KiB"));
  for (const char* d : {"M nan,0 L 1,1", "M 1e999,0 L 1,1", "M 0,0 L inf,1", "M 0 0 A 1e9 1e-9 7 1 1 1e308 3"}) {
    EXPECT_NE(message_of(svg(std::string("<path id=\"c\" d=\"") + d + "\"/>")), "") << d;
  }
  EXPECT_NE(message_of(svg(R"(<circle id="c" r="nan"/>)")), "");
  EXPECT_NE(
      message_of(svg(R"(<g transform='scale(1e9)'><g transform='scale(1e9)'><path id="c" d="M1,1L2,2"/></g></g>)")),
      "");
}

TEST(HostileSketch, survives_mutation) {
  const std::string good = svg(R"(<path inkscape:label="c" transform='rotate(3)' d="M10,0 c 20,0 20,-20 0,-30"/>
      <path id="scale 60mm" d="M0,0h60"/><use id="u" x="3" href="#axis"/>)",
                               R"(<rect id="c" width="3" height="4" rx="1"/><path id="fold 1" d="M50,50h9"/>)");
  const RandomStream random({3, 0}, "sketch mutation");
  constexpr std::string_view bytes = "<>/=\"'&;:#() \n0129.-+eEMLCZgus\xff\xc3\x00";
  std::uint64_t draw = 0;
  for (int n = 0; n < 3000; ++n) {
    std::string mutant = n % 10 ? good : good.substr(0, random.below(draw++, good.size()));
    for (std::uint64_t k = 1 + random.below(draw++, 4); k > 0 && !mutant.empty(); --k) {
      const std::size_t at = random.below(draw++, mutant.size());
      if (random.below(draw++, 2) == 0) {
        mutant[at] = bytes[random.below(draw++, bytes.size())];
      } else {
        mutant.erase(at, 1 + random.below(draw++, 20));
      }
    }
    try {
      const Sketch drawn = sketch(mutant);
      for (const SketchView view : {SketchView::side, SketchView::top}) {
        try {
          for (const glm::dvec2& p : drawn.curve(view, "c", 10000).curve.points) {
            EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
          }
        } catch (const BadSketch&) {
        }
      }
      drawn.fold_angles(1);
    } catch (const BadSketch&) {
    }
  }
}

// ---- Other editors ----

/// A drawing in full, its side view's axis at x = 10 and its top view's at 50,50.
std::string drawn_by(const std::string& root, const std::string& side, const std::string& top) {
  return "<" + root + " " + page + ">\n" + side + "\n" + top + "\n</" + root.substr(0, root.find(' ')) + ">\n";
}

TEST(Sketch, names_belong_to_a_namespace_whatever_its_prefix) {
  const std::string label = "http://www.inkscape.org/namespaces/inkscape", svg_name = "http://www.w3.org/2000/svg";
  const auto prefixed = [&](const std::string& s, const std::string& i) {
    return drawn_by(
        s + "svg xmlns:" + s.substr(0, s.size() - 1) + "=\"" + svg_name + "\" xmlns:" + i + "=\"" + label + "\"",
        "<" + s + "g " + i + ":label=\"side view\"><" + s + "path id=\"axis\" d=\"M10,0V-60\"/><" + s + "path " + i +
            ":label=\"c\" d=\"M10,-5L30,-10\"/></" + s + "g>",
        "");
  };
  expect_points(points(sketch(prefixed("ns0:", "ns1"))), {{0, 5}, {20, 10}});
  expect_points(points(sketch(prefixed("svg:", "inkscape"))), {{0, 5}, {20, 10}});
  // The namespace is declared where it is used, and a shape of another namespace stands beside it.
  const std::string inner =
      "<g xmlns:x=\"" + label + "\" x:label=\"side view\"><path id=\"axis\" d=\"M10,0V-60\"/>" +
      "<o:path xmlns:o=\"urn:other\" id=\"c\" d=\"M0,0L1,1\"/><path x:label=\"c\" d=\"M10,-5L30,-10\"/></g>";
  expect_points(points(sketch(drawn_by("svg xmlns=\"" + svg_name + "\"", inner, ""))), {{0, 5}, {20, 10}});
  EXPECT_THROW(sketch(drawn_by("svg xmlns=\"urn:other\"", inner, "")), BadSketch);
}

TEST(Sketch, ids_that_had_to_be_unique_have_a_name_behind_them) {
  const std::string root = "svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:serif=\"http://www.serif.com/\"";
  const auto with = [&](const std::string& top_layer, const std::string& axis) {
    return drawn_by(root, "<g id=\"side_view\"><path id=\"axis\" d=\"M10,0V-60\"/></g>",
                    "<g " + top_layer + "><circle " + axis + " cx=\"50\" cy=\"50\" r=\"1\"/>" +
                        "<path id=\"c\" d=\"M60,50L50,40L45,60Z\"/></g>");
  };
  const std::vector<glm::dvec2> wanted{{10, 0}, {0, 10}, {-5, -10}};
  for (const auto& [layer, axis] : std::vector<std::pair<std::string, std::string>>{
           {"id=\"top_view\" data-name=\"top view\"", "id=\"axis-2\" data-name=\"axis\""},  // Illustrator
           {"id=\"top_x0020_view\"", "id=\"axis_1_\""},                                     // an older one
           {"id=\"top-view\" serif:id=\"top view\"", "id=\"axis1\" serif:id=\"axis\""},     // Affinity
           {"id=\"top view\"", "id=\"axis_2\""}})                                           // Figma
    expect_points(points(sketch(with(layer, axis)), SketchView::top), wanted);
}

/// What a style sheet or a style does to the curve "c" of a drawing, as its message says.
std::string styled(const std::string& css, const std::string& attributes, const std::string& shape = "path") {
  return message_of(svg("<style>" + css + "</style><" + shape + " id=\"c\" " + attributes + " />"));
}

TEST(Sketch, what_css_does_to_places_and_shapes_is_told) {
  const std::string line = R"(class="a cut" d="M10,0 L20,-9")";
  for (const char* rule :
       {".cut{transform:translate(5px)}", "path.a { fill:none; TRANSLATE : 5px }", "#c{rotate:9deg}", "*{scale:2}",
        "@media screen{g .cut{transform:scale(2)}}", "line, g>path{transform:scale(2)}",
        "/* } */ .cut/**/{transform-origin:0 0}", "<![CDATA[ .cut{transform:scale(2)} ]]>"})
    EXPECT_THAT(styled(rule, line), HasSubstr("is moved by its style (CSS)")) << rule;
  EXPECT_THAT(styled("g{transform:scale(2)}", line), HasSubstr("is moved by its style (CSS)")) << "by its group";
  EXPECT_THAT(styled(".cut{d:path('M0,0')}", line), HasSubstr("has its shape from its style (CSS)"));
  EXPECT_THAT(styled("", line + R"x( style="d:path('M0,0')")x"), HasSubstr("has its shape from its style (CSS)"));
  EXPECT_THAT(styled("", R"(r="4" style="stroke:red; r:9px")", "circle"), HasSubstr("has its shape from its style"));
  EXPECT_THAT(styled("", R"(width="4" height="3" style="width:9px")", "rect"),
              HasSubstr("has its shape from its style"));
}

TEST(Sketch, css_that_is_for_others_or_says_nothing_counts_for_nothing) {
  const std::string line = R"(class="a cut" d="M10,0 L20,-9")";
  for (const char* rule : {"", ".b{transform:scale(2)}", "#d{transform:scale(2)}", "circle{transform:scale(2)}",
                           "path:hover{transform:scale(2)}", ".cut{transform:none}", ".cut{text-transform:uppercase}",
                           ".cut{r:9px;cx:4px}", "/* .cut{transform:scale(2)} */", ".cut{transform", "}}{{;;",
                           "@keyframes k{from{transform:none}to{transform:scale(2)}}"})
    EXPECT_EQ(styled(rule, line), "") << rule;
  EXPECT_EQ(styled("", line + R"( style="fill:none;stroke:url(#d);vector-effect:none")"), "");
}

TEST(Sketch, style_sheets_have_a_limit) {
  std::string many;
  for (int i = 0; i < 1000; ++i) many += ".a" + std::to_string(i) + "{transform:scale(2)}";
  EXPECT_THROW(sketch(svg("<style>" + many + "</style>")), BadSketch);
}

TEST(Sketch, a_page_that_covers_its_box_is_larger_and_one_that_is_stretched_is_refused) {
  const auto size = [](const std::string& aspect) {
    const std::string wide = R"(width="400mm" height="100mm" viewBox="0 0 200 100" preserveAspectRatio=")";
    return points(sketch(svg(R"(<path id="c" d="M10,0 L20,-9"/>)", "", wide + aspect + "\""))).back().x;
  };
  EXPECT_NEAR(size(""), 10, 1e-5);
  EXPECT_NEAR(size("xMinYMax meet"), 10, 1e-5);
  EXPECT_NEAR(size("xMinYMid slice"), 20, 1e-5);
  EXPECT_THROW(size("none"), BadSketch);
  EXPECT_NO_THROW(sketch(svg("", "", page + R"( preserveAspectRatio="none")"))) << "it has the same shape";
}

TEST(Sketch, clones_whose_place_is_not_known_are_told) {
  const std::string symbol = R"(<symbol id="s" viewBox="0 0 5 5"><path d="M1,0 L2,-1"/></symbol>)";
  EXPECT_THAT(message_of(svg(symbol + R"(<use id="c" href="#s" width="50" height="50"/>)")),
              HasSubstr("lies in a symbol with a page of its own (viewBox)"));
  const std::string line = R"(<defs><path id="p" d="M10,0 L20,-9"/></defs>)";
  EXPECT_THAT(message_of(svg(line + R"(<use id="c" href="#p" x="10%"/>)")),
              HasSubstr("has a length that cannot be read: x=\"10%\""));
  EXPECT_EQ(message_of(svg(line + R"(<use id="c" href="#p" width="100%"/>)")), "") << "it has no size of its own";
}

}  // namespace
}  // namespace pomona
