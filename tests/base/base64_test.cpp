#include "generator/base/base64.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(Base64, WritesTheVectorsOfRfc4648AndReadsThemBack) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(base64_decoded(text), bytes);
  }
}

TEST(Base64, KeepsEveryByte) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  EXPECT_EQ(base64_decoded(base64(bytes)), bytes);
}

TEST(Base64, PassesOverWhiteSpaceAndNeedsNoPaddingAndRefusesWhatItIsNot) {
  EXPECT_EQ(base64_decoded(" Zm9v\nYm\tFy\r\n"), "foobar");
  EXPECT_EQ(base64_decoded("Zm8"), "fo");
  EXPECT_FALSE(base64_decoded("Zm9v*"));
  EXPECT_FALSE(base64_decoded("Zm-_"));
}

}  // namespace
}  // namespace pomona
