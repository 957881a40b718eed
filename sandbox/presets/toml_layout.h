// Where everything in a TOML text stands, to the byte: what an editor needs that changes one value and leaves
// every other byte alone. It takes texts that the parser takes; it decodes nothing but keys.
//
// A section is what stands from one header to the next: `[table]` or `[[table]]` and its statements, each a
// `key = value`. Section 0 is what stands before the first header.
#ifndef PLUME_PRESETS_TOML_LAYOUT_H
#define PLUME_PRESETS_TOML_LAYOUT_H

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sandbox/presets/value_path.h"

namespace plume {

/// Bytes [begin, end).
struct Span {
  size_t begin = 0, end = 0;
};

/// A value, a table or a list of tables.
struct Place {
  enum class Kind {
    kScalar,
    kArray,   ///< [a, b]
    kInline,  ///< { a = 1 }
    kTable,   ///< of sections, or of dotted keys
    kTables,  ///< [[of sections]]
  };
  static constexpr size_t kNone = size_t(-1);

  Kind kind = Kind::kScalar;
  Place* parent = nullptr;
  std::string key;         ///< in the parent; "" for an item
  Span span;               ///< of a scalar, an array or an inline table: its value
  Span statement;          ///< of what a `key = value` says: from the key to the end of the value
  size_t section = kNone;  ///< of a table with a header, or the top
  bool dotted = false;     ///< a table made by dotted keys alone
  std::vector<std::unique_ptr<Place>> members;  ///< of a table, by key
  std::vector<std::unique_ptr<Place>> items;    ///< of an array or a list of tables

  const Place* member(std::string_view name) const;
  /// 0 for what is no list, 1 for a list, 2 for a list of lists, …
  size_t nesting() const;
  bool is_table() const { return kind == Kind::kTable || kind == Kind::kInline; }
  bool is_list() const { return kind == Kind::kArray || kind == Kind::kTables; }
  /// Whether this is `other` or stands in it.
  bool is_in(const Place& other) const;
};

struct Section {
  Span header;  ///< empty for section 0
  const Place* table = nullptr;
  std::vector<std::pair<Span, const Place*>> statements;

  /// The end of its last statement or of its header.
  size_t end() const { return statements.empty() ? header.end : statements.back().first.end; }
};

class TomlLayout {
 public:
  /// Throws std::invalid_argument where `text` cannot be TOML.
  explicit TomlLayout(std::string_view text);

  const Place& top() const { return *top_; }
  const std::vector<Section>& sections() const { return sections_; }
  std::string_view text() const { return text_; }
  /// Nothing when the text has no such place. The first of a list stands for a table that is no list.
  const Place* find(const std::vector<Step>& path) const;

  size_t line_begin(size_t at) const;
  /// Of the line break, or of the text.
  size_t line_end(size_t at) const;
  /// After the line break.
  size_t next_line(size_t at) const;
  /// Blanks before the first other character of the line.
  std::string_view indentation(size_t at) const;
  bool is_blank_line(size_t at) const;
  std::string_view line_break() const;

 private:
  std::string_view text_;
  std::unique_ptr<Place> top_;
  std::vector<Section> sections_;
};

}  // namespace plume
#endif
