#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/fe/components.h"
#include "io/exports.h"
#include "io/files.h"
#include "io/fragment_places.h"
#include "io/pvd_index.h"
#include "io/terrain/site_place.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

int cellTypeOf(ElementShape shape) {
    static constexpr std::array<int, 7> types{VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_TETRA, VTK_QUAD, VTK_TRIANGLE, VTK_LINE};
    return types[static_cast<std::size_t>(shape)];
}

/// Collects cells and their numbers, then becomes a grid.
class GridBuilder {
public:
    /// Points far from the origin need double precision.
    explicit GridBuilder(const SitePlace& site) : m_site(site) {
        m_points->SetDataType(site.toWorld(Vec3::Zero()).cwiseAbs().maxCoeff() < 10000.0 ? VTK_FLOAT : VTK_DOUBLE);
        m_cells->Use32BitStorage();
    }

    vtkIdType addPoint(const Vec3& local) {
        const Vec3 p = m_site.toWorld(local);
        return m_points->InsertNextPoint(p.x(), p.y(), p.z());
    }
    void addCell(ElementShape shape, std::span<const vtkIdType> points, std::int64_t element, std::size_t component) {
        m_cells->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
        m_types->InsertNextValue(static_cast<unsigned char>(cellTypeOf(shape)));
        m_elements->InsertNextValue(element);
        m_components->InsertNextValue(static_cast<int>(component));
    }
    void addFragmentNumbers(std::size_t fragment, std::int64_t cluster, float speed) {
        m_fragments->InsertNextValue(static_cast<int>(fragment));
        m_clusters->InsertNextValue(static_cast<int>(cluster));
        m_speeds->InsertNextValue(speed);
    }

    /// The file's content.
    std::string text(const std::vector<std::string>& components);

private:
    const SitePlace& m_site;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkCellArray> m_cells;
    vtkNew<vtkUnsignedCharArray> m_types;
    vtkNew<vtkTypeInt64Array> m_elements;
    vtkNew<vtkTypeInt32Array> m_components;
    vtkNew<vtkTypeInt32Array> m_fragments;
    vtkNew<vtkTypeInt32Array> m_clusters;
    vtkNew<vtkFloatArray> m_speeds;
};

std::string GridBuilder::text(const std::vector<std::string>& components) {
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(m_points);
    grid->SetCells(m_types, m_cells);
    const auto add = [&](vtkDataArray* array, const char* name) {
        if (array->GetNumberOfTuples() == m_types->GetNumberOfTuples()) {
            array->SetName(name);
            grid->GetCellData()->AddArray(array);
        }
    };
    add(m_fragments, "fragment_id");
    add(m_elements, "element_id");
    add(m_components, "component");
    add(m_clusters, "cluster_id");
    add(m_speeds, "speed");
    vtkNew<vtkStringArray> names;
    names->SetName("component_names");
    for (const std::string& name : components) {
        names->InsertNextValue(name);
    }
    grid->GetFieldData()->AddArray(names);
    vtkNew<vtkZLibDataCompressor> compressor;
    compressor->SetCompressionLevel(1);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetCompressor(compressor);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetIdTypeToInt32();
    writer->WriteToOutputStringOn();
    writer->Write();
    return writer->GetOutputString();
}

/// What the files of a series are made from.
struct Series {
    const RunReader& run;
    const FeResult& fe;
    FragmentPlaces places;
    SitePlace site;
    std::vector<std::string> componentNames;
    std::vector<ComponentId> componentOf;  // of each element
    std::vector<std::int64_t> elementIds;  // of each fragment
    std::shared_ptr<const Clustering> clustering;
    std::vector<IslandRecord> islands;  // released when the FE result ends
    std::vector<BodyRecord> bodies;
};

Series makeSeries(const RunReader& run, const FeResult& fe) {
    const Scenario& scenario = run.origin().scenario;
    Series series{run,
                  fe,
                  FragmentPlaces(run),
                  SitePlace(run.origin().frame, run.origin().site),
                  run.componentNames(),
                  {},
                  run.elementIds(),
                  run.clustering(),
                  run.islands(),
                  run.bodies()};
    series.componentOf = groupComponents(fe.mesh(), scenario.regrouping, scenario.components, scenario.assumptions).of;
    for (const Fragment& fragment : series.places.fragments().list) {
        if (at(fragment.element) >= fe.mesh().elementCount()) {
            throw UsageError(
                Message{"io.series.other_fe", "The run was not made from {0}: it has fewer elements", {fe.contents().path}},
                Message{"io.series.other_fe.remedy", "Give the FE file that the run names.", {}});
        }
    }
    std::erase_if(series.islands, [&](const IslandRecord& island) {
        return std::any_of(island.elements.begin(), island.elements.end(),
                           [&](ElementIndex e) { return at(e) >= fe.mesh().elementCount(); });
    });
    return series;
}

