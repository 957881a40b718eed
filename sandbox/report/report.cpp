#include "sandbox/report/report.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <tuple>

#include "renderer/methods/methods.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/measure/pass_groups.h"
#include "sandbox/report/page_files.h"
#include "sandbox/report/pictures.h"

namespace plume {
namespace {

using nlohmann::json;

/// JSON that may stand in a <script>: a `<` in a string could end it.
std::string script_json(const json& value) {
  std::string text;
  for (const char c : value.dump(-1, ' ', false, json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

/// An attribute's value; names of scenes are whatever a file is called.
std::string attribute(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

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

/// Pictures before error maps, and the first of each moment before the second of any: where room is short it
/// is the maps that are left out, and no moment goes without.
std::vector<std::string> picture_files(const Results& results) {
  using Moment = std::tuple<std::string, uint32_t, uint32_t, uint32_t, uint32_t, uint32_t>;
  std::map<Moment, size_t> met;
  std::multimap<size_t, const FrameResult*> in_turn;
  for (const FrameResult& f : results.frames)
    in_turn.insert({met[{f.scene, f.tick, f.shot, f.width, f.height, f.seed}]++, &f});
  std::vector<std::string> files;
  std::set<std::string> known{""};
  for (const auto member : {&FrameResult::image, &FrameResult::error_map})
    for (const auto& [turn, frame] : in_turn)
      if (known.insert(frame->*member).second) files.push_back(frame->*member);
  return files;
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

std::string_view page_file(std::string_view name) {
  for (const PageFile& file : page_files())
    if (file.name == name) return file.text;
  throw std::logic_error("the report's page names " + std::string(name) + ", which is not embedded");
}

/// Replaces every {{NAME}} of the page by the file of that name, or by what is made here.
std::string filled(std::string_view page, const std::string& data, const std::string& pictures) {
  std::string text;
  for (size_t from = 0;;) {
    const size_t begin = page.find("{{", from), end = page.find("}}", begin);
    text += page.substr(from, begin - from);
    if (begin == std::string_view::npos) return text;
    const std::string_view name = page.substr(begin + 2, end - begin - 2);
    text += name == "data"       ? std::string_view(data)
            : name == "pictures" ? std::string_view(pictures)
                                 : page_file(name);
    from = end + 2;
  }
}

}  // namespace

void write_report(const std::filesystem::path& path, const Results& results, uint64_t most_bytes) {
  uint64_t fixed = script_json(page_data(results, {})).size();
  for (const PageFile& file : page_files()) fixed += file.text.size();
  const std::vector<std::string> files = picture_files(results);
  for (const std::string& file : files) fixed += file.size() + 64;  // its element
  const PagePictures pictures =
      page_pictures(path.parent_path(), files, most_bytes > fixed ? most_bytes - fixed : 0);
  const std::string page =
      filled(page_file("page.html"), script_json(page_data(results, pictures)), picture_elements(pictures));
  write_file(path, {reinterpret_cast<const uint8_t*>(page.data()), page.size()});
}

}  // namespace plume
