#include "app/cli/evidence/scope_options.h"

#include "io/site/survey_file.h"

namespace rubble::cli {

namespace {

Outline polygonsOf(const std::vector<std::string>& paths, const Frame& frame, const Site& site, Findings& findings,
                   const Execution& execution) {
    Outline all;
    for (const std::string& path : paths) {
        const Outline read = io::readScope(path, frame, site, findings, execution);
        all.polygons.insert(all.polygons.end(), read.polygons.begin(), read.polygons.end());
    }
    return all;
}

}  // namespace

Option areaOption() {
    return {"--area", "FILE", true,
            "polygons of the area of interest: nothing beyond it is compared (default: all that was surveyed)"};
}

Option leaveOutOption() {
    return {"--leave-out", "FILE", true, "polygons that are left out: vehicles, trees, what rescuers moved"};
}

SurveyScope scopeFrom(const Arguments& arguments, const Frame& frame, const Site& site, Findings& findings,
                      const Execution& execution) {
    return {polygonsOf(arguments.values("--area"), frame, site, findings, execution),
            polygonsOf(arguments.values("--leave-out"), frame, site, findings, execution)};
}

}  // namespace rubble::cli
