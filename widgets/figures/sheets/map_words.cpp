#include "widgets/figures/sheets/map_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/fe/north.h"
#include "widgets/figures/draw.h"
#include "widgets/figures/number_text.h"

namespace rubble::figures {
namespace {

struct MapWords {
    Q_DECLARE_TR_FUNCTIONS(rubble::figures::Sheet)
};

QString quantity(double value, const char* unit) {
    const ShownUnit shown = shownUnit(unit);
    return legendNumber(value * shown.perSi) + QChar(0x00A0) + shown.name;
}

}  // namespace

QString layerName(const DebrisMap& map, MapLayer layer) {
    const Message title = mapLayerTitle(map, layer);
    QString name = QCoreApplication::translate("messages", title.pattern.c_str());
    for (std::size_t i = 0; i < title.arguments.size(); ++i) {
        name.replace(QStringLiteral("{%1}").arg(i), QString::fromStdString(englishText({"", "{0}", {title.arguments[i]}})));
    }
    return name;
}

namespace {

bool inMega(MapLayer layer) {
    return layer == MapLayer::ImpactEnergy && unitSet() == UnitSet::Si;
}

/// Times are told in seconds, as they are along the timeline of a file.
ShownUnit unitOf(MapLayer layer) {
    const std::string_view row = mapLayerRow(layer).unit;
    return row == "s" ? ShownUnit{QStringLiteral("s"), 1.0} : shownUnit(row);
}

}  // namespace

double shownScale(MapLayer layer) {
    return inMega(layer) ? 1e-6 : unitOf(layer).perSi;
}

QString unitText(MapLayer layer) {
    return (inMega(layer) ? QStringLiteral("M") : QString()) + unitOf(layer).name;
}

ShownUnit coordinateUnit(const MapPictureStyle& style) {
    return placedSystem(style.place, style.system).empty() ? shownUnit("m") : ShownUnit{QStringLiteral("m"), 1.0};
}

double coordinateStep(const MapPictureStyle& style, double metres, double pixels) {
    const ShownUnit unit = coordinateUnit(style);
    std::optional<FileUnits> ofSystem;
    if (unit.perSi == 1.0) {
        ofSystem.emplace();
    }
    return unit.perSi * roundLength(metres, pixels);
}

QString coordinatesWords(const MapPictureStyle& style) {
    const std::string placed = placedSystem(style.place, style.system);
    const QString unit = coordinateUnit(style).name;
    return !placed.empty()               ? QString::fromStdString(placed)
           : unit == QStringLiteral("m") ? MapWords::tr("local coordinates in metres")
                                         : MapWords::tr("local coordinates in %1").arg(unit);
}

QString legendNumber(double value) {
    return std::abs(value) >= 1000.0 && std::abs(value) < 1e7 ? countText(static_cast<std::size_t>(std::lround(value)))
                                                              : numberText(value);
}

QString debrisSums(const DebrisMap& map) {
    const MapLedger& ledger = map.ledger;
    const bool heavy = ledger.mass >= 1000.0;
    QString text = MapWords::tr("%1 fragments, %2, %4 of solid material, on %3 by cells of %5")
                       .arg(countText(static_cast<std::size_t>(ledger.fragments)),
                            heavy ? quantity(ledger.mass / 1000.0, "t") : quantity(ledger.mass, "kg"),
                            quantity(ledger.footprintArea, "m2"), quantity(ledger.volume, "m3"), lengthText(map.cell));
    double highest = 0.0;
    for (const double height : map.layer(MapLayer::Height)) {
        highest = std::isfinite(height) ? std::max(highest, height) : highest;
    }
    if (highest > 0.0) {
        text += MapWords::tr("; highest cell, in the mean: %1").arg(lengthText(highest));
        text += ledger.highestStands ? MapWords::tr(", on structure that stands") : QString();
        text += ledger.highestStands && std::isfinite(ledger.pileHeight)
                    ? MapWords::tr("; where none stands within 1 m: %1").arg(lengthText(ledger.pileHeight))
                    : QString();
    }
    // Debris too, to whoever stands before it: what fell and was not broken up.
    if (ledger.liveMass > 0.0) {
        text += MapWords::tr("; fallen live structure beside them, moved farther than %3: %1 on %2")
                    .arg(ledger.liveMass >= 1000.0 ? quantity(ledger.liveMass / 1000.0, "t") : quantity(ledger.liveMass, "kg"),
                         quantity(ledger.liveFootprintArea, "m2"), lengthText(map.liveThreshold));
    }
    return text;
}

namespace {

/// With its unit; empty: the cell has none.
QString valueWords(const DebrisMap& map, MapLayer layer, std::size_t cell) {
    const double value = map.has(layer) ? map.layer(layer)[cell] : std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(value)) {
        return {};
    }
    if (layer == MapLayer::Component) {
        return QString::fromStdString(map.components.at(static_cast<std::size_t>(value)));
    }
    const QString unit = unitText(layer);
    const QString number = legendNumber(value * shownScale(layer));
    return unit.isEmpty() ? number : number + QChar(0x00A0) + unit;
}

}  // namespace

