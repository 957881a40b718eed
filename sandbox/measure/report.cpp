#include "sandbox/measure/report.h"

#include <fmt/format.h>

#include <cmath>

#include "sandbox/measure/file_bytes.h"

namespace plume {
namespace {

constexpr std::string_view kStyle = R"(
body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:84rem;padding:0 1rem;color:#222;background:#fafafa}
h1{margin-bottom:.2rem}h2{margin-top:2.2rem}
table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .8rem;text-align:right;border-bottom:1px solid #ddd}
th:first-child,td:first-child,th:last-child,td:last-child{text-align:left}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(26rem,1fr));gap:1.2rem}
figure{margin:0}img{width:100%;display:block;border-radius:3px}
figcaption{padding:.3rem 0;color:#444}.note{color:#666}code{background:#eee;padding:0 .25em}
)";

std::string escape(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string base64(const std::vector<uint8_t>& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < left ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += k <= left ? kDigits[(word >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

/// Every name and value of an object in one line.
std::string one_line(const nlohmann::json& object, std::string_view equals, std::string_view separator) {
  std::string text;
  for (const auto& [name, value] : object.items())
    text += fmt::format("{}{}{}{}", text.empty() ? "" : separator, name, equals,
                        value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

std::string settings_text(const nlohmann::json& settings) {
  return one_line(settings, "=", ", ");
}

std::string left_out_text(const FrameResult& frame) {
  std::string text;
  for (const std::string& output : frame.left_out) text += fmt::format("no {}; ", output);
  return text;
}

std::string row(const FrameResult& frame) {
  std::string cells = fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>", escape(frame.scene), frame.tick,
                                  escape(frame.method));
  if (frame.status != "ok" || !frame.error)
    return cells + fmt::format("<td colspan=7>{}</td><td>{}</td></tr>\n", escape(frame.status),
                               escape(settings_text(changed_settings(frame))));
  const ErrorSummary& e = *frame.error;
  return cells + fmt::format(
                     "<td>{:.5f}</td><td>{}</td><td>{:.4f}</td><td>{:.4f}</td><td>{:.2f}</td><td>{:.2f}</td>"
                     "<td>{:.2f}</td><td>{}</td></tr>\n",
                     e.rmse, std::isfinite(e.psnr_db) ? fmt::format("{:.2f}", e.psnr_db) : "∞", e.ssim,
                     e.flip, frame.gpu_ms, frame.transparency_ms, double(frame.memory_bytes) / 1048576.0,
                     escape(left_out_text(frame) + settings_text(changed_settings(frame))));
}

std::string picture(const std::filesystem::path& folder, const std::string& file,
                    const std::string& caption) {
  if (file.empty() || !std::filesystem::exists(folder / file))
    return "";  // kept by --resume, its picture gone
  return fmt::format(
      "<figure><img alt=\"{}\" src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
      escape(caption), base64(read_file(folder / file)), escape(caption));
}

std::string passes_text(const FrameResult& frame) {
  std::string text;
  for (const PassSummary& pass : frame.passes)
    text += fmt::format("{}{} {:.2f}", text.empty() ? "" : " · ", pass.name, pass.ms.median);
  return text;
}

}  // namespace

void write_report(const std::filesystem::path& path, const Results& results) {
  std::string page = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Plume "
      "comparison</title><style>{}</style>\n"
      "<h1>What accuracy costs in time</h1>\n<p class=\"note\">{}</p>\n"
      "<p>Every method drew the same particles on the same frame. RMSE is over linear light against the "
      "exact reference; "
      "PSNR, SSIM and FLIP (67 pixels per degree) are over the displayed image. Lower RMSE and FLIP are "
      "better. GPU time is the "
      "median of the sum of all passes; own are the method's passes among them, without what is the same for "
      "all. Settings that are not named are the method's defaults.</p>\n"
      "<table><tr><th>scene</th><th>tick</th><th>method</th><th>RMSE</th><th>PSNR "
      "dB</th><th>SSIM</th><th>FLIP</th>"
      "<th>GPU ms</th><th>own ms</th><th>MiB</th><th>settings</th></tr>\n",
      kStyle, escape(one_line(results.environment, ": ", " · ")));
  for (const FrameResult& frame : results.frames) page += row(frame);
  page +=
      "</table>\n<p class=\"note\">Error maps show FLIP from 0 (black) to 1 (pale yellow), the same scale "
      "everywhere.</p>\n";

  for (size_t i = 0; i < results.frames.size(); ++i) {
    const FrameResult& frame = results.frames[i];
    const bool starts =
        i == 0 || results.frames[i - 1].scene != frame.scene || results.frames[i - 1].tick != frame.tick;
    if (starts)
      page += fmt::format("{}<h2>{}, tick {}</h2>\n<div class=\"pictures\">\n", i == 0 ? "" : "</div>\n",
                          escape(frame.scene), frame.tick);
    const std::string name =
        frame.method +
        (changed_settings(frame).empty() ? "" : " (" + settings_text(changed_settings(frame)) + ")");
    page += picture(path.parent_path(), frame.image, name + " — ms: " + passes_text(frame));
    page += picture(path.parent_path(), frame.error_map, name + ", error");
  }
  page += results.frames.empty() ? "</html>\n" : "</div></html>\n";
  write_file(path, {reinterpret_cast<const uint8_t*>(page.data()), page.size()});
}

}  // namespace plume
