// One file out of a page of sandbox/report/page/, what it names, and data.
#ifndef PLUME_REPORT_PAGE_H
#define PLUME_REPORT_PAGE_H

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace plume {

/// The page with every {{NAME}} replaced by the file of that name, {{data}} by `data` and {{pictures}} by
/// `pictures`. Throws std::logic_error where a name is not embedded.
std::string assemble_page(std::string_view name, const nlohmann::json& data, std::string_view pictures);

/// Text as the value of an attribute.
std::string attribute(std::string_view text);

}  // namespace plume
#endif
