#include "generator/order/option_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "generator/base/error.h"
#include "generator/order/option_key.h"

namespace pomona {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A valid value of an option other than its default.
std::string other_value(const OrderOption& option) {
  static const std::map<std::string, std::string> special = {
      {"seeds", "2-4"},   {"texel", "0.2mm"}, {"ripeness-variants", "0.5,1"}, {"size", "80x60"}, {"view", "30,20"},
      {"style", "plain"}, {"knife", "half"},  {"variation", "0.25"},          {"scale", "0.25"}, {"detail", "0.25"}};
  if (const auto found = special.find(option.name); found != special.end()) return found->second;
  if (const auto* choice = std::get_if<ChoiceValue>(&option.value))
    return choice->words[choice->words[0] == text_of_option(option, {}) ? 1 : 0];
  if (const auto* number = std::get_if<NumberValue>(&option.value))
    return std::to_string(static_cast<int>(number->high));
  if (const auto* number = std::get_if<OptionalNumberValue>(&option.value)) return number->high > 1 ? "2" : "1";
  if (const auto* number = std::get_if<WholeValue>(&option.value)) return std::to_string(number->high);
  if (const auto* number = std::get_if<OptionalWholeValue>(&option.value)) return std::to_string(number->high);
  if (std::holds_alternative<CountValue>(option.value)) return "18446744073709551615";
  if (std::holds_alternative<FlagValue>(option.value)) return "true";
  return "somewhere";
}

TEST(OptionTable, GivesBackWhatItReads) {
  for (const OrderOption& option : order_options()) {
    Order order;
    EXPECT_FALSE(is_ordered(option, order)) << option.name;
    read_option(option, other_value(option), order);
    EXPECT_EQ(text_of_option(option, order), other_value(option)) << option.name;
    EXPECT_TRUE(is_ordered(option, order)) << option.name;

    // No other option has changed.
    for (const OrderOption& other : order_options())
      EXPECT_EQ(is_ordered(other, order), other.name == option.name) << option.name << " gives " << other.name;
  }
}

TEST(OptionTable, HasEachNameOnceAndHelpForEach) {
  std::set<std::string> names;
  for (const OrderOption& option : order_options()) {
    EXPECT_TRUE(names.insert(option.name).second) << option.name;
    EXPECT_FALSE(option.help.empty()) << option.name;
    EXPECT_FALSE(option.takers.empty()) << option.name;
  }
  for (const OrderOption& option : order_options())
    EXPECT_TRUE(option.excludes.empty() || names.contains(option.excludes)) << option.name;
}

TEST(OptionTable, RefusesWhatIsBeyondARange) {
  for (const OrderOption& option : order_options()) {
    for (const char* wrong : {"-1", "1e9", "", "x"}) {
      const bool is_text = std::holds_alternative<TextValue>(option.value) ||
                           std::holds_alternative<ParsedValue>(option.value) ||
                           std::holds_alternative<KnivesValue>(option.value);
      if (is_text && wrong[0] != 0) continue;
      Order order;
      EXPECT_THROW(read_option(option, wrong, order), Error) << option.name << " takes \"" << wrong << "\"";
    }
  }
}

TEST(OptionTable, WritesLimitsAsPeopleDo) {
  EXPECT_THAT(fault_of_option(order_option("piece"), "0"), HasSubstr("from 1 to 1000000"));
  EXPECT_THAT(fault_of_option(order_option("scale"), "0"), HasSubstr("from 0.05 to 20"));
}

TEST(OptionTable, WarnsOfEveryOptionThatNoFormatHeeds) {
  for (const OrderOption& option : order_options()) {
    if (option.heeded.empty()) continue;
    Order order;
    read_option(option, other_value(option), order);
    for (const Format format : {Format::ply, Format::glb, Format::usda, Format::obj, Format::stl, Format::pov,
                                Format::png, Format::svg, Format::json, Format::html, Format::pomona}) {
      order.outputs = {{"x." + name_of(format), format}};
      const bool is_heeded = any_is(order.outputs, option.heeded);
      const std::vector<std::string> warnings = idle_options(order, option.takers.front());
      if (is_heeded) {
        for (const std::string& warning : warnings) EXPECT_THAT(warning, Not(HasSubstr("no output is one")));
      } else {
        ASSERT_EQ(warnings.size(), 1u) << option.name << " " << name_of(format);
        EXPECT_THAT(warnings[0], StartsWith(flag_of(option) + " is about " + endings_of(option.heeded)));
      }
    }
  }
}

TEST(OptionTable, SaysInACommandWhatMakesAPiece) {
  Order order;
  EXPECT_EQ(piece_words(order), "");
  order.color.quality = Quality::draft;
  order.color.style = "my style.toml";
  order.mesh.feature_ids = true;
  order.mesh.maps = Maps::color;  // has no effect without textures
  order.picture.dpi = 300;        // not an option of pieces
  EXPECT_EQ(piece_words(order), " --quality draft --style 'my style.toml' --feature-ids");
  order.mesh.texture = 256;
  EXPECT_EQ(piece_words(order), " --quality draft --style 'my style.toml' --texture 256 --maps color --feature-ids");
}

TEST(OptionKey, ReadsWhatTheCommandLineReads) {
  TomlDocument document("lod = 0\nfeature_ids = true\nsize = \"80x60\"\nexplode = 2\ntexture = 8\nmaps = \"best\"\n",
                        "x.toml");
  Order order;
  order.mesh.lod = 3;
  for (const OrderOption& option : order_options()) read_option_key(option, document.root(), order);
  EXPECT_EQ(order.mesh.lod, 0);
  EXPECT_TRUE(order.mesh.feature_ids);
  EXPECT_EQ(order.picture.size->width, 80);
  EXPECT_EQ(order.cut.explode, 2);
  try {
    document.throw_if_any();
    FAIL() << "nothing is wrong";
  } catch (const Error& error) {
    ASSERT_EQ(error.diagnostics().size(), 2u);
    EXPECT_THAT(to_string(error.diagnostics()[0]), StartsWith("x.toml:5:11: error: texture is below 64 texels"));
    EXPECT_THAT(to_string(error.diagnostics()[1]), StartsWith("x.toml:6:8: error: maps"));
  }
}

}  // namespace
}  // namespace pomona
