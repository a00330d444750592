#include "io/run/acknowledgements.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/simulation/health/passed_limits.h"
#include "io/base/files.h"
#include "io/base/trimmed.h"
#include "io/json/json_document.h"
#include "io/run/run_json.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

// A sidecar of thousands of entries is far smaller.
constexpr JsonKind acknowledgementKind{"rubble-acknowledgements", 1, std::uintmax_t{16} << 20};

std::vector<Acknowledgement> listFrom(const std::string& path) {
    const nlohmann::json document = readJsonDocument(path, acknowledgementKind);
    const JsonCursor top(document, path);
    std::vector<Acknowledgement> list;
    for (const JsonCursor& entry : top["acknowledgements"].elements()) {
        list.push_back({entry["by"].text(), entry["when"].text(), entry["note"].text(), digestFromJson(entry["breaches"])});
    }
    return list;
}

std::string required(const std::string& text, const char* what) {
    const std::string content(trimmed(text));
    if (content.empty()) {
        throw UsageError({"io.acknowledged.empty", "An acknowledgement needs a {0}.", {what}},
                         {"io.acknowledged.empty.remedy", "Say who has looked at the breaches, and why the run may be used.", {}});
    }
    return content;
}

std::shared_ptr<const SimulationResult> breachesOf(const std::string& runPath) {
    const auto run = openRun(runPath);
    const auto result = run->result();
    if (!result) {
        throw ParseError({"io.acknowledged.incomplete", "{0} is not complete: it has no outcome to acknowledge", {runPath}},
                         {"io.run.incomplete.remedy", "Run the case again to the end.", {}});
    }
    if (result->health.breaches.empty()) {
        throw UsageError({"io.acknowledged.sound", "{0} has no health breaches: there is nothing to acknowledge", {runPath}},
                         {"io.acknowledged.sound.remedy", "Use the run as it is, or name the run that you mean.", {}});
    }
    return result;
}

}  // namespace

std::string acknowledgementPath(const std::string& runPath) {
    return runPath + ".acknowledged.json";
}

void acknowledge(const std::string& runPath, Acknowledgement acknowledgement) {
    acknowledgement.by = required(acknowledgement.by, "name");
    acknowledgement.note = required(acknowledgement.note, "note");
    acknowledgement.breaches = breachesDigest(*breachesOf(runPath));
    if (acknowledgement.when.empty()) {
        acknowledgement.when = utcNow();
    }
    std::vector<Acknowledgement> list = acknowledgements(runPath);
    list.push_back(std::move(acknowledgement));
    nlohmann::json document = {{"format", acknowledgementKind.format},
                               {"version", acknowledgementKind.version},
                               {"run", fs::path(runPath).filename().string()},
                               {"acknowledgements", nlohmann::json::array()}};
    for (const Acknowledgement& entry : list) {
        document["acknowledgements"].push_back(
            {{"by", entry.by}, {"when", entry.when}, {"note", entry.note}, {"breaches", entry.breaches.hex()}});
    }
    writeAtomically(acknowledgementPath(runPath), [&](std::ostream& out) { out << jsonText(document) << '\n'; });
}

std::vector<Acknowledgement> acknowledgements(const std::string& runPath) {
    const std::string path = acknowledgementPath(runPath);
    std::error_code failed;
    if (!fs::exists(fs::symlink_status(path, failed))) {
        return {};
    }
    return listFrom(path);
}

Taint taintOf(std::span<const HealthBreach> breaches) {
    Taint taint;
    taint.limits = passedLimits(breaches).size();
    taint.grade = gravestGrade(breaches);
    return taint;
}

Taint taintOf(const RunReader& run) {
    Taint taint = taintOf(run.breaches());
    const auto result = run.result();
    taint.complete = result != nullptr;
    if (!result || taint.limits == 0) {
        return taint;
    }
    try {
        const std::vector<Acknowledgement> list = acknowledgements(run.path());
        if (const Acknowledgement* found = acknowledgementOf(*result, list)) {
            taint.acknowledgement = *found;
        }
    } catch (const Error& error) {
        taint.problem = error.message();
    }
    return taint;
}

}  // namespace rubble::io
