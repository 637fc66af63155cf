// What all pages have in common: the text of one, with everything it needs inside.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/page/page_options.h"

namespace pomona {

struct PageText {
  struct Packed {
    std::string kind;   ///< "asset" or "scene"
    std::string id;     ///< of its element
    std::string bytes;  ///< become text of 85 digits
  };
  std::string title = {}, latin = {};
  std::string about = {};  ///< for screen readers; what keys do follows it
  std::vector<Packed> packed = {};
  std::string_view script = "fruit_script.js";  ///< the one that begins
};

std::string page_text(const PageText& page, const PageOptions& options);

}  // namespace pomona
