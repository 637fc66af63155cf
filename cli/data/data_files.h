// The files that tell of a whole data set: COCO's annotations and YOLO's lists of each part, and what Croissant says.
#pragma once

#include "cli/batch/workplace.h"

namespace pomona {

/// True for the batch.json of a data set.
bool is_data_record(const std::string& record);

/// Writes train.json, train.txt and their like, data.yaml, classes.txt, statistics.json and croissant.json. Every
/// picture is there. Memory does not grow with their number. \param record the folder's batch.json.
void write_data_files(Workplace& workplace, const std::string& record);

}  // namespace pomona
