#include "app/cli/exports/export_request.h"

#include <algorithm>
#include <array>

#include "app/cli/exports/page_request.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/exports/exports.h"

namespace rubble::cli {

std::span<const ExportKind> exportKinds() {
    static constexpr std::array<ExportKind, 9> kinds{
        {{"fragments", "*.csv", "table of all fragments: birth, rest, speeds, mass", "any spreadsheet, pandas, R"},
         {"series", "*.pvd", "fragments and structure over time, a folder of VTU files", "ParaView, VisIt, VTK"},
         {"vtkhdf", "*.vtkhdf", "the same over time in one file", "ParaView from 5.12 on, VTK from 9.3 on"},
         {"bodies", "*.xdmf", "bodies as points over time, read out of the run file itself", "ParaView (its Xdmf3 reader)"},
         {"gltf", "*.glb", "fragments with their motion, glTF 2.0, metres, y up", "Blender, three.js, web viewers"},
         {"page", "*.html", "one page with both views, timeline, health and provenance; no network",
          "any web browser of 2023 and later"},
         {"debris-map", "*.tif, *.gpkg, *.csv, *.png", "a debris map: height, volume, mass and more by cells",
          "QGIS, ArcGIS, GDAL"},
         {"footprint", "*.gpkg", "footprint, height contours and fragments as shapes", "QGIS, ArcGIS, GDAL"},
         {"figure", "*.png, *.svg, *.pdf", "a picture of the views at one instant", "any viewer"}}};
    return kinds;
}

Option ExportRequest::option() {
    return {"--export", "KIND=PATH", true,
            "write a file of this kind: fragments=F.csv, series=D.pvd, vtkhdf=F.vtkhdf, bodies=F.xdmf, gltf=F.glb, "
            "page=F.html, debris-map=F.tif (.gpkg, .csv, .png), footprint=F.gpkg, figure=F.png (.svg, .pdf); rubble-cli export "
            "--list says what "
            "reads them"};
}

ExportRequest::ExportRequest(const Arguments& arguments, std::span<const std::string> inputs)
    : m_figure(arguments), m_map(arguments) {
    for (const std::string& text : arguments.values("--export")) {
        const auto [kind, path] = splitAssignment("--export", text);
        if (kind == "figure") {
            FigureRequest::checkFormat("--export figure", path);
        } else if (kind == "debris-map") {
            MapRequest::checkFormat("--export debris-map", path);
        } else if (kind == "footprint" && !io::hasEnding(path, ".gpkg")) {
            throw wrongValue("--export footprint", path, "a GeoPackage, whose name ends in .gpkg");
        } else if (kind == "gltf" && !io::hasEnding(path, ".glb")) {
            throw wrongValue("--export gltf", path, "a binary glTF file, whose name ends in .glb");
        } else if (kind == "page" && !io::hasEnding(path, ".html")) {
            throw wrongValue("--export page", path, "a page, whose name ends in .html");
        } else if (kind == "vtkhdf" && !io::hasEnding(path, ".vtkhdf")) {
            throw wrongValue("--export vtkhdf", path, "a VTKHDF file, whose name ends in .vtkhdf");
        }
        const auto known = exportKinds();
        if (std::none_of(known.begin(), known.end(), [&, &name = kind](const ExportKind& row) { return row.name == name; })) {
            std::string names;
            for (const ExportKind& row : known) {
                names += (names.empty() ? "" : ", ") + std::string(row.name);
            }
            throw UsageError({"cli.export_kind", "--export {0}: there is no export of the kind \"{1}\".", {text, kind}},
                             {"cli.export_kind.remedy", "Kinds: {0}.", {names}});
        }
        m_rows.push_back({kind, path});
        checkOutputPath(path, inputs);
    }
}

bool ExportRequest::readsFe(const Row& row) {
    return row.kind != "fragments" && row.kind != "gltf" && row.kind != "bodies";
}

bool ExportRequest::needsFe(const io::RunReader& run) const {
    return std::any_of(m_rows.begin(), m_rows.end(),
                       [&](const Row& row) { return readsFe(row) || (row.kind == "gltf" && !run.islands().empty()); });
}

void ExportRequest::checkKept() const {
    for (const Row& row : m_rows) {
        if (row.kind == "bodies") {
            throw UsageError(
                {"cli.export_kept", "--export bodies={0}: this file refers to the run file, which is not kept.", {row.path}},
                {"cli.export_kept.remedy", "Keep the run with --out RUN.h5.", {}});
        }
    }
}

void ExportRequest::perform(const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs, const RunSurroundings& around,
                            Session& session) const {
    std::optional<RunMap> map;
    const Execution& execution = session.execution();
    for (const Row& row : m_rows) {
        execution.check();
        if (row.kind == "fragments") {
            io::exportFragments(row.path, *run, execution);
        } else if (row.kind == "series") {
            io::exportSeries(row.path, *run, *inputs.fe, execution);
        } else if (row.kind == "vtkhdf") {
            io::exportVtkHdf(row.path, *run, *inputs.fe, execution);
        } else if (row.kind == "bodies") {
            io::exportBodies(row.path, *run, execution);
        } else if (row.kind == "gltf") {
            io::exportGltf(row.path, *run, inputs.fe.get(), execution);
        } else if (row.kind == "page") {
            writePage(row.path, run, inputs, around, session);
        } else if (row.kind == "figure") {
            execution.report({"cli.stage.figure", "Drawing the figure", {}}, 0.0);
            m_figure.write(row.path, run, inputs, around, session.execution());
            execution.report({"cli.stage.figure", "Drawing the figure", {}}, 1.0);
        } else {
            if (!map) {
                map = m_map.make(*run, inputs, execution);
            }
            m_map.write(row.path, *map, *run, session);
        }
    }
}

std::vector<std::string> ExportRequest::paths() const {
    std::vector<std::string> paths;
    for (const Row& row : m_rows) {
        paths.push_back(row.path);
    }
    return paths;
}

}  // namespace rubble::cli
