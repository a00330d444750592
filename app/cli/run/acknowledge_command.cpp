#include "app/cli/frame/arguments.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/health_output.h"
#include "core/base/error.h"

namespace rubble::cli {

namespace {

ExitCode acknowledgeRun(const Arguments& arguments, Session& session) {
    const std::string& path = arguments.operand();
    io::acknowledge(path, {arguments.value("--by").value_or(""), {}, arguments.value("--note").value_or(""), {}});
    const std::shared_ptr<io::RunReader> run = io::openRun(path);
    const io::Taint taint = io::taintOf(*run);
    if (arguments.json()) {
        Json object;
        object["run"] = path;
        object["sidecar"] = io::acknowledgementPath(path);
        object["tainted"] = taint.tainted();
        object["acknowledged"] = acknowledgedJson(taint);
        object["health"] = healthJson(*run->result());
        printJson(session, object);
        return ExitCode::Ok;
    }
    printHealth(session.out(), *run->result(), taint);
    session.out() << "  " << io::acknowledgementPath(path) << '\n';
    return ExitCode::Ok;
}

}  // namespace

Command acknowledgeCommand() {
    return {"acknowledge",
            "RUN",
            "say that a run with health breaches may be used all the same",
            "A run in which the health monitor found breaches is tainted until someone acknowledges them. The acknowledgement lies "
            "beside the run, in RUN.h5.acknowledged.json; the run file itself is not changed.",
            {{"--by", "NAME", false, "who has looked at the breaches"},
             {"--note", "TEXT", false, "why the run may be used all the same"}},
            acknowledgeRun};
}

}  // namespace rubble::cli
