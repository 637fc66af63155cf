#include "generator/scene/layout_file.h"

#include <array>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/json_text.h"
#include "generator/text/json_node.h"

namespace pomona {

namespace {

[[noreturn]] void fail(const SourcePlace& place, const std::string& message, const std::string& hint = {}) {
  throw Error(ExitStatus::bad_data, {{place, message, hint}});
}

std::string quoted(const std::string& text) { return json_text(nlohmann::json(text)); }

template <std::size_t count>
std::string listed(const std::array<double, count>& numbers) {
  return json_text(nlohmann::json(numbers));
}

std::string read_string(const JsonNode& node) {
  if (node.kind != JsonNode::Kind::string) fail(node.place(), "should be a string");
  return node.text;
}

template <std::size_t count>
std::array<double, count> read_numbers(const JsonNode& node) {
  if (node.kind != JsonNode::Kind::array || node.items.size() != count)
    fail(node.place(), "should be " + std::to_string(count) + " numbers");
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const JsonNode& item = node.items[i];
    if (item.kind != JsonNode::Kind::number || !(std::fabs(item.number) <= 1e6))
      fail(item.place(), "should be a number up to a million");
    numbers[i] = item.number;
  }
  return numbers;
}

Pose read_pose(const JsonNode& node) {
  const auto q = read_numbers<4>(node.need("rotation"));
  const auto t = read_numbers<3>(node.need("translation"));
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (std::fabs(length - 1) > 1e-4)
    fail(node.need("rotation").place(), "rotation is no unit quaternion", "write [w, x, y, z] of length 1");
  return {glm::dquat(q[0], q[1], q[2], q[3]), {t[0], t[1], t[2]}};
}

}  // namespace

std::string write_layout(const Scene& scene) {
  std::string text = "{\n  \"format\": 1,\n  \"instances\": [";
  const char* separator = "\n";
  for (const Instance& instance : scene.instances) {
    const glm::dquat& q = instance.pose.rotation;
    const glm::dvec3& t = instance.pose.translation;
    text += separator;
    text += "    {\"name\": " + quoted(instance.name);
    text += ", \"solid\": " + quoted(scene.solids[static_cast<std::size_t>(instance.solid)].name);
    text += ", \"rotation\": " + listed(std::array{q.w, q.x, q.y, q.z});
    text += ", \"translation\": " + listed(std::array{t.x, t.y, t.z}) + "}";
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

Layout parse_layout(std::string_view json, const std::string& file) {
  const JsonNode root = parse_json(json, file);
  const JsonNode& format = root.need("format");
  if (format.kind != JsonNode::Kind::number || format.number != 1) fail(format.place(), "format should be 1");
  const JsonNode& instances = root.need("instances");
  if (instances.kind != JsonNode::Kind::array) fail(instances.place(), "instances should be an array");

  Layout layout{instances.place(), {}};
  std::map<std::string, int> lines;
  for (const JsonNode& node : instances.items) {
    const std::string name = read_string(node.need("name"));
    const auto [known, is_new] = lines.try_emplace(name, node.place().line);
    if (!is_new)
      fail(node.need("name").place(),
           "\"" + name + "\" was placed in line " + std::to_string(known->second) + " already");
    layout.placements.push_back({name, read_string(node.need("solid")), read_pose(node), node.need("name").place()});
  }
  return layout;
}

Layout read_layout(const std::filesystem::path& file) {
  return parse_layout(file_bytes(file, max_json_bytes), file.string());
}

std::optional<Layout> layout_of(const SceneDescription& scene) {
  if (scene.layout.empty()) return {};
  try {
    return read_layout(std::filesystem::path(scene.file).parent_path() / scene.layout);
  } catch (const Error& error) {
    if (error.status() != ExitStatus::input_missing) throw;
    const Diagnostic& what = error.diagnostics().front();
    throw Error(error.status(),
                {{scene.layout_place, "layout \"" + scene.layout + "\": " + what.message,
                  "settle the scene without it, and write one: pomona scene " + scene.name + " -o FILE.json"}});
  }
}

std::vector<Pose> poses_for(const Layout& layout, const std::vector<Solid>& solids,
                            const std::vector<Instance>& instances) {
  const std::string hint = "the layout was written for another scene, seed or version; write it anew";
  std::map<std::string, const Layout::Placement*> by_name;
  for (const Layout::Placement& placement : layout.placements) by_name[placement.name] = &placement;
  std::vector<Pose> poses;
  for (const Instance& instance : instances) {
    const auto found = by_name.find(instance.name);
    if (found == by_name.end()) fail(layout.list, "\"" + instance.name + "\" has no place here", hint);
    const std::string& solid = solids[static_cast<std::size_t>(instance.solid)].name;
    if (found->second->solid != solid)
      fail(found->second->place, "\"" + instance.name + "\" is of solid \"" + solid + "\" in the scene", hint);
    poses.push_back(found->second->pose);
    by_name.erase(found);
  }

  // The first placement that is left over, in the order of the file.
  for (const Layout::Placement& placement : layout.placements)
    if (by_name.contains(placement.name)) fail(placement.place, "\"" + placement.name + "\" is not in the scene", hint);
  return poses;
}

}  // namespace pomona
