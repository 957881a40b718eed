// What report.html is put together from, embedded when the program is built: sandbox/report/page/ and
// Chart.js.
#ifndef PLUME_REPORT_PAGE_FILES_H
#define PLUME_REPORT_PAGE_FILES_H

#include <span>
#include <string_view>

namespace plume {

struct PageFile {
  std::string_view name, text;
};
std::span<const PageFile> page_files();

}  // namespace plume
#endif
