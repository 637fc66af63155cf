#include "render/export/gltf/engine_names.h"

#include <algorithm>

namespace pomona::gltf {

std::string engine_name(Engine engine, const std::string& name) {
  std::string result = name;
  if (engine != Engine::any) std::replace(result.begin(), result.end(), '.', '_');
  return result;
}

std::string level_name(Engine engine, const std::string& name, std::size_t level, std::size_t count) {
  const bool numbers_all = (engine == Engine::unreal || engine == Engine::unity) && count > 1;
  return level > 0 || numbers_all ? name + "_LOD" + std::to_string(level) : name;
}

std::string hull_name(Engine engine, const std::string& name) {
  switch (engine) {
    case Engine::godot:
      return name + "-convcolonly";
    case Engine::unreal:
      return "UCX_" + name + "_00";
    default:
      return {};
  }
}

}  // namespace pomona::gltf
