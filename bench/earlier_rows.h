// Long reports can be resumed: rows that are in their file already are not measured again.
#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

namespace pomona::bench {

/// The rows of a report as it was last written; none if there is no file.
/// \throws Error (bad data) if it is no report.
std::vector<nlohmann::ordered_json> earlier_rows(const std::filesystem::path& report);

}  // namespace pomona::bench
