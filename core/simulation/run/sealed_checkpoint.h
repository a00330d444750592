#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/archive.h"
#include "core/base/finding.h"
#include "core/base/hash.h"
#include "core/simulation/run/checkpoint.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Names everything that decides a run: build, inputs, scenario, the fragments and how they are joined.
Digest runDigest(const RunDescription& description);

/// Begins the bytes of a checkpoint; what is written into the archive next is its content.
void beginCheckpoint(Archive& archive, const Digest& run);
/// The bytes with the digest of their content.
std::string sealCheckpoint(Archive&& archive);
/// The content of a checkpoint. Nothing, which is counted, if it is cut short, changed, or of another run, scenario or build.
std::optional<std::string_view> openCheckpoint(std::string_view bytes, const Digest& run, Findings& findings);

/// What the store, if there is one, holds; what cannot be read is counted.
std::optional<std::string> latestCheckpoint(CheckpointStore* checkpoints, Findings& findings);

/// Counts a checkpoint that is not what it should be.
void addDamagedCheckpoint(Findings& findings, std::string_view example);

}  // namespace rubble
