#pragma once

#include <QSize>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "core/evidence/maps/run_map.h"
#include "core/pipeline/pipeline.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// Layers by their keys, separated by commas. @param ensemble  of maps of an ensemble instead of one run
/// Throws UsageError for a layer that such a map does not have.
std::vector<MapLayer> parseLayers(const std::string& text, bool ensemble);

/// What a debris map of a run is to show, as given by --time, --cell, --layers, --live, --live-threshold, --contours and --size.
class MapRequest {
public:
    /// Options of the map itself; --time and --size stand beside them in every command that has figures too.
    static std::vector<Option> options();

    /// Throws UsageError for a value that is not one of those offered.
    explicit MapRequest(const Arguments& arguments);

    /// Throws UsageError unless the path ends in .tif, .tiff, .gpkg, .csv or .png.
    static void checkFormat(const std::string& option, const std::string& path);

    /// Makes the map. Throws as mapOfRun().
    RunMap make(const io::RunReader& run, const Inputs& inputs, const Execution& execution) const;
    /// Writes it in the format that the path's ending names. A picture shows the first of the layers.
    /// Throws UsageError for a layer that the map does not have, and what the writers throw.
    void write(const std::string& path, const RunMap& made, const io::RunReader& run, Session& session) const;
    /// The layers asked for that the map has, all unless --layers said otherwise.
    std::vector<MapLayer> layersOf(const DebrisMap& map) const;

private:
    std::optional<double> m_time;  ///< s; unset: the end
    bool m_feEnd = false;          ///< the last FE state instead
    MapSettings m_settings;
    bool m_live = true;
    double m_contours = 0.5;       ///< m
    double m_drawnContours = 0.0;  // m, in a picture; 0: none
    std::vector<MapLayer> m_layers;
    std::string m_case;  // the case that was named; empty: a run or a result was
    std::optional<QSize> m_pixels;
};

}  // namespace rubble::cli
