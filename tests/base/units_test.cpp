#include "generator/base/units.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(Units, lengths_carry_their_unit) {
  EXPECT_DOUBLE_EQ(*parse_length("4mm"), 0.004);
  EXPECT_DOUBLE_EQ(*parse_length("5cm"), 0.05);
  EXPECT_DOUBLE_EQ(*parse_length("0.05m"), 0.05);
  EXPECT_DOUBLE_EQ(*parse_length("0.05"), 0.05);
  EXPECT_DOUBLE_EQ(*parse_length("-1.5e1 mm"), -0.015);
}

TEST(Units, what_is_no_length_is_nothing) {
  for (const char* text : {"", "mm", "4 miles", "4mmm", "nan", "inf", "1e999m", "0x10mm", " 4mm", "4,5mm"}) {
    EXPECT_FALSE(parse_length(text)) << text;
  }
}

TEST(Units, numbers_fill_the_whole_text) {
  EXPECT_EQ(*parse_number("+2.5"), 2.5);
  EXPECT_EQ(*parse_number("-1e-3"), -1e-3);
  for (const char* text : {"", "+", "2.5x", "--1", "1 2", "infinity"}) EXPECT_FALSE(parse_number(text)) << text;
}

}  // namespace
}  // namespace pomona
