#include "io/case/case_surveys.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/base/error.h"
#include "core/evidence/evidence_list.h"
#include "io/base/delimited_table.h"
#include "io/case/case_file.h"
#include "io/fe/meshes/ply_header.h"
#include "io/fe/meshes/raw_mesh_file.h"
#include "io/site/cause_evidence.h"
#include "io/site/clouds/height_source.h"
#include "io/site/clouds/point_cloud.h"
#include "io/site/clouds/run_scan.h"
#include "io/site/input_files.h"
#include "io/site/outline_file.h"
#include "io/site/surveys/measured_points.h"

namespace rubble::io {

namespace {

/// Whether rows of three numbers or more stand in a table; a page of text has none.
bool holdsNumbers(const std::string& path) {
    try {
        const DelimitedTable table = readDelimitedStart(path, 4);
        return std::any_of(table.rows.begin(), table.rows.end(), [&](const DelimitedRow& row) {
            return std::count_if(row.fields.begin(), row.fields.end(),
                                 [&](const std::string& field) { return table.numberIn(field).has_value(); }) > 2;
        });
    } catch (const Error&) {
        return false;  // what is wrong with it is said where it is read
    }
}

/// [SurveyKind] What a name told otherwise.
Message otherKind(SurveyKind found) {
    const std::array<Message, surveyKindNames.size()> said{
        {{"evidence.other_kind", "the ending of its name says otherwise, but this file holds heights", {}},
         {"evidence.other_kind", "the ending of its name says otherwise, but this file holds a point cloud", {}},
         {"evidence.other_kind", "the ending of its name says otherwise, but this file holds an outline", {}},
         {"evidence.other_kind", "the ending of its name says otherwise, but this file holds measured points", {}}}};
    return said[static_cast<std::size_t>(found)];
}

}  // namespace

SurveyKind surveyKindOf(const std::string& path, const CloudRequest& read) {
    if (holdsMeasuredPoints(path)) {
        return SurveyKind::Points;
    }
    if (holdsOutline(path)) {
        return SurveyKind::Outline;
    }
    return holdsCloud(path, read) ? SurveyKind::Cloud : SurveyKind::Heights;
}

std::size_t takeSurvey(Case& theCase, const std::string& casePath, const std::string& path) {
    namespace fs = std::filesystem;
    std::vector<CaseInput>& inputs = theCase.inputs;
    if (const CaseInput* known = surveyOfFile(theCase, casePath, path)) {
        CaseInput& again = inputs[static_cast<std::size_t>(known - inputs.data())];
        again.kind = again.kind ? again.kind : surveyKindOf(path, again.read);
        return static_cast<std::size_t>(known - inputs.data());
    }
    const std::string sha256 = digestOfInput(path, InputRole::Survey, Execution()).sha256;
    const auto taken = [&](const std::string& id) {
        return std::any_of(inputs.begin(), inputs.end(), [&](const CaseInput& input) { return input.id == id; });
    };
    int number = 1;
    while (taken("survey-" + std::to_string(number))) {
        ++number;
    }
    const fs::path folder = fs::absolute(casePath).parent_path().lexically_normal();
    const fs::path relative = fs::absolute(path).lexically_normal().lexically_proximate(folder);
    inputs.push_back({"survey-" + std::to_string(number), InputRole::Survey, relative.generic_string(), sha256});
    inputs.back().kind = surveyKindOf(path, {});
    if (inputs.back().kind == SurveyKind::Cloud) {
        inputs.back().instant = scannedInstant(path, {});
    }
    return inputs.size() - 1;
}

std::vector<NamedPoint> controlPointsOfCase(const Case& theCase, const std::string& casePath, const SitePlace& place,
                                            Findings& findings, const Execution& execution) {
    std::vector<NamedPoint> all;
    for (const CaseInput& input : theCase.inputs) {
        if (input.role != InputRole::Survey || input.held != PointsHeld::Control) {
            continue;
        }
        const std::string path = inputPath(casePath, input);
        std::int64_t twice = 0;
        for (NamedPoint& point : readNamedPoints(path, findings, execution)) {
            const bool known = std::any_of(all.begin(), all.end(), [&](const NamedPoint& each) { return each.name == point.name; });
            if (known) {
                ++twice;
            } else {
                if (input.registration) {
                    point.place = place.toWorld((*input.registration)(place.toLocal(point.place)));
                }
                all.push_back(std::move(point));
            }
        }
        if (twice > 0) {
            findings.add({"control.of_another_file", "points have the name of a point of another file; that one counts", {}},
                         {"control.of_another_file.remedy", "hold one of the files as control, or rename its points", {}}, path,
                         twice);
        }
    }
    return all;
}

Findings checkKind(const CaseInput& survey, const std::string& path) {
    Findings findings;
    std::error_code ignored;
    if (survey.kind || !std::filesystem::is_regular_file(path, ignored)) {
        return findings;
    }
    CaseInput found = survey;
    found.kind = surveyKindOf(path, survey.read);
    if (evidenceFormOf(found) != evidenceFormOf(survey)) {
        findings.add(otherKind(*found.kind),
                     {"evidence.other_kind.remedy", "let the case keep what it holds: add the same file once more", {}}, path);
    }
    return findings;
}

void stateReading(CaseInput& survey, const std::string& path, const CloudRequest& read) {
    if (!read.empty()) {
        openCloud(path, read);
    }
    const SurveyKind kind = surveyKindOf(path, read);
    if (!read.empty() && kind != SurveyKind::Cloud && kind != SurveyKind::Points) {
        refuseRequestOfNoCloud(path);
    }
    survey.read = read;
    if (survey.role == InputRole::Survey) {
        survey.kind = kind;
        survey.held = kind == SurveyKind::Points ? survey.held : PointsHeld::Section;
    }
}

OpenReading readingLeftOpen(const CaseInput& survey, const std::string& path, const Frame& frame) {
    if (evidenceFormOf(survey) != EvidenceForm::Cloud) {
        // A table of which nobody knows the columns is read by nothing, so it is called heights.
        CaseInput byEnding = survey;
        byEnding.kind.reset();
        return {false, survey.kind == SurveyKind::Heights && evidenceFormOf(byEnding) == EvidenceForm::Cloud && holdsNumbers(path)};
    }
    if (isMeshPath(path) && !isPlyOfPoints(path)) {
        return {};
    }
    try {
        const std::unique_ptr<PointCloud> cloud = openCloud(path, survey.read);
        return {cloud->head().crs.empty() && !frame.crs.empty(), cloud->findings().count("cloud.columns_assumed") > 0};
    } catch (const Error&) {
        return {};  // what is wrong with it is said where it is read
    }
}

}  // namespace rubble::io
