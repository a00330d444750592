#include <cmath>
#include <numbers>

#include "widgets/figures/report/report_sections.h"

namespace rubble::figures {

namespace {

/// To the millimetre, and without groups of digits: commas part coordinates.
QString metres(double length) {
    constexpr double thousand = 1000.0;
    constexpr int digits = 12;
    return QString::number(std::round(length * thousand) / thousand, 'g', digits).replace(u'-', QStringLiteral("−"));
}

/// "12.5, 3, −4".
QString vectorShown(const Vec3& vector) {
    return ReportSections::tr("%1, %2, %3", "the three parts of a vector")
        .arg(metres(vector.x()), metres(vector.y()), metres(vector.z()));
}

}  // namespace

void ReportSections::addPlace() {
    const ReportPlace& place = m_facts.place;
    const QString named = escaped(place.named);
    if (place.named.empty() && place.fit.used < 2) {
        text(tr("The case names no coordinate system: coordinates are those of the model."));
    } else if (place.fit.used >= 2) {
        text(tr("The model lies in %1 by %2 of %3 control points: turned by %4°, scaled %5 times, %6 m off in plan and %7 m in "
                "height (RMS).")
                 .arg(place.named.empty() ? tr("the frame of its control points") : tr("the coordinate system %1").arg(named))
                 .arg(place.fit.used)
                 .arg(place.points.size())
                 .arg(reportNumber(place.fit.angle * 180.0 / std::numbers::pi, 3), reportNumber(place.fit.scale, 6),
                      metres(place.fit.rmsPlan), metres(place.fit.rmsHeight)));
    } else if (place.system.empty()) {
        text(tr("The case names the coordinate system %1, but the model has no place in it: coordinates are those of the model.")
                 .arg(named));
    } else {
        text(tr("The model lies in the coordinate system %1 by the origin of its frame, at %2 m.")
                 .arg(named, vectorShown(Vec3(place.fit.shift.x(), place.fit.shift.y(), place.fit.height))));
    }
    addControlPoints();
    if (m_facts.terrain != nullptr && !place.terrain.empty()) {
        const TerrainGrid& grid = *m_facts.terrain;
        text(tr("Debris falls on the terrain %1: %2 by %3 heights, %4 m apart, from %5 m to %6 m.")
                 .arg(escaped(place.terrain))
                 .arg(grid.nx())
                 .arg(grid.ny())
                 .arg(metres(grid.cell()), metres(grid.lowest()), metres(grid.highest())));
    }
    for (const ReportMesh& mesh : place.meshes) {
        text(mesh.offset.isZero()
                 ? tr("Debris falls on the surroundings %1 as well.").arg(escaped(mesh.name))
                 : tr("Debris falls on the surroundings %1 as well, which were moved by %2 m from where their file has them.")
                       .arg(escaped(mesh.name), vectorShown(mesh.offset)));
    }
}

void ReportSections::addControlPoints() {
    const ReportPlace& place = m_facts.place;
    if (place.points.empty()) {
        return;
    }
    ReportTable table;
    table.caption = tr("Control points: where the model has them, and where they were measured");
    table.columns = QStringList{tr("point"), tr("model x, y, z [m]"), tr("easting, northing, height [m]"), tr("off in plan [m]"),
                                tr("off in height [m]")};
    table.words = {true, false, false, false, false};
    table.shares = {0.16, 0.26, 0.32, 0.13, 0.13};
    for (std::size_t p = 0; p < place.points.size(); ++p) {
        const ControlPoint& point = place.points[p];
        const bool fitted = p < place.fit.residuals.size();
        table.rows.push_back({point.used ? escaped(point.name) : tr("%1, not used").arg(escaped(point.name)),
                              vectorShown(point.local), vectorShown(point.world),
                              fitted ? metres(place.fit.residuals[p].head<2>().norm()) : QStringLiteral("–"),
                              fitted ? metres(place.fit.residuals[p].z()) : QStringLiteral("–")});
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
}

}  // namespace rubble::figures