std::string fragmentsText(const Series& series, const std::vector<FragmentPlaces::Place>& places) {
    GridBuilder builder(series.site);
    const FragmentSet& fragments = series.places.fragments();
    std::vector<vtkIdType> corners;
    for (const FragmentPlaces::Place& place : places) {
        const std::size_t f = at(place.fragment);
        corners.clear();
        for (const Vec3& vertex : fragments.verticesOf(place.fragment)) {
            corners.push_back(builder.addPoint(place.fromHandOver * vertex));
        }
        builder.addCell(fragments.solid[f], corners, series.elementIds[f], at(fragments.list[f].component));
        const bool clustered = series.clustering && f < series.clustering->of.size();
        builder.addFragmentNumbers(f, clustered ? static_cast<std::int64_t>(at(series.clustering->of[f])) : -1, place.speed);
    }
    return builder.text(series.componentNames);
}

std::string structureText(const Series& series, std::size_t state, const std::vector<FragmentPlaces::Place>& shown) {
    const Mesh& mesh = series.fe.mesh();
    std::vector<bool> isFragment(mesh.elementCount(), false);
    for (const FragmentPlaces::Place& place : shown) {
        isFragment[at(series.places.fragments().list[at(place.fragment)].element)] = true;
    }
    // Loose parts of it leave with the last state.
    for (std::size_t i = 0; state + 1 == series.fe.stateCount() && i < series.islands.size(); ++i) {
        for (const ElementIndex e : series.islands[i].elements) {
            isFragment[at(e)] = true;
        }
    }
    const std::shared_ptr<const FeState> positions = series.fe.state(state);
    std::vector<vtkIdType> pointOf(mesh.nodeCount(), -1);
    GridBuilder builder(series.site);
    std::vector<vtkIdType> corners;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const ElementIndex element = idAt<ElementIndex>(e);
        if (isFragment[e] || !series.fe.activity().active(state, element)) {
            continue;
        }
        corners.clear();
        for (const std::uint32_t node : mesh.cornersOf(element)) {
            if (pointOf[node] < 0) {
                pointOf[node] = builder.addPoint(positions->positions[node]);
            }
            corners.push_back(pointOf[node]);
        }
        builder.addCell(mesh.shapes[e], corners, mesh.elementIds[e], at(series.componentOf[e]));
    }
    return builder.text(series.componentNames);
}

/// The released islands where their bodies are.
std::string releasedText(const Series& series, double time) {
    const Mesh& mesh = series.fe.mesh();
    const TrajectoryFrame frame = frameAtTime(series.run, time);
    const std::shared_ptr<const FeState> positions = series.fe.state(series.fe.stateCount() - 1);
    GridBuilder builder(series.site);
    std::vector<vtkIdType> pointOf(mesh.nodeCount(), -1);
    std::vector<vtkIdType> corners;
    for (const IslandRecord& island : series.islands) {
        const std::size_t body = at(island.body);
        if (body >= frame.bodies()) {
            continue;
        }
        const Pose& birth = series.bodies[body].atBirth;
        const Quat turn = frame.orientations[body].cast<double>().normalized() * birth.orientation.conjugate();
        const Vec3 place = frame.positions[body].cast<double>();
        for (const ElementIndex e : island.elements) {
            corners.clear();
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                if (pointOf[node] < 0) {
                    pointOf[node] = builder.addPoint(place + turn * (positions->positions[node] - birth.position));
                }
                corners.push_back(pointOf[node]);
            }
            builder.addCell(mesh.shapes[at(e)], corners, mesh.elementIds[at(e)], at(series.componentOf[at(e)]));
        }
    }
    return builder.text(series.componentNames);
}

/// One instant of the series: its time, and the FE state whose structure it shows.
struct Instant {
    double time = 0.0;
    std::size_t state = 0;
};

