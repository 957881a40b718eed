#include "sandbox/workspace/open_documents.h"

namespace plume {
namespace {

constexpr double kPollSeconds = 0.25;

}  // namespace

PresetDocument& OpenDocuments::open(const std::string& name) {
  auto opened = opened_.find(name);
  if (opened == opened_.end()) {
    PresetDocument document(library_.find(kind_, name), kind_, library_);
    const uint64_t revision = document.revision();
    opened = opened_.emplace(name, Opened{.document = std::move(document), .first_revision = revision}).first;
  }
  return opened->second.document;
}

void OpenDocuments::poll(double now_s) {
  if (now_s < next_poll_s_) return;
  next_poll_s_ = now_s + kPollSeconds;
  for (auto& [name, opened] : opened_) poll(opened);
}

void OpenDocuments::poll(Opened& opened) {
  try {
    switch (opened.document.poll()) {
      case PresetDocument::Disk::kReloaded:
        opened.on_disk = OnDisk::kSame;
        break;
      case PresetDocument::Disk::kConflict:
        opened.on_disk = OnDisk::kChanged;
        break;
      case PresetDocument::Disk::kGone:
        opened.on_disk = OnDisk::kGone;
        break;
      case PresetDocument::Disk::kSame: {
        std::error_code unreadable;
        if (opened.on_disk == OnDisk::kGone && std::filesystem::exists(opened.document.path(), unreadable))
          opened.on_disk = OnDisk::kSame;
      }
    }
  } catch (const FileErrors&) {
    opened.on_disk = OnDisk::kGone;  // between the look and the reading
  }
}

OpenDocuments::OnDisk OpenDocuments::on_disk(const std::string& name) const {
  return opened_.at(name).on_disk;
}

void OpenDocuments::save(const std::string& name, PresetDocument::OverChanges over) {
  Opened& opened = opened_.at(name);
  opened.document.save(over);
  opened.on_disk = OnDisk::kSame;
}

void OpenDocuments::reload(const std::string& name) {
  Opened& opened = opened_.at(name);
  opened.document.reload();
  opened.on_disk = OnDisk::kSame;
}

void OpenDocuments::save_as(const std::string& name, const std::filesystem::path& path) {
  Opened& opened = opened_.at(name);
  opened.document.save_as(path);
  opened.on_disk = OnDisk::kSame;
  auto entry = opened_.extract(name);
  entry.key() = path.string();
  opened_.erase(entry.key());  // a file that is gone since it was opened
  opened_.insert(std::move(entry));
}

std::map<std::string, Effect> OpenDocuments::edited_effects() const {
  std::map<std::string, Effect> effects;
  for (const auto& [name, opened] : opened_)
    if (opened.document.revision() != opened.first_revision) effects[name] = *opened.document.effect();
  return effects;
}

uint64_t OpenDocuments::revision() const {
  uint64_t sum = 0;
  for (const auto& [name, opened] : opened_) sum += opened.document.revision() - opened.first_revision;
  return sum;
}

std::vector<std::string> OpenDocuments::unsaved() const {
  std::vector<std::string> names;
  for (const auto& [name, opened] : opened_)
    if (opened.document.is_changed()) names.push_back(name);
  return names;
}

}  // namespace plume
