#include "app/cli/exports/map_request.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/cli/frame/option_value.h"
#include "app/cli/frame/picture_options.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/map_files.h"
#include "io/exports/provenance.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/map_picture.h"

namespace rubble::cli {

std::vector<MapLayer> parseLayers(const std::string& text, bool ensemble) {
    std::vector<MapLayer> offered;
    std::copy_if(mapLayers().begin(), mapLayers().end(), std::back_inserter(offered),
                 [ensemble](MapLayer layer) { return mapLayerRow(layer).ensemble == ensemble; });
    std::string keys;
    for (const MapLayer layer : offered) {
        keys += (keys.empty() ? "" : ", ") + std::string(mapLayerRow(layer).key);
    }
    std::vector<MapLayer> layers;
    for (const std::string& key : splitAtCommas(text)) {
        const auto found =
            std::find_if(offered.begin(), offered.end(), [&](MapLayer layer) { return mapLayerRow(layer).key == key; });
        if (found == offered.end()) {
            throw wrongValue("--layers", key, "some of " + keys);
        }
        layers.push_back(*found);
    }
    return layers;
}

std::vector<Option> MapRequest::options() {
    return {
        {"--cell", "M", false, "side of the cells of a debris map, m (default: 0.25, less where fragments are smaller)"},
        {"--layers", "A,B", false, "layers of a debris map, by the names in the manual (default: all); a picture shows the first"},
        {"--live", "on|off", false, "fallen live structure as layers of its own in a debris map (default: on)"},
        {"--live-threshold", "M", false, "live structure has fallen if it moved farther than this, m (default: 1)"},
        {"--contours", "M", false,
         "distance of the height contours in a GeoPackage, m (default: 0.5); in a picture where it is given"}};
}

MapRequest::MapRequest(const Arguments& arguments) {
    if (const auto time = arguments.value("--time"); time && *time != "end") {
        double seconds = 0.0;
        m_feEnd = *time == "fe_end";
        if (!m_feEnd && (!parseNumber(*time, seconds) || !std::isfinite(seconds))) {
            throw wrongValue("--time", *time, "seconds with a point as decimal sign, end, or of a map fe_end");
        }
        m_time = seconds;
    }
    if (arguments.has("--cell")) {
        m_settings.cell = parseLength(arguments, "--cell", 0.0);
    }
    m_settings.liveThreshold = parseLength(arguments, "--live-threshold", m_settings.liveThreshold, true);
    m_contours = parseLength(arguments, "--contours", m_contours);
    m_drawnContours = arguments.has("--contours") ? m_contours : 0.0;
    if (const auto layers = arguments.value("--layers")) {
        m_layers = parseLayers(*layers, false);
    }
    m_live = parseOnOff(arguments, "--live", m_live);
    if (const auto size = arguments.value("--size")) {
        m_pixels = parsePictureSize(*size);
    }
    m_case = io::isCaseFile(arguments.operand()) ? arguments.operand() : std::string();
}

void MapRequest::checkFormat(const std::string& option, const std::string& path) {
    for (const std::string_view ending : {".tif", ".tiff", ".gpkg", ".csv", ".png"}) {
        if (io::hasEnding(path, ending)) {
            return;
        }
    }
    throw UsageError({"cli.map_format", "{0}: {1} does not say by its ending what kind of map it is to be.", {option, path}},
                     {"cli.map_format.remedy", "Endings: .tif (GeoTIFF), .gpkg (GeoPackage), .csv, .png.", {}});
}

RunMap MapRequest::make(const io::RunReader& run, const Inputs& inputs, const Execution& execution) const {
    const MappedRun mapped{inputs.fe.get(), &run, run.fragments(), run.result(), inputs.terrain, run.origin().scenario};
    return mapOfRun(mapped, m_feEnd ? std::optional(inputs.fe->times().back()) : m_time, m_settings, m_live, execution);
}

std::vector<MapLayer> MapRequest::layersOf(const DebrisMap& map) const {
    if (m_layers.empty()) {
        return map.present();
    }
    for (const MapLayer layer : m_layers) {
        if (!map.has(layer)) {
            throw UsageError({"cli.map_layer", "--layers {0}: this map does not have it.", {mapLayerRow(layer).key}},
                             {"cli.map_layer.remedy",
                              "Impact energy needs a run that is complete; layers of live structure need --live on.",
                              {}});
        }
    }
    return m_layers;
}

void MapRequest::write(const std::string& path, const RunMap& made, const io::RunReader& run, Session& session) const {
    const std::vector<MapLayer> layers = layersOf(made.map);
    if (!io::hasEnding(path, ".png")) {
        io::writeRunMap(path, made, layers, m_contours, run, session.execution());
        return;
    }
    const io::MapOrigin origin = io::mapOrigin(run, made.map, made.shown);
    quietQt();
    figures::ensureGuiApplication();
    figures::MapPictureStyle style;
    style.pixels = m_pixels.value_or(style.pixels);
    style.fitted = !m_pixels;
    style.subject = io::mapSubject(run.origin(), m_case);
    style.place = io::SitePlace(origin.frame, origin.site).transform();
    style.system = origin.frame.crs;
    style.shown = origin.facts.front().second;
    style.provenance = io::footLine(run.origin());
    style.cautions = pictureCautions(runCautions(io::standingAt(run, made.map.time)));
    style.contours = m_drawnContours;
    figures::writePng(path, figures::mapPicture(made.map, layers.front(), style));
    io::writeMapProvenance(path, origin);
}

}  // namespace rubble::cli
