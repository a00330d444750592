#include "io/case/case_photographs.h"

#include <algorithm>
#include <filesystem>

namespace rubble::io {

namespace fs = std::filesystem;

std::optional<std::string> addPhotograph(Case& theCase, const std::string& casePath, const std::string& path,
                                         const PhotoFacts& facts, const std::string& sha256) {
    std::vector<CaseInput>& inputs = theCase.inputs;
    const auto any = [&](const auto& is) { return std::any_of(inputs.begin(), inputs.end(), is); };
    if (any([&](const CaseInput& input) { return input.role == InputRole::Photograph && input.sha256 == sha256; })) {
        return std::nullopt;
    }
    int number = 1;
    std::string id = "photograph-1";
    while (any([&](const CaseInput& input) { return input.id == id; })) {
        id = "photograph-" + std::to_string(++number);
    }
    const fs::path folder = fs::absolute(casePath).parent_path().lexically_normal();
    const fs::path relative = fs::absolute(path).lexically_normal().lexically_proximate(folder);
    inputs.push_back({id, InputRole::Photograph, relative.generic_string(), sha256});
    Photograph& added = theCase.photographs.emplace_back();
    added.input = id;
    added.facts = facts;
    added.camera.width = facts.width;
    added.camera.height = facts.height;
    added.camera.freePrincipal = cropped(facts);
    return id;
}

}  // namespace rubble::io