QString placeWords(const DebrisMap& map, MapLayer layer, const MapPictureStyle& style, const Eigen::Vector2d& place) {
    const ShownUnit unit = coordinateUnit(style);
    const Vec3 world = style.place.toWorld(Vec3(place.x(), place.y(), 0.0)) * unit.perSi;
    const bool placed = !placedSystem(style.place, style.system).empty();
    const auto along = [&](double number) { return QString::number(number, 'f', placed ? 1 : 2); };
    QString text =
        (placed ? MapWords::tr("E %1, N %2 %3") : MapWords::tr("x %1, y %2 %3")).arg(along(world.x()), along(world.y()), unit.name);
    const auto index = [&](double at) { return static_cast<std::int32_t>(std::floor(at / map.cell)); };
    const MapCell cell{index(place.y()), index(place.x())};
    const auto found = std::lower_bound(map.cells.begin(), map.cells.end(), cell);
    QStringList told;
    if (found != map.cells.end() && *found == cell) {
        const auto c = static_cast<std::size_t>(found - map.cells.begin());
        for (const MapLayer each : {layer, layer == MapLayer::Height || map.members > 0 ? layer : MapLayer::Height}) {
            const QString value = valueWords(map, each, c);
            if (!value.isEmpty() && (told.isEmpty() || each != layer)) {
                told << layerName(map, each) + QStringLiteral(": ") + value;
            }
        }
    }
    text += u'\n' + (told.isEmpty() ? MapWords::tr("no debris in this cell") : told.join(u'\n'));
    return text;
}

QString outlineWords(MapOutline::Of of) {
    switch (of) {
        case MapOutline::Of::Structure:
            return MapWords::tr("what collapsed");
        case MapOutline::Of::Standing:
            return MapWords::tr("what still stands");
        case MapOutline::Of::Evidence:
            return MapWords::tr("found on the site");
        case MapOutline::Of::Simulated:
            return MapWords::tr("of a run: no evidence");
        case MapOutline::Of::Area:
            break;
    }
    return MapWords::tr("area of interest");
}

QPen lineOf(MapOutline::Of of, const Palette& palette, double width) {
    switch (of) {
        case MapOutline::Of::Structure:
            return {palette.accent, width, Qt::DashLine};
        case MapOutline::Of::Standing:
            return {palette.muted, width};
        case MapOutline::Of::Evidence:
            return {palette.error, width};
        case MapOutline::Of::Simulated:
            return {palette.error, width, Qt::DotLine};
        case MapOutline::Of::Area:
            break;
    }
    return {palette.text, width, Qt::DashDotLine};
}

QString legendTitle(const DebrisMap& map, MapLayer layer) {
    if (layer >= MapLayer::AboveFirst && layer <= MapLayer::AboveThird) {
        const auto which = static_cast<std::size_t>(layer) - static_cast<std::size_t>(MapLayer::AboveFirst);
        return MapWords::tr("P(height > %1)").arg(quantity(map.thresholds[which], "m"));
    }
    if (layer == MapLayer::Separation) {
        return MapWords::tr("log ratio");
    }
    const QString unit = unitText(layer);
    const QString name = layerName(map, layer);
    return unit.isEmpty() ? name : name + QStringLiteral(" [") + unit + QStringLiteral("]");
}

}  // namespace rubble::figures
