#include "tests/template/plum.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/template/read/read_template.h"

namespace pomona {

namespace {

std::string good_text() {
  std::ifstream stream(std::filesystem::path(POMONA_SOURCE_DIR) / "tests/template/good.toml", std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

Template plum_and(const std::string& more) { return parse_template(good_text() + more, "plum.toml"); }

void expect_found(std::span<const Mistake> mistakes) {
  const std::string good = good_text();
  const auto lines = static_cast<int>(std::count(good.begin(), good.end(), '\n'));
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(mistake.text);
    try {
      plum_and(mistake.text);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_data);
      const Diagnostic& first = error.diagnostics().front();
      EXPECT_EQ(first.place.line - lines, mistake.line) << error.what();
      EXPECT_EQ(first.place.column, mistake.column) << error.what();
      EXPECT_THAT(first.message, testing::HasSubstr(mistake.message));
    }
  }
}

}  // namespace pomona
