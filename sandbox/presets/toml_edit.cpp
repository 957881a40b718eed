#include "sandbox/presets/toml_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "sandbox/presets/table_reader.h"
#include "sandbox/presets/toml_layout.h"

namespace plume {
namespace {

using Kind = Place::Kind;
using Path = std::vector<Step>;

struct Replacement {
  Span span;
  std::string text;
};

std::string replaced(std::string_view text, std::vector<Replacement> replacements) {
  std::string result(text);
  std::ranges::stable_sort(replacements, std::greater(), [](const Replacement& r) { return r.span.begin; });
  for (const auto& [span, by] : replacements) result.replace(span.begin, span.end - span.begin, by);
  return result;
}

std::string inserted(std::string_view text, size_t at, std::string_view what) {
  return std::string(text.substr(0, at)).append(what).append(text.substr(at));
}

// --- values --------------------------------------------------------------------------------------------

/// Whether the text of a value says it already.
bool says(const toml::node& node, const TomlValue& value) {
  const auto is_number = [&](auto wanted) {
    using Number = decltype(wanted);
    if (const auto* whole = node.as_integer()) return static_cast<Number>(whole->get()) == wanted;
    const auto* real = node.as_floating_point();
    return real && static_cast<Number>(real->get()) == wanted;
  };
  return std::visit(
      [&](const auto& v) -> bool {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, bool>) {
          return node.is_boolean() && node.as_boolean()->get() == v;
        } else if constexpr (std::is_same_v<T, int64_t>) {
          return node.is_integer() && node.as_integer()->get() == v;
        } else if constexpr (std::is_floating_point_v<T>) {
          return is_number(v);
        } else if constexpr (std::is_same_v<T, std::string>) {
          return node.is_string() && node.as_string()->get() == v;
        } else if constexpr (std::is_same_v<T, TomlValue::Verbatim>) {
          return false;
        } else {
          const toml::array* array = node.as_array();
          if (!array || array->size() != v.size()) return false;
          for (size_t i = 0; i < v.size(); ++i)
            if (!says((*array)[i], v[i])) return false;
          return true;
        }
      },
      value.value);
}

/// What separates items of a list: a comma and one blank, or a line break and the indentation.
std::string separator(const TomlLayout& layout, const Place& list) {
  const size_t from = list.items.size() > 1 ? list.items[0]->span.end : list.span.begin;
  const size_t to = list.items.size() > 1 ? list.items[1]->span.begin : list.items[0]->span.begin;
  const bool breaks = layout.text().substr(from, to - from).find('\n') != std::string_view::npos;
  return breaks ? fmt::format(",{}{}", layout.line_break(), layout.indentation(to)) : std::string(", ");
}

/// The items of an array or the members of an inline table, as they stand.
std::vector<Span> spans_of(const Place& place) {
  std::vector<Span> spans;
  if (place.kind == Kind::kArray) {
    for (const auto& item : place.items) spans.push_back(item->span);
    return spans;
  }
  const auto collect = [&](const auto& self, const Place& table) -> void {
    for (const auto& member : table.members)
      member->dotted ? self(self, *member) : spans.push_back(member->statement);
  };
  collect(collect, place);
  std::ranges::sort(spans, {}, &Span::begin);
  return spans;
}

/// What to cut so that items [from, to) of a list, or members of an inline table, are gone.
Span cut(const TomlLayout& layout, const Place& list, size_t from, size_t to) {
  const std::vector<Span> items = spans_of(list);
  if (to < items.size()) return {items[from].begin, items[to].begin};  // comments stay behind what they tell
  if (from == 0) return {list.span.begin + 1, list.span.end - 1};
  // The last: the comma before it, or where it has lines of its own, those.
  const std::string_view text = layout.text();
  const size_t before = items[from - 1].end, end = items.back().end;
  const size_t line = text.substr(0, items[from].begin).find('\n', before);
  const bool comma_first = line != text.npos && text.substr(before, line - before).find(',') == text.npos;
  if (line == text.npos || comma_first || list.span.end <= layout.next_line(end)) return {before, end};
  return {line, layout.next_line(end) - 1};
}

void rewrite(const TomlLayout& layout, const Place& place, const toml::node& node, const TomlValue& value,
             std::vector<Replacement>& out) {
  if (says(node, value)) return;
  const auto* items = std::get_if<std::vector<TomlValue>>(&value.value);
  const toml::array* array = node.as_array();
  if (!items || !array || items->empty() || array->empty() || place.kind != Kind::kArray)
    return out.push_back({place.span, to_toml(value)});
  const size_t had = place.items.size(), has = items->size(), both = std::min(had, has);
  size_t first = 0, last = 0;  // the same items at either end
  while (first < both && says((*array)[first], (*items)[first])) ++first;
  while (last < both - first && says((*array)[had - 1 - last], (*items)[has - 1 - last])) ++last;
  const size_t changed = both - first - last;
  for (size_t i = first; i < first + changed; ++i)
    rewrite(layout, *place.items[i], (*array)[i], (*items)[i], out);
  const size_t at = first + changed;
  if (had > has) {
    out.push_back({cut(layout, place, at, had - last), ""});
  }
  if (has > had) {
    const std::string gap = separator(layout, place);
    std::string added;
    for (size_t i = at; i < has - last; ++i)
      added += at < had ? to_toml((*items)[i]) + gap : gap + to_toml((*items)[i]);
    const size_t where = at < had ? place.items[at]->span.begin : place.items.back()->span.end;
    out.push_back({{where, where}, std::move(added)});
  }
}

// --- places ---------------------------------------------------------------------------------------------

/// Where the comment right above a header begins, or its line.
size_t lead_begin(const TomlLayout& layout, const Section& section) {
  const size_t begin = layout.line_begin(section.header.begin);
  size_t lead = begin;
  while (lead > 0) {
    const size_t above = layout.line_begin(lead - 1);
    const size_t content = above + layout.indentation(above).size();
    if (layout.text()[content] != '#') break;
    lead = above;
  }
  return lead == 0 ? begin : lead;  // a comment that opens the file is about the file
}

/// The end of the last thing that is said in a table or a list of tables.
size_t end_of(const TomlLayout& layout, const Place& place) {
  size_t end = place.span.end;
  for (const Section& section : layout.sections()) {
    if (section.table->is_in(place)) end = std::max(end, section.header.end);
    for (const auto& [span, said] : section.statements)
      if (said->is_in(place)) end = std::max(end, span.end);
  }
  return end;
}

const Section* first_section_in(const TomlLayout& layout, const Place& place) {
  for (const Section& section : layout.sections())
    if (section.header.end > 0 && section.table->is_in(place)) return &section;
  return nullptr;
}

/// The table whose section or braces hold the statements of `table`, and the dotted keys from there.
const Place& home_of(const Place& table, std::string& prefix) {
  if (!table.dotted) return table;
  const Place& home = home_of(*table.parent, prefix);
  prefix += written_key(table.key) + ".";
  return home;
}

std::string header_path(const Place& place) {
  if (!place.parent) return "";
  const std::string above = header_path(*place.parent);
  if (place.key.empty()) return above;  // an item
  return above.empty() ? written_key(place.key) : above + "." + written_key(place.key);
}

/// A text of whole lines, put after the line that `at` stands in.
std::string with_lines_after(const TomlLayout& layout, size_t at, std::string lines) {
  const size_t next = layout.next_line(at);
  const bool broken = next > 0 && layout.text()[next - 1] == '\n';
  if (!broken && next > 0) lines = std::string(layout.line_break()) + lines;
  return inserted(layout.text(), next, lines);
}

/// The table that a table is in, beyond the list that it may be an item of.
const Place* outer_table(const Place& table) {
  const Place* outer = table.parent;
  return outer && outer->is_list() ? outer->parent : outer;
}

/// Of the header of a table in `parent`: as another there, or as deep as tables are nested in this file.
std::string header_indentation(const TomlLayout& layout, const Place& parent) {
  const auto own = [&](size_t section) {
    return std::string(layout.indentation(layout.sections()[section].header.begin));
  };
  const auto has_header = [](const Place* table) {
    return table->section != Place::kNone && table->section > 0;
  };
  std::optional<std::string> step;
  for (size_t i = 1; i < layout.sections().size(); ++i) {
    const Place* outer = outer_table(*layout.sections()[i].table);
    if (outer == &parent) return own(i);
    if (!step && has_header(outer) && own(i).starts_with(own(outer->section)))
      step = own(i).substr(own(outer->section).size());
  }
  if (!parent.parent) return "";
  return (has_header(&parent) ? own(parent.section) : "") + step.value_or("  ");
}

/// How much further than its header a table's keys are indented in this file.
size_t key_indentation(const TomlLayout& layout) {
  for (const Section& section : layout.sections()) {
    if (section.header.end == 0 || section.statements.empty()) continue;
    const size_t key = layout.indentation(section.statements[0].first.begin).size();
    return key - std::min(key, layout.indentation(section.header.begin).size());
  }
  return 0;
}

/// A key that its table does not have yet.
std::string with_member(std::string_view text, const Place& table, const TomlLayout& layout,
                        std::string_view key, std::string_view value) {
  std::string prefix;
  const Place& home = home_of(table, prefix);
  const std::string said = fmt::format("{}{} = {}", prefix, written_key(key), value);
  if (home.kind == Kind::kInline) {
    if (home.members.empty()) return replaced(text, {{home.span, "{ " + said + " }"}});
    return inserted(text, spans_of(home).back().end, ", " + said);
  }
  const auto line = [&](std::string_view indentation) {
    return fmt::format("{}{}{}", indentation, said, layout.line_break());
  };
  if (home.section == Place::kNone) {  // made by the headers of its tables
    const Section& inner = *first_section_in(layout, home);
    const std::string indentation(layout.indentation(inner.header.begin));
    const std::string header = fmt::format("{}[{}]{}", indentation, header_path(home), layout.line_break());
    return inserted(text, lead_begin(layout, inner), header + line(indentation));
  }
  const Section& section = layout.sections()[home.section];
  const auto in_table = [&](const auto& statement) { return statement.second->is_in(table); };
  const auto last = std::find_if(section.statements.rbegin(), section.statements.rend(), in_table);
  if (last != section.statements.rend())
    return with_lines_after(layout, last->first.end, line(layout.indentation(last->first.begin)));
  if (section.header.end > 0) {
    const std::string indentation =
        std::string(layout.indentation(section.header.begin)) + std::string(key_indentation(layout), ' ');
    return with_lines_after(layout, section.header.end, line(indentation));
  }
  if (layout.sections().size() == 1) return inserted(text, text.size(), line(""));
  return inserted(text, lead_begin(layout, layout.sections()[1]),
                  line("") + std::string(layout.line_break()));
}

Path outside(const Path& path) {
  return Path(path.begin(), path.end() - 1);
}

[[noreturn]] void fail(const Path& path, std::string_view why) {
  throw std::invalid_argument(fmt::format("`{}` cannot be there: {}", to_string(path), why));
}

/// Removes every section and every dotted statement of a table.
std::string without_table(const TomlLayout& layout, const Place& place) {
  std::vector<Replacement> cuts;
  const std::vector<Section>& sections = layout.sections();
  for (size_t i = 0; i < sections.size(); ++i) {
    const bool whole = i > 0 && sections[i].table->is_in(place);
    if (!whole) {
      for (const auto& [span, said] : sections[i].statements)
        if (said->is_in(place))
          cuts.push_back({{layout.line_begin(span.begin), layout.next_line(span.end)}, ""});
      continue;
    }
    const size_t begin = lead_begin(layout, sections[i]);
    while (i + 1 < sections.size() && sections[i + 1].table->is_in(place)) ++i;
    size_t end = layout.next_line(sections[i].end());
    // Of blank lines before and after, one side stays; at the end of the file, none.
    const bool blank_before = begin > 0 && layout.is_blank_line(begin - 1);
    size_t after = end;
    while (after < layout.text().size() && layout.is_blank_line(after)) after = layout.next_line(after);
    size_t from = begin;
    if (after == layout.text().size())
      while (from > 0 && layout.is_blank_line(from - 1)) from = layout.line_begin(from - 1);
    if (blank_before || after == layout.text().size()) end = after;
    cuts.push_back({{from, end}, ""});
  }
  return replaced(layout.text(), std::move(cuts));
}

}  // namespace

