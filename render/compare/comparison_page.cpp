#include "render/compare/comparison_page.h"

#include <algorithm>
#include <cstdio>

#include "generator/base/base64.h"
#include "generator/base/xml_text.h"
#include "render/compare/heat_map.h"

namespace pomona {

namespace {

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #222; background: #f7f3eb; margin: 2em }
h1 { font-size: 1.3em; margin: 0 0 .2em }
.verdict { color: #a11; margin: 0 0 1.2em; padding: 0; list-style: none }
.verdict.same { color: #275d2a }
.row { display: flex; flex-wrap: wrap; gap: 1.5em }
figure { margin: 0 }
figcaption { margin-bottom: .4em; color: #555 }
img { display: block; image-rendering: pixelated; border: 1px solid #ccc; background: #fff }
.blink { position: relative }
.blink img + img { position: absolute; left: 0; top: 0; opacity: 0 }
.blink:hover img + img { opacity: 1 }
table { border-collapse: collapse; margin-top: 1.5em }
td, th { padding: .15em 1.2em .15em 0; text-align: left; font-weight: normal }
th { color: #777 }
)";

/// Small pictures are shown enlarged by a whole number.
std::string img(const Image& image) {
  const int scale = std::clamp(480 / std::max({1, image.width, image.height}), 1, 8);
  return "<img width=\"" + std::to_string(image.width * scale) + "\" alt=\"\" src=\"data:image/png;base64," +
         base64(write_png(image)) + "\">";
}

std::string figure(const std::string& caption, const std::string& content) {
  return "<figure><figcaption>" + xml_escaped(caption) + "</figcaption>" + content + "</figure>\n";
}

template <typename... Values>
std::string row(const char* name, const char* format, Values... values) {
  char cells[200];
  std::snprintf(cells, sizeof cells, format, values...);
  return std::string("<tr><td>") + name + "</td>" + cells + "</tr>\n";
}

std::string figures(const Comparison& found, const Tolerance& allowed) {
  const double percent = 100 / std::max(1.0, static_cast<double>(found.map.error.size()));
  std::string rows = "<table><tr><th></th><th>found</th><th>allowed</th></tr>\n";
  rows += row("mean FLIP", "<td>%.6f</td><td>%g</td>", found.flip, allowed.flip);
  rows += row("largest difference of a channel", "<td>%d of 255</td><td>%d</td>", found.largest,
              std::max(allowed.usual, allowed.never));
  const std::string beyond = "pixels that differ by more than " + std::to_string(allowed.usual) + " of 255";
  rows += row(beyond.c_str(), "<td>%.3f %%</td><td>%.3f %%</td>", percent * static_cast<double>(found.beyond),
              100 * allowed.exceptions);
  rows += row("pixels that differ at all", "<td>%.3f %%</td><td></td>", percent * static_cast<double>(found.different));
  return rows + "</table>\n";
}

std::string verdict(const Comparison& found) {
  if (found.same) return "<p class=\"verdict same\">They count as the same.</p>\n";
  std::string list = "<ul class=\"verdict\">\n";
  for (const std::string& reason : found.reasons) list += "<li>" + xml_escaped(reason) + "</li>\n";
  return list + "</ul>\n";
}

}  // namespace

std::string comparison_page(const ComparedPictures& pictures, const Comparison& comparison,
                            const Tolerance& tolerance) {
  const std::string reference = img(laid_on_white(pictures.reference)), result = img(laid_on_white(pictures.result));
  std::string page = "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>" +
                     xml_escaped(pictures.title) + "</title>\n<style>" + style + "</style>\n<h1>" +
                     xml_escaped(pictures.title) + "</h1>\n" + verdict(comparison) + "<div class=\"row\">\n";
  page += figure("reference: " + pictures.reference_name, reference);
  page += figure("result: " + pictures.result_name + " (the pointer over it shows the reference)",
                 "<div class=\"blink\">" + result + reference + "</div>");
  if (!comparison.map.error.empty()) page += figure("FLIP: black = the same", img(heat_map(comparison.map)));
  page += "</div>\n";
  if (!comparison.map.error.empty()) page += figures(comparison, tolerance);
  return page + "</html>\n";
}

}  // namespace pomona
