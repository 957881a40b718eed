// One self-contained HTML page about a run: the table, and per frame the pictures with their error maps.
#ifndef PLUME_MEASURE_REPORT_H
#define PLUME_MEASURE_REPORT_H

#include <filesystem>

#include "sandbox/measure/results.h"

namespace plume {

/// Embeds the images that stand beside `path`. Throws FileError when the page cannot be written.
void write_report(const std::filesystem::path& path, const Results& results);

}  // namespace plume
#endif
