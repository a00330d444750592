#include "widgets/figures/sheets/map_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "widgets/figures/number_text.h"
#include "widgets/figures/shown_units.h"

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

double unitScale(MapLayer layer) {
    return layer == MapLayer::ImpactEnergy ? 1e6 : 1.0;
}

QString unitText(MapLayer layer) {
    const std::string_view row = mapLayerRow(layer).unit;
    return (unitScale(layer) == 1e6 ? QStringLiteral("M") : QString()) +
           raisedUnits(QString::fromUtf8(row.data(), static_cast<qsizetype>(row.size())));
}

QString legendNumber(double value) {
    return std::abs(value) >= 1000.0 && std::abs(value) < 1e7 ? countText(static_cast<std::size_t>(std::lround(value)))
                                                              : numberText(value);
}

QString debrisSums(const DebrisMap& map) {
    const MapLedger& ledger = map.ledger;
    const bool heavy = ledger.mass >= 1000.0;
    QString text =
        MapWords::tr("%1 fragments, %2, on %3")
            .arg(countText(static_cast<std::size_t>(ledger.fragments)),
                 heavy ? quantity(ledger.mass / 1000.0, "t") : quantity(ledger.mass, "kg"), quantity(ledger.footprintArea, "m2"));
    double highest = 0.0;
    for (const double height : map.layer(MapLayer::Height)) {
        highest = std::isfinite(height) ? std::max(highest, height) : highest;
    }
    if (highest > 0.0) {
        text += MapWords::tr("; highest cell, in the mean: %1").arg(lengthText(highest));
    }
    // Debris too, to whoever stands before it: what fell and was not broken up.
    if (ledger.liveMass > 0.0) {
        text += MapWords::tr("; fallen live structure beside them: %1 on %2")
                    .arg(ledger.liveMass >= 1000.0 ? quantity(ledger.liveMass / 1000.0, "t") : quantity(ledger.liveMass, "kg"),
                         quantity(ledger.liveFootprintArea, "m2"));
    }
    return text;
}

QString outlineWords(MapOutline::Of of) {
    switch (of) {
        case MapOutline::Of::Structure:
            return MapWords::tr("what collapsed");
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
        return MapWords::tr("P(height > %1 m)").arg(map.thresholds[which]);
    }
    if (layer == MapLayer::Separation) {
        return MapWords::tr("log ratio");
    }
    const QString unit = unitText(layer);
    const QString name = layerName(map, layer);
    return unit.isEmpty() ? name : name + QStringLiteral(" [") + unit + QStringLiteral("]");
}

}  // namespace rubble::figures
