#include "io/exports/compared_causes.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/json/findings_json.h"

namespace rubble::io {

namespace {

using nlohmann::json;

BlindShare shareFrom(const json& from) {
    return {from.at("trials").get<std::int64_t>(), from.at("right").get<std::int64_t>(), from.at("wrong").get<std::int64_t>()};
}

FurtherEvidence furtherFrom(const json& from) {
    FurtherEvidence further;
    const auto kind = from.at("kind").get<std::string>();
    for (const EvidenceKind each : {EvidenceKind::Footprint, EvidenceKind::Heights, EvidenceKind::Photograph, EvidenceKind::Time}) {
        further.kind = kind == evidenceKindName(each) ? each : further.kind;
    }
    if (const json& part = from.at("part_m"); !part.is_null()) {
        further.part = Eigen::AlignedBox2d(Eigen::Vector2d(part.at(0).get<double>(), part.at(1).get<double>()),
                                           Eigen::Vector2d(part.at(2).get<double>(), part.at(3).get<double>()));
    }
    if (const json& place = from.at("from_m"); !place.is_null()) {
        further.from = Eigen::Vector2d(place.at(0).get<double>(), place.at(1).get<double>());
    }
    // Rankings of earlier versions know no times.
    if (const auto accuracy = from.find("accuracy_s"); accuracy != from.end() && !accuracy->is_null()) {
        further.accuracy = accuracy->get<double>();
    }
    further.named = shareFrom(from);
    return further;
}

ReportCauses causesFrom(const json& from, const std::string& path) {
    ReportCauses causes;
    causes.toldApart = from.at("told_apart").get<bool>();
    causes.unexplained = from.at("unexplained").get<bool>();
    for (const json& evidence : from.at("evidence")) {
        causes.evidence.push_back(evidence.at("name").get<std::string>());
    }
    for (const json& row : from.at("ranking")) {
        ReportCause& cause = causes.ranked.emplace_back();
        cause.name = row.at("cause").get<std::string>();
        cause.members = row.at("score").at("members").get<std::int64_t>();
        if (const json& over = row.at("closest_over_it"); !over.is_null()) {
            cause.closestOver = {over.at("share").get<double>(), over.at("low").get<double>(), over.at("high").get<double>()};
            cause.apart = row.at("told_apart").get<bool>();
        }
    }
    if (const auto further = from.find("further_evidence"); further != from.end() && !further->is_null()) {
        if (const json& atHand = further->at("at_hand"); !atHand.is_null()) {
            causes.atHand = shareFrom(atHand);
        }
        for (const json& row : further->at("ranked")) {
            causes.further.push_back(furtherFrom(row));
        }
    }
    // Comparisons of earlier versions have none in a form that is said in other languages.
    if (const auto findings = from.find("findings"); findings != from.end()) {
        const json text = json::parse(findings->get<std::string>());
        const Findings said = findingsFromJson(JsonCursor(text, path, "findings"));
        for (const Finding& finding : said.list()) {
            causes.findings.push_back(finding.what);
        }
    }
    if (causes.ranked.empty()) {
        throw json::other_error::create(599, "no cause is ranked", nullptr);
    }
    return causes;
}

}  // namespace

ReportCauses readComparedCauses(const std::string& path) {
    const std::optional<std::string> content = contentOf(path);
    if (!content) {
        failToRead(path);
    }
    try {
        return causesFrom(json::parse(*content), path);
    } catch (const json::exception& error) {
        throw ParseError(
            {"report.causes", "{0} is not what rubble-cli compare --json prints of causes and evidence: {1}", {path, error.what()}},
            {"report.causes.remedy", "Make it anew: rubble-cli compare --json.", {}});
    }
}

std::string findingsOfCauses(const Findings& findings) {
    return findingsJson(findings).dump(-1, ' ', true, json::error_handler_t::replace);
}

}  // namespace rubble::io
