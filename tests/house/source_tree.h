#pragma once

#include <string>
#include <vector>

namespace rubble::house {

/// One source file of the tree.
struct SourceFile {
    std::string path;  ///< relative to the root, "core/fe/mesh.h"
    std::vector<std::string> lines;

    bool header() const { return path.ends_with(".h"); }
    bool under(const std::string& folder) const { return path.starts_with(folder + "/"); }
};

/// An include directive.
struct Include {
    std::string name;  ///< what stands between the brackets or quotes
    bool quoted = false;
    std::size_t line = 0;  ///< 1-based
};

/// All .h and .cpp files under the given folders of the root, sorted by path.
std::vector<SourceFile> readSources(const std::vector<std::string>& folders);

/// The folders that hold the program.
std::vector<SourceFile> programSources();
/// The program, its tests and its benchmarks.
std::vector<SourceFile> allSources();

std::vector<Include> includesOf(const SourceFile& file);

/// "path:line", as compilers write it.
std::string place(const SourceFile& file, std::size_t line);

}  // namespace rubble::house
