#include "generator/base/xml_text.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(XmlText, EscapesWhatWouldEndTextOrAnAttribute) {
  EXPECT_EQ(xml_escaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(xml_escaped("&amp;"), "&amp;amp;");
}

TEST(XmlText, LeavesOutWhatXmlCannotHold) {
  EXPECT_EQ(xml_escaped(std::string("a\0b\x1b"
                                    "c\nd",
                                    7)),
            "a b c d");
}

TEST(XmlText, HoldsUtf8Alone) {
  EXPECT_EQ(xml_escaped("a\xff"
                        "b\xc3"),
            "a\xef\xbf\xbd"
            "b\xef\xbf\xbd");
}

TEST(XmlText, KeepsOtherCharactersAsTheyAre) { EXPECT_EQ(xml_escaped("cœur d’ananas"), "cœur d’ananas"); }

}  // namespace
}  // namespace pomona
