// The counts of [variation]: good.toml with more at its end.
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "tests/template/plum.h"

namespace pomona {
namespace {

TEST(ReadCounts, NothingVariesInNumberUnlessItIsSaid) {
  const CountVariation counts = plum_and("[variation]\nsize = 0.1\n").variation.counts;
  EXPECT_TRUE(counts.folds.empty());
  EXPECT_TRUE(counts.present.empty());
}

TEST(ReadCounts, TakesFoldsWithTheirSharesAndSurfacesByName) {
  const CountVariation counts =
      plum_and("[variation]\nfolds = [[2, 0.75], [3, 0.25]]\npresent = { stone = 0.5 }\n").variation.counts;
  ASSERT_EQ(counts.folds.size(), 2u);
  EXPECT_EQ(counts.folds[1].number, 3);
  EXPECT_EQ(counts.folds[1].share, 0.25);
  ASSERT_EQ(counts.present.size(), 1u);
  EXPECT_EQ(counts.present[0].surface, 1);
  EXPECT_EQ(counts.present[0].share, 0.5);
}

TEST(ReadCounts, MistakesAreFoundWhereTheyAre) {
  const Mistake mistakes[] = {
      {"[variation]\nfolds = [[2, 0.5], [3, 0.25]]\n", 2, 9, "do not add up to 1"},
      {"[variation]\nfolds = [[2, 0.5], 3]\n", 2, 20, "must be an array"},
      {"[variation]\nfolds = [[2, 0.5, 1]]\n", 2, 10, "a number of folds and its share"},
      {"[variation]\nfolds = [[65, 1]]\n", 2, 11, "65"},
      {"[variation]\nfolds = [[0, 1]]\n", 2, 11, "0"},
      {"[variation]\nfolds = [[2, nan]]\n", 2, 14, "nan"},
      {"[variation]\nfolds = 3\n", 2, 9, "must be"},
      {"[variation]\npresent = { pit = 0.5 }\n", 2, 19, "not the name of a surface"},
      {"[variation]\npresent = { stone = 1.5 }\n", 2, 21, "stone is 1.5"},
      {"[variation]\npresent = 0.5\n", 2, 11, "must be a table"},
  };
  expect_found(mistakes);
}

TEST(ReadCounts, ASurfaceThatIsMistypedIsSuggested) {
  try {
    plum_and("[variation]\npresent = { stnoe = 0.5 }\n");
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.diagnostics().front().hint, "did you mean \"stone\"?");
  }
}

}  // namespace
}  // namespace pomona
