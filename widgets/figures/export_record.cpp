#include "widgets/figures/export_record.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <numbers>

#include "widgets/render/panes.h"

namespace rubble::figures {

namespace {

std::string textOf(const QJsonObject& object) {
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString();
}

/// What the plane of a view cuts and what it leaves whole, of what is drawn.
void addCut(QJsonObject& settings, const render::View& view, const render::SceneData& data) {
    if (!view.clip) {
        return;
    }
    QJsonArray cuts{"structure"};
    if (data.fragments != nullptr) {
        cuts.append("fragments");
    }
    if (data.points != nullptr && !view.cloud.empty()) {
        cuts.append("points of the cloud");
    }
    QJsonArray whole;
    if (view.ground) {
        whole.append(data.terrain != nullptr ? "terrain" : "ground");
        if (data.surroundings != nullptr && !data.surroundings->empty()) {
            whole.append("surroundings");
        }
        if (data.waterLevel) {
            whole.append("water");
        }
    }
    settings.insert("cut", QJsonObject{{"cuts", cuts}, {"leaves_whole", whole}});
}

}  // namespace

std::string settingsText(QSize pixels, double dpi, std::optional<FigurePreset> preset, QSize panel, const render::View& view,
                         const render::SceneData& data) {
    QJsonObject settings{{"pixels", QJsonArray{pixels.width(), pixels.height()}},
                         {"dpi", dpi},
                         {"panel_pixels", QJsonArray{panel.width(), panel.height()}}};
    for (const auto& [name, each] : figurePresets) {
        if (preset == each) {
            settings.insert("preset", QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())));
        }
    }
    addCut(settings, view, data);
    return textOf(settings);
}

std::string settingsText(QSize pixels, const MovieSettings& settings, const render::View& view, const render::SceneData& data) {
    QJsonObject object{{"pixels", QJsonArray{pixels.width(), pixels.height()}}, {"fps", settings.fps}, {"pace", settings.pace}};
    QJsonArray times;
    for (const CameraKey& key : settings.cameras) {
        times.append(key.time);
    }
    if (!times.empty()) {
        object.insert("camera_keys_s", times);
    }
    addCut(object, view, data);
    return textOf(object);
}

render::View reshaped(const render::View& view, double aspect, int width, int height) {
    render::View made = view;
    const std::vector<render::Pane> panes = render::panesOf(view.layout, width, height);
    const double shape = panes.empty() ? 0.0 : panes.front().aspect();
    if (!(shape > 0.0) || !(aspect > shape)) {
        return made;
    }
    for (render::Camera& camera : made.cameras) {
        const double half = 0.5 * camera.viewAngle * std::numbers::pi / 180.0;
        camera.viewAngle = 2.0 * std::atan(std::tan(half) * aspect / shape) * 180.0 / std::numbers::pi;
        camera.parallelScale *= aspect / shape;
    }
    return made;
}

std::vector<MoviePane> moviePanes(const render::View& view, bool simulated) {
    render::PaneStatus status;
    status.states = 2;
    status.interpolated = true;
    status.fragments = 1;
    status.simulated = simulated;
    status.kind = FrameKind::Interpolated;
    std::vector<MoviePane> panes;
    for (const render::Pane& pane : render::panesOf(view.layout, 100, 100)) {
        panes.push_back({paneName(pane.content).toStdString(), shownAs(pane.content, status)});
    }
    return panes;
}

}  // namespace rubble::figures
