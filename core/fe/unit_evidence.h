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
    std::vector<Density> densities;  ///< of parts that have one, in their order
    double size = 0.0;               ///< largest extent of the structure at rest
    double duration = 0.0;           ///< from the first state to the last
    std::optional<Vec3> fall;        ///< acceleration of what falls; nothing: nothing was seen to
    bool freely = true;              ///< of nodes that nothing holds; else of pieces that gather speed, which may be held in part
    std::optional<FileUnits> declared;  ///< by a deck
};

/// Whether what falls may do so by gravity: freely, or at half to twice of it in a known system. In units of the file.
bool fallsByGravity(const UnitEvidence& evidence);

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

/// Gathers evidence in the units of the contents, without reading a state: seenFall() adds to it.
UnitEvidence evidenceOf(const FeResult::Contents& contents);

/// Looks for gravity in the motion: at up to twelve states among nodes all of whose elements are dead, which a solver that keeps
/// them lets fall; else at up to 24 among nodes that have left their place and gather speed along their way, whose median is that
/// of a structure coming down. Throws as the source does, and Cancelled.
void addSeenFall(UnitEvidence& evidence, const FeResult::Contents& contents, const Execution& execution);

/// The same evidence in the units and axes of the file, where contents were brought into a frame. Without densities if the unit of
/// mass was judged by them.
UnitEvidence evidenceInFile(UnitEvidence evidence, const FileUnits& units, const Frame& frame);

/// All systems, the best fit first; of equals in the order of unitSystems().
std::vector<UnitFit> fitUnits(const UnitEvidence& evidence);

/// The fit to read a file in that nobody has said anything of: the best one, if it fits clearly better than the system that the
/// file is read in now. Null: no known system fits, or the present one does as well.
const UnitFit* betterFit(const std::vector<UnitFit>& fits, const UnitSystem* now);

/// Ids of the systems that fit about as well as the best one, that one first; empty: no known system fits.
std::vector<std::string> rivalSystems(const std::vector<UnitFit>& fits);

/// What the findings of an FE result say of units that nobody has said: ids of the systems that fit as well; empty: nothing.
std::string unsaidUnits(const Findings& findings);

/// The system that fits clearly better than any other; else its rivals are named in the reason.
Proposal proposeUnits(const UnitEvidence& evidence);

/// The axis against which things fall.
Proposal proposeUpAxis(const UnitEvidence& evidence);

/// The structure at rest in a sentence, if no structure can be so large or so small in SI.
std::optional<Message> implausibleSize(double size);

}  // namespace rubble
