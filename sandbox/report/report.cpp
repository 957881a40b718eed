#include "sandbox/report/report.h"

#include <fmt/format.h>

#include "renderer/methods/methods.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/measure/pass_groups.h"
#include "sandbox/report/page.h"
#include "sandbox/report/pictures.h"

namespace plume {
namespace {

using nlohmann::json;

/// What is known of the methods and passes that appear.
json methods_of(const Results& results) {
  json methods = json::object();
  for (const FrameResult& frame : results.frames)
    if (const auto method = make_method(frame.method)) {
      const Traits traits = method->traits();
      methods[frame.method] = {{"title", traits.title}, {"source", traits.source}, {"limits", traits.limits}};
    }
  return methods;
}

json passes_of(const Results& results) {
  json passes = json::object();
  for (const FrameResult& frame : results.frames)
    for (const PassSummary& pass : frame.passes) {
      const auto group = group_of(pass.name);
      passes[pass.name] = {{"group", group ? json(kPassGroupNames.at(size_t(*group))) : json(nullptr)},
                           {"common", is_common(pass.name)}};
    }
  return passes;
}

/// Six digits of every number, which is what eyes can use; results.json has the others.
void round_numbers(json& value) {
  if (value.is_structured())
    for (json& part : value) round_numbers(part);
  else if (value.is_number_float())
    value = std::stod(fmt::format("{:.6g}", value.get<double>()));
}

/// results.json without what the page does not show.
json shown_results(const Results& results) {
  json shown = to_json(results);
  for (json& frame : shown["frames"]) {
    for (const char* name : {"settings", "statistics"}) frame.erase(name);
    for (json& pass : frame["passes"])
      pass = {{"name", pass["name"]}, {"median_ms", pass["median_ms"]}, {"samples", pass["samples"]}};
  }
  round_numbers(shown);
  return shown;
}

/// What the page reads: results.json, and what that cannot know.
json page_data(const Results& results, const PagePictures& pictures) {
  json changed = json::array();
  for (const FrameResult& frame : results.frames) changed.push_back(changed_settings(frame));
  return {{"results", shown_results(results)},
          {"changed_settings", changed},
          {"methods", methods_of(results)},
          {"passes", passes_of(results)},
          {"pictures",
           {{"count", pictures.all.size()},
            {"bytes", pictures.bytes()},
            {"divisor", pictures.divisor},
            {"format", pictures.divisor == 1 ? "png" : "webp"},
            {"left_out", pictures.left_out}}}};
}

/// One element each, which nothing reads before it is looked at.
std::string picture_elements(const PagePictures& pictures) {
  std::string text;
  text.reserve(pictures.bytes() + pictures.all.size() * 128);
  for (const PagePicture& picture : pictures.all)
    if (!picture.base64.empty()) {
      text += "<script type=\"text/plain\" data-picture=\"" + attribute(picture.file) + "\">";
      text += picture.base64;
      text += "</script>\n";
    }
  return text;
}

}  // namespace

void write_report(const std::filesystem::path& path, const Results& results, uint64_t most_bytes) {
  const std::vector<std::string> files = picture_files(results);
  uint64_t fixed = assemble_page("page.html", page_data(results, {}), "").size();
  for (const std::string& file : files) fixed += file.size() + 64;  // its element
  const PagePictures pictures =
      page_pictures(path.parent_path(), files, most_bytes > fixed ? most_bytes - fixed : 0);
  const std::string page =
      assemble_page("page.html", page_data(results, pictures), picture_elements(pictures));
  write_file(path, page);
}

}  // namespace plume
