#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace rubble {

/// What a survey is moved by before it is compared.
enum class SurveyFit {
    None,    ///< it lies where it was surveyed
    Ground,  ///< to the ground beside the debris: errors of its place go, differences of the debris stay
    Debris,  ///< to the debris in plan: what then differs is the shape, no longer the place
};

/// Their names in files and on the command line, in their order.
inline constexpr std::array<std::string_view, 3> surveyFitNames{"none", "ground", "debris"};
constexpr std::string_view surveyFitName(SurveyFit fit) {
    return surveyFitNames[static_cast<std::size_t>(fit)];
}
/// Unset: none is called so.
std::optional<SurveyFit> surveyFitNamed(std::string_view name);

/// How the evidence of a case is held against its runs, where nothing else is asked for.
struct EvidenceSettings {
    double cell = 0.5;         ///< m, of surveys
    double leastHeight = 0.2;  ///< m above the ground from which a surveyed height is debris
    SurveyFit fit = SurveyFit::None;
    bool surveysWithFallen = true;      ///< fallen live structure is debris to a survey
    bool photographsWithFallen = true;  ///< and to a photograph
    friend bool operator==(const EvidenceSettings&, const EvidenceSettings&) = default;
};

}  // namespace rubble
