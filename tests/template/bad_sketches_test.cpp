// Every drawing in sketches/bad/ is good.svg with one mistake; each must be reported at the place of the template that
// needs the curve, with the curve's name, its place in the drawing, and what to redraw.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;
const fs::path here = fs::path(POMONA_SOURCE_DIR) / "tests/template/sketches";

struct Mistake {
  const char* file;
  int line, column;
  const char* message;
};

const Mistake mistakes[] = {
    {"not_xml", 3, 10, "sketch not_xml.svg:24:3: it is not XML: Start-end tags mismatch"},
    {"compressed", 3, 10, "sketch compressed.svg:1:1: it is compressed (.svgz)"},
    {"plain_svg", 8, 9, "symmetry folds has no layer \"top view\" in plain_svg.svg, nor anything else with a label"},
    {"no_svg", 3, 10, "sketch no_svg.svg:1:1: it is no SVG drawing: its first element is <html>"},
    {"no_side_view", 13, 12, "surface \"skin\": vertical has no layer \"side view\" in no_side_view.svg"},
    {"no_top_view", 8, 9, "symmetry folds has no layer \"top view\" in no_top_view.svg"},
    {"two_side_views", 3, 10,
     "sketch has two layers \"side view\", at two_side_views.svg:4:3 and two_side_views.svg:10:3"},
    {"no_side_axis", 13, 12,
     "surface \"skin\": vertical \"axis\" is missing in the side view; one of that name is drawn in the top view at "
     "no_side_axis.svg:11:5"},
    {"two_axes", 13, 12,
     "surface \"skin\": vertical \"axis\" is drawn 2 times in the side view, first at two_axes.svg:5:5 and "
     "two_axes.svg:7:5"},
    {"two_top_axes", 8, 9,
     "symmetry folds \"axis\" is drawn 2 times in the top view, first at two_top_axes.svg:11:5 and "
     "two_top_axes.svg:11:43"},
    {"side_axis_lies", 13, 12, "surface \"skin\": vertical \"axis\" (side_axis_lies.svg:5:5) does not stand upright"},
    {"side_axis_dot", 13, 12, "surface \"skin\": vertical \"axis\" (side_axis_dot.svg:5:5) does not stand upright"},
    {"no_top_axis", 8, 9,
     "symmetry folds \"axis\" is missing in the top view; one of that name is drawn in the side view at "
     "no_top_axis.svg:5:5"},
    {"no_real_size", 13, 12,
     "surface \"skin\": vertical does not say how large the fruit is: no_real_size.svg has no real size"},
    {"scale_without_length", 13, 12,
     "surface \"skin\": vertical \"scale\" (scale_without_length.svg:5:65) does not say how long it is"},
    {"scale_is_a_dot", 13, 12,
     "surface \"skin\": vertical \"scale 60mm\" (scale_is_a_dot.svg:5:65) has no length one could measure by"},
    {"scale_twice", 13, 12,
     "surface \"skin\": vertical \"scale 60mm\" (scale_twice.svg:7:5) is one of several scale lines"},
    {"misspelt", 13, 12,
     "surface \"skin\": vertical \"skin\" is missing in the side view; one of that name is drawn in the top view at "
     "misspelt.svg:15:5"},
    {"in_the_other_view", 30, 15,
     "surface \"hole\": horizontal no. 1 \"hole 1\" is missing in the top view; one of that name is drawn in the side "
     "view at in_the_other_view.svg:8:5"},
    {"outside_the_layers", 13, 12,
     "surface \"skin\": vertical \"skin\" is missing in the side view; one of that name is drawn outside both layers "
     "at "
     "outside_the_layers.svg:23:58"},
    {"twice", 13, 12,
     "surface \"skin\": vertical \"skin\" is drawn 2 times in the side view, first at twice.svg:6:5 and "
     "twice.svg:8:36"},
    {"is_text", 13, 12, "surface \"skin\": vertical \"skin\" (is_text.svg:6:5) is no curve but <text>"},
    {"is_a_picture", 13, 12, "surface \"skin\": vertical \"skin\" (is_a_picture.svg:6:5) is no curve but <image>"},
    {"is_a_dot", 13, 12, "surface \"skin\": vertical curve \"skin\" (is_a_dot.svg:6:5) has too few points"},
    {"is_a_group", 13, 12,
     "surface \"skin\": vertical \"skin\" (is_a_group.svg:6:5) is a group of 2 curves where one is needed"},
    {"several_parts", 13, 12, "surface \"skin\": vertical \"skin\" (several_parts.svg:6:5) has several parts"},
    {"path_garbage", 13, 12,
     "surface \"skin\": vertical \"skin\" (path_garbage.svg:6:5) is not SVG path data: a command or a number is "
     "missing or out of place"},
    {"path_empty", 13, 12, "surface \"skin\": vertical \"skin\" (path_empty.svg:6:5) is empty"},
    {"left_of_axis", 13, 12, "surface \"skin\": vertical curve \"skin\" (left_of_axis.svg:6:5) goes left of the axis"},
    {"misses_the_axis", 13, 12,
     "surface \"skin\": vertical curve \"skin\" (misses_the_axis.svg:6:5) does not reach the axis at its upper end: "
     "3.0 "
     "mm are missing"},
    {"touches_axis", 13, 12,
     "surface \"skin\": vertical curve \"skin\" (touches_axis.svg:6:5) touches the axis between its ends"},
    {"crosses_itself", 13, 12, "surface \"skin\": vertical curve \"skin\" (crosses_itself.svg:6:5) crosses itself"},
    {"chamber_open", 21, 12, "surface \"chamber\": vertical curve \"chamber\" (chamber_open.svg:7:5) is not closed"},
    {"axis_outside_loop", 14, 14,
     "surface \"skin\": horizontal curve \"skin\" (axis_outside_loop.svg:15:5) does not surround the axis"},
    {"loop_crosses_itself", 14, 14,
     "surface \"skin\": horizontal curve \"skin\" (loop_crosses_itself.svg:15:5) crosses itself"},
    {"chamber_around_axis", 22, 14,
     "surface \"chamber\": horizontal curve \"chamber a\" (chamber_around_axis.svg:17:7) surrounds the axis"},
    {"fold_crossed_thrice", 14, 14,
     "surface \"skin\": horizontal curve \"skin\" (fold_crossed_thrice.svg:15:5) crosses fold line 1, at 0 degrees, 3 "
     "times"},
    {"loop_open", 14, 14, "surface \"skin\": horizontal curve \"skin\" (loop_open.svg:15:5) is not closed"},
    {"loop_in_two_folds", 22, 14,
     "surface \"chamber\": horizontal curve \"chamber a\" (loop_in_two_folds.svg:17:7) leaves fold 1, which spans 0 "
     "degrees to 120 degrees"},
    {"two_loops_in_a_fold", 22, 14,
     "surface \"chamber\": horizontal curve \"chamber c\" (two_loops_in_a_fold.svg:19:7) lies in fold 2, where curve "
     "\"chamber b\" (two_loops_in_a_fold.svg:18:7) lies already"},
    {"clone_in_the_same_fold", 22, 14,
     "surface \"chamber\": horizontal curve \"use44\" (clone_in_the_same_fold.svg:19:7) lies in fold 2, where curve "
     "\"chamber b\" (clone_in_the_same_fold.svg:18:7) lies already"},
    {"loop_in_wrong_fold", 30, 30,
     "surface \"hole\": horizontal no. 3 curve \"hole 3\" (loop_in_wrong_fold.svg:22:5) leaves fold 3, which spans "
     "240 degrees to 360 degrees"},
    {"group_of_pictures", 22, 14, "surface \"chamber\": horizontal #chambers is a group without curves"},
    {"empty_group", 22, 14, "surface \"chamber\": horizontal #chambers is a group without curves"},
    {"fold_missing", 8, 9,
     "symmetry folds \"fold 2\" is missing in the top view of fold_missing.svg, though \"fold 3\" is there"},
    {"fold_last_lost", 8, 9,
     "symmetry folds has fold lines numbered 1 to 2 in fold_last_lost.svg, but the fruit has 3 folds"},
    {"folds_many", 8, 9, "symmetry folds has fold lines numbered 1 to 4 in folds_many.svg, but the fruit has 3 folds"},
    {"fold_off_axis", 8, 9, "symmetry folds \"fold 2\" (fold_off_axis.svg:13:5) does not start at the axis"},
    {"fold_is_a_dot", 8, 9, "symmetry folds \"fold 2\" (fold_is_a_dot.svg:13:5) does not start at the axis"},
    {"fold_through_the_axis", 8, 9,
     "symmetry folds \"fold 2\" (fold_through_the_axis.svg:13:5) does not start at the axis"},
    {"folds_equal", 8, 9, "symmetry folds \"fold 3\" (folds_equal.svg:14:5) does not follow the fold line before it"},
    {"folds_unordered", 8, 9,
     "symmetry folds \"fold 3\" (folds_unordered.svg:14:5) does not follow the fold line before it"},
    {"transform_garbage", 13, 12,
     "surface \"skin\": vertical \"skin\" (transform_garbage.svg:6:5) has a transform that cannot be read"},
    {"transform_flat", 13, 12, "surface \"skin\": vertical curve \"skin\" (transform_flat.svg:6:5) has too few points"},
    {"moved_by_style", 13, 12,
     "surface \"skin\": vertical \"skin\" (moved_by_style.svg:6:5) is moved by its style (CSS)"},
    {"clone_of_nothing", 13, 12,
     "surface \"skin\": vertical \"skin\" (clone_of_nothing.svg:6:5) is a clone of nothing"},
    {"clone_of_itself", 13, 12, "surface \"skin\": vertical \"a\" (clone_of_itself.svg:6:5) is a clone of itself"},
    {"page_in_the_page", 13, 12,
     "surface \"skin\": vertical \"skin\" (page_in_the_page.svg:6:16) lies in a page within the page (a nested <svg>)"},
    {"too_far", 13, 12,
     "surface \"skin\": vertical curve \"skin\" (too_far.svg:6:5) lies more than 10 m from the axis"},
};

