#include <cmath>
#include <ostream>

#include "core/base/csv_text.h"
#include "io/base/files.h"
#include "io/exports/map_files.h"
#include "io/site/site_place.h"

namespace rubble::io {

std::string mapColumn(MapLayer layer) {
    const MapLayerRow& row = mapLayerRow(layer);
    std::string column(row.key);
    if (!row.unit.empty()) {
        column += '_';
    }
    for (const char c : row.unit) {
        column += c == '/' ? std::string("_per_") : std::string(1, static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c));
    }
    return column;
}

void writeMapCsv(const std::string& path, const DebrisMap& map, const std::vector<MapLayer>& layers, const MapOrigin& origin,
                 const Execution& execution) {
    const Message stage{"io.export.map", "Writing {0}", {path}};
    const SitePlace place(origin.frame, origin.site);
    writeAtomically(path, [&](std::ostream& out) {
        out << "x_m,y_m";
        for (const MapLayer layer : layers) {
            out << ',' << mapColumn(layer);
        }
        out << '\n';
        for (std::size_t c = 0; c < map.cells.size(); ++c) {
            if (c % 16384 == 0) {
                execution.report(stage, static_cast<double>(c) / static_cast<double>(map.cells.size()));
            }
            const Eigen::Vector2d middle = map.cell * Eigen::Vector2d(map.cells[c].i + 0.5, map.cells[c].j + 0.5);
            const Eigen::Vector2d at = place.planToWorld(middle);
            out << exactNumber(at.x()) << ',' << exactNumber(at.y());
            for (const MapLayer layer : layers) {
                const double value = map.layer(layer)[c];
                const bool named =
                    layer == MapLayer::Component && value >= 0.0 && value < static_cast<double>(map.components.size());
                out << ',' << (named ? csvField(map.components[static_cast<std::size_t>(value)]) : exactNumber(value));
            }
            out << '\n';
        }
    });
    writeProvenance(path, origin.provenance);
    execution.report(stage, 1.0);
}

void writeMapProvenance(const std::string& path, const MapOrigin& origin) {
    writeProvenance(path, origin.provenance);
}

}  // namespace rubble::io
