#include "io/json/run_behind.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/base/embedded_text.h"
#include "io/base/files.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t provenanceMost = 64 * 1024 * 1024;  // bytes; larger is none

/// What a provenance says of its run; a figure of the FE result alone names one that was not simulated.
std::string fingerprintIn(const std::string& text, const std::string& path) {
    const nlohmann::json about = parseJson(text, path);
    const auto found = about.is_object() ? about.find("fingerprint") : about.end();
    const bool named = about.is_object() && about.contains("build") && found != about.end() && found->is_string();
    const auto simulated = named ? about.find("simulated") : about.end();
    if (!named || (simulated != about.end() && *simulated == false)) {
        return {};
    }
    return found->get<std::string>();
}

}  // namespace

std::string runBehind(const std::string& path) {
    const std::string sidecar = path + ".provenance.json";
    std::error_code ignored;
    if (!fs::is_regular_file(sidecar, ignored) || fs::file_size(sidecar, ignored) > provenanceMost) {
        return {};
    }
    try {
        return fingerprintIn(contentOf(sidecar).value_or(std::string()), sidecar);
    } catch (const Error&) {
        return {};  // nothing rests on it
    }
}

std::string runWithin(const std::string& path) {
    try {
        const std::string text = embeddedProvenance(path);
        return text.empty() ? runBehind(path) : fingerprintIn(text, path);
    } catch (const Error&) {
        return {};
    }
}

std::string fingerprintOf(std::string_view text) {
    const bool hex = text.size() == fingerprintDigits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
    return hex ? std::string(text) : std::string();
}

void noteRunBehind(Findings& findings, const std::string& path, const std::string& behind, const std::string& held) {
    if (behind.empty()) {
        return;
    }
    const Message remedy{
        "evidence.of_run.remedy", "Take it out of the evidence; what it agrees with says nothing of a collapse.", {}};
    if (behind == held) {
        findings.add({"evidence.of_this_run", "The evidence was made from the very run that it is held against", {}}, remedy, path);
    } else {
        constexpr std::size_t figures = 16;  // tell one run from another
        findings.add({"evidence.of_run", "The evidence was made from a simulated run, {0}", {behind.substr(0, figures)}}, remedy,
                     path);
    }
}

}  // namespace rubble::io
