#include "generator/text/read_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pomona {
namespace {

using testing::ElementsAre;

struct ReadRange {
  std::optional<Within> range;
  std::vector<std::string> mistakes;
};

/// What `x = VALUE` gives for numbers from 0 to 9.
ReadRange read(const std::string& value) {
  ReadRange result;
  try {
    TomlDocument document("x = " + value + "\n", "x.toml");
    result.range = number_range(document.root().get("x"), {0, 9});
    document.throw_if_any();
  } catch (const Error& error) {
    for (const Diagnostic& one : error.diagnostics()) result.mistakes.push_back(one.message);
  }
  return result;
}

TEST(NumberRange, is_one_number_or_two_in_order) {
  const ReadRange one = read("4"), two = read("[2, 7]"), same = read("[3, 3]");
  ASSERT_TRUE(one.range && two.range && same.range);
  EXPECT_EQ(one.range->low, 4);
  EXPECT_EQ(one.range->high, 4);
  EXPECT_EQ(two.range->low, 2);
  EXPECT_EQ(two.range->high, 7);
  EXPECT_EQ(same.range->high, 3);
}

TEST(NumberRange, is_nothing_where_the_key_is_missing) {
  TomlDocument document("y = 1\n", "x.toml");
  EXPECT_FALSE(number_range(document.root().get("x"), {0, 9}));
}

TEST(NumberRange, names_each_mistake_once) {
  EXPECT_THAT(read("[1, 2, 3]").mistakes, ElementsAre("x needs two values"));
  EXPECT_THAT(read("[]").mistakes, ElementsAre("x needs two values"));
  EXPECT_THAT(read("[5, 2]").mistakes, ElementsAre("x is empty"));
  EXPECT_EQ(read("12").mistakes.size(), 1u);
  EXPECT_EQ(read("[5, \"a\"]").mistakes.size(), 1u);
  EXPECT_EQ(read("[\"a\", 5]").mistakes.size(), 1u);
}

}  // namespace
}  // namespace pomona
