#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/pipeline/pipeline.h"
#include "core/scenario/case.h"
#include "io/case/terrain_reader.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// An FE result that is open already: it is not read a second time.
struct OpenResult {
    std::string path;  ///< absolute
    ImportSettings import;
    std::shared_ptr<const FeResult> fe;  ///< null: none is open
};

/// What is to be opened, and how.
struct CaseRequest {
    std::string path;                     ///< of a case or an FE result, recognised by content
    std::optional<Case> theCase;          ///< set: this case in memory; its inputs are relative to `path`, which need not exist
    std::optional<std::string> scenario;  ///< of a case, by id or name; unset: the one that is worked on, else the first
    /// Keys and texts as setParameterText() takes them, applied to the scenario in this order.
    std::vector<std::pair<std::string, std::string>> settings;
    std::optional<std::string> terrain;                       ///< file in place of the terrain of the case; surroundings stay
    CloudRequest terrainRead;                                 ///< of a terrain that is a cloud, in place of what the case states
    std::optional<std::vector<std::uint16_t>> groundClasses;  ///< in place of those of the site of the case
    std::optional<Vec3> meshOffset;                           ///< m, in place of the offsets of all surroundings of the case
    bool cached = false;                                      ///< FE results through compressed copies in the cache folder
    std::optional<std::size_t> stateBytes;                    ///< bytes of FE states kept in memory at most; unset: as usual
    OpenResult open;
    /// A case whose inputs cannot be read is opened without them; OpenedCase::failure then says why.
    bool evenWithoutInputs = false;
};

/// One scenario of a case, or an FE result by itself, with everything that it stands on.
struct OpenedCase {
    Case theCase;            ///< as in its file; around an FE result: one scenario, "As computed"
    std::string casePath;    ///< as it was asked for; empty: an FE result by itself
    std::string base;        ///< file that the inputs of the case are relative to
    std::string scenarioId;  ///< of the case
    std::string scenarioName;
    Scenario scenario;               ///< with the settings that were asked for
    Inputs inputs;                   ///< without FE result if it could not be read
    std::string fePath;              ///< absolute
    TerrainInput terrain;            ///< as read; its grid is that of `inputs`, null without one
    std::vector<std::string> files;  ///< everything that was read: never written over
    double openSeconds = 0.0;        ///< wall time of opening the FE result
    std::exception_ptr failure;      ///< why the inputs could not be read; null: they were
};

/// Opens a scenario of a case, or an FE result. A scenario that names no FE input stands on the first of the case. A terrain or
/// surroundings that debris falls on and that cannot be read are failures, not level ground.
/// Throws UsageError (no such scenario, input or setting), what loadCase(), openFe() and openSiteOfCase() throw, and Cancelled.
OpenedCase openCase(const CaseRequest& request, const Execution& execution);

/// Of opening, without those of the FE result: inputs that are other files than the case names, and those of the site.
Findings openingFindings(const OpenedCase& opened);

/// Of opening, of the FE result and of every part of the results, in the order data flows; one row for each kind.
Findings allFindings(const OpenedCase& opened, const Results& results);

/// Where a run of this scenario comes from: files with SHA-256, site, frame, settings, build and fingerprint.
/// The FE result must have been read.
RunOrigin originOf(const OpenedCase& opened);
/// The same with other settings of the scenario, and another name.
RunOrigin originOf(const OpenedCase& opened, const Scenario& scenario, const std::string& scenarioName);

}  // namespace rubble::io
