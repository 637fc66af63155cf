#include "bench/walk_truth_store.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "bench/timing.h"
#include "generator/diffusion/walk/walk_on_spheres.h"
#include "render/export/output.h"

namespace pomona::bench {

namespace {

constexpr std::size_t points_at_once = 256;

/// FNV-1a, to tell whether a kept file still belongs to the same surfaces and points.
class Fingerprint {
 public:
  template <typename Value>
  void add(std::span<const Value> values) {
    const auto* byte = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size_bytes(); ++i) hash_ = (hash_ ^ byte[i]) * 0x100000001b3;
  }

  std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
    return digits;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

Fingerprint fingerprint_of(const DiffusionSurfaces& surfaces, double standard_error) {
  Fingerprint print;
  print.add(std::span(surfaces.position));
  print.add(std::span(surfaces.front_color));
  print.add(std::span(surfaces.back_color));
  print.add(std::span(surfaces.triangle));
  print.add(std::span<const double>(&standard_error, 1));
  return print;
}

/// The content of a file, if it belongs to the same surfaces and points.
std::optional<WalkTruth> kept(const std::filesystem::path& file, const std::string& fingerprint) {
  std::ifstream stream(file);
  const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object() || json.value("fingerprint", "") != fingerprint) return std::nullopt;

  WalkTruth piece;
  for (const auto& color : json.at("color")) piece.color.emplace_back(color.at(0), color.at(1), color.at(2));
  piece.standard_error = json.at("standard_error").get<std::vector<double>>();
  piece.seconds = json.at("seconds");
  return piece;
}

void keep(const std::filesystem::path& file, const std::string& fingerprint, const WalkTruth& piece) {
  nlohmann::ordered_json json = {{"fingerprint", fingerprint}, {"seconds", piece.seconds}};
  for (const Color& color : piece.color) json["color"].push_back({color.x, color.y, color.z});
  json["standard_error"] = piece.standard_error;
  write_whole(file, json.dump());
}

WalkTruth walked(const WalkOnSpheres& walks, std::span<const glm::vec3> points) {
  WalkTruth piece;
  const Duration time = time_of([&] {
    const WalkResult result = walks.at(points);
    piece.color = result.color;
    piece.standard_error.assign(result.standard_error.begin(), result.standard_error.end());
  });
  piece.seconds = time.wall / 1000;
  return piece;
}

}  // namespace

WalkTruth walk_truth(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points,
                     const WalkTruthOptions& options) {
  std::filesystem::create_directories(options.folder);
  WalkOptions how;
  how.standard_error = options.standard_error;
  how.threads = options.threads;
  const WalkOnSpheres walks(surfaces, how);
  const Fingerprint question = fingerprint_of(surfaces, options.standard_error);
  WalkTruth truth;
  for (std::size_t first = 0; first < points.size(); first += points_at_once) {
    const auto some = points.subspan(first, std::min(points_at_once, points.size() - first));
    Fingerprint print = question;
    print.add(some);
    const std::filesystem::path file = options.folder / (std::to_string(first / points_at_once) + ".json");

    std::optional<WalkTruth> piece = kept(file, print.text());
    if (!piece) {
      piece = walked(walks, some);
      keep(file, print.text(), *piece);
    }
    truth.color.insert(truth.color.end(), piece->color.begin(), piece->color.end());
    truth.standard_error.insert(truth.standard_error.end(), piece->standard_error.begin(), piece->standard_error.end());
    truth.seconds += piece->seconds;
    if (options.progress) options.progress(truth.color.size(), points.size());
  }
  return truth;
}

}  // namespace pomona::bench
