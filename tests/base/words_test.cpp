// Files are read up to the allowed length, and nearly correct names are recognised.
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "generator/base/first_bytes.h"
#include "generator/base/nearest_name.h"

namespace pomona {
namespace {

TEST(FirstBytes, AreAsManyAsAskedForOrAsThereAre) {
  std::string all;
  for (int i = 0; i < 200000; ++i) all += static_cast<char>('a' + i % 23);
  for (const std::size_t max : {0u, 1u, 100u, 65535u, 65536u, 65537u, 150000u, 200000u, 300000u}) {
    std::istringstream stream(all);
    EXPECT_EQ(first_bytes(stream, max), all.substr(0, max)) << max;
  }
}

TEST(NearestName, IsOfWordsOfUpTo64Letters) {
  const std::string longest(64, 'x'), known = longest + "y";
  EXPECT_EQ(nearest_name(longest, {known}), known);
  EXPECT_EQ(nearest_name(longest + "z", {known}), std::nullopt);
}

TEST(NearestName, IsNoFartherThanAThirdOfTheWord) {
  EXPECT_EQ(nearest_name("tmoato", {"potato", "tomato"}), "tomato") << "letters that change places are one mistake";
  EXPECT_EQ(nearest_name("abcdef", {"abcdxy"}), "abcdxy");
  EXPECT_EQ(nearest_name("abcdef", {"abcxyz"}), std::nullopt);
  EXPECT_EQ(nearest_name("abcdef", {"abcdefgh"}), "abcdefgh") << "letters that are missing";
  EXPECT_EQ(nearest_name("abcdef", {"abcdefghi"}), std::nullopt);
  EXPECT_EQ(nearest_name("abcdefgh", {"bcdefg"}), "bcdefg") << "letters too many";
  EXPECT_EQ(nearest_name("abcdefgh", {"bcde"}), std::nullopt);
  EXPECT_EQ(nearest_name("a", {"b"}), "b");
  EXPECT_EQ(nearest_name("HALF", {"bite", "half"}), "half") << "capitals are no mistakes";
  EXPECT_EQ(nearest_name("halve", {"bite", "half"}), "half") << "two letters of five";
  EXPECT_EQ(nearest_name("first", {"firsts", "fists"}), "firsts") << "the first of those that are as near";
  EXPECT_EQ(nearest_name("parst", {"part", "parts"}), "parts") << "of those that are as near, the one as long";
  EXPECT_EQ(nearest_name("parst", {"parts", "part"}), "parts");
}

TEST(NameHint, IsTheNearestOrAll) {
  EXPECT_EQ(name_hint("skni", {"stone", "skin"}), "did you mean \"skin\"?");
  EXPECT_EQ(name_hint("leaf", {"stone", "skin", "stone"}), "known here: skin, stone");
  EXPECT_EQ(name_hint("leaf", {}), "");
}

}  // namespace
}  // namespace pomona
