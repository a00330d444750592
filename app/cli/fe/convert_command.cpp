#include <filesystem>

#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_output.h"
#include "io/exports/convert/fe_conversion.h"

namespace rubble::cli {

namespace {

ExitCode convert(const Arguments& arguments, Session& session) {
    const std::string& path = arguments.operand(1);
    checkOutputPath(path, std::vector<std::string>{arguments.operand()});
    const io::OpenedCase subject = openSubject(arguments, session);
    const FeResult& fe = *subject.inputs.fe;
    const io::Conversion made = io::convertFe(fe, subject.inputs.frame, path, arguments.has("--force"), session.execution());
    const Findings findings = io::allFindings(subject, {});
    if (arguments.json()) {
        Json object;
        object["fe"] = {{"path", subject.fePath}, {"sha256", fe.contents().sha256}};
        object["from"] = fe.contents().format;
        object["to"] = conversionName(made.target);
        object["states"] = made.states;
        object["written"] = made.files;
        object["written_bytes"] = made.bytes;
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
        return ExitCode::Ok;
    }
    for (const std::string& file : made.files) {
        session.out() << file << '\n';
    }
    session.out() << conversionName(made.target) << " of " << englishInteger(static_cast<std::int64_t>(made.states)) << " states, "
                  << englishInteger(static_cast<std::int64_t>(made.bytes)) << " bytes, from " << fe.contents().format << '\n';
    printFindings(session.out(), findings);
    return ExitCode::Ok;
}

}  // namespace

Command convertCommand() {
    return {"convert",
            "FE|CASE OUT",
            "an FE result in another format, deaths kept",
            "OUT ends in .exo (Exodus II), .pvd (a series of VTU files for ParaView) or .h5 (a copy that opens at once). The "
            "terrain of "
            "a case is not part of it.",
            {setOption(), scenarioOption(), {"--force", "", false, "replace OUT if it is there"}, cachedOption()},
            convert};
}

}  // namespace rubble::cli
