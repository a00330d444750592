#include "io/site/surveys/named_points.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>

#include "core/base/small_letters.h"
#include "io/base/delimited_table.h"
#include "io/base/drawing_unit.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/base/trimmed.h"
#include "io/site/clouds/cloud_columns.h"
#include "io/site/gdal_session.h"

namespace rubble::io {

namespace {

constexpr std::uintmax_t tableBytesMax = std::uintmax_t{64} << 20;
/// A station measures hundreds of points; a table of more bytes whose rows have numbers is a cloud.
constexpr std::uintmax_t stationBytesMost = std::uintmax_t{1} << 20;
constexpr std::array<const char*, 2> stationFormats{"DXF", nullptr};
/// m in plan. A text that lies farther from a point names another one.
constexpr double labelReach = 1.0;

bool isNameColumn(const std::string& heading) {
    constexpr std::array<std::string_view, 9> names{"name", "point", "point_id", "pointid", "id", "number", "no", "nr", "pt"};
    return std::find(names.begin(), names.end(), inSmallLetters(heading)) != names.end();
}

/// Where the columns of a table stand.
struct StationColumns {
    std::optional<std::size_t> name, x, y, z;
    Vec3 metres = Vec3::Ones();  ///< in a unit of each
};

StationColumns columnsOf(const std::string& path, const std::vector<std::string>& heading) {
    StationColumns columns;
    for (std::size_t c = 0; c < heading.size(); ++c) {
        const ColumnHeading column = columnHeading(path, heading[c]);
        const auto take = [&](std::optional<std::size_t>& at, Eigen::Index axis) {
            if (!at) {
                at = c;
                columns.metres[axis] = column.metres.value_or(1.0);
            }
        };
        switch (column.role) {
            case ColumnRole::X:
                take(columns.x, 0);
                break;
            case ColumnRole::Y:
                take(columns.y, 1);
                break;
            case ColumnRole::Z:
                take(columns.z, 2);
                break;
            default:
                if (isNameColumn(heading[c])) {
                    columns.name = columns.name.value_or(c);
                }
        }
    }
    return columns;
}

std::vector<NamedPoint> pointsOfTable(const std::string& path, std::int64_t& unnamed) {
    const DelimitedTable table = readDelimitedTable(path, tableBytesMax);
    const StationColumns columns = table.rows.empty() ? StationColumns() : columnsOf(path, table.rows.front().fields);
    if (!columns.name || !columns.x || !columns.y || !columns.z) {
        refuseContent({"control.columns", "{0}: the first line does not name the columns of measured points", {path}},
                      "Begin the table with the line name,easting,northing,height, in the order of its columns.");
    }
    std::vector<NamedPoint> points;
    for (std::size_t r = 1; r < table.rows.size(); ++r) {
        const DelimitedRow& row = table.rows[r];
        requireNoMoreFields(path, table.rows.front(), row);
        const auto field = [&row](std::size_t c) { return c < row.fields.size() ? row.fields[c] : std::string(); };
        if (field(*columns.name).empty()) {
            ++unnamed;
            continue;
        }
        NamedPoint& point = points.emplace_back(NamedPoint{field(*columns.name), Vec3::Zero()});
        Eigen::Index axis = 0;
        for (const std::size_t c : {*columns.x, *columns.y, *columns.z}) {
            const std::optional<double> number = table.numberIn(field(c));
            if (!number) {
                refuseContent({"control.no_number",
                               "{0}: line {1} has \"{2}\" for the point {3}, which is no number",
                               {path, row.line, field(c), point.name}},
                              "Correct the line, or take the point out of the table.");
            }
            point.place[axis] = *number * columns.metres[axis];
            ++axis;
        }
    }
    return points;
}

/// Points and texts of a drawing.
class Drawing {
public:
    /// @param unit  m, in which it counts
    explicit Drawing(double unit) : m_unit(unit) {}

    void add(const OGRFeature& feature) {
        const OGRGeometry* shape = feature.GetGeometryRef();
        if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbPoint) {
            return;
        }
        const OGRPoint& point = *shape->toPoint();
        const Vec3 place = m_unit * Vec3(point.getX(), point.getY(), point.getZ());
        const int field = feature.GetFieldIndex("Text");
        const std::string text(trimmed(field >= 0 ? feature.GetFieldAsString(field) : ""));
        if (text.empty()) {
            m_points.push_back(place);
        } else {
            m_texts.push_back({text, place});
        }
    }

