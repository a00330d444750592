#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// One line of an index of times.
struct ListedFile {
    std::optional<double> time;  ///< s; nothing: the index has no times
    std::string part;            ///< as written; empty where the index knows no parts
    std::string file;
};

/// Lines of a .pvd, in their order. Times are read as loosely as other programs do: a line without one among others is at 0.
/// Throws ParseError.
std::vector<ListedFile> listedByPvd(const std::string& path);
/// Lines of a .series. Throws ParseError.
std::vector<ListedFile> listedBySeries(const std::string& path);

/// A state of an index: the files of all its parts.
struct ListedState {
    std::optional<double> time;
    std::vector<std::string> files;
    std::vector<std::string> again;  ///< of those, listed once more, each as often as that
};
/// The states in the order in which they were written: different parts of one time are pieces of one state; another file of the
/// same part is the state written again, unless the two lie at different places. An index that only is in disorder, as one sorted
/// by names, is put into the order of its times. Without times, a part that comes again begins the next state.
std::vector<ListedState> statesListed(const std::vector<ListedFile>& list);

}  // namespace rubble::io
