#include "generator/text/toml_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/units.h"

namespace pomona {
namespace {

using testing::HasSubstr;

/// The message of throw_if_any() for a text after `read` has read it.
template <typename Read>
std::vector<Diagnostic> diagnostics_of(const std::string& toml, Read read) {
  try {
    TomlDocument document(toml, "x.toml");
    read(document.root());
    document.throw_if_any();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    return error.diagnostics();
  }
  return {};
}

void expect_at(const Diagnostic& diagnostic, int line, int column, const std::string& message) {
  EXPECT_EQ(diagnostic.place.file, "x.toml");
  EXPECT_EQ(diagnostic.place.line, line) << to_string(diagnostic);
  EXPECT_EQ(diagnostic.place.column, column) << to_string(diagnostic);
  EXPECT_THAT(diagnostic.message, HasSubstr(message));
}

TEST(TomlDocument, reads_every_kind_of_value) {
  TomlDocument document(
      "name = 'fig'\nfolds = 5\nshare = 0.5\nwidth = \"4mm\"\nturn = 90\nskin = \"#ffffff\"\nraw = true\n"
      "many = [1, 2]\n[inner]\nx = 1\n[[surface]]\ny = 1\n[[surface]]\ny = 2\n",
      "x.toml");
  const TomlTable root = document.root();
  EXPECT_EQ(root.need("name").text(), "fig");
  EXPECT_EQ(root.need("folds").integer(0, 1, 64), 5);
  EXPECT_EQ(root.need("share").number(), 0.5);
  EXPECT_DOUBLE_EQ(root.need("width").length(), 0.004);
  EXPECT_DOUBLE_EQ(root.need("turn").angle(), pi / 2);
  EXPECT_EQ(root.need("skin").color(), Color(1.0f));
  EXPECT_TRUE(root.need("raw").boolean());
  ASSERT_EQ(root.need("many").values().size(), 2u);
  EXPECT_EQ(root.get("many").values()[1].integer(0, 0, 9), 2);
  EXPECT_EQ(root.need("inner").table().need("x").integer(0, 0, 9), 1);
  const std::vector<TomlTable> surfaces = root.need("surface").tables();
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].need("y").integer(0, 0, 9), 1);
  EXPECT_EQ(surfaces[1].need("y").integer(0, 0, 9), 2);
  EXPECT_EQ(root.get("absent").text("fallback"), "fallback");
  EXPECT_NO_THROW(document.throw_if_any());
}

TEST(TomlDocument, reports_all_mistakes_sorted_by_position) {
  const auto found =
      diagnostics_of("a = 'x'\nb = 99\nc = \"4 miles\"\nd = \"#12g\"\ncolour = 1\n", [](const TomlTable& root) {
        root.get("d").color();
        root.get("c").length();
        root.get("b").integer(1, 1, 64);
        root.get("a").number();
        root.get("color").color();
        root.need("format");
      });
  ASSERT_EQ(found.size(), 6u);
  expect_at(found[0], 1, 1, "the file lacks \"format\"");
  expect_at(found[1], 1, 5, "a must be a number, not a text");
  expect_at(found[2], 2, 5, "b is 99, but must lie between 1 and 64");
  expect_at(found[3], 3, 5, "c \"4 miles\" is not a length");
  expect_at(found[4], 4, 5, "d \"#12g\" is not a colour");
  expect_at(found[5], 5, 1, "unknown key \"colour\"");
  EXPECT_EQ(found[5].hint, "did you mean \"color\"?");
}

TEST(TomlDocument, names_tables_and_reports_what_they_lack_at_their_head) {
  const auto found = diagnostics_of("[[surface]]\nname = 'skin'\nfront = { color = 3 }\n", [](const TomlTable& root) {
    const TomlTable surface = root.get("surface").tables()[0].called("surface \"skin\"");
    surface.need("name");
    surface.need("vertical");
    surface.need("front").table().need("color").color();
  });
  ASSERT_EQ(found.size(), 2u);
  expect_at(found[0], 1, 1, "surface \"skin\": lacks \"vertical\"");
  expect_at(found[1], 3, 19, "surface \"skin\": front color must be a colour");
}

TEST(TomlDocument, a_table_that_is_missing_complains_once) {
  const auto found = diagnostics_of("x = 1\n", [](const TomlTable& root) {
    root.get("x");
    root.need("symmetry").table().need("folds").table().need("deeper");
  });
  ASSERT_EQ(found.size(), 1u);
  expect_at(found[0], 1, 1, "lacks \"symmetry\"");
}

TEST(TomlDocument, stops_at_twenty) {
  std::string toml;
  for (int i = 0; i < 50; ++i) toml += "k" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(diagnostics_of(toml, [](const TomlTable&) {}).size(), 20u);
}