    /// Each text names the point nearest to it, and each point is named by the nearest such text.
    std::vector<NamedPoint> named(std::int64_t& unnamed) const {
        std::map<std::size_t, std::pair<double, std::string>> names;
        for (const NamedPoint& text : m_texts) {
            std::size_t nearest = 0;
            double least = labelReach;
            for (std::size_t p = 0; p < m_points.size(); ++p) {
                const double distance = (m_points[p] - text.place).head<2>().norm();
                if (distance <= least) {
                    least = distance;
                    nearest = p + 1;
                }
            }
            if (nearest > 0) {
                const auto [known, isNew] = names.emplace(nearest - 1, std::pair(least, text.name));
                if (!isNew && least < known->second.first) {
                    known->second = {least, text.name};
                }
            }
        }
        std::vector<NamedPoint> points;
        for (const auto& [p, name] : names) {
            points.push_back({name.second, m_points[p]});
        }
        unnamed += static_cast<std::int64_t>(m_points.size() - names.size());
        return points;
    }

private:
    double m_unit;
    std::vector<Vec3> m_points;
    std::vector<NamedPoint> m_texts;
};

std::vector<NamedPoint> pointsOfDrawing(const std::string& path, std::int64_t& unnamed, Findings& findings,
                                        const Execution& execution) {
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, stationFormats.data(), nullptr, nullptr)));
    if (!file) {
        refuseContent({"control.drawing", "{0} cannot be read as a DXF", {path}}, "Write it anew from the drawing, as DXF.");
    }
    Drawing drawing(drawingUnit(path, findings));
    for (int l = 0; l < file->GetLayerCount(); ++l) {
        OGRLayer& layer = *file->GetLayer(l);
        layer.ResetReading();
        while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
            execution.check();
            drawing.add(*feature);
        }
    }
    std::vector<NamedPoint> points = drawing.named(unnamed);
    const auto isLevel = [](const NamedPoint& point) { return point.place.z() == 0.0; };
    const auto level = std::count_if(points.begin(), points.end(), isLevel);
    if (level > 0 && level < std::ssize(points)) {
        addFinding(
            findings, path,
            {"control.level", "named points of the drawing lie at height 0 while others have heights; they were left out", {}},
            "give them their heights if they are to count", level);
        std::erase_if(points, isLevel);
    }
    return points;
}

}  // namespace

std::vector<NamedPoint> readNamedPoints(const std::string& path, Findings& findings, const Execution& execution) {
    std::int64_t unnamed = 0;
    std::vector<NamedPoint> points =
        hasEnding(path, ".dxf") ? pointsOfDrawing(path, unnamed, findings, execution) : pointsOfTable(path, unnamed);
    std::map<std::string, std::size_t> names;
    for (const NamedPoint& point : points) {
        if (++names[point.name] > 1) {
            refuseContent({"control.twice", "{0} has the point {1} twice", {path, point.name}},
                          "Keep the one that counts: a pair is told by its name.");
        }
    }
    if (points.empty()) {
        refuseContent({"control.none", "{0} has no point with a name", {path}},
                      "Give points their names: a column of a table, or texts of a drawing beside its points.");
    }
    if (unnamed > 0) {
        addFinding(findings, path, {"control.unnamed", "measured points without a name were left out", {}},
                   "none is needed unless one was meant to count", unnamed);
    }
    return points;
}

bool namesStationPoints(const std::string& path) {
    std::error_code failed;
    const std::uintmax_t bytes = std::filesystem::file_size(path, failed);
    if ((!hasEnding(path, ".csv") && !hasEnding(path, ".txt")) || (!failed && bytes > stationBytesMost)) {
        return false;
    }
    try {
        const DelimitedTable table = readDelimitedStart(path, 2);
        const StationColumns columns = table.rows.empty() ? StationColumns() : columnsOf(path, table.rows.front().fields);
        return columns.name && columns.x && columns.y && columns.z;
    } catch (const ParseError&) {
        return false;  // its readers say what is wrong with it
    }
}

}  // namespace rubble::io
