#include "io/fe/vtk/piece_index.h"

#include <filesystem>
#include <set>

#include "io/fe/vtk/index_text.h"

namespace rubble::io {

namespace {

constexpr int deepestTree = 16;

// Of files that are done already, as some writers name a piece twice, the cells would count twice.
void collect(const std::string& path, int depth, StatePieces& pieces, std::set<std::filesystem::path>& done) {
    std::error_code ignored;
    const std::filesystem::path place = std::filesystem::absolute(path, ignored).lexically_normal();
    if (done.contains(place)) {
        pieces.again.push_back(path);
        return;
    }
    const std::string head = headOfFile(path);
    const std::string type = vtkTypeOf(head);
    if (isPieceIndex(type)) {
        if (depth == deepestTree) {
            failIndex(path, "indices name each other");
        }
        pieces.indices.push_back(path);
        for (const std::string& piece : namedPieces(path)) {
            requireMember(path, piece);
            collect(piece, depth + 1, pieces, done);
        }
    } else if (depth > 0 && !type.empty() && type != "UnstructuredGrid") {
        pieces.left.push_back(std::filesystem::path(path).filename().string());
    } else {
        pieces.grids.push_back(path);
    }
    done.insert(place);
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
    return files;
}

StatePieces piecesOfState(const std::vector<std::string>& paths) {
    StatePieces pieces;
    std::set<std::filesystem::path> done;
    for (const std::string& path : paths) {
        collect(path, 0, pieces, done);
    }
    return pieces;
}

}  // namespace rubble::io
