#include "io/case/case_surveys.h"

#include <algorithm>
#include <filesystem>

#include "io/site/cause_evidence.h"
#include "io/site/clouds/height_source.h"
#include "io/site/input_files.h"
#include "io/site/outline_file.h"

namespace rubble::io {

SurveyKind surveyKindOf(const std::string& path, const CloudRequest& read) {
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

}  // namespace rubble::io
