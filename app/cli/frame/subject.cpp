#include "app/cli/frame/subject.h"

#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"

namespace rubble::cli {

io::CaseRequest caseRequest(const Arguments& arguments, const std::string& path) {
    io::CaseRequest request;
    request.path = path;
    request.scenario = arguments.value("--scenario");
    for (const std::string& setting : arguments.values("--set")) {
        request.settings.push_back(splitAssignment("--set", setting));
    }
    request.terrain = arguments.value("--terrain");
    request.groundClasses = parseClasses(arguments, "--ground-class");
    takeCloudRequest(arguments, request.terrainRead, terrainColumns, terrainSystem);
    request.meshOffset = parsePlace(arguments, "--mesh-offset");
    request.cached = arguments.has("--cached");
    return request;
}

io::OpenedCase openSubject(const Arguments& arguments, Session& session) {
    return io::openCase(caseRequest(arguments, arguments.operand()), session.execution());
}

Results runTo(const io::OpenedCase& subject, Stage last, TrajectorySink* sink, const Execution& execution,
              CheckpointStore* checkpoints) {
    Results opened;
    opened.wallSeconds[static_cast<std::size_t>(Stage::Import)] = subject.openSeconds;
    return run(subject.inputs, subject.scenario, last, opened, sink, execution, checkpoints);
}

}  // namespace rubble::cli
