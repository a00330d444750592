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

}  // namespace

std::string settingsText(QSize pixels, double dpi, std::optional<FigurePreset> preset, QSize panel) {
    QJsonObject settings{{"pixels", QJsonArray{pixels.width(), pixels.height()}},
                         {"dpi", dpi},
                         {"panel_pixels", QJsonArray{panel.width(), panel.height()}}};
    for (const auto& [name, each] : figurePresets) {
        if (preset == each) {
            settings.insert("preset", QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())));
        }
    }
    return textOf(settings);
}

std::string settingsText(QSize pixels, const MovieSettings& settings) {
    QJsonObject object{{"pixels", QJsonArray{pixels.width(), pixels.height()}}, {"fps", settings.fps}, {"pace", settings.pace}};
    QJsonArray times;
    for (const CameraKey& key : settings.cameras) {
        times.append(key.time);
    }
    if (!times.empty()) {
        object.insert("camera_keys_s", times);
    }
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
