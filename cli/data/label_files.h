// The labels of one picture for readers of other formats: BOP's poses, YOLO's boxes, the pieces' meshes.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "generator/data/data_plan.h"
#include "generator/scene/scene.h"
#include "render/export/named_file.h"

namespace pomona {

/// The class of an annotation of a piece, as an index into DataPlan::classes; -1 for what is no piece of fruit, or
/// shows fewer pixels than the set wants.
int class_index(const nlohmann::ordered_json& annotation, const std::string& species, const DataPlan& plan);

/// picture.txt, scene_camera.json, scene_gt.json and scene_gt_info.json, from a picture's annotations.json.
std::vector<NamedFile> label_files(const nlohmann::ordered_json& annotations, const DataPlan& plan);

/// obj_000001.ply, ... and models_info.json: the mesh of each annotated piece in millimetres, its origin at the centre
/// of mass, by the number of the annotation.
std::vector<NamedFile> model_files(const Scene& scene, const nlohmann::ordered_json& annotations);

}  // namespace pomona
