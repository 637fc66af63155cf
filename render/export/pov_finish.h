// Materials as POV-Ray's finishes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/scene/scene.h"

namespace pomona::pov {

/// The finishes of a scene: "Skin" and "Flesh", and one more for each different material on skins and on cut faces.
class Finishes {
 public:
  /// \param gloss factor of the shine of all materials
  Finishes(const Scene& scene, double gloss);

  /// The index of the finish of a part on the skin or on a cut face: 0 is Skin, 1 is Flesh.
  int number(const Solid& solid, std::int32_t part, bool on_cut_face) const;
  /// "Skin", "Flesh", "Finish_2" ...
  static std::string name(int number);
  /// All as #declare statements. Subsurface light is in them where the scene's `Subsurface` is not 0.
  const std::string& declarations() const { return declarations_; }

 private:
  double gloss_;
  std::map<std::string, int> number_;  // index of each finish by its text
  std::string declarations_;
};

/// Whether light goes into any part of it.
bool is_translucent(const Solid& solid);

}  // namespace pomona::pov
