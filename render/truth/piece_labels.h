// The labels of a piece in annotations: its state, where it came from, and its pose before the camera.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "generator/scene/scene.h"
#include "render/strokes/lens.h"

namespace pomona {

/// "state", "peeled", "seed", "index", "knives", ...: nothing for what was not cut from a fruit.
nlohmann::ordered_json state_labels(const Solid& solid);

/// "cam_R_m2c" and "cam_t_m2c" of the BOP benchmark: from the mesh of a .glb, which has its origin at the centre of
/// mass, to the camera's frame; a rotation row by row, and millimetres.
nlohmann::ordered_json camera_pose(const Instance& instance, const Solid& solid, const Lens& lens);

}  // namespace pomona
