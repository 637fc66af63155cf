// Colours of texels: diffused at the texels' own points, then with the style's noise and paint.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/piece/section_colors.h"
#include "render/style/look.h"
#include "render/style/paint.h"
#include "render/texture/face_colors.h"
#include "render/texture/texels.h"

namespace pomona {

class SampleColors {
 public:
  /// Number of samples that are coloured at once: enough for many threads, and few enough to need little memory.
  static constexpr std::size_t at_once = 300'000;

  /// The source of the colours of cut faces. If both are null, the colours of vertices are interpolated.
  struct OfCutFaces {
    const FaceColors* faces = nullptr;  ///< diffused at some points
    const ColorField* field = nullptr;  ///< to be diffused at each sample
  };

  /// \param texel size, metres
  SampleColors(const Solid& solid, const Style& style, const OfCutFaces& of_cut_faces, double texel, Threads threads);

  /// The final linear colours, one per sample: styled() of plain().
  std::vector<Color> of(const std::vector<TexelSample>& samples) { return styled(samples, plain(samples)); }

  /// Before noise, details and paint.
  std::vector<Color> plain(const std::vector<TexelSample>& samples);
  std::vector<Color> styled(const std::vector<TexelSample>& samples, std::vector<Color> colors) const;

  const Look& look() const { return look_; }

  /// The mean of a chart that is smaller than a texel.
  Color mean_of(const Chart& chart) const;

  /// The number of samples diffused so far.
  std::size_t diffused() const { return diffused_; }

 private:
  LookPlace look_place(const TexelSample& sample) const;
  Color interpolated(const TexelSample& sample) const;
  void diffuse(const std::vector<TexelSample>& samples, const std::vector<glm::vec3>& points,
               std::vector<Color>& colors);

  const SolidMesh& mesh_;
  OfCutFaces of_cut_faces_;
  Look look_;
  Paint paint_;
  double texel_;
  Threads threads_;
  std::size_t diffused_ = 0;
};

}  // namespace pomona
