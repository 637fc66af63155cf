#include "cli/studio/studio_page.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options/find_style.h"
#include "cli/studio/studio_files.h"
#include "generator/base/error.h"
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

std::string studio_scripts(std::initializer_list<std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += studio_text(name);
  return text;
}

/// `page` with each mark, "@NAME@", replaced. No text holds a mark that comes after its own.
std::string marked(std::string page, const std::vector<std::pair<std::string, std::string>>& marks) {
  for (const auto& [mark, text] : marks) {
    for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + text.size()))
      page.replace(at, mark.size(), text);
  }
  return page;
}

}  // namespace

StudioPage studio_page(const std::string& title, const std::string& token, const std::string& nonce) {
  const PageParts parts = page_parts({.style = find_style("ink"), .cuts = {}, .made_by = {}});
  const std::string scripts = studio_scripts(
      {"svg_text.js", "toml_tree.js", "toml_curves.js", "bezier.js", "drawing.js",    "history.js",   "server.js",
       "pictures.js", "pane.js",      "node_tool.js",   "places.js", "ramp.js",       "side_text.js", "brush.js",
       "ribbon.js",   "tools.js",     "paint.js",       "trace.js",  "fruit_view.js", "studio.js",    "panel.js"});
  return {
      marked(studio_text("studio.html"), {{"@NONCE@", nonce},
                                          {"@TITLE@", xml_escaped(title)},
                                          {"@TOKEN@", token},
                                          {"@STYLE@", studio_text("studio.css")},
                                          {"@OPTIONS@", parts.options},
                                          {"@WORKER@", parts.worker + studio_text("unpack.js")},
                                          {"@SCRIPT@", parts.picture + scripts}}),
      "default-src 'none'; script-src 'nonce-" + nonce + "'; style-src 'nonce-" + nonce +
          "'; img-src 'self' data: blob:; connect-src 'self'; worker-src blob:; base-uri 'none'; form-action 'none'; "
          "frame-ancestors 'none'"};
}

}  // namespace pomona
