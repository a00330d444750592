#include "app/cli/exports/run_surroundings.h"

#include <algorithm>

#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/case/site_reader.h"

namespace rubble::cli {

Option caseOption() {
    return {"--case", "CASE", false, "the case of the run, whose orthophoto and surroundings pictures then show"};
}

Case loadCaseOfRun(const std::string& path, const io::RunOrigin& origin) {
    Case theCase = io::loadCase(path);
    const bool same = std::any_of(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& input) {
        return input.role == InputRole::Fe && input.sha256 == origin.feSha256;
    });
    if (!same) {
        throw UsageError({"cli.other_case",
                          "--case {0}: none of its FE results is that of the run, whose SHA-256 is {1}.",
                          {path, origin.feSha256}},
                         {"cli.other_case.remedy", "Name the case that the run was made from.", {}});
    }
    return theCase;
}

RunSurroundings surroundingsOfRun(const io::RunOrigin& origin, const Inputs& inputs, const Arguments& arguments, Session& session) {
    const std::optional<std::string> path = arguments.value("--case");
    return path ? surroundingsOfRun(loadCaseOfRun(*path, origin), *path, origin, inputs, session) : RunSurroundings();
}

RunSurroundings surroundingsOfRun(const Case& theCase, const std::string& casePath, const io::RunOrigin& origin,
                                  const Inputs& inputs, Session& session) {
    RunSurroundings around{casePath, io::openSurroundingsOfCase(theCase, casePath, inputs.fe->mesh(), inputs.frame, origin.site,
                                                                inputs.terrain.get(), session.execution())};
    printNotes(session, around.shown.findings);
    return around;
}

}  // namespace rubble::cli
