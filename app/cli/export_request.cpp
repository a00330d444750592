#include "app/cli/export_request.h"

#include <algorithm>

#include "app/cli/option_value.h"
#include "app/cli/output_file.h"
#include "core/base/error.h"
#include "io/exports.h"

namespace rubble::cli {

Option ExportRequest::option() {
    return {"--export", "KIND=PATH", true,
            "fragments=F.csv: a table of all fragments; series=D.pvd: fragments and structure over time for ParaView; "
            "figure=F.png: a picture; "
            "debris-map=F.tif (.gpkg, .csv, .png): a debris map; footprint=F.gpkg: its outline, contours and fragments"};
}

ExportRequest::ExportRequest(const Arguments& arguments, std::span<const std::string> inputs)
    : m_figure(arguments), m_map(arguments) {
    for (const std::string& text : arguments.values("--export")) {
        const auto [kind, path] = splitAssignment("--export", text);
        if (kind == "fragments") {
            m_rows.push_back({Kind::Fragments, path});
        } else if (kind == "series") {
            m_rows.push_back({Kind::Series, path});
        } else if (kind == "figure") {
            m_rows.push_back({Kind::Figure, path});
        } else if (kind == "debris-map") {
            MapRequest::checkFormat("--export debris-map", path);
            m_rows.push_back({Kind::Map, path});
        } else if (kind == "footprint") {
            if (!path.ends_with(".gpkg")) {
                throw wrongValue("--export footprint", path, "a GeoPackage, whose name ends in .gpkg");
            }
            m_rows.push_back({Kind::Map, path});
        } else {
            throw UsageError({"cli.export_kind", "--export {0}: there is no export of the kind \"{1}\".", {text, kind}},
                             {"cli.export_kind.remedy", "Kinds: fragments, series, figure, debris-map, footprint.", {}});
        }
        checkOutputPath(path, inputs);
    }
}

bool ExportRequest::needsFe() const {
    return std::any_of(m_rows.begin(), m_rows.end(), [](const Row& row) { return row.kind != Kind::Fragments; });
}

void ExportRequest::perform(const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs, Session& session) const {
    std::optional<RunMap> map;
    for (const Row& row : m_rows) {
        session.execution().check();
        switch (row.kind) {
            case Kind::Fragments:
                io::exportFragments(row.path, *run, session.execution());
                break;
            case Kind::Series:
                io::exportSeries(row.path, *run, *inputs.fe, session.execution());
                break;
            case Kind::Figure:
                session.execution().report({"cli.stage.figure", "Drawing the figure", {}}, 0.0);
                m_figure.write(row.path, run, inputs);
                session.execution().report({"cli.stage.figure", "Drawing the figure", {}}, 1.0);
                break;
            case Kind::Map:
                if (!map) {
                    map = m_map.make(*run, inputs, session.execution());
                }
                m_map.write(row.path, *map, *run, session);
                break;
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
