#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubble::io {

/// True for a file that says which files make up one state: .pvtu, .vtm and its kin. @param type  see vtkTypeOf()
bool isPieceIndex(std::string_view type);

/// The files that such an index names itself, as often as it names them, whether or not they are there. Throws ParseError.
std::vector<std::string> namedPieces(const std::string& index);

/// What a file holds of one state: itself, or all grids that an index names, through any number of indices.
struct StatePieces {
    std::vector<std::string> grids;
    std::vector<std::string> indices;
    std::vector<std::string> left;   ///< blocks that are no unstructured grid, without folder
    std::vector<std::string> again;  ///< files that are named once more, each as often as that; their cells count once
};
/// @param paths  of one state  Throws WorldError for a piece that is not there, ParseError.
StatePieces piecesOfState(const std::vector<std::string>& paths);

}  // namespace rubble::io
