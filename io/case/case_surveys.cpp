#include "io/case/case_surveys.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/evidence/evidence_list.h"
#include "io/base/delimited_table.h"
#include "io/fe/meshes/ply_header.h"
#include "io/fe/meshes/raw_mesh_file.h"
#include "io/site/cause_evidence.h"
#include "io/site/clouds/height_source.h"
#include "io/site/clouds/point_cloud.h"
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
    return inputs.size() - 1;
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
