#include "app/cli/evidence/placed_survey.h"

#include <numbers>

#include "app/cli/frame/option_value.h"
#include "app/cli/frame/text_output.h"
#include "core/base/message.h"
#include "io/case/case_file.h"
#include "io/site/site_place.h"

namespace rubble::cli {

namespace {

constexpr double degreesOf = 180.0 / std::numbers::pi;

std::string waysText(const Registration& registration) {
    std::string text;
    if (registration.pairs > 0) {
        text += " by " + englishInteger(registration.pairs) + " pairs (RMS " + englishNumber(registration.pairsLeft) + " m)";
    }
    if (registration.fitted > 0) {
        text += std::string(text.empty() ? "" : ", then") + " by a fit to what did not move (RMS " +
                englishNumber(registration.fitBefore) + " m before, " + englishNumber(registration.fitLeft) + " m after)";
    }
    return text;
}

}  // namespace

Option evidenceCaseOption() {
    return {"--case", "CASE", false, "of a run: the case that says when the survey was taken, what counts of it and how it lies"};
}

Option pairsErrorOption(std::string_view unit) {
    return {
        "--pairs-error", unit, false,
        "standard deviation of the control points themselves along each axis, where the table has no column deviation_m (default: "
        "not known, and not in the error)"};
}

std::optional<double> pairsErrorFrom(const Arguments& arguments) {
    return arguments.has("--pairs-error") ? std::optional(parseLength(arguments, "--pairs-error", 0.0, true)) : std::nullopt;
}

std::string caseOfEvidence(const Arguments& arguments) {
    return io::isCaseFile(arguments.operand()) ? arguments.operand() : arguments.value("--case").value_or("");
}

Json registrationJson(const std::optional<Registration>& registration) {
    if (!registration) {
        return {};
    }
    const auto three = [](const Vec3& of, double by) { return Json{by * of.x(), by * of.y(), by * of.z()}; };
    const bool fitted = registration->fitted > 0;
    return {{"shift_m", three(registration->shift, 1.0)},
            {"turn_deg", three(registration->turn, degreesOf)},
            {"about_m", three(registration->about, 1.0)},
            {"pairs", registration->pairs},
            {"pairs_rms_m", registration->pairs > 0 ? Json(registration->pairsLeft) : Json()},
            {"control_error_m", registration->control ? Json(*registration->control) : Json()},
            {"fitted_points", registration->fitted},
            {"fit_rms_before_m", fitted ? Json(registration->fitBefore) : Json()},
            {"fit_rms_m", fitted ? Json(registration->fitLeft) : Json()},
            {"error_m", registration->error ? Json(*registration->error) : Json()}};
}

std::string placedText(const Frame& frame, const Site& site, const std::optional<Registration>& registration) {
    std::string text(io::SitePlace(frame, site).words());
    if (!registration) {
        return text + "; no registration";
    }
    text += "; then moved by " + englishNumber(registration->shift.norm()) + " m and turned by " +
            englishNumber(degreesOf * registration->turn.norm()) + " degrees" + waysText(*registration);
    text += ", a place is known to " +
            (registration->error ? englishNumber(*registration->error) + " m" : std::string("an error that is not known"));
    if (registration->control) {
        return text + ", of which the control points themselves " + englishNumber(*registration->control) + " m";
    }
    return text + (registration->pairs > 0 ? "; how accurate the control points are nobody stated: it is not in it" : "");
}

}  // namespace rubble::cli