// Every FE state that the run reached; after the last, frames about as far apart as the states, and the very last one.
std::vector<Instant> instantsOf(const Series& series) {
    const std::vector<double>& times = series.fe.times();
    const std::size_t frames = series.run.frameCount();
    const double reached = frames ? series.run.frameTime(frames - 1) : times.front();
    std::vector<Instant> instants;
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (k == 0 || times[k] <= reached || series.run.complete()) {
            instants.push_back({times[k], k});
        }
    }
    const double spacing = times.size() > 1 ? (times.back() - times.front()) / static_cast<double>(times.size() - 1) : 0.0;
    for (std::size_t i = 0; i < frames; ++i) {
        const double time = series.run.frameTime(i);
        const bool far = time >= instants.back().time + 0.999 * spacing;
        if (time > times.back() && (far || i + 1 == frames)) {
            instants.push_back({time, times.size() - 1});
        }
    }
    return instants;
}

constexpr std::array<const char*, 3> partNames{"fragments", "structure", "released"};

std::string numberedName(const char* stem, std::size_t number) {
    std::array<char, 48> name{};
    std::snprintf(name.data(), name.size(), "%s_%05zu.vtu", stem, number);
    return name.data();
}

// Files of an earlier, longer series in the same folder would only mislead.
void removeStale(const fs::path& folder, const std::vector<PvdEntry>& entries) {
    std::set<std::string> current;
    for (const PvdEntry& entry : entries) {
        current.insert(fs::path(entry.file).filename().string());
    }
    std::error_code ignored;
    std::vector<fs::path> stale;
    for (const auto& file : fs::directory_iterator(folder, ignored)) {
        const std::string name = file.path().filename().string();
        const bool ours = file.path().extension() == ".vtu" &&
                          std::any_of(partNames.begin(), partNames.end(),
                                      [&](const char* part) { return name.starts_with(std::string(part) + '_'); });
        if (ours && !current.contains(name)) {
            stale.push_back(file.path());
        }
    }
    for (const fs::path& file : stale) {
        fs::remove(file, ignored);
    }
}

void writeText(const fs::path& path, const std::string& text) {
    writeAtomically(path.string(), [&text](std::ostream& out) { out << text; });
}

void writeInstants(const Series& series, const fs::path& folder, const std::string& path, std::vector<PvdEntry>& entries,
                   const Execution& execution) {
    const std::vector<Instant> instants = instantsOf(series);
    std::optional<std::pair<std::size_t, std::string>> lastStructure;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        execution.report(Message{"io.export.series", "Writing {0}", {path}},
                         static_cast<double>(i) / static_cast<double>(instants.size()));
        const Instant& instant = instants[i];
        const std::vector<FragmentPlaces::Place> places = series.places.at(instant.time);
        const std::string fragments = numberedName("fragments", i);
        writeText(folder / fragments, fragmentsText(series, places));
        // The structure stands still after the last state: one file serves all these instants.
        if (!lastStructure || lastStructure->first != instant.state) {
            lastStructure = {instant.state, numberedName("structure", instant.state)};
            writeText(folder / lastStructure->second, structureText(series, instant.state, places));
        }
        const std::string prefix = folder.filename().string() + "/";
        entries.push_back({instant.time, 0, partNames[0], prefix + fragments});
        entries.push_back({instant.time, 1, partNames[1], prefix + lastStructure->second});
        if (!series.islands.empty() && instant.state + 1 == series.fe.stateCount()) {
            const std::string released = numberedName("released", i);
            writeText(folder / released, releasedText(series, instant.time));
            entries.push_back({instant.time, 2, partNames[2], prefix + released});
        }
    }
}

}  // namespace

void exportSeries(const std::string& path, const RunReader& run, const FeResult& fe, const Execution& execution) {
    const Series series = makeSeries(run, fe);
    fs::path folder = fs::path(path).replace_extension();
    if (folder == fs::path(path)) {
        folder += "_files";
    }
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw WorldError(
            Message{"io.series.folder", "Cannot make the folder {0} for the series", {folder.string()}},
            Message{"io.series.folder.remedy", "Check free space and rights of the folder, or choose another place.", {}});
    }
    std::vector<PvdEntry> entries;
    try {
        writeInstants(series, folder, path, entries, execution);
    } catch (const Cancelled&) {
        // What was written so far is a series as well.
        writePvdIndex(path, entries);
        throw;
    }
    writePvdIndex(path, entries);
    removeStale(folder, entries);
    writeProvenance(path, provenanceText(run));
    execution.report(Message{"io.export.series", "Writing {0}", {path}}, 1.0);
}

}  // namespace rubble::io
