#include <algorithm>
#include <array>
#include <filesystem>
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

/// Writes the part of a column that belongs to one frame.
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
        slab.append_attribute("ItemType") = "HyperSlab";
        slab.append_attribute("Dimensions") = shape(frame.bodies).c_str();
        pugi::xml_node where = slab.append_child("DataItem");
        where.append_attribute("Dimensions") = wide ? "3 2" : "3 1";
        where.append_attribute("Format") = "XML";
        const std::string first = std::to_string(frame.offset);
        const std::string ones = wide ? " 0 1 1 " : " 1 ";
        where.text() = (first + ones + shape(frame.bodies)).c_str();
        pugi::xml_node whole = slab.append_child("DataItem");
        whole.append_attribute("Format") = "HDF";
        whole.append_attribute("NumberType") = column.number;
        whole.append_attribute("Precision") = column.precision;
        whole.append_attribute("Dimensions") = shape(m_columns.rows(column.dataset)).c_str();
        whole.text() = (m_run + ":" + layout.path).c_str();
    }

private:
    const RunColumns& m_columns;
    std::string m_run;
};

void addFrame(pugi::xml_node series, const FrameRow& frame, const FrameItems& items) {
    pugi::xml_node grid = series.append_child("Grid");
    grid.append_attribute("Name") = "bodies";
    grid.append_attribute("GridType") = "Uniform";
    grid.append_child("Time").append_attribute("Value") = exactNumber(frame.time).c_str();
    pugi::xml_node topology = grid.append_child("Topology");
    topology.append_attribute("TopologyType") = "Polyvertex";
    topology.append_attribute("NumberOfElements") = std::to_string(frame.bodies).c_str();
    topology.append_attribute("NodesPerElement") = "1";
    pugi::xml_node places = grid.append_child("Geometry");
    places.append_attribute("GeometryType") = "XYZ";
    items.add(places, geometry, frame);
    for (const BodyColumn& column : attributes) {
        pugi::xml_node attribute = grid.append_child("Attribute");
        attribute.append_attribute("Name") = column.name;
        attribute.append_attribute("AttributeType") = column.type;
        attribute.append_attribute("Center") = "Node";
        items.add(attribute, column, frame);
    }
}

}  // namespace

void exportBodies(const std::string& path, const RunReader& run, const Execution& execution) {
    const fs::path folder = fs::absolute(path).parent_path();
    const std::string relative =
        fs::absolute(run.path()).lexically_normal().lexically_proximate(folder.lexically_normal()).string();
    if (relative.find(':') != std::string::npos) {
        throw UsageError(
            Message{"io.bodies.name", "{0}: XDMF cannot name a run file with a colon in its path: {1}", {path, relative}},
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
    pugi::xml_node series = root.append_child("Domain").append_child("Grid");
    series.append_attribute("Name") = "run";
    series.append_attribute("GridType") = "Collection";
    series.append_attribute("CollectionType") = "Temporal";
    const FrameItems items(columns, relative);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        execution.report(Message{"io.export.bodies", "Writing {0}", {path}},
                         static_cast<double>(i) / static_cast<double>(frames.size()));
        addFrame(series, frames[i], items);
    }
    writeAtomically(path, [&](std::ostream& out) { document.save(out, " "); });
    writeProvenance(path, provenanceText(run));
    execution.report(Message{"io.export.bodies", "Writing {0}", {path}}, 1.0);
}

}  // namespace rubble::io
