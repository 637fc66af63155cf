#include "generator/piece/piece_origin.h"

#include <array>
#include <charconv>
#include <filesystem>

#include "generator/base/shell_words.h"

namespace pomona {

namespace {

/// The shortest decimals that read back as the same number.
std::string number_text(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

/// What is as the program has it by itself is left out.
std::string variant_words(const PieceOrigin& origin) {
  const GrowOptions& how = origin.growing;
  const auto& [seed, index] = origin.key;
  std::string words;

  // Seed 0 without an index is the drawing; with one it is a variant like any other.
  const bool is_plain_drawing = how.as_drawn && seed == 0 && index == 0;
  if (!is_plain_drawing) {
    words += " --seed " + std::to_string(seed);
    if (index != 0 || seed == 0) words += " --index " + std::to_string(index);
    if (how.as_drawn) words += " --as-drawn";
  }
  if (how.variation != GrowOptions{}.variation) words += " --variation " + number_text(how.variation);
  if (how.curves_only) words += " --curves-only";
  if (how.folds) words += " --folds " + std::to_string(*how.folds);
  if (how.ripeness) words += " --ripeness " + number_text(*how.ripeness);
  if (how.scale != GrowOptions{}.scale) words += " --scale " + number_text(how.scale);
  if (how.detail != GrowOptions{}.detail) words += " --detail " + number_text(how.detail);
  return words;
}

std::string cut_words(const PieceOrigin& origin) {
  std::string words;
  for (const std::string& knife : origin.knives) words += " --knife " + shell_word(knife);
  if (origin.growing.browning > 0) words += " --browning " + number_text(origin.growing.browning);
  if (origin.coarse) words += " --faces coarse";
  return words;
}

}  // namespace

std::string source_word(const std::string& name_or_path) {
  const std::filesystem::path path = name_or_path;
  return path.is_absolute() ? path.filename().string() : name_or_path;
}

std::string knives_text(const PieceOrigin& origin) {
  std::string text;
  for (const std::string& knife : origin.knives) text += (text.empty() ? "" : " ") + knife;
  return text;
}

std::string command_for(const PieceOrigin& origin, const std::string& file, const std::string& further) {
  if (origin.source.empty() || origin.number == 0) return {};
  const bool is_cut = !origin.knives.empty();
  std::string line = std::string("pomona ") + (is_cut ? "cut " : "grow ") + shell_word(origin.source);
  line += variant_words(origin);
  if (is_cut) line += cut_words(origin);
  if (origin.pieces > 1) line += " --piece " + std::to_string(origin.number);
  return line + further + " -o " + shell_word(file);
}

}  // namespace pomona
