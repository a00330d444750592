#include <cmath>

#include "app/cli/evidence/camera_output.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "io/site/point_pairs.h"

namespace rubble::cli {

namespace {

double parseFinite(std::string_view option, const std::string& text) {
    double number = 0.0;
    if (!parseNumber(text, number) || !std::isfinite(number)) {
        throw wrongValue(option, text, "a number with a point as decimal sign");
    }
    return number;
}

CameraKnowledge parseKnowledge(const Arguments& arguments) {
    CameraKnowledge known;
    const std::string size = arguments.value("--size").value_or("");
    const std::size_t cross = size.find('x');
    if (cross == std::string::npos || !parseNumber(std::string_view(size).substr(0, cross), known.width) ||
        !parseNumber(std::string_view(size).substr(cross + 1), known.height) || known.width < 1 || known.height < 1) {
        throw wrongValue("--size", size, "WIDTHxHEIGHT of the picture in pixels; it is needed");
    }
    if (const auto focal = arguments.value("--focal")) {
        known.focal = parseFinite("--focal", *focal);
    }
    if (const auto principal = arguments.value("--principal")) {
        if (*principal == "free") {
            known.freePrincipal = true;
        } else {
            const std::vector<std::string> parts = splitAtCommas(*principal);
            if (parts.size() != 2) {
                throw wrongValue("--principal", *principal, "X,Y in pixels, or free");
            }
            known.principal = Eigen::Vector2d(parseFinite("--principal", parts[0]), parseFinite("--principal", parts[1]));
        }
    }
    if (const auto radial = arguments.value("--radial"); radial && *radial != "auto") {
        if (*radial != "0" && *radial != "1" && *radial != "2") {
            throw wrongValue("--radial", *radial, "auto, or 0, 1 or 2: how many terms are to be found");
        }
        known.radialTerms = radial->front() - '0';
    }
    return known;
}

std::vector<PointPair> pairsOf(const Arguments& arguments, Findings& findings, const Execution& execution) {
    const std::string& path = arguments.operand();
    const auto measured = arguments.value("--points");
    if (!measured) {
        return io::readPointPairs(path);
    }
    return io::readPointPairs(path, io::readNamedPoints(*measured, findings, execution), [](const Vec3& place) { return place; });
}

ExitCode camera(const Arguments& arguments, Session& session) {
    const CameraKnowledge known = parseKnowledge(arguments);
    checkCsvPath(arguments, std::vector<std::string>{arguments.operand()});
    Findings findings;
    const std::vector<PointPair> pairs = pairsOf(arguments, findings, session.execution());
    const CameraMatch match = matchCamera(pairs, known, session.execution());
    findings.append(match.findings);
    writeCsv(arguments, residualTable(match, pairs));
    if (arguments.json()) {
        Json object = matchJson(match, pairs);
        object["warnings"] = findingsJson(findings);
        printJson(session, object);
    } else {
        printHeading(session.out(), "Camera");
        printMatch(session.out(), match, pairs);
        printFindings(session.out(), findings);
    }
    return ExitCode::Ok;
}

}  // namespace

Command cameraCommand() {
    return {"camera",
            "PAIRS.csv",
            "where a photograph was taken from, by points seen in it",
            "Finds the camera of a picture from pairs of a picture point and a point of the model or a survey, with its "
            "uncertainty, and "
            "points out pairs that look wrong.",
            {{"--points", "FILE", false,
              "where the points are: a table or DXF of a total station, by their names; the pairs then need no places"},
             {"--size", "WxH", false, "pixels of the picture; needed"},
             {"--focal", "PX", false, "focal length in pixels, if it is known (default: found)"},
             {"--principal", "X,Y|free", false, "principal point in pixels, or free to be found (default: the middle)"},
             {"--radial", "auto|0|1|2", false,
              "terms of radial distortion to be found; auto: as far as the points tell it from real lenses (default: auto)"},
             csvOption("write the residuals, one row for each pair")},
            camera};
}

}  // namespace rubble::cli
