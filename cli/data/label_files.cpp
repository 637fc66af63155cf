#include "cli/data/label_files.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"
#include "generator/mesh/box.h"
#include "generator/piece/piece_facts.h"
#include "render/export/ply.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;
constexpr double millimetres = 1000;

std::string species_of(const Json& annotations, const Json& annotation) {
  return annotations["categories"][annotation["category_id"].get<std::size_t>() - 1]["name"];
}

/// A line for each piece: its class, and the middle and size of its box as shares of the picture.
std::string yolo_lines(const Json& annotations, const DataPlan& plan) {
  const double width = annotations["images"][0]["width"], height = annotations["images"][0]["height"];
  std::string lines;
  for (const Json& piece : annotations["annotations"]) {
    const int index = class_index(piece, species_of(annotations, piece), plan);
    if (index < 0) continue;
    const std::array<double, 4> box = piece["bbox"];
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "%d %.6f %.6f %.6f %.6f\n", index, (box[0] + 0.5 * box[2]) / width,
                  (box[1] + 0.5 * box[3]) / height, box[2] / width, box[3] / height);
    lines += line.data();
  }
  return lines;
}

/// The matrix of the camera. BOP's pixels have their middles at whole numbers, Pomona's at halves.
Json camera_of(const Json& image) {
  const Json& camera = image["camera"];
  const double focal = camera["focal_length"], x = camera["principal_point"][0], y = camera["principal_point"][1];
  const std::array<double, 3> eye = camera["eye"];
  Json rotation = Json::array(), translation = Json::array();
  for (const char* axis : {"right", "down", "forward"}) {
    const std::array<double, 3> along = camera[axis];
    for (const double part : along) rotation.push_back(part);
    translation.push_back(-millimetres * (along[0] * eye[0] + along[1] * eye[1] + along[2] * eye[2]));
  }
  return {{"cam_K", {focal, 0, x - 0.5, 0, focal, y - 0.5, 0, 0, 1}},
          {"depth_scale", millimetres * image["metres_per_depth_step"].get<double>()},
          {"cam_R_w2c", rotation},
          {"cam_t_w2c", translation}};
}

NamedFile of_image_0(const char* name, const Json& value) { return {name, json_text(Json{{"0", value}}) + "\n"}; }

}  // namespace

int class_index(const Json& annotation, const std::string& species, const DataPlan& plan) {
  if (!annotation.contains("state") || annotation["area"].get<int>() < plan.data.least_area) return -1;
  const std::string name = class_of(plan.data.classes, species, annotation["state"].get<std::string>());
  const auto found = std::find(plan.classes.begin(), plan.classes.end(), name);
  return found == plan.classes.end() ? -1 : static_cast<int>(found - plan.classes.begin());
}

std::vector<NamedFile> label_files(const Json& annotations, const DataPlan& plan) {
  Json poses = Json::array(), infos = Json::array();
  for (const Json& piece : annotations["annotations"]) {
    if (!piece.contains("state")) continue;
    poses.push_back({{"cam_R_m2c", piece["cam_R_m2c"]}, {"cam_t_m2c", piece["cam_t_m2c"]}, {"obj_id", piece["id"]}});
    infos.push_back({{"bbox_obj", piece["amodal_bbox"]},
                     {"bbox_visib", piece["bbox"]},
                     {"px_count_all", piece["amodal_area"]},
                     {"px_count_visib", piece["area"]},
                     {"visib_fract", 1 - piece["occlusion"].get<double>()}});
  }
  return {{"picture.txt", yolo_lines(annotations, plan)},
          of_image_0("scene_camera.json", camera_of(annotations["images"][0])),
          of_image_0("scene_gt.json", poses),
          of_image_0("scene_gt_info.json", infos)};
}

std::vector<NamedFile> model_files(const Scene& scene, const Json& annotations) {
  std::vector<NamedFile> files;
  Json infos = Json::object();
  for (const Json& piece : annotations["annotations"]) {
    if (!piece.contains("state")) continue;
    const auto id = piece["id"].get<int>();
    const Instance& instance = scene.instances[static_cast<std::size_t>(id - 1)];
    Scene model;
    model.solids.push_back(scene.solids[static_cast<std::size_t>(instance.solid)]);
    const glm::dvec3 middle = facts_of(model.solids[0]).center;
    Box<double> box;
    for (glm::vec3& place : model.solids[0].mesh.position) {
      place = glm::vec3(millimetres * (glm::dvec3(place) - middle));
      box.add(glm::dvec3(place));
    }
    model.instances.push_back({0, {}, instance.name});
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "obj_%06d.ply", id);
    files.push_back({name.data(), write_solids(model)});
    const glm::dvec3 size = box.size();
    infos[std::to_string(id)] = {{"diameter", glm::length(size)},
                                 {"min_x", box.low.x},
                                 {"min_y", box.low.y},
                                 {"min_z", box.low.z},
                                 {"size_x", size.x},
                                 {"size_y", size.y},
                                 {"size_z", size.z}};
  }
  files.push_back({"models_info.json", json_text(infos) + "\n"});
  return files;
}

}  // namespace pomona
