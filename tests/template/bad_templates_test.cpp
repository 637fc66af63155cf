// Every file in bad/ is good.toml with one mistake; each must be reported at its place.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

const std::filesystem::path here = std::filesystem::path(POMONA_SOURCE_DIR) / "tests/template";

struct Mistake {
  const char* file;
  int line, column;
  const char* message;
};

const Mistake mistakes[] = {
    {"syntax", 9, 9, "parsing"},
    {"open_string", 3, 14, "string"},
    {"duplicate_key", 4, 9, "cannot redefine"},
    {"not_utf8", 3, 12, "UTF-8"},
    {"unknown_key", 5, 1, "unknown key \"colour\""},
    {"misspelt_key", 16, 1, "unknown key \"roundnes\""},
    {"format_of_the_future", 1, 10, "format is 2"},
    {"lacks_name", 1, 1, "the file lacks \"name\""},
    {"odd_name", 2, 8, "is not a plain name"},
    {"title_no_text", 3, 9, "title must be a text"},
    {"unit_without_unit", 4, 8, "unit \"1\" is not a length"},
    {"unit_of_nothing", 4, 8, "unit is 0mm, but must lie between"},
    {"parts_twice", 5, 27, "\"skin\" is there already"},
    {"no_parts", 5, 9, "parts is empty"},
    {"symmetry_unknown", 8, 8, "symmetry kind \"mirror\" is not known"},
    {"folds_zero", 9, 9, "folds is 0, but must lie between 1 and 64"},
    {"folds_many", 9, 9, "folds is 65"},
    {"folds_fraction", 9, 9, "folds must be a whole number"},
    {"fold_angles_few", 10, 15, "has 1 angles for 2 folds"},
    {"fold_angles_back", 10, 21, "does not ascend"},
    {"type_unknown", 13, 8, "type \"around\" is not known"},
    {"lacks_vertical", 11, 1, "surface \"skin\": lacks \"vertical\""},
    {"path_garbage", 23, 12, "\"X\" after 8 characters"},
    {"path_short", 23, 12, "missing or out of place"},
    {"path_empty", 23, 12, "curve is empty"},
    {"path_in_pieces", 23, 12, "curve has several parts"},
    {"path_beyond_numbers", 23, 12, "beyond"},
    {"left_of_axis", 14, 12, "goes left of the axis"},
    {"touches_axis", 14, 12, "touches the axis between its ends"},
    {"vertical_crosses_itself", 23, 12, "crosses itself"},
    {"vertical_open_in_fold", 23, 12, "is not closed"},
    {"loop_misses_axis", 15, 14, "does not surround the axis"},
    {"loop_crosses_itself", 15, 14, "crosses itself"},
    {"loop_crosses_fold_line", 15, 14, "crosses fold line 1, at 0 degrees, 3 times"},
    {"loop_leaves_fold", 24, 14, "leaves fold 1"},
    {"loops_few", 24, 14, "has 1 curves for 2 folds"},
    {"in_fold_without_folds", 19, 1, "lies in a fold, but the fruit has none"},
    {"both_hidden", 11, 1, "surface \"skin\": has both sides hidden"},
    {"part_unknown", 27, 17, "back part \"pit\" is not known"},
    {"colour_short", 17, 34, "front color \"#5b2\" is not a colour"},
    {"ramp_unsorted", 18, 54, "does not ascend"},
    {"ramp_beyond", 16, 27, "must lie between 0 and 1"},
    {"stop_odd", 16, 26, "is not a stop"},
    {"blur_negative", 25, 8, "blur is -0.4mm"},
    {"around_many", 26, 10, "around is 1025"},
    {"surface_twice", 21, 8, "\"skin\" is there already"},
    {"grain_surface", 31, 11, "surface \"stones\" is not known"},
    {"grain_radius", 32, 11, "spacing is 0mm"},
    {"grain_number", 33, 10, "length must be a length with its unit"},
    {"grain_depth_around", 38, 9, "depth is for surfaces in folds"},
    {"grain_fold_beyond", 38, 13, "must lie between 1 and 2"},
    {"grain_apart_from_itself", 38, 15, "are no grains written before these"},
    {"grain_core_out", 38, 8, "sticks out of its grain"},
    {"grain_looks_share", 38, 9, "shares of more than 1"},
    {"grain_density_beyond", 38, 30, "must lie between 0 and 1"},
    {"grain_sector_empty", 38, 10, "is empty"},
    {"not_a_number", 16, 9, "taper is nan"},
    {"bend_round", 40, 9, "bend angle is 400"},
    {"bend_folds", 39, 1, "bend folds the fruit where it is wide"},
    {"variation_wild", 45, 8, "variation size is 0.5"},
    {"variation_unknown", 46, 1, "unknown key \"profil\""},
    {"variation_bend_number", 47, 8, "bend must be a table"},
    {"surface_no_table", 20, 1, "cannot redefine"},
};

TEST(BadTemplates, the_file_they_come_from_is_good) { EXPECT_NO_THROW(read_template(here / "good.toml")); }

TEST(BadTemplates, each_is_found_where_it_is) {
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(mistake.file);
    try {
      read_template(here / "bad" / (std::string(mistake.file) + ".toml"));
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_data);
      const auto fits = [&](const Diagnostic& diagnostic) {
        return diagnostic.place.line == mistake.line && diagnostic.place.column == mistake.column &&
               diagnostic.message.find(mistake.message) != std::string::npos;
      };
      const auto& all = error.diagnostics();
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), fits))
          << "wanted " << mistake.line << ":" << mistake.column << " " << mistake.message << "\n"
          << error.what();
    }
  }
}

TEST(BadTemplates, none_is_forgotten) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(here / "bad")) {
    ++files;
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(std::any_of(std::begin(mistakes), std::end(mistakes), [&](const Mistake& mistake) {
      return name == mistake.file;
    })) << name;
  }
  EXPECT_EQ(files, std::size(mistakes));
}

TEST(BadTemplates, a_missing_file_is_status_66) {
  try {
    read_template(here / "bad" / "no_such_file.toml");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::input_missing);
  }
}

}  // namespace
}  // namespace pomona
