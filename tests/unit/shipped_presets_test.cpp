// What we ship must read without a word, and name only what we ship.
#include <gtest/gtest.h>

#include "sandbox/presets/check.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/library.h"

namespace plume {
namespace {

TEST(ShippedPresets, ReadWithoutDiagnostics) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  for (const PresetKind kind : {PresetKind::kEffect, PresetKind::kScene, PresetKind::kReplay}) {
    EXPECT_FALSE(library.ids(kind).empty()) << "no presets of kind " << static_cast<int>(kind);
    for (const std::string& id : library.ids(kind))
      for (const Diagnostic& diagnostic : check_file(library.find(kind, id)))
        ADD_FAILURE() << to_string(diagnostic);
  }
}

}  // namespace
}  // namespace plume
