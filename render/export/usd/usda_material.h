// Materials of a USD file.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "render/export/pbr_look.h"
#include "render/export/usd/usda_text.h"

namespace pomona::usd {

/// All pieces of a fruit share its looks: a class prim for each, which pieces refer to.
class Looks {
 public:
  /// The name of the class for one of the solid's groups: "tomato_skin".
  std::string name_for(const Solid& solid, const LookGroup& group);

  /// The class prims: UsdPreviewSurface, coloured by displayColor.
  std::string text() const { return text_; }

 private:
  PrimNames names_;
  std::map<std::tuple<std::string, float, PbrLook>, std::string> known_;
  std::string text_;
};

}  // namespace pomona::usd
