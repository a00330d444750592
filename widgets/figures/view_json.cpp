#include "widgets/figures/view_json.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"

namespace rubble::figures {
namespace {

constexpr int version = 1;

template <class Enum>
struct Named {
    Enum value;
    const char* name;
};

constexpr std::array<Named<render::Layout>, 7> layouts{{{render::Layout::Beside, "beside"},
                                                        {render::Layout::Stacked, "stacked"},
                                                        {render::Layout::FeOnly, "fe_only"},
                                                        {render::Layout::FragmentsOnly, "fragments_only"},
                                                        {render::Layout::OverlayOnly, "overlay_only"},
                                                        {render::Layout::Four, "four"},
                                                        {render::Layout::Scenarios, "scenarios"}}};
constexpr std::array<Named<render::ColourMap>, 4> colourMaps{{{render::ColourMap::Standard, "standard"},
                                                              {render::ColourMap::Viridis, "viridis"},
                                                              {render::ColourMap::Cividis, "cividis"},
                                                              {render::ColourMap::Grey, "grey"}}};
constexpr std::array<Named<render::Style>, 2> styles{
    {{render::Style::Analysis, "analysis"}, {render::Style::Presentation, "presentation"}}};
constexpr std::array<Named<render::ColourBy>, 7> colourings{{{render::ColourBy::Highlight, "highlight"},
                                                             {render::ColourBy::Component, "component"},
                                                             {render::ColourBy::BirthTime, "birth_time"},
                                                             {render::ColourBy::Speed, "speed"},
                                                             {render::ColourBy::Cluster, "cluster"},
                                                             {render::ColourBy::Error, "error"},
                                                             {render::ColourBy::Island, "island"}}};
constexpr std::array<Named<render::PointColour>, 4> pointColours{{{render::PointColour::Own, "own"},
                                                                  {render::PointColour::Height, "height"},
                                                                  {render::PointColour::Class, "class"},
                                                                  {render::PointColour::Distance, "distance"}}};
constexpr std::array<Named<render::Theme>, 3> themes{
    {{render::Theme::Light, "light"}, {render::Theme::Dark, "dark"}, {render::Theme::Print, "print"}}};

template <class Enum, std::size_t N>
QString nameOf(const std::array<Named<Enum>, N>& table, Enum value) {
    for (const auto& row : table) {
        if (row.value == value) {
            return QString::fromLatin1(row.name);
        }
    }
    return {};
}

[[noreturn]] void refuse(std::string_view source, const std::string& what, const std::string& wanted) {
    throw ParseError({"view.content", "{0}: the view's {1}", {source, what}}, {"view.content.remedy", "Give {0}.", {wanted}});
}

/// Reads members of one JSON object; a missing one keeps what was there.
class Reader {
public:
    Reader(const QJsonObject& object, std::string_view source, std::string place)
        : m_object(object), m_source(source), m_place(std::move(place)) {}

