// The section as PLY has the documented header, and the bytes that it announces.
#include "generator/cut/section/section_file.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(SectionFile, HoldsWhatTheFormatSays) {
  CrossSection section;
  section.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  section.color = {{1, 0, 0}, {0, 0.5f, 0}, {0, 0, 0.25f}};
  section.interior = {0, 1, 0};
  section.part = {0, 1, 0};
  section.triangle = {{0, 1, 2}};
  section.cut = {7};
  section.part_names = {"skin", "two\nlines"};
  section.surface_names = {"outer skin"};
  const std::string file = write_section(section);

  const std::size_t body = file.find("end_header\n") + 11;
  const std::string header = file.substr(0, body);
  EXPECT_THAT(header, testing::StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(header,
              testing::HasSubstr("comment surface 0 outer skin\ncomment part 0 skin\ncomment part 1 two lines\n"));
  EXPECT_THAT(header, testing::HasSubstr("element vertex 3\n"));
  EXPECT_THAT(header, testing::HasSubstr("property uchar interior\nproperty int part\nelement face 1\n"));

  constexpr std::size_t vertex = 12 + 3 + 12 + 1 + 4, face = 1 + 12 + 4;
  ASSERT_EQ(file.size(), body + 3 * vertex + face);
  float green = 0;
  std::memcpy(&green, file.data() + body + vertex + 15 + 4, 4);
  EXPECT_EQ(green, 0.5f);
  EXPECT_EQ(file[body + vertex + 27], 1);
  EXPECT_EQ(file[body + 3 * vertex], 3);
  EXPECT_EQ(file[body + 3 * vertex + 13], 7);
}

}  // namespace
}  // namespace pomona
