// An SVG file as a plain list of its elements: where each stands in the file, what it is called, where it lies on
// the page. What it means to a template is sketch.h's business.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/text/svg_aspect.h"
#include "generator/text/svg_transform.h"

namespace pomona {

/// A fault of a sketch, and what to redraw; the place is part of the message.
struct BadSketch : std::runtime_error {
  BadSketch(const std::string& message, std::string remedy) : std::runtime_error(message), hint(std::move(remedy)) {}
  std::string hint;
};

struct SvgElement {
  std::string tag;    ///< "g", "path", "image", ...
  std::string id;     ///< id of XML
  std::string label;  ///< label in Inkscape's Layers and Objects; in other editors' files the name behind the id
  int line = 0, column = 0;
  std::size_t end = 0;               ///< the elements from the next one up to this index (not included) lie in this one
  bool drawn = true;                 ///< false in <defs>, <symbol> and the like
  std::string fault;                 ///< why its place on the page is unknown; else empty
  SvgTransform around;               ///< from the coordinates around it to the page's
  SvgTransform to_page;              ///< from its own coordinates to the page's
  std::optional<std::string> d;      ///< the path data of a path or of a basic shape
  std::optional<glm::dvec2> center;  ///< centre of a circle, ellipse or rectangle
  std::string href;                  ///< link of an image or a clone (<use>)
  glm::dvec2 position{0}, size{0};   ///< position and size of an image or a clone
  SvgAspect aspect;                  ///< of an image
};

struct SvgDrawing {
  std::string file;                  ///< for messages
  std::vector<SvgElement> elements;  ///< in the order of the file; hidden layers too
  std::optional<double> page_unit;   ///< metres of one unit of the page, if the file states a real size
};

/// Reads an SVG file. Nothing in it is executed or fetched, and no entity is expanded.
/// \throws BadSketch for what is not SVG, or beyond 64 MiB, 200 000 elements or 64 groups within each other.
SvgDrawing parse_svg(std::string_view text, const std::string& file);

/// "kiwi.svg:12:5"
std::string place_of(const SvgDrawing& drawing, const SvgElement& element);

}  // namespace pomona