    void read(const char* key, double& value) const {
        if (const QJsonValue v = m_object.value(QLatin1String(key)); !v.isUndefined()) {
            if (!v.isDouble() || !std::isfinite(v.toDouble())) {
                refuse(m_source, named(key) + " is not a number", "a finite number");
            }
            value = v.toDouble();
        }
    }
    void read(const char* key, bool& value) const {
        if (const QJsonValue v = m_object.value(QLatin1String(key)); !v.isUndefined()) {
            if (!v.isBool()) {
                refuse(m_source, named(key) + " is not a switch", "true or false");
            }
            value = v.toBool();
        }
    }
    void read(const char* key, std::string& value) const {
        if (const QJsonValue v = m_object.value(QLatin1String(key)); !v.isUndefined()) {
            if (!v.isString()) {
                refuse(m_source, named(key) + " is not a name", "a name, or nothing between two quotes");
            }
            value = v.toString().toStdString();
        }
    }
    void read(const char* key, Vec3& value) const {
        const QJsonValue v = m_object.value(QLatin1String(key));
        if (v.isUndefined()) {
            return;
        }
        const QJsonArray list = v.toArray();
        Vec3 read = Vec3::Constant(std::nan(""));
        for (int i = 0; i < 3 && list.size() == 3; ++i) {
            read[i] = list[i].toDouble(std::nan(""));
        }
        if (!read.allFinite()) {
            refuse(m_source, named(key) + " is not a point", "three finite numbers in metres");
        }
        value = read;
    }
    template <class Enum, std::size_t N>
    void read(const char* key, Enum& value, const std::array<Named<Enum>, N>& table) const {
        const QJsonValue v = m_object.value(QLatin1String(key));
        if (v.isUndefined()) {
            return;
        }
        std::string choices;
        for (const auto& row : table) {
            if (v.toString() == QLatin1String(row.name)) {
                value = row.value;
                return;
            }
            choices += (choices.empty() ? "" : ", ") + std::string(row.name);
        }
        refuse(m_source, named(key) + " is none of its choices", "one of " + choices);
    }
    const QJsonObject& object() const { return m_object; }
    std::string named(const char* key) const { return m_place + key; }

private:
    QJsonObject m_object;
    std::string_view m_source;
    std::string m_place;
};

QJsonArray pointOf(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

QJsonObject objectOf(const render::Camera& camera) {
    return {{"position", pointOf(camera.position)},
            {"focal_point", pointOf(camera.focalPoint)},
            {"up", pointOf(camera.up)},
            {"view_angle", camera.viewAngle},
            {"parallel", camera.parallel},
            {"parallel_scale", camera.parallelScale}};
}

render::Camera cameraFrom(const QJsonValue& value, std::string_view source, const std::string& place) {
    if (!value.isObject()) {
        refuse(source, place + " is not an object", "an object with position, focal_point and up");
    }
    const Reader reader(value.toObject(), source, place + ".");
    render::Camera camera;
    reader.read("position", camera.position);
    reader.read("focal_point", camera.focalPoint);
    reader.read("up", camera.up);
    reader.read("view_angle", camera.viewAngle);
    reader.read("parallel", camera.parallel);
    reader.read("parallel_scale", camera.parallelScale);
    if (!(camera.viewAngle > 0.0 && camera.viewAngle < 180.0)) {
        refuse(source, place + ".view_angle is out of range", "an angle between 0 and 180 degrees");
    }
    if (!(camera.parallelScale > 0.0)) {
        refuse(source, place + ".parallel_scale is out of range", "a positive length in metres");
    }
    if (camera.position == camera.focalPoint || camera.up.norm() == 0.0) {
        refuse(source, place + " looks nowhere", "a position off the focal point and an up direction of some length");
    }
    return camera;
}

void readGrid(const QJsonValue& value, std::string_view source, render::View& view) {
    if (value.isUndefined() || value.isNull()) {
        return;
    }
    const QJsonArray list = value.toArray();
    std::array<double, 3> size{};
    for (int i = 0; i < 3; ++i) {
        size[static_cast<std::size_t>(i)] = list.size() == 3 ? list[i].toDouble(0.0) : 0.0;
    }
    if (!std::all_of(size.begin(), size.end(), [](double s) { return std::isfinite(s) && s > 0.0; })) {
        refuse(source, "basic_grid is no size", "three lengths above 0 in metres, or null");
    }
    view.basicGrid = size;
}

void readErrorSteps(const QJsonValue& value, std::string_view source, render::View& view) {
    if (value.isUndefined()) {
        return;
    }
    std::vector<double> steps;
    for (const QJsonValue& entry : value.toArray()) {
        const double step = entry.toDouble(0.0);
        if (!std::isfinite(step) || !(step > (steps.empty() ? 0.0 : steps.back()))) {
            refuse(source, "error_steps are no rising lengths", "lengths above 0 in metres, each larger than the one before");
        }
        steps.push_back(step);
    }
    if (steps.empty()) {
        refuse(source, "error_steps are empty", "at least one length above 0 in metres");
    }
    view.errorSteps = std::move(steps);
}

void readElements(const QJsonObject& object, const std::string& key, std::string_view source, std::vector<ElementIndex>& elements) {
    const QJsonValue value = object.value(QLatin1String(key.c_str()));
    if (!value.isUndefined() && !value.isArray()) {
        refuse(source, key + " is not a list", "a list of element indices");
    }
    for (const QJsonValue& entry : value.toArray()) {
        const double index = entry.toDouble(-1.0);
        if (index < 0.0 || index > 4294967295.0 || index != std::floor(index)) {
            refuse(source, key + " holds something that is no element index", "whole numbers from 0");
        }
        elements.push_back(idAt<ElementIndex>(static_cast<std::size_t>(index)));
    }
}

void readHiddenComponents(const QJsonValue& value, std::string_view source, render::View& view) {
    if (!value.isUndefined() && !value.isArray()) {
        refuse(source, "hidden_components is not a list", "a list of names of components");
    }
    for (const QJsonValue& entry : value.toArray()) {
        if (!entry.isString()) {
            refuse(source, "hidden_components holds something that is no name", "names of components");
        }
        view.hiddenComponents.push_back(entry.toString().toStdString());
    }
}

/// "#rrggbb" by name of a component.
void readComponentColours(const QJsonValue& value, std::string_view source, render::View& view) {
    if (!value.isUndefined() && !value.isObject()) {
        refuse(source, "component_colours is not an object", "an object of colours such as \"#d55e00\" by name of a component");
    }
    const QJsonObject object = value.toObject();
    for (auto entry = object.begin(); entry != object.end(); ++entry) {
        const QString text = entry.value().toString();
        bool ok = false;
        const uint rgb = text.mid(1).toUInt(&ok, 16);
        if (!ok || text.size() != 7 || text[0] != QLatin1Char('#')) {
            refuse(source, "component_colours." + entry.key().toStdString() + " is no colour", "a colour such as \"#d55e00\"");
        }
        view.componentColours[entry.key().toStdString()] = {static_cast<std::uint8_t>(rgb >> 16),
                                                            static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)};
    }
}

void readClip(const QJsonValue& value, std::string_view source, render::View& view) {
    if (value.isUndefined() || value.isNull()) {
        return;
    }
    if (!value.isObject()) {
        refuse(source, "clip is not an object", "an object with point and normal, or null");
    }
    const Reader reader(value.toObject(), source, "clip.");
    render::ClipPlane plane;
    reader.read("point", plane.point);
    reader.read("normal", plane.normal);
    if (!(plane.normal.norm() > 0.0)) {
        refuse(source, "clip.normal has no length", "a direction of some length");
    }
    // Left as it stands if it is a direction already: it must read back to the same bits.
    if (std::abs(plane.normal.norm() - 1.0) > 1e-12) {
        plane.normal.normalize();
    }
    view.clip = plane;
}

void readMeasurements(const QJsonValue& value, std::string_view source, render::View& view) {
    if (!value.isUndefined() && !value.isArray()) {
        refuse(source, "measurements is not a list", "a list of objects with from, to and height");
    }
    std::size_t number = 0;
    for (const QJsonValue& entry : value.toArray()) {
        const std::string place = "measurements[" + std::to_string(number++) + "]";
        if (!entry.isObject()) {
            refuse(source, place + " is not an object", "an object with from, to and height");
        }
        const Reader reader(entry.toObject(), source, place + ".");
        render::Measurement measured;
        reader.read("from", measured.from);
        reader.read("to", measured.to);
        reader.read("height", measured.height);
        view.measurements.push_back(measured);
    }
}

void readPath(const QJsonValue& value, std::string_view source, render::View& view) {
    if (!value.isUndefined() && !value.isArray()) {
        refuse(source, "path is not a list", "a list of points");
    }
    for (const QJsonValue& entry : value.toArray()) {
        Vec3 point = Vec3::Zero();
        Reader(QJsonObject{{"point", entry}}, source, "path.").read("point", point);
        view.path.push_back(point);
    }
}

/// The quantities of a filter by their keys.
template <class Filter>
auto rangesOf(Filter& filter) {
    return std::array{std::pair("speed", &filter.speed), std::pair("mass", &filter.mass), std::pair("size", &filter.size),
                      std::pair("birth", &filter.birth)};
}

void readFilter(const QJsonValue& value, std::string_view source, render::View& view) {
    if (value.isUndefined() || value.isNull()) {
        return;
    }
    if (!value.isObject()) {
        refuse(source, "filter is not an object", "an object with speed, mass, size, birth and component, or null");
    }
    const QJsonObject object = value.toObject();
    for (const auto& [key, range] : rangesOf(view.filter)) {
        const QJsonValue bounds = object.value(QLatin1String(key));
        if (bounds.isUndefined() || bounds.isNull()) {
            continue;
        }
        const QJsonArray list = bounds.toArray();
        const std::string name = key;
        const auto bound = [&](qsizetype i) -> std::optional<double> {
            if (i < list.size() && (list[i].isDouble() || list[i].isNull())) {
                return list[i].isNull() ? std::nullopt : std::optional(list[i].toDouble());
            }
            refuse(source, "filter." + name + " is no pair of bounds", "two numbers or null: least and greatest");
        };
        range->low = bound(0);
        range->high = bound(1);
    }
    const QJsonValue component = object.value(QLatin1String("component"));
    if (!component.isUndefined() && !component.isString()) {
        refuse(source, "filter.component is no name", "the name of a component");
    }
    view.filter.component = component.toString().toStdString();
}

QJsonValue objectOf(const render::FragmentFilter& filter) {
    if (filter.empty()) {
        return QJsonValue(QJsonValue::Null);
    }
    QJsonObject object;
    for (const auto& [key, range] : rangesOf(filter)) {
        const auto bound = [](const std::optional<double>& of) { return of ? QJsonValue(*of) : QJsonValue(QJsonValue::Null); };
        if (!range->empty()) {
            object.insert(QLatin1String(key), QJsonArray{bound(range->low), bound(range->high)});
        }
    }
    if (!filter.component.empty()) {
        object.insert("component", QString::fromStdString(filter.component));
    }
    return object;
}

QJsonArray listOf(const std::vector<ElementIndex>& elements) {
    QJsonArray list;
    for (const ElementIndex e : elements) {
        list.append(static_cast<qint64>(at(e)));
    }
    return list;
}

QJsonArray listOf(const std::vector<render::Measurement>& measurements) {
    QJsonArray list;
    for (const render::Measurement& measured : measurements) {
        list.append(QJsonObject{{"from", pointOf(measured.from)}, {"to", pointOf(measured.to)}, {"height", measured.height}});
    }
    return list;
}

/// What a view hides, cuts and marks.
void addMarks(QJsonObject& object, const render::View& view) {
    QJsonArray hidden;
    for (const std::string& name : view.hiddenComponents) {
        hidden.append(QString::fromStdString(name));
    }
    QJsonObject colours;
    for (const auto& [name, c] : view.componentColours) {
        colours.insert(QString::fromStdString(name),
                       QStringLiteral("#%1").arg((static_cast<uint>(c.r) << 16) | (static_cast<uint>(c.g) << 8) | c.b, 6, 16,
                                                 QLatin1Char('0')));
    }
    QJsonArray path;
    for (const Vec3& point : view.path) {
        path.append(pointOf(point));
    }
    object.insert("selection", listOf(view.selection));
    object.insert("hidden", listOf(view.hidden));
    object.insert("hidden_components", hidden);
    object.insert("filter", objectOf(view.filter));
    object.insert("component_colours", colours);
    object.insert("clip",
                  view.clip ? QJsonValue(QJsonObject{{"point", pointOf(view.clip->point)}, {"normal", pointOf(view.clip->normal)}})
                            : QJsonValue(QJsonValue::Null));
    object.insert("measurements", listOf(view.measurements));
    object.insert("path", path);
}

void readCameras(const QJsonValue& value, std::string_view source, render::View& view) {
    if (value.isUndefined()) {
        return;
    }
    const QJsonArray list = value.toArray();
    if (list.size() != 2 && list.size() != static_cast<qsizetype>(render::paneCameras)) {
        refuse(source, "cameras are not four", "a list of four cameras: FE, fragments, overlay, plan");
    }
    for (qsizetype i = 0; i < list.size(); ++i) {
        view.cameras[static_cast<std::size_t>(i)] = cameraFrom(list[i], source, "cameras[" + std::to_string(i) + "]");
    }
    if (list.size() == 2) {
        // Views of the time when there were two.
        view.cameras[2] = view.cameras[3] = view.cameras[0];
    }
}

}  // namespace

std::string toJson(const render::View& view) {
    QJsonArray cameras;
    for (const render::Camera& camera : view.cameras) {
        cameras.append(objectOf(camera));
    }
    QJsonValue grid(QJsonValue::Null);
    if (view.basicGrid) {
        grid = QJsonArray{(*view.basicGrid)[0], (*view.basicGrid)[1], (*view.basicGrid)[2]};
    }
    QJsonArray steps;
    for (const double step : view.errorSteps) {
        steps.append(step);
    }
    QJsonObject object{{"rubble_view", version},
                       {"layout", nameOf(layouts, view.layout)},
                       {"cameras", cameras},
                       {"cameras_linked", view.camerasLinked},
                       {"time", view.time},
                       {"time_origin", view.timeOrigin},
                       {"colour_by", nameOf(colourings, view.colourBy)},
                       {"colour_map", nameOf(colourMaps, view.colourMap)},
                       {"style", nameOf(styles, view.style)},
                       {"theme", nameOf(themes, view.theme)},
                       {"ground", view.ground},
                       {"ground_grid", view.groundGrid},
                       {"shading", view.shading},
                       {"shadows", view.shadows},
                       {"cloud", QString::fromStdString(view.cloud)},
                       {"point_colour", nameOf(pointColours, view.pointColour)},
                       {"axes", view.axes},
                       {"captions", view.captions},
                       {"legends", view.legends},
                       {"scale_bar", view.scaleBar},
                       {"basic_grid", grid},
                       {"error_steps", steps}};
    addMarks(object, view);
    return QJsonDocument(object).toJson(QJsonDocument::Indented).toStdString();
}

render::View viewFromJson(std::string_view json, std::string_view source) {
    QJsonParseError error;
    const auto document = QJsonDocument::fromJson(QByteArray(json.data(), static_cast<qsizetype>(json.size())), &error);
    if (!document.isObject()) {
        throw ParseError({"view.json",
                          "{0}: not a view in JSON, at character {1}: {2}",
                          {source, static_cast<std::int64_t>(error.offset), error.errorString().toStdString()}},
                         {"view.json.remedy", "Save the view again, or mend the file there.", {}});
    }
    const Reader reader(document.object(), source, "");
    const int found = reader.object().value("rubble_view").toInt(version);
    if (found > version || found < 1) {
        throw ParseError({"view.version", "{0}: a view of version {1}; this program reads version {2}", {source, found, version}},
                         {"view.version.remedy", "Open it with a newer Rubble.", {}});
    }
    render::View view;
    reader.read("layout", view.layout, layouts);
    reader.read("cameras_linked", view.camerasLinked);
    reader.read("time", view.time);
    reader.read("time_origin", view.timeOrigin);
    reader.read("colour_by", view.colourBy, colourings);
    reader.read("colour_map", view.colourMap, colourMaps);
    reader.read("style", view.style, styles);
    reader.read("theme", view.theme, themes);
    reader.read("ground", view.ground);
    reader.read("ground_grid", view.groundGrid);
    reader.read("shading", view.shading);
    reader.read("shadows", view.shadows);
    reader.read("cloud", view.cloud);
    reader.read("point_colour", view.pointColour, pointColours);
    reader.read("axes", view.axes);
    reader.read("captions", view.captions);
    reader.read("legends", view.legends);
    reader.read("scale_bar", view.scaleBar);
    readCameras(reader.object().value("cameras"), source, view);
    readGrid(reader.object().value("basic_grid"), source, view);
    readErrorSteps(reader.object().value("error_steps"), source, view);
    readElements(reader.object(), "selection", source, view.selection);
    readElements(reader.object(), "hidden", source, view.hidden);
    readHiddenComponents(reader.object().value("hidden_components"), source, view);
    readFilter(reader.object().value("filter"), source, view);
    readComponentColours(reader.object().value("component_colours"), source, view);
    readClip(reader.object().value("clip"), source, view);
    readMeasurements(reader.object().value("measurements"), source, view);
    readPath(reader.object().value("path"), source, view);
    return view;
}

render::View viewFromFile(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly)) {
        throw WorldError({"view.open", "{0} cannot be read: {1}", {path, file.errorString().toStdString()}},
                         {"view.open.remedy", "Check the name and the permissions.", {}});
    }
    return viewFromJson(file.readAll().toStdString(), path);
}

}  // namespace rubble::figures
