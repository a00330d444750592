#include "io/site/cause_evidence.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/base/error.h"
#include "core/evidence/surveys/stated_survey.h"
#include "io/site/clouds/run_scan.h"
#include "io/site/evidence_surface.h"

namespace rubble::io {

std::string_view evidenceKeyword(EvidenceFile::Kind kind) {
    static constexpr std::array<std::string_view, 4> names{"footprint", "height", "surface", "survey"};
    return names[static_cast<std::size_t>(kind)];
}

SurfaceEvidence readEvidence(const EvidenceFile& file, const EvidenceSite& site, const CaseInput& stated,
                             const SurfaceSettings& settings, Findings& findings, const Execution& execution) {
    checkShowsRest(stated);
    SurveyRequest request;
    request.holds = file.kind == EvidenceFile::Kind::Footprint ? SurveyRequest::Holds::Outline
                    : file.kind == EvidenceFile::Kind::Survey  ? SurveyRequest::Holds::Either
                                                               : SurveyRequest::Holds::Heights;
    request.aboveGround = file.kind == EvidenceFile::Kind::Heights;
    request.withFallen = settings.withFallen;
    request.ground = site.groundFile;
    request.groundRead = site.groundRead;
    request.registration = stated.registration;
    request.read = stated.read;
    request.edge = stated.held == PointsHeld::Outline;
    const SurveyInput survey = readSurvey(file.path, site.frame, site.site, Aabb(), execution, request);
    findings.append(survey.findings);
    return surfaceEvidence(survey, stated, settings.cell, site.ground, execution);
}

const CaseInput* surveyOfFile(const Case& theCase, const std::string& casePath, const std::string& file) {
    const std::filesystem::path folder = std::filesystem::absolute(casePath).parent_path();
    const auto found = std::find_if(theCase.inputs.begin(), theCase.inputs.end(), [&](const CaseInput& input) {
        std::error_code ignored;
        return input.role == InputRole::Survey && std::filesystem::equivalent(folder / input.path, file, ignored);
    });
    return found != theCase.inputs.end() ? &*found : nullptr;
}

std::optional<double> instantOfScan(const std::string& file, Findings& findings) {
    const std::optional<double> instant = scannedInstant(file, {});
    if (instant) {
        findings.add({"survey.scanned_instant",
                      "the scan says that it shows the run at {0}: the run is taken at that instant",
                      {{*instant, "s"}}},
                     {"survey.scanned_instant.remedy", "say another instant if it is of another one", {}}, file);
    }
    return instant;
}

CaseInput statedOfFile(const Case& theCase, const std::string& casePath, const std::string& file, const SurveyScope& given,
                       Findings& findings) {
    const CaseInput* survey = surveyOfFile(theCase, casePath, file);
    CaseInput stated;
    stated.path = file;
    if (survey != nullptr) {
        stated = *survey;
        checkShowsDebris(*survey);
    } else {
        stated.instant = instantOfScan(file, findings);
    }
    if (!given.whole()) {
        stated.scope = given;
    }
    stated.scope = scopeWhenTaken(theCase, stated, findings);
    return stated;
}

std::vector<PhotoEvidence> photographsAsEvidence(const Case& theCase, Findings& findings, const Execution& execution) {
    std::vector<PhotoEvidence> usable;
    for (const Photograph& photograph : theCase.photographs) {
        const auto input = std::find_if(theCase.inputs.begin(), theCase.inputs.end(),
                                        [&](const CaseInput& each) { return each.id == photograph.input; });
        const std::string name = input != theCase.inputs.end() ? input->path : photograph.input;
        const bool drawn = std::any_of(photograph.masks.begin(), photograph.masks.end(),
                                       [](const PhotoMask& mask) { return mask.kind == MaskClass::Debris; });
        if (!drawn || photograph.time) {
            findings.add(
                {"causes.photo_left_out", "A photograph is left out: no outline is drawn on it, or it was not taken at rest.", {}},
                {"causes.photo_left_out.remedy",
                 "Members keep their debris at rest; draw around the debris on photographs of it.",
                 {}},
                name);
            continue;
        }
        try {
            usable.push_back({name, photograph, matchPhotograph(photograph, execution)});
        } catch (const UsageError& error) {
            findings.add(error.message(), error.remedy(), name);
        }
    }
    return usable;
}

}  // namespace rubble::io
