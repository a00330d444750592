#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// One state of a series as its index has it: where it lies, and when it is.
struct GridEntry {
    std::optional<double> time;        ///< s; nothing: the files say, or nobody
    std::vector<std::string> files;    ///< grids; several where a state is written in pieces
    std::vector<std::string> indices;  ///< that name them
    std::vector<std::string> left;     ///< blocks that are no unstructured grid
    std::vector<std::string> again;    ///< files that are named once more, each as often as that; they are among the others once
};

/// The states that a file stands for, in the order in which they were written: those that a .pvd or .series lists; else the file
/// itself and those beside it whose names differ only in the number before the ending. Each is a grid, or what a .pvtu or .vtm
/// names. Entries of one time are pieces if their parts differ; of one part the later is the same state written again.
/// @param alone  the file itself only
/// Throws WorldError, ParseError (place, what is wrong).
std::vector<GridEntry> indexGrids(const std::string& path, bool alone);

/// The files that indexGrids() takes for states because of their numbers; none where an index lists them.
std::vector<std::string> numberedGrids(const std::string& path);

/// The index that stands for a file: a .pvtu or .vtm that names it as a piece; a .pvd or .series that lists it or its index, the
/// first by name; of several indices with one content the first by name. They are sought in the folder of the file and the two
/// above it. The file itself where there is none. Never throws.
std::string canonicalIndex(const std::string& path);

/// The .pvtu or .vtm that names a file as a piece of a state; empty: there is none. Never throws.
std::string wholeOfPiece(const std::string& path);

}  // namespace rubble::io
