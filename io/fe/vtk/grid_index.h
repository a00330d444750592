#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// One state of a series as its index has it: where it lies, and when it is.
struct GridEntry {
    std::optional<double> time;      ///< s; nothing: the files say, or nobody
    std::vector<std::string> files;  ///< several where a state is written in parts
};

/// The states that a file stands for, in order: those a .pvd or .series lists; the pieces of a .pvtu; else the file itself and
/// those beside it whose names differ only in the number before the ending. Throws WorldError, ParseError (place, what is wrong).
std::vector<GridEntry> indexGrids(const std::string& path);

/// The files that indexGrids() takes for states because of their numbers; none where an index lists them.
std::vector<std::string> numberedGrids(const std::string& path);

/// The index that stands for a file: one beside it that lists it, the first by name; of several indices with one content the first
/// by name; the file itself where there is none. Never throws.
std::string canonicalIndex(const std::string& path);

}  // namespace rubble::io
