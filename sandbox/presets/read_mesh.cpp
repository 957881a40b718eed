#include "sandbox/presets/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "renderer/parameters.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/preset_file.h"

namespace plume {
namespace {

constexpr std::string_view kUnused[] = {"vt", "vn", "vp", "o", "g", "s", "mtllib", "usemtl"};
constexpr std::string_view kBlank = " \t\r";
constexpr double kFarthest = 1000;       // coordinate, in units of the file
constexpr double kLeastArea = 1e-12;     // of a triangle, in squared units of the file
constexpr size_t kMostCorners = 64;      // of a polygon
constexpr size_t kMostDiagnostics = 20;  // a file that is no mesh has a mistake in every line

struct Word {
  std::string_view text;
  uint32_t column;  // from 1
};

std::vector<Word> words_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<Word> words;
  for (size_t at = line.find_first_not_of(kBlank); at != line.npos;) {
    const size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    words.push_back({line.substr(at, end - at), uint32_t(at + 1)});
    at = line.find_first_not_of(kBlank, end);
  }
  return words;
}

/// What of a hostile text can be shown in a message.
std::string shown(std::string_view text) {
  std::string result(text.substr(0, 40));
  std::ranges::replace_if(
      result, [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

class MeshReader {
 public:
  explicit MeshReader(const std::string& file) : file_(file) { mesh_.id = preset_id(file); }

  Mesh read(std::string_view text) {
    for (line_ = 1; !text.empty() && found_.size() < kMostDiagnostics; ++line_) {
      const size_t end = std::min(text.find('\n'), text.size());
      read_line(words_of(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (found_.empty() && mesh_.triangles.empty()) {
      line_ = 1;
      report(1, "the file has no face, expected `v x y z` for the corners and `f` for the faces of a mesh");
    }
    if (!found_.empty()) throw FileErrors(std::move(found_));
    return std::move(mesh_);
  }

 private:
  void report(uint32_t column, std::string message) {
    found_.push_back({file_, line_, column, std::move(message)});
  }

  void read_line(const std::vector<Word>& words) {
    if (words.empty()) return;
    const std::string_view statement = words[0].text;
    if (statement == "v")
      read_vertex(words);
    else if (statement == "f")
      read_face(words);
    else if (std::ranges::find(kUnused, statement) == std::end(kUnused))
      report(words[0].column, fmt::format("unknown statement `{}`, expected `v` or `f`", shown(statement)));
  }

  void read_vertex(const std::vector<Word>& words) {
    glm::vec3 vertex(0.0f);
    if (words.size() != 4)
      report(words[0].column, fmt::format("`v` with {} numbers, expected 3: x y z", words.size() - 1));
    for (size_t i = 1; i < std::min<size_t>(words.size(), 4); ++i) {
      const auto [text, column] = words[i];
      double value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size() || !(std::abs(value) <= kFarthest))
        report(column,
               fmt::format("`{}`, expected a number from {} to {}", shown(text), -kFarthest, kFarthest));
      else
        vertex[int(i) - 1] = float(value);
    }
    vertices_.push_back(vertex);  // a wrong one too: faces count on
  }

  /// `7`, `7/2`, `7//3` or `7/2/3`, of which the first is the vertex; negative ones count from the last.
  bool read_corner(const Word& word, glm::vec3& corner) {
    const std::string_view text = word.text.substr(0, word.text.find('/'));
    long index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    const long count = long(vertices_.size());
    if (error != std::errc() || end != text.data() + text.size() || index == 0 || index > count ||
        index < -count)
      return report(word.column, fmt::format("`{}`, expected a vertex from 1 to {}, the number of `v` so far",
                                             shown(word.text), count)),
             false;
    corner = vertices_[size_t(index > 0 ? index - 1 : count + index)];
    return true;
  }

  void read_face(const std::vector<Word>& words) {
    const size_t count = words.size() - 1;
    if (count < 3 || count > kMostCorners)
      return report(words[0].column,
                    fmt::format("`f` with {} corners, expected 3 to {}", count, kMostCorners));
    std::vector<glm::vec3> corners(count);
    bool read = true;
    for (size_t i = 0; i < count; ++i) read &= read_corner(words[i + 1], corners[i]);
    if (!read) return;
    if (mesh_.triangles.size() + count - 2 > kMaxMeshTriangles) {
      if (!full_)
        report(words[0].column,
               fmt::format("more than {0} triangles, expected at most {0}: simplify the mesh",
                           kMaxMeshTriangles));
      full_ = true;
      return;
    }
    for (size_t i = 2; i < count; ++i) {
      const glm::dvec3 a(corners[0]), b(corners[i - 1]), c(corners[i]);
      if (0.5 * glm::length(glm::cross(b - a, c - a)) < kLeastArea)
        return report(words[0].column,
                      "a face without area, expected corners that are apart and not in a line");
      mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }

  const std::string& file_;
  uint32_t line_ = 1;
  Mesh mesh_;
  std::vector<glm::vec3> vertices_;
  std::vector<Diagnostic> found_;
  bool full_ = false;
};

}  // namespace

Mesh read_mesh_text(std::string_view text, const std::string& file) {
  return MeshReader(file).read(text);
}

Mesh read_mesh(const std::filesystem::path& path) {
  return read_mesh_text(load_text(path), path.string());
}

}  // namespace plume
