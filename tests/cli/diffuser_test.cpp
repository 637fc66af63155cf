// --diffuser for users: the device in --stats, and the errors without OpenGL.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_pomona.h"

namespace pomona::testing {
namespace {

using ::testing::HasSubstr;

/// Sets an environment variable for programs started during its lifetime.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Environment() { unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
};

/// A coarse section, with --stats in stats.json.
Outcome cut_with(const std::string& diffuser, const TemporaryFolder& folder) {
  return run_pomona({"cut", "tomato", "--knife", "half", "--section", "--detail", "0.4", "--quality", "draft",
                     "--quiet", "--diffuser", diffuser, "--stats", "stats.json", "-o", "x.ply"},
                    folder.path());
}

nlohmann::json stats_in(const TemporaryFolder& folder) {
  return nlohmann::json::parse(bytes_of(folder / "stats.json"));
}

TEST(Diffuser, GlIsNamedWithItsRenderer) {
  for (const char* route : {"device", "surfaceless", "osmesa"}) {
    const Environment wanted("POMONA_GL", route);
    const TemporaryFolder folder;
    const Outcome outcome = cut_with("gl", folder);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(stats_in(folder).at("diffuser"), "gl");
    EXPECT_NE(stats_in(folder).at("device"), "cpu");
    EXPECT_FALSE(std::string(stats_in(folder).at("device")).empty());
  }
}

TEST(Diffuser, AutoIsTheCpuWhereThereIsNoGraphicsCard) {
  const Environment software("POMONA_GL", "surfaceless");
  const TemporaryFolder by_auto, by_cpu;
  ASSERT_EQ(cut_with("auto", by_auto).status, 0);
  ASSERT_EQ(cut_with("cpu", by_cpu).status, 0);
  EXPECT_EQ(stats_in(by_auto).at("diffuser"), "cpu");
  EXPECT_EQ(bytes_of(by_auto / "x.ply"), bytes_of(by_cpu / "x.ply"));
}

TEST(Diffuser, AWrongRouteIsAWrongCommandLine) {
  const Environment wrong("POMONA_GL", "glide");
  const TemporaryFolder folder;
  const Outcome outcome = cut_with("gl", folder);
  EXPECT_EQ(outcome.status, 64);
  EXPECT_THAT(outcome.err, HasSubstr("glide"));
}

TEST(Diffuser, MissingOpenGlIsTold) {
  // No driver for EGL; OSMesa needs none.
  const Environment no_driver("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere");
  for (const char* route : {"device", "surfaceless"}) {
    const Environment wanted("POMONA_GL", route);
    const TemporaryFolder folder;
    const Outcome outcome = cut_with("gl", folder);
    EXPECT_EQ(outcome.status, 69) << route;
    EXPECT_THAT(outcome.err, HasSubstr("EGL")) << route;
  }
  const TemporaryFolder folder;
  EXPECT_EQ(cut_with("auto", folder).status, 0);
}

TEST(Diffuser, OldOpenGlIsTold) {
  // Mesa reads this variable.
  const Environment old("MESA_GL_VERSION_OVERRIDE", "3.3");
  const TemporaryFolder folder;
  const Outcome outcome = cut_with("gl", folder);
  EXPECT_EQ(outcome.status, 69);
  EXPECT_THAT(outcome.err, HasSubstr("4.5"));
  EXPECT_EQ(cut_with("auto", folder).status, 0);
}

}  // namespace
}  // namespace pomona::testing