TEST(TomlDocument, mistakes_in_the_syntax_have_a_position) {
  const auto nothing = [](const TomlTable&) {};
  expect_at(diagnostics_of("a = 1\na = 2\n", nothing).at(0), 2, 5, "cannot redefine");
  expect_at(diagnostics_of("a = 1\nb = = 2\n", nothing).at(0), 2, 5, "");
  expect_at(diagnostics_of("a = \"open\n", nothing).at(0), 1, 10, "");
}

TEST(TomlDocument, mistakes_in_the_syntax_say_what_was_meant) {
  const auto hint = [](const std::string& text) { return diagnostics_of(text, [](const TomlTable&) {}).at(0).hint; };
  EXPECT_EQ(hint("a = 1\nblur = 1.5mm\n"), "texts and lengths stand in quotes: \"1.5mm\"");
  EXPECT_EQ(hint("blur = 4 mm"), "texts and lengths stand in quotes: \"4 mm\"");
  EXPECT_EQ(hint("parts = [skin, flesh]\n"), "texts and lengths stand in quotes: \"skin\"");
  EXPECT_EQ(hint("front = { part = \"\u00fc\u00fc\u00fc\", color = #c8752c }\n"),
            "colours stand in quotes: \"#c8752c\"");
  EXPECT_EQ(hint("hidden = True\n"), "write it in small letters: true, false");
  EXPECT_EQ(hint("x = 0,8\n"), "decimals have a point: 0.5");
  EXPECT_EQ(hint("x = .8\r\n"), "write 0.8");
  EXPECT_EQ(hint("x = \u201cplum\u201d\n"), "quotes are straight: \"");
  EXPECT_EQ(hint("x = \"plum\ny = 1\n"), "the text lacks the quotes at its end");
  EXPECT_EQ(hint("x: 1\n"), "write a key and its value so: name = \"plum\"");
  EXPECT_EQ(hint("x = { a = 1,\n b = 2 }\n"), "what is in { } stands on one line");
  EXPECT_EQ(hint("[[srface]]\nx = 1\n[surface.front]\nx = 1\n[[surface]]\n"),
            "an earlier heading of it lacks its second brackets, or is mistyped");
  for (const char* odd : {"x = [0 \"a\"]", "x = \"Pl\\um\"", "[x", "x = = 2", "x = 1\nx = 2", "x = ", "=", "x ="})
    EXPECT_EQ(hint(odd), "") << odd;
}

TEST(TomlDocument, numbers_must_be_finite) {
  const auto found = diagnostics_of("a = nan\nb = inf\nc = 1e300\n", [](const TomlTable& root) {
    for (const char* key : {"a", "b", "c"}) root.get(key).number();
  });
  EXPECT_EQ(found.size(), 3u);
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(TomlDocument, refuses_what_goes_beyond_the_limits) {
  const auto message = [](const std::string& toml) {
    const auto found = diagnostics_of(toml, [](const TomlTable& root) { root.get("a"); });
    return found.empty() ? "" : found[0].message;
  };
  EXPECT_THAT(message("a = " + repeated("[", 100000)), HasSubstr("nest deeper"));
  EXPECT_THAT(message("a = " + repeated("{a=", 100000)), HasSubstr("nest deeper"));
  EXPECT_THAT(message(repeated("a.", 100000) + "a = 1"), HasSubstr("nests deeper"));
  EXPECT_THAT(message(repeated("[", 1) + repeated("a.", 100000) + "a]"), HasSubstr("nests deeper"));
  EXPECT_THAT(message("a = " + repeated("{a.b.c=", 50) + "1" + repeated("}", 50)), HasSubstr("nest deeper"));
  EXPECT_THAT(message("a = [" + repeated("1,", 100001) + "]"), HasSubstr("more values than 100000"));
  EXPECT_THAT(message("a = '" + repeated("x", 65537) + "'"), HasSubstr("longer than"));
  EXPECT_THAT(message("a = '''" + repeated("x", 65537) + "'''"), HasSubstr("longer than"));
  EXPECT_THAT(message(std::string((16 << 20) + 1, ' ')), HasSubstr("16 MiB"));
  EXPECT_THAT(message("a = '\xff'"), HasSubstr("UTF-8"));
  EXPECT_THAT(message("# \xed\xa0\x80\n"), HasSubstr("UTF-8"));
  EXPECT_EQ(message("a = [" + repeated("1,", 99999) + "1]"), "");
  EXPECT_EQ(message("a = '" + repeated("x", 65536) + "'"), "");
  EXPECT_EQ(message("a = \"\"\"[[[ \\\" \"\" # {{{ \"\"\"\"\" # ok"), "");
}

}  // namespace
}  // namespace pomona
