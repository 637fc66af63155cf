// Errors as users read them.
#include <string>

#include <gtest/gtest.h>

#include "generator/base/error.h"

namespace pomona {
namespace {

TEST(Diagnostic, SaysWhereAsExactlyAsItIsKnown) {
  const auto told = [](const SourcePlace& place) { return to_string({place, "is odd", ""}); };
  EXPECT_EQ(told({}), "error: is odd");
  EXPECT_EQ(told({"a.toml", 0, 0, ""}), "a.toml: error: is odd") << "line 0 is the file as a whole";
  EXPECT_EQ(told({"a.toml", 1, 1, ""}), "a.toml:1:1: error: is odd") << "the first line is a line";
  EXPECT_EQ(told({"a.toml", 12, 9, ""}), "a.toml:12:9: error: is odd");
  EXPECT_EQ(told({"a.ply", 12, 9, "vertex 3, byte 45"}), "a.ply:vertex 3, byte 45: error: is odd");
  EXPECT_EQ(to_string({{"a.toml", 2, 3, ""}, "is odd", "make it even"}),
            "a.toml:2:3: error: is odd\n  hint: make it even");
}

TEST(Error, HoldsAllThatIsWrong) {
  const Error error(ExitStatus::bad_data, {{{"a", 1, 2, ""}, "one", ""}, {{"a", 3, 4, ""}, "two", ""}});
  EXPECT_EQ(error.what(), std::string("a:1:2: error: one\na:3:4: error: two"));
  EXPECT_EQ(error.diagnostics().size(), 2u);
}

}  // namespace
}  // namespace pomona