/// good.toml with another drawing.
std::string template_with(const std::string& svg) {
  std::ifstream stream(here / "good.toml", std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text.replace(text.find("good.svg"), 8, svg);
}

TEST(BadSketches, the_drawing_they_come_from_is_good) { EXPECT_NO_THROW(read_template(here / "good.toml")); }

TEST(BadSketches, each_is_told_with_name_place_and_remedy) {
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(mistake.file);
    try {
      parse_template(template_with(std::string(mistake.file) + ".svg"), (here / "bad" / "x.toml").string());
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_data);
      const Diagnostic& first = error.diagnostics().front();
      EXPECT_EQ(first.place.line, mistake.line) << error.what();
      EXPECT_EQ(first.place.column, mistake.column) << error.what();
      EXPECT_FALSE(first.hint.empty());

      // Messages contain the whole path; the table contains only the part after the folder.
      std::string message = first.message;
      const std::string folder = (here / "bad/").string();
      for (std::size_t at; (at = message.find(folder)) != std::string::npos;) message.erase(at, folder.size());
      EXPECT_EQ(message, mistake.message);
    }
  }
}

TEST(BadSketches, none_is_forgotten) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(here / "bad")) {
    ++files;
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(std::any_of(std::begin(mistakes), std::end(mistakes), [&](const Mistake& mistake) {
      return name == mistake.file;
    })) << name;
  }
  EXPECT_EQ(files, std::size(mistakes));
}

