#include "render/page/page_text.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/marked_text.h"
#include "generator/base/xml_text.h"
#include "render/gl/embedded_shaders.h"
#include "render/page/page_files.h"

namespace pomona {

namespace {

using nlohmann::ordered_json;

std::string_view text_of(std::span<const EmbeddedFile> files, std::string_view name) {
  for (const EmbeddedFile& file : files) {
    if (file.name == name) return file.text;
  }
  throw Error(ExitStatus::bug, "a page has no file " + std::string(name));
}

/// A shader or a script without indentation and comment lines, which only readers of the sources need.
std::string code_of(std::string_view text) {
  std::string code;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t first = line.find_first_not_of(" \n");
    if (first == std::string_view::npos || line.substr(first, 2) == "//") continue;
    code += line.substr(first);
  }
  return code;
}

/// Adds a shader of the page, or one of pictures, with all that it includes: so noise, detail and light are the same.
void add_shader(ordered_json& all, const std::string& name) {
  if (all.contains(name)) return;
  const bool own = std::ranges::any_of(page_files(), [&](const EmbeddedFile& file) { return file.name == name; });
  const std::string code = code_of(text_of(own ? page_files() : embedded_shaders(), name));
  all[name] = code;
  constexpr std::string_view include = "#include \"";
  for (std::size_t at = code.find(include); at != std::string::npos; at = code.find(include, at)) {
    at += include.size();
    add_shader(all, code.substr(at, code.find('"', at) - at));
  }
}

ordered_json shaders() {
  ordered_json all;
  for (const char* name : {"look.glsl", "section.glsl", "skin.glsl", "ground.glsl", "cut_away.glsl"})
    add_shader(all, name);
  return all;
}

ordered_json style_of(const Style& style) {
  return {{"noise", style.noise},
          {"lines", style.ink},
          {"ink", style.ink_color ? ordered_json(to_hex(*style.ink_color)) : ordered_json(nullptr)},
          {"outline", style.outline_width},
          {"inner", style.inner_width},
          {"inner_opacity", style.inner_opacity},
          {"paper", to_hex(style.paper)},
          {"grain", style.grain},
          {"saturation", style.saturation},
          {"lightness", style.lightness},
          {"gloss", style.gloss},
          {"light",
           {{"azimuth", style.light.azimuth},
            {"elevation", style.light.elevation},
            {"strength", style.light.strength},
            {"ambient", style.light.ambient},
            {"occlusion", style.light.occlusion}}},
          {"shadow", {{"color", to_hex(style.shadow.color)}, {"strength", style.shadow.strength}}}};
}

ordered_json options_of(const PageOptions& options) {
  ordered_json cuts = ordered_json::array();
  for (const auto& [plane, knife, step] : options.cuts) {
    cuts.push_back({{"normal", {plane.normal.x, plane.normal.y, plane.normal.z}},
                    {"offset", plane.offset},
                    {"knife", knife},
                    {"step", step}});
  }
  return {{"style", style_of(options.style)}, {"cuts", cuts}, {"shaders", shaders()}};
}

/// Bytes as text, five characters for four bytes, the highest digit first; the last four are padded with 0. Digits are
/// the 85 characters from ( to ~ that mean nothing to HTML and to strings: without < and the backslash. A sixteenth
/// shorter than base 64.
std::string base85(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() / 4 * 5 + 5);
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    std::uint32_t four = 0;
    for (std::size_t k = i; k < i + 4; ++k)
      four = four << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    char five[5];
    for (int k = 4; k >= 0; --k, four /= 85) {
      const int digit = 40 + static_cast<int>(four % 85);
      five[k] = static_cast<char>(digit + (digit >= 60 ? 1 : 0) + (digit >= 91 ? 1 : 0));
    }
    text.append(five, 5);
  }
  return text;
}

}  // namespace

std::string page_options(const PageOptions& options) { return json_in_script(options_of(options)); }

std::string page_text(const PageText& page, const PageOptions& options) {
  std::string packed;
  for (const PageText::Packed& one : page.packed) {
    packed += "<script type=\"text/plain\" class=\"" + one.kind + "\" id=\"" + one.id + "\" data-length=\"" +
              std::to_string(one.bytes.size()) + "\">" + base85(one.bytes) + "</script>\n";
  }
  return filled(text_of(page_files(), "page.html"), {{"@TITLE@", xml_escaped(page.title)},
                                                     {"@LATIN@", xml_escaped(page.latin)},
                                                     {"@ABOUT@", xml_escaped(page.about)},
                                                     {"@MADE_BY@", xml_escaped(options.made_by)},
                                                     {"@STYLE@", std::string(text_of(page_files(), "page.css"))},
                                                     {"@OPTIONS@", page_options(options)},
                                                     {"@PACKED@", packed},
                                                     {"@WORKER@", code_of(text_of(page_files(), "worker_script.js"))},
                                                     {"@SCRIPT@", code_of(text_of(page_files(), page.script))}});
}

}  // namespace pomona
