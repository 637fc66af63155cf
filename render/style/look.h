// Perlin modulation and texture detail in one function, for pictures, baked textures and exports.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "generator/cut/section/detail_guide.h"
#include "generator/template/detail_sketch.h"
#include "render/style/detail.h"
#include "render/style/noise.h"

namespace pomona {

/// A place of a fruit whose colour is wanted.
struct LookPlace {
  glm::dvec3 position{0};             ///< in the fruit's own frame, metres
  double footprint = 0;               ///< size of a pixel or texel there, metres; 0 for a point
  DetailFace face = DetailFace::cut;  ///< whether the place is on a cut face or on a skin
  DetailGuide guide = {};             ///< Solid::guide or CrossSection::guide there, else the default
};

/// A template's noise and details, prepared for many colours.
class Look {
 public:
  Look() : Look(NoiseStyle{}) {}
  /// \param like a Look whose equal patterns are reused, because pieces of one fruit have the same ones.
  Look(const NoiseStyle& noise, const std::vector<DetailSketch>& details = {}, const Look* like = nullptr);

  /// The colour with noise, then examples and then the other details in their order, each with the weight
  /// w = amount guide.share exp(-|OKLab(unmodulated) - OKLab(near)|^2 / 2 near_within^2); examples act as
  /// with_example() says (example.h); a pattern of share s and tone t moves the colour by s w towards the detail's
  /// colour, or by s w axis, and by t |w| tone_step in lightness. Without any effect the colour returns bit for bit.
  /// Two cuts of a fruit agree where they meet.
  Color operator()(const Color& unmodulated, const LookPlace& place) const;

  /// The same at many places, several times as fast: a thousand at a time fit the processor's caches.
  std::vector<Color> operator()(std::span<const Color> unmodulated, std::span<const LookPlace> places) const;

  /// How high the details stand out at a place, and how far that lies below their mean: the sum over them of
  ///   relief guide.share exp(-|OKLab(unmodulated) - OKLab(near)|^2 / 2 near_within^2) s
  /// with s the pattern's share there; patterns too fine for the footprint have their mean height.
  struct Height {
    double height = 0;  ///< height along the normal, metres
    double below = 0;   ///< how far it lies below the mean of each pattern, relative to that pattern's size
  };
  Height height(const Color& unmodulated, const LookPlace& place) const;

  /// The same at many places, several times as fast.
  std::vector<Height> height(std::span<const Color> unmodulated, std::span<const LookPlace> places) const;

  /// Whether any detail of faces of this kind has a relief.
  bool has_relief(DetailFace face) const;

  /// Whether it changes no colour.
  bool is_plain() const;
  const Modulation& modulation() const { return modulation_; }

  /// A detail as the formula and the GPU need it, in the order of DetailGuide::share.
  struct Detail {
    Pattern pattern;
    glm::dvec3 target{0};  ///< its colour in OKLab, else the axis
    glm::dvec3 near{0};    ///< OKLab
  };
  const std::vector<Detail>& details(DetailFace face) const { return details_[static_cast<std::size_t>(face)]; }

  static constexpr double tone_step = 0.12;  ///< step of OKLab lightness for a tone of 1

 private:
  Modulation modulation_;
  std::array<std::vector<Detail>, 2> details_;  ///< details for each kind of face
};

}  // namespace pomona
