#include "app/cli/frame/json_output.h"

namespace rubble::cli {

void printJson(Session& session, const Json& object) {
    session.out() << object.text() << '\n';
}

Json findingsJson(const Findings& findings, const std::function<std::string(const Message&)>& say) {
    Json list = Json::array();
    for (const Finding& finding : findings.list()) {
        Json row;
        row["id"] = finding.what.id;
        row["count"] = finding.count;
        row["what"] = say(finding.what);
        row["example"] = finding.example;
        row["remedy"] = say(finding.remedy);
        list.push_back(std::move(row));
    }
    return list;
}

Json findingsJson(Findings findings, const std::optional<Finding>& more) {
    if (more) {
        findings.add(more->what, more->remedy, more->example, more->count);
    }
    return findingsJson(findings);
}

void addSizingJson(Json& object, const Sizing& sizing) {
    object["grid"]["l"] = sizing.grid.l;
    object["grid"]["w"] = sizing.grid.w;
    object["grid"]["h"] = sizing.grid.h;
    object["multiple"] = axesJson(sizing, [](const AxisSizing& a) { return Json(a.multiple); });
    object["common_multiple"] = sizing.commonMultiple;
    object["mean_distance"] = axesJson(sizing, [](const AxisSizing& a) { return Json(a.meanDistance); });
    object["bounds"] = axesJson(sizing, [](const AxisSizing& a) {
        Json bounds;
        bounds["h_eff_min"] = a.efficiencyMin;
        bounds["h_acc_min"] = a.accuracyMin;
        bounds["h_acc_max"] = a.accuracyMax;
        return bounds;
    });
    object["awake_at_once"] = sizing.awake;
    object["stopped_by"] = stoppedByName(sizing.stoppedBy);
    object["clamped_by"] = axesJson(sizing, [](const AxisSizing& a) { return Json(clampedByName(a.clampedBy)); });
    object["fps_target"] = sizing.fpsTarget;
    object["bodies_max"] = sizing.bodiesMax;
    if (sizing.stoppedBy == StoppedBy::FpsUnreachable) {
        object["fps_reachable"] = sizing.reachableFps;
    } else {
        object["fps_reachable"] = nullptr;
    }
}

}  // namespace rubble::cli
