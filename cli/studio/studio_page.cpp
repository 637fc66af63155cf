#include "cli/studio/studio_page.h"

#include <string_view>

#include "cli/options/find_style.h"
#include "cli/studio/studio_files.h"
#include "generator/base/error.h"
#include "generator/base/marked_text.h"
#include "generator/base/xml_text.h"
#include "render/page/page.h"

namespace pomona {

namespace {

std::string studio_text(std::string_view name) {
  for (const EmbeddedFile& file : studio_files()) {
    if (file.name == name) return std::string(file.text);
  }
  throw Error(ExitStatus::bug, "the studio has no file " + std::string(name));
}

}  // namespace

StudioPage studio_page(const std::string& title, const std::string& token, const std::string& nonce) {
  return {
      filled(studio_text("studio.html"),
             {{"@NONCE@", nonce},
              {"@TITLE@", xml_escaped(title)},
              {"@TOKEN@", token},
              {"@STYLE@", studio_text("studio.css")},
              {"@OPTIONS@", page_options({.style = find_style("ink"), .cuts = {}, .made_by = {}})},
              {"@WORKER@", studio_text("unpack_script.js")},
              {"@SCRIPT@", studio_text("studio_script.js")}}),
      "default-src 'none'; script-src 'nonce-" + nonce + "'; style-src 'nonce-" + nonce +
          "'; img-src 'self' data: blob:; connect-src 'self'; worker-src blob:; base-uri 'none'; form-action 'none'; "
          "frame-ancestors 'none'"};
}

}  // namespace pomona
