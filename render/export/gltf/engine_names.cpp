#include "render/export/gltf/engine_names.h"

#include <algorithm>

namespace pomona::gltf {

std::string engine_name(Engine engine, const std::string& name) {
  std::string result = name;
  if (engine != Engine::any && engine != Engine::blender) std::replace(result.begin(), result.end(), '.', '_');
  return result;
}

std::string level_name(Engine engine, const std::string& name, std::size_t level, std::size_t count) {
  const bool numbers_all = (engine == Engine::unreal || engine == Engine::unity) && count > 1;
  return level > 0 || numbers_all ? name + "_LOD" + std::to_string(level) : name;
}

std::string hull_name(Engine engine, const std::string& name, std::size_t part, std::size_t count) {
  const std::string number = std::string(part < 10 ? "_0" : "_") + std::to_string(part);
  switch (engine) {
    case Engine::godot:
      return name + (count > 1 ? number : "") + "-convcolonly";
    case Engine::unreal:
      return "UCX_" + name + number;
    default:
      return {};
  }
}

std::string triangles_name(Engine engine, const std::string& name) {
  return engine == Engine::godot ? name + "-colonly" : std::string();
}

}  // namespace pomona::gltf
