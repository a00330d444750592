#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/subject.h"
#include "core/evidence/ensembles/probability_map.h"
#include "io/case/ensemble_source.h"

namespace rubble::cli {

/// How ensembles are to be made, as given by --members, --vary, --seed, --cell, --live, --instant, --jobs, --threads.
class EnsembleRequest {
public:
    static std::vector<Option> options();

    /// Throws UsageError for a value that is not one of those offered.
    explicit EnsembleRequest(const Arguments& arguments);

    /// Everything of the study but its store. @param store  may be null
    EnsembleOptions studyOptions(SettledStore* store) const;
    /// What a case says, with what was asked for in its place.
    EnsembleSettings settingsFor(const Case& theCase) const;
    const SurfaceSettings& surface() const { return m_surface; }
    DebrisInstant instant() const { return m_instant; }

private:
    std::vector<VariedSetting> m_varied;
    std::optional<std::int64_t> m_members;
    std::optional<std::int64_t> m_seed;
    SurfaceSettings m_surface;
    DebrisInstant m_instant = DebrisInstant::AtRest;
    int m_jobs = 0;
    int m_threads = 0;
};

/// A case or FE file with the scenarios that its ensemble needs, and how that is made.
struct EnsembleSubject : io::EnsembleSource {
    EnsembleSettings settings;
    std::string path;  ///< case or FE file that it was opened from
};

/// Opens a case or FE file with every scenario that is varied, or only the one that is named. Throws as openSubject().
/// @param like  whose case an FE file takes instead of the delivered settings; null: none
EnsembleSubject openEnsembleSubject(const std::string& path, const std::optional<std::string>& scenario, const Arguments& arguments,
                                    const EnsembleRequest& request, Session& session, const EnsembleSubject* like = nullptr);

/// The worlds of the members of a subject, for others to make. Throws what ensembleTasks() throws.
std::vector<StudyTask> tasksOf(const EnsembleSubject& subject, const EnsembleRequest& request, const Execution& execution);

/// All operands of a command that takes any number.
std::vector<std::string> operandsOf(const Arguments& arguments);

/// Three ascending heights of --heights. Throws UsageError.
HeightThresholds parseThresholds(const Arguments& arguments);

}  // namespace rubble::cli