std::string with_table(std::string_view text, const Path& path) {
  const TomlLayout layout(text);
  if (const Place* there = layout.find(path)) {
    if (there->is_table() || there->is_list()) return std::string(text);
    fail(path, "it is a value");
  }
  Path list = path;
  list.back().index.reset();
  const Place* others = path.back().index ? layout.find(list) : nullptr;
  const size_t count = !others ? 0 : others->is_list() ? others->items.size() : 1;
  if (path.back().index.value_or(0) > (path.back().index ? count : 0))
    fail(path, fmt::format("the list has {}", count));

  if (others && others->kind == Kind::kArray) {
    if (others->items.empty()) return replaced(text, {{others->span, "[{}]"}});
    return inserted(text, others->items.back()->span.end, separator(layout, *others) + "{}");
  }
  if (others && others->is_table()) {  // [one] becomes [[one]]
    if (others->section == Place::kNone) fail(path, "the first is no table of its own; write it as [[one]]");
    const Span header = layout.sections()[others->section].header;
    const std::string listed = fmt::format("[{}]", text.substr(header.begin, header.end - header.begin));
    return with_table(replaced(text, {{header, listed}}), path);
  }
  const Path outer = outside(path);
  const Place* parent = layout.find(outer);
  if (!parent) return with_table(with_table(text, outer), path);
  if (!parent->is_table()) fail(path, fmt::format("`{}` is no table", to_string(outer)));
  if (parent->kind == Kind::kInline || parent->dotted)
    return with_member(text, *parent, layout, path.back().key, path.back().index ? "[{}]" : "{}");

  const std::string above = header_path(*parent);
  const std::string name = (above.empty() ? "" : above + ".") + written_key(path.back().key);
  const std::string header = path.back().index ? fmt::format("[[{}]]", name) : fmt::format("[{}]", name);
  const std::string_view line_break = layout.line_break();
  bool apart = !parent->parent;  // tables at the top stand apart
  if (others) {
    const size_t lead = lead_begin(layout, layout.sections()[others->items.back()->section]);
    apart = lead > 0 && layout.is_blank_line(lead - 1);
  }
  const size_t after = end_of(layout, others ? *others->items.back() : *parent);
  return with_lines_after(layout, after,
                          fmt::format("{}{}{}{}", apart ? line_break : "",
                                      header_indentation(layout, *parent), header, line_break));
}

