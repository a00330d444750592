#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/geometry.h"
#include "core/base/message.h"
#include "core/fe/fe_result.h"
#include "core/fe/units.h"

namespace rubble {

/// What a file tells about its units, in these units.
struct UnitEvidence {
    struct Density {
        std::string part;
        double value = 0.0;
    };
    std::vector<Density> densities;     ///< of parts that have one, in their order
    double size = 0.0;                  ///< largest extent of the structure at rest
    double duration = 0.0;              ///< from the first state to the last
    std::optional<Vec3> fall;           ///< acceleration of nodes that nothing holds; nothing: none was seen to fall
    std::optional<FileUnits> declared;  ///< by a deck
};

/// How well a system fits what a file tells.
struct UnitFit {
    const UnitSystem* system = nullptr;
    double score = 0.0;            ///< logarithm of a likelihood; 3 more is clearly better
    std::vector<Message> reasons;  ///< in words and numbers
};

/// What is proposed: a choice and its reason. An empty choice: nothing in the file decides.
struct Proposal {
    std::string choice;  ///< id of a system, or an axis
    Message reason;
};

/// Gathers evidence in the units of the contents. Free fall is looked for at up to twelve states, among nodes all of whose elements
/// are dead: a solver that keeps them lets them fall. @param withFall  false: no state is read
/// Throws as the source does, and Cancelled.
UnitEvidence evidenceOf(const FeResult::Contents& contents, bool withFall, const Execution& execution);

/// The same evidence in the units and axes of the file, where contents were brought into a frame. Without densities if the unit of
/// mass was judged by them.
UnitEvidence evidenceInFile(UnitEvidence evidence, const FileUnits& units, const Frame& frame);

/// All systems, the best fit first; of equals in the order of unitSystems().
std::vector<UnitFit> fitUnits(const UnitEvidence& evidence);

/// The system that fits clearly better than any other; else its rivals are named in the reason.
Proposal proposeUnits(const UnitEvidence& evidence);

/// The axis against which free nodes fall.
Proposal proposeUpAxis(const UnitEvidence& evidence);

/// The structure at rest in a sentence, if no structure can be so large or so small in SI.
std::optional<Message> implausibleSize(double size);

}  // namespace rubble
