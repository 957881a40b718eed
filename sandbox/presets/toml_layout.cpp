#include "sandbox/presets/toml_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sandbox/presets/table_reader.h"
#include "sandbox/presets/toml_guard.h"

namespace plume {
namespace {

constexpr std::string_view kBlank = " \t", kBlankOrBreak = " \t\r\n";

Place& add_member(Place& table, std::string key, Place::Kind kind) {
  Place& place = *table.members.emplace_back(std::make_unique<Place>());
  place.kind = kind, place.parent = &table, place.key = std::move(key);
  return place;
}

Place& add_item(Place& list, Place::Kind kind) {
  Place& place = *list.items.emplace_back(std::make_unique<Place>());
  place.kind = kind, place.parent = &list;
  return place;
}

/// Walks the text once, statement by statement.
class Scanner {
 public:
  Scanner(std::string_view text, Place& top, std::vector<Section>& sections)
      : text_(text), top_(top), sections_(sections) {}

  void scan() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    sections_.push_back({.table = &top_});
    Place* table = &top_;
    for (skip(kBlankOrBreak); at_ < text_.size(); skip(kBlankOrBreak))
      if (text_[at_] == '[')
        table = &header();
      else
        sections_.back().statements.push_back(statement(*table));
  }

 private:
  [[noreturn]] void fail() const {
    throw std::invalid_argument(fmt::format("no TOML at byte {} of the text", at_));
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void expect(char c) {
    if (peek() != c) fail();
    ++at_;
  }
  /// Comments too, where lines may break.
  void skip(std::string_view blanks) {
    for (;; at_ += opaque_length(text_.substr(at_))) {
      at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
      if (peek() != '#' || blanks == kBlank) return;
    }
  }

  std::string key() {
    if (peek() == '"' || peek() == '\'') {
      const std::string_view text = text_.substr(at_, opaque_length(text_.substr(at_)));
      at_ += text.size();
      if (text.size() < 2) fail();
      if (text.find('\\') == text.npos) return std::string(text.substr(1, text.size() - 2));
      return toml::parse("k = " + std::string(text))["k"].value_or(std::string());
    }
    const size_t end = std::min(text_.find_first_of(" \t\r\n.=]#\"'", at_), text_.size());
    if (end == at_) fail();
    const std::string_view bare = text_.substr(at_, end - at_);
    at_ = end;
    return std::string(bare);
  }
  std::vector<std::string> keys() {
    std::vector<std::string> keys;
    for (skip(kBlank);; ++at_, skip(kBlank)) {
      keys.push_back(key());
      skip(kBlank);
      if (peek() != '.') return keys;
    }
  }

  static Place* find_member(Place& table, std::string_view key) {
    return const_cast<Place*>(table.member(key));
  }

  Place& header() {
    const size_t begin = at_++;
    const bool is_list = peek() == '[';
    at_ += is_list;
    const std::vector<std::string> path = keys();
    expect(']');
    if (is_list) expect(']');
    Place* table = &top_;
    for (size_t i = 0; i < path.size(); ++i) {
      const bool makes_item = is_list && i + 1 == path.size();
      Place* next = find_member(*table, path[i]);
      if (!next) next = &add_member(*table, path[i], makes_item ? Place::Kind::kTables : Place::Kind::kTable);
      if (makes_item) {
        add_item(*next, Place::Kind::kTable);
      }
      if (next->is_list()) {
        if (next->items.empty()) fail();
        next = next->items.back().get();
      }
      table = next;
    }
    if (!table->is_table()) fail();
    table->section = sections_.size();
    sections_.push_back({.header = {begin, at_}, .table = table});
    return *table;
  }

  std::pair<Span, const Place*> statement(Place& table) {
    const size_t begin = at_;
    const std::vector<std::string> path = keys();
    Place* in = &table;
    for (size_t i = 0; i + 1 < path.size(); ++i) {
      Place* next = find_member(*in, path[i]);
      if (!next) {
        next = &add_member(*in, path[i], Place::Kind::kTable);
        next->dotted = true;
      }
      in = next;
    }
    expect('=');
    skip(kBlank);
    Place& place = add_member(*in, path.back(), Place::Kind::kScalar);
    value(place);
    place.statement = {begin, at_};
    return {place.statement, &place};
  }

  void value(Place& place) {
    place.span.begin = at_;
    if (peek() == '[') {
      place.kind = Place::Kind::kArray;
      for (++at_, skip(kBlankOrBreak); peek() != ']';) {
        value(add_item(place, Place::Kind::kScalar));
        skip(kBlankOrBreak);
        if (peek() != ']') expect(','), skip(kBlankOrBreak);
      }
      ++at_;
    } else if (peek() == '{') {
      place.kind = Place::Kind::kInline;
      for (++at_, skip(kBlank); peek() != '}';) {
        statement(place);
        skip(kBlank);
        if (peek() != '}') expect(','), skip(kBlank);
      }
      ++at_;
    } else if (peek() == '"' || peek() == '\'') {
      at_ += opaque_length(text_.substr(at_));
    } else {
      at_ = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
      while (at_ > place.span.begin && kBlank.find(text_[at_ - 1]) != kBlank.npos) --at_;
      if (at_ == place.span.begin) fail();
    }
    place.span.end = at_;
  }

  std::string_view text_;
  Place& top_;
  std::vector<Section>& sections_;
  size_t at_ = 0;
};

}  // namespace

const Place* Place::member(std::string_view name) const {
  const auto found = std::ranges::find(members, name, [](const auto& place) { return place->key; });
  return found == members.end() ? nullptr : found->get();
}

size_t Place::nesting() const {
  return kind != Kind::kArray ? 0 : 1 + (items.empty() ? 0 : items[0]->nesting());
}

bool Place::is_in(const Place& other) const {
  for (const Place* place = this; place; place = place->parent)
    if (place == &other) return true;
  return false;
}

TomlLayout::TomlLayout(std::string_view text) : text_(text), top_(std::make_unique<Place>()) {
  top_->kind = Place::Kind::kTable;
  top_->section = 0;
  Scanner(text, *top_, sections_).scan();
}

const Place* TomlLayout::find(const std::vector<Step>& path) const {
  const Place* place = top_.get();
  for (const auto& [key, index] : path) {
    place = place->member(key);
    if (!place) return nullptr;
    if (!index) continue;
    if (place->is_list())
      place = *index < place->items.size() ? place->items[*index].get() : nullptr;
    else if (!place->is_table() || *index > 0)
      place = nullptr;
    if (!place) return nullptr;
  }
  return place;
}

size_t TomlLayout::line_begin(size_t at) const {
  const size_t before = at == 0 ? text_.npos : text_.rfind('\n', at - 1);
  return before == text_.npos ? 0 : before + 1;
}

size_t TomlLayout::line_end(size_t at) const {
  const size_t end = std::min(text_.find('\n', at), text_.size());
  return end > at && text_[end - 1] == '\r' ? end - 1 : end;
}

size_t TomlLayout::next_line(size_t at) const {
  const size_t end = text_.find('\n', at);
  return end == text_.npos ? text_.size() : end + 1;
}

std::string_view TomlLayout::indentation(size_t at) const {
  const size_t begin = line_begin(at);
  return text_.substr(begin, std::min(text_.find_first_not_of(kBlank, begin), text_.size()) - begin);
}

bool TomlLayout::is_blank_line(size_t at) const {
  return text_.substr(line_begin(at), line_end(at) - line_begin(at)).find_first_not_of(kBlank) == text_.npos;
}

std::string_view TomlLayout::line_break() const {
  const size_t end = text_.find('\n');
  return end != text_.npos && end > 0 && text_[end - 1] == '\r' ? "\r\n" : "\n";
}

}  // namespace plume
