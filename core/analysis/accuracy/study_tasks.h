#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/accuracy/study_store.h"

namespace rubble {

/// A world of a study as a piece of work of its own: any process that has the same inputs, settings and build can make it into the
/// store, and the study takes it from there.
struct StudyTask {
    WorldOrigin origin;
    std::string name;         ///< "reference", "repeat 1", "multiple=2", "member 12"
    std::int64_t bodies = 0;  ///< clusters that it starts from; of a member of an ensemble those of its scene
    // What its cost can be predicted from.
    Scenario scenario;
    WorldOrigin reference;       ///< of the same scene
    std::int64_t fragments = 0;  ///< likewise
    double span = 0.0;           ///< s, from the first birth to the last FE state
    bool carries = false;        ///< the engine moves loose structure as well
    double collapse = 0.0;       ///< s, all that is simulated: FE result and settling
};

/// @param results  of its scene, up to the clusters; null: they are not known, and nothing is said of bodies and span
StudyTask studyTask(const Inputs& inputs, const Scenario& scenario, const Results* results, WorldOrigin origin, std::string name);

/// The scenario as a run of these clusters takes it (settledScenario()).
Scenario settledBy(const Inputs& inputs, const Scenario& scenario, const Results& results);

/// From the first birth to the end of the FE result, s; 0 without fragments.
double collapseSpan(const FragmentSet& fragments, double feEnd);

/// Which worlds of a study are simulated: all that the store lacks, or only these. The others are taken from the store or left
/// open, and count as neither done nor failed.
class WorldChoice {
public:
    /// All that are missing.
    WorldChoice() = default;
    static WorldChoice none() { return WorldChoice(std::optional<Digest>()); }
    static WorldChoice only(const Digest& key) { return WorldChoice(key); }

    bool all() const { return m_all; }
    bool wants(const Digest& key) const { return m_all || m_only == key; }
    /// One world alone is to be made: nothing else of the study needs to be.
    bool single() const { return !m_all && m_only.has_value(); }
    /// Throws UsageError if a single world is wanted that is none of these.
    void check(const std::vector<StudyTask>& tasks) const;

private:
    explicit WorldChoice(std::optional<Digest> only) : m_all(false), m_only(only) {}

    bool m_all = true;
    std::optional<Digest> m_only;
};

/// The digest that Digest::hex() wrote; nothing unless the text is 32 lower-case hexadecimal digits.
std::optional<Digest> digestFromHex(std::string_view text);

/// The tasks of one key once: members that were drawn alike are one world.
std::vector<StudyTask> distinctTasks(std::vector<StudyTask> tasks);

}  // namespace rubble
