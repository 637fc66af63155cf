// A sketch: an SVG, its views, and all its named curves.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "generator/base/error.h"
#include "generator/template/read/sketch.h"
#include "generator/template/read/sketch_fault.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

/// Calls `ask`, which may throw that the sketch is wrong.
template <typename Ask>
void ask(const Ask& asked) {
  try {
    asked();
  } catch (const pomona::BadSketch&) {
  }
}

/// Reads all that templates can read, for the first names.
void ask_all(const pomona::Sketch& sketch) {
  using pomona::SketchView;
  std::vector<std::string> names;
  for (const pomona::SvgElement& element : sketch.drawing().elements) {
    for (const std::string& name : {element.label, element.id})
      if (!name.empty() && names.size() < 16) names.push_back(name);
  }
  for (const SketchView view : {SketchView::side, SketchView::top}) {
    for (const std::string& name : names) {
      ask([&] { sketch.curve(view, name, 4096); });
      ask([&] { sketch.group(view, name, 4096); });
    }
  }
  for (const std::string& name : names) ask([&] { sketch.page_points(name, 9); });
  for (const int folds : {1, 5}) ask([&] { sketch.fold_angles(folds); });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] {
    try {
      ask_all(pomona::Sketch(pomona::parse_svg(bytes, "fuzz.svg"), 1e-3));
    } catch (const pomona::BadSketch& bad) {
      throw pomona::Error(pomona::ExitStatus::bad_data, {pomona::placed_fault(bad, "fuzz.svg")});
    }
  });
}
