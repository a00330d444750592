#include "app/python/recorded_run.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/terrain_reader.h"
#include "io/exports/exports.h"
#include "io/exports/map_files.h"
#include "io/fe/fe_reader.h"
#include "io/site/input_files.h"

namespace rubble::python {

namespace {

void checkDigest(const std::string& path, const std::string& found, const std::string& wanted) {
    if (found != wanted) {
        throw WorldError(
            {"python.input_differs", "{0} is not what the run was made from: its SHA-256 is {1}, not {2}.", {path, found, wanted}},
            {"python.input_differs.remedy", "Give the file with that SHA-256 as fe, or simulate again.", {}});
    }
}

}  // namespace

RecordedRun::RecordedRun(std::shared_ptr<io::RunReader> reader, std::optional<Inputs> inputs)
    : m_reader(std::move(reader)), m_inputs(std::move(inputs)) {}

std::shared_ptr<const FragmentSet> RecordedRun::fragments() const {
    auto fragments = m_reader->fragments();
    if (!fragments) {
        throw ParseError(
            {"io.run.not_begun", "The run of {0} was stopped before its simulation began", {m_reader->origin().fePath}},
            {"io.run.incomplete.remedy", "Run the case again to the end.", {}});
    }
    return fragments;
}

std::shared_ptr<const SimulationResult> RecordedRun::result() const {
    auto result = m_reader->result();
    if (!result) {
        throw UsageError({"python.not_complete", "{0} is not complete: it has frames, but no outcome.", {m_reader->path()}},
                         {"python.not_complete.remedy", "Use its frames, or run the case again to the end.", {}});
    }
    return result;
}

const Inputs& RecordedRun::inputs(const std::optional<std::string>& fe, const Execution& execution) {
    if (m_inputs && !fe) {
        return *m_inputs;
    }
    const io::RunOrigin& origin = m_reader->origin();
    const std::string path = fe.value_or(origin.fePath);
    checkDigest(path, io::sha256OfFe(path), origin.feSha256);
    Inputs inputs;
    inputs.fe = io::openFe(path, origin.scenario.import, origin.frame, execution);
    inputs.frame = inputs.fe->contents().frame;
    if (!origin.terrainPath.empty()) {
        const std::string& kept = origin.terrainSha256;
        checkDigest(origin.terrainPath, io::digestOfInput(origin.terrainPath, InputRole::Terrain, execution).against(kept), kept);
        inputs.terrain = io::openTerrain(origin.terrainPath, inputs.frame, io::boundsAtRest(inputs.fe->mesh()), execution,
                                         origin.site, origin.terrainRead)
                             .grid;
    }
    m_inputs = std::move(inputs);
    return *m_inputs;
}

void RecordedRun::write(const std::string& kind, const std::string& path, const std::optional<std::string>& fe,
                        const Execution& execution) {
    if (kind == "fragments") {
        io::exportFragments(path, *m_reader, execution);
    } else if (kind == "series") {
        io::exportSeries(path, *m_reader, *inputs(fe, execution).fe, execution);
    } else if (kind == "vtkhdf") {
        io::exportVtkHdf(path, *m_reader, *inputs(fe, execution).fe, execution);
    } else if (kind == "bodies") {
        io::exportBodies(path, *m_reader, execution);
    } else if (kind == "gltf") {
        const bool islands = !m_reader->islands().empty();
        io::exportGltf(path, *m_reader, islands ? inputs(fe, execution).fe.get() : nullptr, execution);
    } else {
        throw UsageError(
            {"python.kind", "There is no export of the kind \"{0}\".", {kind}},
            {"python.kind.remedy", "Kinds: fragments, series, vtkhdf, bodies, gltf; a debris map writes itself with save().", {}});
    }
}

std::shared_ptr<const RecordedMap> RecordedRun::map(std::optional<double> cell, std::optional<double> time, bool live,
                                                    const std::optional<std::string>& fe, const Execution& execution) {
    const Inputs& of = inputs(fe, execution);
    const MappedRun run{of.fe.get(), m_reader.get(), fragments(), m_reader->result(), of.terrain, m_reader->origin().scenario};
    MapSettings settings;
    settings.cell = cell;
    return std::make_shared<RecordedMap>(RecordedMap{mapOfRun(run, time, settings, live, execution), m_reader});
}

void saveMap(const RecordedMap& map, const std::string& path, const Execution& execution) {
    const DebrisMap& cells = map.made.map;
    const io::MapOrigin origin = io::mapOrigin(*map.run, cells, map.made.shown);
    if (io::hasEnding(path, ".tif") || io::hasEnding(path, ".tiff")) {
        io::writeMapTiff(path, cells, cells.present(), origin, execution);
    } else if (io::hasEnding(path, ".csv")) {
        io::writeMapCsv(path, cells, cells.present(), origin, execution);
    } else if (io::hasEnding(path, ".gpkg")) {
        const auto fragments = map.run->fragments();
        const io::MapFragments list{fragments.get(), &map.made.debris, map.run->elementIds(), map.made.arrivals, map.made.energies};
        constexpr double contourSpacing = 0.5;
        io::writeMapPackage(path, cells, list, contourSpacing, origin, execution);
    } else {
        throw UsageError({"python.map_format", "{0} does not say by its ending what kind of map it is to be.", {path}},
                         {"python.map_format.remedy", "Endings: .tif (GeoTIFF), .gpkg (GeoPackage), .csv.", {}});
    }
}

}  // namespace rubble::python
