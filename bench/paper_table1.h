// Table 1 as the paper prints it (a laptop of 2010), for the columns beside ours.
#pragma once

#include <optional>
#include <string>

namespace pomona::bench {

struct PaperRow {
  const char* name;
  const char* type;
  double cut_seconds;
  int vertices, faces, kilobytes;
};

/// The paper's row for a template of ours; nothing for models that the paper does not have.
std::optional<PaperRow> paper_row(const std::string& template_name);

}  // namespace pomona::bench
