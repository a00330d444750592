#include "io/fe/vtk/piece_index.h"

#include <algorithm>
#include <filesystem>

#include "io/fe/vtk/index_text.h"

namespace rubble::io {

namespace {

constexpr int deepest = 16;

void collect(const std::string& path, int depth, StatePieces& pieces) {
    const std::string head = headOfFile(path);
    const std::string type = vtkTypeOf(head);
    if (isPieceIndex(type)) {
        if (depth == deepest) {
            failIndex(path, "indices name each other");
        }
        pieces.indices.push_back(path);
        for (const std::string& piece : namedPieces(path)) {
            requireMember(path, piece);
            collect(piece, depth + 1, pieces);
        }
    } else if (depth > 0 && !type.empty() && type != "UnstructuredGrid") {
        pieces.left.push_back(std::filesystem::path(path).filename().string());
    } else {
        pieces.grids.push_back(path);
    }
}

void collectNames(pugi::xml_node node, const std::string& index, std::vector<std::string>& files) {
    for (const pugi::xml_node child : node.children()) {
        const std::string_view name = child.name();
        if (name == "DataSet" && child.attribute("file")) {
            files.push_back(namedByIndex(index, child.attribute("file").as_string()));
        } else if (name == "Piece" && child.attribute("Source")) {
            files.push_back(namedByIndex(index, child.attribute("Source").as_string()));
        } else {
            collectNames(child, index, files);
        }
    }
}

}  // namespace

bool isPieceIndex(std::string_view type) {
    return type == "PUnstructuredGrid" || type == "vtkMultiBlockDataSet" || type == "vtkMultiPieceDataSet" ||
           type == "vtkHierarchicalDataSet" || type == "vtkMultiGroupDataSet" || type == "vtkPartitionedDataSet" ||
           type == "vtkPartitionedDataSetCollection";
}

std::vector<std::string> namedPieces(const std::string& index) {
    std::vector<std::string> files;
    const pugi::xml_document document = indexXml(index);
    collectNames(document.child("VTKFile"), index, files);
    std::vector<std::string> once;
    for (const std::string& file : files) {
        // Some writers name a piece twice.
        if (std::find(once.begin(), once.end(), file) == once.end()) {
            once.push_back(file);
        }
    }
    return once;
}

StatePieces piecesOfState(const std::string& path) {
    StatePieces pieces;
    collect(path, 0, pieces);
    return pieces;
}

}  // namespace rubble::io
