// The text of a page, with everything that it needs inside.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/page/page_options.h"

namespace pomona {

struct PageText {
  struct Packed {
    std::string kind;   ///< "asset" or "scene"
    std::string id;     ///< id of its element
    std::string bytes;  ///< content, to be written in 85 digits
  };
  std::string title = {}, latin = {};
  std::string about = {};  ///< text for screen readers; the keys follow it
  std::vector<Packed> packed = {};
  std::string_view script = "fruit_script.js";  ///< the script that starts the page
};

std::string page_text(const PageText& page, const PageOptions& options);

}  // namespace pomona
