#pragma once

#include <string>
#include <vector>

#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "io/exports/report_facts.h"

namespace rubble::cli {

/// How a report is made, whichever run it is of, as given by --repeats, --language and --self-test.
struct ReportMaking {
    static std::vector<Option> options();
    /// Throws UsageError for a value that is not one of those offered.
    explicit ReportMaking(const Arguments& arguments);

    int repeats = 2;
    std::string language = "en";           ///< "en", "zh_CN"
    std::string selfTest = "closed-form";  ///< "all", "closed-form", "none"
};

/// A report as it was written.
struct WrittenReport {
    ReportFacts facts;
    std::vector<std::string> files;
    Findings lacks;
};

/// Writes a report with its self-test into a folder; starts a virtual display where none answers. Throws what io::reportFacts(),
/// drawing and writing throw.
WrittenReport writeReport(const std::string& folder, const io::ReportRequest& request, const RunSurroundings& around,
                          const ReportMaking& making, Session& session);

}  // namespace rubble::cli
