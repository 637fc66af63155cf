#include "generator/diffusion/harmonic/node_runs.h"

namespace pomona {

NodeRuns make_node_runs(const Node& count, const std::vector<std::uint8_t>& wanted) {
  NodeRuns runs;
  runs.count = count;
  runs.blocks = (count[0] + NodeRuns::length - 1) / NodeRuns::length;
  runs.place.assign(wanted.size(), NodeRuns::none);
  std::size_t place = 0;
  for (int z = 0; z < count[2]; ++z) {
    runs.first_of_plane.push_back(static_cast<std::uint32_t>(runs.run.size()));
    for (int y = 0; y < count[1]; ++y) {
      for (int block = 0; block < runs.blocks; ++block, ++place) {
        if (wanted[place] == 0) continue;
        runs.place[place] = static_cast<std::int32_t>(runs.run.size());
        runs.run.push_back({block, y, z});
      }
    }
  }
  runs.first_of_plane.push_back(static_cast<std::uint32_t>(runs.run.size()));
  return runs;
}

NodeRuns all_node_runs(const Node& count) {
  const int blocks = (count[0] + NodeRuns::length - 1) / NodeRuns::length;
  const auto places = static_cast<std::size_t>(blocks) * static_cast<std::size_t>(count[1] * count[2]);
  return make_node_runs(count, std::vector<std::uint8_t>(places, 1));
}

std::vector<std::pair<std::size_t, std::size_t>> ranges_of_planes(const NodeRuns& runs, std::size_t parts) {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  std::size_t first = 0;
  for (std::size_t plane = 1; plane < runs.first_of_plane.size(); ++plane) {
    const std::size_t end = runs.first_of_plane[plane];
    const bool is_last = plane + 1 == runs.first_of_plane.size();
    if (end == first || (!is_last && (end - first) * parts < runs.run.size())) continue;
    ranges.emplace_back(first, end);
    first = end;
  }
  return ranges;
}

}  // namespace pomona
