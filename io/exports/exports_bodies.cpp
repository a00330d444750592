#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <pugixml.hpp>

#include "core/base/csv_text.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/run/run_columns.h"
#include "io/run/run_layout.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// A frame dataset as others see it.
struct BodyColumn {
    RunDataset dataset;
    const char* name;
    const char* type;       ///< of an XDMF attribute; empty for the geometry
    const char* number;     ///< of XDMF
    const char* precision;  ///< bytes
};

constexpr BodyColumn geometry{RunDataset::Positions, "positions", "", "Float", "4"};
constexpr std::array<BodyColumn, 3> attributes{{{RunDataset::Speeds, "speed", "Scalar", "Float", "4"},
                                                {RunDataset::States, "state", "Scalar", "UChar", "1"},
                                                {RunDataset::Orientations, "orientation", "Matrix", "Float", "4"}}};

/// Writes the part of a column that belongs to one frame: FILE:DATASET|first:stride:count:whole, as XDMF 3 writes a hyperslab. Its
/// older form, an item of its own, is read as nothing by the reader that ParaView opens the file with.
class FrameItems {
public:
    FrameItems(const RunColumns& columns, std::string run) : m_columns(columns), m_run(std::move(run)) {}

    void add(pugi::xml_node owner, const BodyColumn& column, const FrameRow& frame) const {
        const RunDatasetLayout& layout = layoutOf(column.dataset);
        const bool wide = layout.width > 1;
        const auto shape = [&](std::uint64_t rows) {
            return std::to_string(rows) + (wide ? " " + std::to_string(layout.width) : "");
        };
        pugi::xml_node slab = owner.append_child("DataItem");
        slab.append_attribute("Format") = "HDF";
        slab.append_attribute("NumberType") = column.number;
        slab.append_attribute("Precision") = column.precision;
        slab.append_attribute("Dimensions") = shape(frame.bodies).c_str();
        const std::string first = std::to_string(frame.offset) + (wide ? " 0" : "");
        const std::string stride = wide ? "1 1" : "1";
        slab.text() = (m_run + ":" + layout.path + "|" + first + ":" + stride + ":" + shape(frame.bodies) + ":" +
                       shape(m_columns.rows(column.dataset)))
                          .c_str();
    }

private:
    const RunColumns& m_columns;
    std::string m_run;
};

/// Writes the frames one after the other.
class FrameGrids {
public:
    FrameGrids(pugi::xml_node series, const FrameItems& items) : m_series(series), m_items(items) {}

    void add(const FrameRow& frame) {
        pugi::xml_node grid = m_series.append_child("Grid");
        ++m_count;
        grid.append_attribute("Name") = "bodies";
        grid.append_attribute("GridType") = "Uniform";
        grid.append_child("Time").append_attribute("Value") = exactNumber(frame.time).c_str();
        addTopology(grid, frame.bodies);
        pugi::xml_node places = grid.append_child("Geometry");
        places.append_attribute("GeometryType") = "XYZ";
        m_items.add(places, geometry, frame);
        for (const BodyColumn& column : attributes) {
            pugi::xml_node attribute = grid.append_child("Attribute");
            attribute.append_attribute("Name") = column.name;
            attribute.append_attribute("AttributeType") = column.type;
            attribute.append_attribute("Center") = "Node";
            m_items.add(attribute, column, frame);
        }
    }

private:
    /// Without its points named a cell is drawn by no reader. Frames of as many bodies share the list.
    void addTopology(pugi::xml_node grid, std::uint64_t bodies) {
        const auto [known, isNew] = m_topologyOf.emplace(bodies, m_count);
        if (!isNew) {
            grid.append_child("xi:include").append_attribute("xpointer") =
                ("xpointer(/Xdmf/Domain/Grid/Grid[" + std::to_string(known->second) + "]/Topology)").c_str();
            return;
        }
        pugi::xml_node topology = grid.append_child("Topology");
        topology.append_attribute("TopologyType") = "Polyvertex";
        topology.append_attribute("NumberOfElements") = std::to_string(bodies).c_str();
        topology.append_attribute("NodesPerElement") = "1";
        pugi::xml_node points = topology.append_child("DataItem");
        points.append_attribute("Format") = "XML";
        points.append_attribute("NumberType") = "Int";
        points.append_attribute("Dimensions") = std::to_string(bodies).c_str();
        std::string numbers;
        for (std::uint64_t i = 0; i < bodies; ++i) {
            numbers += (i > 0 ? " " : "") + std::to_string(i);
        }
        points.text() = numbers.c_str();
    }

    pugi::xml_node m_series;
    const FrameItems& m_items;
    std::size_t m_count = 0;
    std::map<std::uint64_t, std::size_t> m_topologyOf;  ///< number of the first frame with so many bodies, from 1
};

}  // namespace

void exportBodies(const std::string& path, const RunReader& run, const Execution& execution) {
    const fs::path folder = fs::absolute(path).parent_path();
    const std::string relative =
        fs::absolute(run.path()).lexically_normal().lexically_proximate(folder.lexically_normal()).string();
    if (relative.find_first_of(":|") != std::string::npos) {
        throw UsageError(
            Message{"io.bodies.name", "{0}: XDMF cannot name a run file with a colon or a bar in its path: {1}", {path, relative}},
            Message{"io.bodies.name.remedy", "Rename the run file, or put the XDMF file beside it.", {}});
    }
    RunColumns columns(run.path());
    std::vector<FrameRow> frames = columns.list<FrameRow>(RunDataset::Index);
    // Of a run that was killed only the whole frames count.
    frames.resize(std::min(frames.size(), run.frameCount()));
    std::erase_if(frames, [](const FrameRow& frame) { return frame.bodies == 0; });
    if (frames.empty()) {
        throw UsageError(Message{"io.bodies.nothing", "{0}: the run has no frame with a body", {path}},
                         Message{"io.bodies.nothing.remedy", "Choose a run in which elements were deactivated.", {}});
    }
    pugi::xml_document document;
    pugi::xml_node root = document.append_child("Xdmf");
    root.append_attribute("Version") = "3.0";
    root.append_attribute("xmlns:xi") = "http://www.w3.org/2001/XInclude";
    pugi::xml_node series = root.append_child("Domain").append_child("Grid");
    series.append_attribute("Name") = "run";
    series.append_attribute("GridType") = "Collection";
    series.append_attribute("CollectionType") = "Temporal";
    const FrameItems items(columns, relative);
    FrameGrids grids(series, items);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        execution.report(Message{"io.export.bodies", "Writing {0}", {path}},
                         static_cast<double>(i) / static_cast<double>(frames.size()));
        grids.add(frames[i]);
    }
    writeAtomically(path, [&](std::ostream& out) { document.save(out, " "); });
    writeProvenance(path, provenanceText(run));
    execution.report(Message{"io.export.bodies", "Writing {0}", {path}}, 1.0);
}

}  // namespace rubble::io
