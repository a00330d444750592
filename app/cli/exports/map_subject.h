#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/health_output.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/session.h"
#include "app/cli/frame/temporary_run.h"
#include "core/base/finding.h"
#include "core/pipeline/pipeline.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// The run that the operand names, or that was made of the case or FE file that it names, with its inputs.
struct MapSubject {
    std::unique_ptr<TemporaryRun> temporary;  ///< null: the run was recorded before
    std::string path;                         ///< as the run was named; empty: it was made here
    std::shared_ptr<io::RunReader> run;
    Inputs inputs;
    Findings findings;
    std::optional<double> instant{};  ///< s, of what was made; unset: the last one
};

/// The run of a file; null if the file is none. Throws what reading a run throws.
std::shared_ptr<io::RunReader> runAt(const std::string& path);

/// Opens a run, or simulates a case or FE file. Throws UsageError for settings of a run that is recorded already, and what opening
/// and simulating throw.
MapSubject openMapSubject(const Arguments& arguments, Session& session);

/// Says what was made of a run: its JSON, or its tables with the files written and the findings. Warns of a tainted run.
void conclude(const Arguments& arguments, Session& session, const MapSubject& subject, const Findings& findings,
              const std::function<Json()>& json, const std::function<void(std::ostream&)>& tables);

}  // namespace rubble::cli
