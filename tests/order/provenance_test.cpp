#include "render/deliver/provenance.h"

#include <gtest/gtest.h>

#include "generator/base/version.h"

namespace pomona {
namespace {

TEST(Provenance, NamesEverySeed) {
  const std::string program = std::string("pomona ") + version;
  EXPECT_EQ(made_by({}), program + ", seed 0");
  EXPECT_EQ(made_by({{7}}), program + ", seed 7");
  EXPECT_EQ(made_by({{1, 2}}), program + ", seeds 1-2");
  EXPECT_EQ(made_by({{0, 2, 7}}), program + ", seeds 0,2,7");
  EXPECT_EQ(provenance_of({.seed = 3}).seeds, (std::vector<std::uint64_t>{3}));
  EXPECT_EQ(provenance_of({.seeds = {1, 4}}).seeds, (std::vector<std::uint64_t>{1, 4}));
}

}  // namespace
}  // namespace pomona
