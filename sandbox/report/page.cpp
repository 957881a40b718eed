#include "sandbox/report/page.h"

#include <stdexcept>

#include "sandbox/report/page_files.h"

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

std::string_view page_file(std::string_view name) {
  for (const PageFile& file : page_files())
    if (file.name == name) return file.text;
  throw std::logic_error("the report's page names " + std::string(name) + ", which is not embedded");
}

/// Replaces every {{NAME}} of the page by the file of that name, or by what is made here.
std::string filled(std::string_view page, std::string_view data, std::string_view pictures) {
  std::string text;
  for (size_t from = 0;;) {
    const size_t begin = page.find("{{", from), end = page.find("}}", begin);
    text += page.substr(from, begin - from);
    if (begin == std::string_view::npos) return text;
    const std::string_view name = page.substr(begin + 2, end - begin - 2);
    text += name == "data" ? data : name == "pictures" ? pictures : page_file(name);
    from = end + 2;
  }
}

}  // namespace

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

std::string assemble_page(std::string_view name, const json& data, std::string_view pictures) {
  return filled(page_file(name), script_json(data), pictures);
}

}  // namespace plume