TEST(BadSketches, a_page_directly_in_the_page_is_one_too) {
  std::ifstream stream(here / "good.svg", std::ios::binary);
  std::string svg{std::istreambuf_iterator<char>(stream), {}};
  svg.insert(svg.find("  <g inkscape:groupmode"), "<svg>");
  svg.insert(svg.rfind("</svg>"), "</svg>");
  try {
    parse_drawn_template(template_with("good.svg"), (here / "x.toml").string(), svg);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("lies in a page within the page"));
  }
}

TEST(BadSketches, a_sketch_lies_beside_its_template) {
  for (const char* path :
       {"../good.svg", "/etc/passwd", "no_such.svg", "", ".", "bad", "a/../../good.svg", "/dev/zero"}) {
    SCOPED_TRACE(path);
    try {
      parse_template(template_with(path), (here / "bad" / "x.toml").string());
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      ASSERT_EQ(error.diagnostics().size(), 1u) << error.what();
      EXPECT_EQ(error.diagnostics()[0].place.line, 3);
      EXPECT_EQ(error.diagnostics()[0].place.column, 10);
    }
  }
  EXPECT_NO_THROW(
      parse_template(template_with("sketches/../sketches/good.svg"), (here.parent_path() / "x.toml").string()));
}

TEST(BadSketches, a_name_needs_a_sketch) {
  std::string text = template_with("good.svg");
  text.erase(text.find("sketch = "), std::string("sketch = \"good.svg\"").size());
  try {
    parse_template(text, (here / "x.toml").string());
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("is a name in a sketch, but there is none"));
  }
}

}  // namespace
}  // namespace pomona