std::string with_value(std::string_view text, const Path& path, const TomlValue& value) {
  const TomlLayout layout(text);
  const Path outer = outside(path);
  const Place* parent = layout.find(outer);
  if (!parent) return with_value(with_table(text, outer), path, value);
  if (!parent->is_table()) fail(path, fmt::format("`{}` is no table", to_string(outer)));
  const Place* place = layout.find(path);
  if (!place && path.back().index) fail(path, "the list has no such item");
  if (!place) return with_member(text, *parent, layout, path.back().key, to_toml(value));
  if (place->kind == Kind::kTable || place->kind == Kind::kTables) fail(path, "there is a table");
  const toml::table alone =
      toml::parse("v = " + std::string(text.substr(place->span.begin, place->span.end - place->span.begin)));
  std::vector<Replacement> changes;
  rewrite(layout, *place, *alone.get("v"), value, changes);
  return replaced(text, std::move(changes));
}

std::string without(std::string_view text, const Path& path) {
  const TomlLayout layout(text);
  const Place* place = layout.find(path);
  if (!place || !place->parent) fail(path, "there is no such thing");
  if (place->kind == Kind::kTable || place->kind == Kind::kTables) return without_table(layout, *place);

  const Place* in = place->parent;
  while (in->dotted) in = in->parent;
  if (in->kind == Kind::kTable)
    return replaced(
        text, {{{layout.line_begin(place->statement.begin), layout.next_line(place->statement.end)}, ""}});
  const std::vector<Span> spans = spans_of(*in);
  if (in->kind == Kind::kArray && spans.size() == 1) {
    Path list = path;
    list.back().index.reset();
    return without(text, list);
  }
  const size_t begin = in->kind == Kind::kArray ? place->span.begin : place->statement.begin;
  const size_t index = size_t(std::ranges::find(spans, begin, &Span::begin) - spans.begin());
  return replaced(text, {{cut(layout, *in, index, index + 1), ""}});
}

}  // namespace plume
