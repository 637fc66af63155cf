// The table of knives: each entry is read as the kind that it names, and help, hints and documents name all kinds.
#include "generator/knife/knife_kinds.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/knife/parse_knife.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// "plane:NX,NY,NZ,D" as a user might fill it in.
std::string filled_in(std::string written) {
  const std::vector<std::pair<std::string, std::string>> values = {
      {"NX,NY,NZ,D", "1,2,0,3cm"}, {":N", ":6"}, {"=X,Y,Z", "=0,1,0"}, {"FILE.svg#id", "knives.svg#line"}};
  for (const auto& [word, value] : values) {
    const std::size_t at = written.find(word);
    if (at != std::string::npos) written.replace(at, word.size(), value);
  }
  return written;
}

class KnifeKinds : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.path() / "knives.svg")
        << R"(<svg xmlns="http://www.w3.org/2000/svg"><path id="line" d="M 4,-20 L 9,-25 4,-30"/></svg>)";
  }

  Knife parsed(const std::string& text) const { return parse_knife(text, folder_.path()); }

  std::string hint_for(const std::string& text) const {
    try {
      parsed(text);
    } catch (const Error& error) {
      return error.diagnostics().at(0).hint;
    }
    ADD_FAILURE() << text << " is accepted";
    return {};
  }

  const TemporaryFolder folder_;
};

/// A knife's kind, as its index in the two families.
std::pair<std::size_t, std::size_t> kind_of(const Knife& knife) {
  return {knife.cut.index(), std::visit([](const auto& cut) { return cut.index(); }, knife.cut)};
}

TEST_F(KnifeKinds, EachIsReadAsItIsWrittenWithEveryOption) {
  for (const KnifeKind& kind : knife_kinds()) {
    for (const std::string& written : kind.written) {
      std::string text = filled_in(written);
      SCOPED_TRACE(text);
      EXPECT_THAT(text, StartsWith(kind.name));
      const Knife plain = parsed(text);
      EXPECT_EQ(plain.text, text);
      for (const std::string& option : kind.options) text += "," + filled_in(option);
      EXPECT_EQ(kind_of(parsed(text)), kind_of(plain));
    }
  }
}

TEST_F(KnifeKinds, TellTheDrawingThatTheirTextNames) {
  EXPECT_EQ(drawing_of_knife("stroke:cut #2.svg#wave,scale=2mm"), "cut #2.svg");
  EXPECT_EQ(drawing_of_knife("revolve:a,b.svg#line"), "a,b.svg");
  EXPECT_EQ(drawing_of_knife("half"), std::nullopt);
  EXPECT_EQ(drawing_of_knife("slices:4mm"), std::nullopt);
}

TEST_F(KnifeKinds, AreAllThereAreAndNoTwoTheSame) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const KnifeKind& kind : knife_kinds()) found.push_back(kind_of(parsed(filled_in(kind.written[0]))));
  std::sort(found.begin(), found.end());
  EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());

  // All alternatives but SurfaceKnife, which nobody can write.
  EXPECT_EQ(found.size(), std::variant_size_v<PlaneCut> + std::variant_size_v<ClosedCut> - 1);
}

TEST_F(KnifeKinds, HoldWhatTheirWordsSay) {
  const auto slices = std::get<SliceKnife>(std::get<PlaneCut>(parsed("slices:8").cut));
  EXPECT_EQ(std::get<SliceCount>(slices.size).count, 8);
  EXPECT_EQ(slices.axis, 1);
  EXPECT_EQ(std::get<SliceKnife>(std::get<PlaneCut>(parsed("slices:4mm,along=x").cut)).axis, 0);
  const auto sticks = std::get<StickKnife>(std::get<PlaneCut>(parsed("sticks:6mm").cut));
  EXPECT_DOUBLE_EQ(std::get<SliceThickness>(sticks.size).metres, 0.006);
  EXPECT_EQ(std::get<WedgeKnife>(std::get<PlaneCut>(parsed("wedges:7").cut)).count, 7);
  EXPECT_DOUBLE_EQ(std::get<CrinkleKnife>(std::get<PlaneCut>(parsed("crinkle:8mm").cut)).thickness, 0.008);

  const auto core = std::get<CoreKnife>(std::get<ClosedCut>(parsed("core:18mm,depth=4cm,axis=0,0,2").cut));
  EXPECT_DOUBLE_EQ(core.diameter, 0.018);
  EXPECT_DOUBLE_EQ(core.depth.value(), 0.04);
  EXPECT_EQ(core.axis, glm::dvec3(0, 0, 1));
  EXPECT_FALSE(core.at);
  const auto ball = std::get<BallKnife>(std::get<ClosedCut>(parsed("ball:24mm,at=1cm,2cm,-3mm").cut));
  EXPECT_NEAR(glm::distance(ball.at.value(), {0.01, 0.02, -0.003}), 0, 1e-15);
  const auto peel = std::get<PeelKnife>(std::get<ClosedCut>(parsed("peel:2mm,spiral=15mm").cut));
  EXPECT_DOUBLE_EQ(peel.strip.value(), 0.015);
  const auto revolve =
      std::get<RevolveKnife>(std::get<ClosedCut>(parsed("revolve:knives.svg#line,scale=2mm,at=0,0,1cm").cut));
  EXPECT_NEAR(revolve.profile.points.at(1).x, 0.018, 1e-9);
  EXPECT_NEAR(glm::distance(revolve.at.value(), {0, 0, 0.01}), 0, 1e-15);
}

