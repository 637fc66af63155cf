#include "generator/text/json_node.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"

namespace pomona {
namespace {

void expect_error(const std::string& json, const std::string& message) {
  try {
    parse_json(json, "x.json");
    ADD_FAILURE() << "was read: " << json.substr(0, 80);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    EXPECT_THAT(to_string(error.diagnostics().front()), testing::StartsWith(message));
  }
}

TEST(JsonNode, EveryValueKnowsWhereItStands) {
  const JsonNode root = parse_json("{\"a\": [1.5,\n  \"two\", true, null]}", "x.json");
  const JsonNode& list = root.need("a");
  ASSERT_EQ(list.kind, JsonNode::Kind::array);
  ASSERT_EQ(list.items.size(), 4u);
  EXPECT_EQ(list.items[0].number, 1.5);
  EXPECT_EQ(list.items[1].text, "two");
  EXPECT_EQ(list.items[2].kind, JsonNode::Kind::boolean);
  EXPECT_EQ(list.items[3].kind, JsonNode::Kind::null);
  EXPECT_EQ(list.items[0].line, 1);
  EXPECT_EQ(list.items[1].line, 2);
  EXPECT_EQ(list.items[1].column, 3);
  EXPECT_EQ(list.items[1].place().file, "x.json");
}

TEST(JsonNode, SaysWhereTheTextIsWrong) {
  expect_error("{\"format\": 1,\n \"instances\": [}", "x.json:2:16: error: this is not JSON");
  expect_error("{\"format\": 1, \"format\": 1}", "x.json:1:15: error: key \"format\" is there already");
  expect_error(std::string(100, '['), "x.json:1:33: error: nests deeper");
}

TEST(JsonNode, IsRefusedBeforeItFillsTheMemory) {
  std::string many = "{\"format\": 1, \"instances\": [";
  for (int i = 0; i < 1'500'000; ++i) many += "0,";
  expect_error(many + "0]}", "x.json:1:3000023: error: more than 1 500 000 values");
  std::string keys = "{\"format\": 1";
  for (int i = 0; i < 1000; ++i) keys += ",\"" + std::to_string(i) + "\": 0";
  expect_error(keys + "}", "x.json:1:8895: error: an object with more than 1000 keys");
}

}  // namespace
}  // namespace pomona
