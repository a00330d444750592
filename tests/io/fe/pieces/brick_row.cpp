#include "tests/io/fe/pieces/brick_row.h"

#include <map>

namespace rubble::io {

namespace {

template <class T>
std::string array(const std::string& type, const std::string& name, int components, const std::vector<T>& values) {
    std::string text = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
                       "\" format=\"ascii\">\n";
    for (const T& value : values) {
        text += std::to_string(value) + " ";
    }
    return text + "\n</DataArray>\n";
}

}  // namespace

std::string BrickRow::vtu() const {
    std::map<std::pair<int, int>, std::int64_t> known;  // of x and lift, where bricks share points
    std::vector<double> points;
    std::vector<std::int64_t> corners, ends, types, nodes;
    const auto point = [&](int x, int corner, int brick) {
        const bool lifted = brick >= liftFrom;
        const auto [found, isNew] = known.try_emplace({8 * x + corner + (lifted ? 4 : 0), ownPoints ? brick : 0},
                                                      static_cast<std::int64_t>(points.size() / 3));
        if (isNew) {
            points.insert(points.end(),
                          {double(x), double(corner == 1 || corner == 2), (corner >= 2 ? 1.0 : 0.0) + (lifted ? 0.5 : 0.0)});
            nodes.push_back(4 * x + corner + nodesBy.value_or(0));
        }
        return found->second;
    };
    for (const int brick : bricks) {
        for (const int x : {brick, brick + 1}) {
            for (int corner = 0; corner < 4; ++corner) {
                corners.push_back(point(x, corner, brick));
            }
        }
        ends.push_back(static_cast<std::int64_t>(corners.size()));
        types.push_back(12);
    }
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n";
    text += time ? "<FieldData>" + array<double>("Float64", "TimeValue", 1, {*time}) + "</FieldData>\n" : "";
    text += "<Piece NumberOfPoints=\"" + std::to_string(points.size() / 3) + "\" NumberOfCells=\"" + std::to_string(bricks.size()) +
            "\">\n<PointData>\n";
    text += nodesBy ? array("Int64", "NODE_ID", 1, nodes) : "";
    text += "</PointData>\n<CellData>\n";
    text += status.empty() ? "" : array("Int32", "STATUS", 1, status);
    text += ghosts.empty() ? "" : array("Int32", "vtkGhostType", 1, ghosts);
    text += elements.empty() ? "" : array("Int64", "ELEMENT_ID", 1, elements);
    text += "</CellData>\n<Points>\n" + array("Float64", "Points", 3, points) + "</Points>\n<Cells>\n";
    text += array("Int64", "connectivity", 1, corners) + array("Int64", "offsets", 1, ends) + array("Int64", "types", 1, types);
    return text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string pvtu(const std::vector<std::string>& pieces) {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\">\n<PUnstructuredGrid GhostLevel=\"1\">\n";
    for (const std::string& piece : pieces) {
        text += "<Piece Source=\"" + piece + "\"/>\n";
    }
    return text + "</PUnstructuredGrid>\n</VTKFile>\n";
}

std::string pvd(const std::vector<std::vector<std::string>>& lines) {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">\n<Collection>\n";
    for (const std::vector<std::string>& line : lines) {
        text += "<DataSet " + (line[0].empty() ? "" : "timestep=\"" + line[0] + "\" ") + "part=\"" + line[1] + "\" file=\"" +
                line[2] + "\"/>\n";
    }
    return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace rubble::io