TEST_F(KnifeKinds, AreClosedExactlyIfTheyCutAlongAClosedSurface) {
  std::vector<std::string> closed;
  for (const KnifeKind& kind : knife_kinds()) {
    if (parsed(filled_in(kind.written[0])).is_closed()) closed.push_back(kind.name);
  }
  EXPECT_THAT(closed, ElementsAre("ball", "core", "bite", "revolve", "peel"));
}

TEST_F(KnifeKinds, WhatIsMistypedIsToldWhatWasMeant) {
  EXPECT_THAT(hint_for("slises:4mm"), StartsWith("did you mean \"slices:4mm\"? a knife is one of: half, across, "));
  EXPECT_THAT(hint_for("bal:24mm"), StartsWith("did you mean \"ball:24mm\"?"));
  EXPECT_THAT(hint_for("chainsaw"), StartsWith("a knife is one of: half, across, "));
  EXPECT_EQ(hint_for("core:18mm,size=3mm"), "it has at=X,Y,Z, axis=X,Y,Z and depth=4cm");
  EXPECT_EQ(hint_for("peel:2mm,at=0,0,0"), "it has spiral=15mm");
  EXPECT_EQ(hint_for("slices:4mm,across=x"), "it has along=x");
}

TEST_F(KnifeKinds, HaveALineOfHelpEach) {
  std::istringstream help(knife_help());
  std::vector<std::string> lines;
  for (std::string line; std::getline(help, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), knife_kinds().size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const KnifeKind& kind = knife_kinds()[i];
    for (const std::string& written : kind.written) EXPECT_THAT(lines[i], HasSubstr(written));
    for (const std::string& option : kind.options) EXPECT_THAT(lines[i], HasSubstr("," + option));
    EXPECT_THAT(lines[i], HasSubstr("  " + kind.help));
    EXPECT_LE(lines[i].size(), 140u);
    EXPECT_THAT(known_knives(), HasSubstr(kind.written.back()));
  }
}

/// The names in the first column of the table that begins with this line: "`slices:4mm`, `slices:8`" is slices.
std::vector<std::string> names_in_table(const std::string& document, const std::string& first_line) {
  std::ifstream file(std::filesystem::path(POMONA_SOURCE_DIR) / "docs" / document);
  std::string line;
  while (std::getline(file, line) && line != first_line) {
  }
  std::getline(file, line);  // the rule below the head
  std::vector<std::string> names;
  while (std::getline(file, line) && line.starts_with("| ")) {
    const std::string cell = line.substr(0, line.find(" | "));
    for (std::size_t at = cell.find('`'); at != std::string::npos; at = cell.find('`', cell.find('`', at + 1) + 1)) {
      const std::size_t end = cell.find_first_of(":`", at + 1);
      const std::string name = cell.substr(at + 1, end - at - 1);
      if (names.empty() || names.back() != name) names.push_back(name);
    }
  }
  return names;
}

TEST_F(KnifeKinds, AreThoseOfTheDocument) {
  std::vector<std::string> names;
  for (const KnifeKind& kind : knife_kinds()) names.push_back(kind.name);
  EXPECT_EQ(names_in_table("reference/commands.md", "| KNIFE | cuts along |"), names);
}

}  // namespace
}  // namespace pomona
