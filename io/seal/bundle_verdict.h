#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "io/seal/seal_check.h"
#include "io/seal/unpacked_bundle.h"

namespace rubble::io {

/// A run of a bundle, simulated again.
struct RepeatedRun {
    SealedRun run;
    RunRepeat repeat;
    Message notSimulated = {};  ///< why; empty: it was
    Message remedy = {};
    bool equal() const { return notSimulated.empty() && repeat.equal; }
    /// The first figure or instant that is not what it was, or why it was not simulated; empty: there is none.
    Message difference() const;
};

/// Simulates all runs of a bundle again, each for itself: one that cannot be simulated is told beside the others.
/// Throws Cancelled, and what UnpackedBundle::repeat() throws besides WorldError.
std::vector<RepeatedRun> repeatRuns(const UnpackedBundle& unpacked, const Execution& execution);

/// How far what was asked of a part of a bundle is proven.
enum class Proof { Holds, Unproven, Fails, Absent };

/// A part of a bundle that was checked, and what came of it.
struct CheckedPart {
    Message name;
    Proof proof = Proof::Holds;
    Message meaning;
    std::vector<SealFault> said = {};   ///< faults first, then doubts
    std::size_t faults = 0;             ///< how many of them are faults
    std::vector<SealFault> known = {};  ///< what must be known all the same, of the runs
};

/// Everything that checkBundle() looked at, in the order in which a reader asks: container, files, statement and signature, time,
/// journal, runs, what came since.
std::vector<CheckedPart> checkedParts(const SealCheck& check);

/// By whom it was seen on which day, or when it was sealed by the signer's word.
Message sealedWhen(const SealCheck& check);

/// "holds", "not proven", "does not hold", "not there".
Message proofText(Proof proof);

/// In one sentence what came of all. @param simulated  the runs were simulated again
Message bundleVerdict(const SealCheck& check, const std::vector<RepeatedRun>& repeats, bool simulated);

}  // namespace rubble::io
