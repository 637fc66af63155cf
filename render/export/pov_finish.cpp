#include "render/export/pov_finish.h"

#include <algorithm>
#include <cmath>

#include "generator/base/number_text.h"
#include "render/export/pov_text.h"

namespace pomona::pov {

namespace {

std::string three_digits(double value) { return number_text(std::round(1000 * value) / 1000); }

/// The parameters of subsurface light: how far each channel goes, in millimetres.
std::string subsurface_text(const Translucency& translucency) {
  if (!(translucency.depth > 0)) return {};
  std::string text = " #if (Subsurface) subsurface { translucency rgb <";
  for (int k = 0; k < 3; ++k) {
    const double millimetres = 1000 * translucency.depth * static_cast<double>(translucency.color[k]);
    text += (k > 0 ? ", " : "") + three_digits(std::max(millimetres, 0.02));
  }
  return text + "> } #end";
}

/// A highlight's width follows the square of the template's roughness; a narrow one is stronger.
std::string skin_text(const MaterialSketch& material, double gloss) {
  const double r = std::max(material.roughness, 0.02);
  const double specular = gloss * 0.22 * material.gloss * std::min(1.8, std::sqrt(0.3 / r));
  return "ambient 0.38 diffuse 0.75 specular " + three_digits(specular) + " roughness " +
         number_text(std::round(1e5 * 0.02 * r * r / 0.09) / 1e5);
}

std::string cut_text(const MaterialSketch& material, double gloss) {
  const double roughness = material.wet > 1 ? 0.05 / material.wet : 0.05;
  return "ambient 0.42 diffuse 0.72 specular " +
         three_digits(gloss * 0.06 * material.wet * std::max(1.0, material.wet)) + " roughness " +
         three_digits(roughness);
}

std::string finish_text(const MaterialSketch& material, bool on_cut_face, double gloss) {
  return "finish { " + (on_cut_face ? cut_text(material, gloss) : skin_text(material, gloss)) +
         subsurface_text(material.translucency) + " }";
}

}  // namespace

Finishes::Finishes(const Scene& scene, double gloss) : gloss_(gloss) {
  const auto add = [&](const MaterialSketch& material, bool on_cut_face) {
    const std::string text = finish_text(material, on_cut_face, gloss);
    const auto [entry, is_new] = number_.try_emplace(text, static_cast<int>(number_.size()));
    if (is_new) declarations_ += "#declare " + name(entry->second) + " = " + text + "\n";
  };
  add({}, false);
  add({}, true);
  for (const Solid& solid : scene.solids) {
    for (const MaterialSketch& material : solid.look->materials) add(material, false), add(material, true);
  }
}

int Finishes::number(const Solid& solid, std::int32_t part, bool on_cut_face) const {
  return number_.at(finish_text(material_of(solid, part), on_cut_face, gloss_));
}

std::string Finishes::name(int number) {
  return number == 0 ? "Skin" : number == 1 ? "Flesh" : "Finish_" + std::to_string(number);
}

bool is_translucent(const Solid& solid) {
  return std::any_of(solid.look->materials.begin(), solid.look->materials.end(),
                     [](const MaterialSketch& material) { return material.translucency.depth > 0; });
}

}  // namespace pomona::pov
