// How a fruit's plain colours come to look: Perlin modulation and texture detail in one function, which pictures,
// baked textures and exports all call.
#pragma once

#include <vector>

#include "generator/cut/detail_guide.h"
#include "generator/template/detail_sketch.h"
#include "render/style/noise.h"

namespace pomona {

/// A place of a fruit at which a colour is looked at.
struct LookPlace {
  glm::dvec3 position{0};             ///< in the fruit's own frame, metres
  double footprint = 0;               ///< size of a pixel or texel there, metres; 0 for a point
  DetailFace face = DetailFace::cut;  ///< a cut face, or what faces air
  DetailGuide guide = {};             ///< Solid::guide or CrossSection::guide there; as it is where there is none
};

/// A template's noise and details made ready for many colours.
class Look {
 public:
  Look() : Look(NoiseStyle{}) {}
  Look(const NoiseStyle& noise, const std::vector<DetailSketch>& details = {});

  /// The colour as it looks: every weight goes by the unmodulated colour. Where neither noise nor a detail has any
  /// effect it returns as it came, bit for bit. Two cuts of a fruit agree where they meet.
  Color operator()(const Color& unmodulated, const LookPlace& place) const;

  /// Whether it leaves all colours alone.
  bool is_plain() const { return modulation_.bands() == 0 && details_.empty(); }
  const Modulation& modulation() const { return modulation_; }

 private:
  Modulation modulation_;
  std::vector<DetailSketch> details_;
};

}  // namespace pomona
