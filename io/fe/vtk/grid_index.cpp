#include "io/fe/vtk/grid_index.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/base/error.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/vtk/index_text.h"
#include "io/fe/vtk/piece_index.h"
#include "io/fe/vtk/time_index.h"

namespace rubble::io {

namespace {

using Path = std::filesystem::path;

constexpr int foldersAbove = 2;

bool isTimeIndex(const std::string& head) {
    return head.find("\"file-series-version\"") != std::string::npos || vtkTypeOf(head) == "Collection";
}

std::vector<ListedFile> listedBy(const std::string& index, const std::string& head) {
    return vtkTypeOf(head) == "Collection" ? listedByPvd(index) : listedBySeries(index);
}

// Whether or not they are there.
std::vector<std::string> namesListed(const std::string& index, const std::string& head) {
    std::vector<std::string> files;
    for (const ListedFile& entry : listedBy(index, head)) {
        files.push_back(entry.file);
    }
    return files;
}

GridEntry stateOf(const std::string& index, const std::optional<double>& time, const ListedState& listed) {
    for (const std::string& file : listed.files) {
        requireMember(index, file);
    }
    StatePieces pieces = piecesOfState(listed.files);
    GridEntry entry{time, std::move(pieces.grids), std::move(pieces.indices), std::move(pieces.left), listed.again};
    entry.again.insert(entry.again.end(), pieces.again.begin(), pieces.again.end());
    return entry;
}

bool endsAsIndex(const std::string& name) {
    constexpr std::array<const char*, 8> endings{".pvd", ".series", ".pvtu", ".vtm", ".vtmb", ".vth", ".vtpc", ".vtpd"};
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return name.ends_with(ending); });
}

// Files that may name this one: in its folder and in those above.
std::vector<std::string> indicesNear(const std::string& path) {
    std::vector<std::string> near;
    std::string beside = path;
    for (int above = 0; above <= foldersAbove; ++above) {
        for (const std::string& other : filesBeside(beside)) {
            if (endsAsIndex(other) && !sameFile(other, path)) {
                near.push_back(other);
            }
        }
        const Path folder = Path(beside).parent_path();
        if (folder.empty() || folder == folder.root_path()) {
            break;
        }
        beside = folder.string();
    }
    return near;
}

// An index of times that lists the file, else an index of pieces that names it; empty: there is none.
std::string indexNaming(const std::string& path, bool timesToo) {
    std::string pieces;
    for (const std::string& candidate : indicesNear(path)) {
        try {
            const std::string head = headOfFile(candidate);
            const bool times = isTimeIndex(head);
            if ((times && !timesToo) || (!times && !isPieceIndex(vtkTypeOf(head)))) {
                continue;
            }
            const std::vector<std::string> files = times ? namesListed(candidate, head) : namedPieces(candidate);
            const bool names = std::any_of(files.begin(), files.end(), [&](const auto& file) { return sameFile(file, path); });
            if (names && times) {
                return candidate;
            }
            if (names && pieces.empty()) {
                pieces = candidate;
            }
        } catch (const std::exception&) {
            // What cannot be read as an index names nothing; opening it says why.
        }
    }
    return pieces;
}

}  // namespace

std::vector<GridEntry> indexGrids(const std::string& path, bool alone) {
    const std::string head = headOfFile(path);
    std::vector<GridEntry> entries;
    if (isTimeIndex(head)) {
        for (const ListedState& state : statesListed(listedBy(path, head))) {
            entries.push_back(stateOf(path, state.time, state));
        }
    } else if (head.starts_with("# vtk DataFile") || vtkTypeOf(head) == "UnstructuredGrid" || isPieceIndex(vtkTypeOf(head))) {
        const std::vector<std::string> siblings = alone ? std::vector<std::string>{path} : numberedSiblings(path);
        for (const std::string& sibling : siblings) {
            try {
                entries.push_back(stateOf(path, std::nullopt, {0.0, {sibling}, {}}));
            } catch (const ParseError&) {
                // The last index may still be being written: its grid is not whole either.
                if (siblings.size() == 1 || sibling != siblings.back()) {
                    throw;
                }
                entries.push_back({std::nullopt, {sibling}, {}, {}, {}});
            }
        }
    } else {
        requireNotEmpty(path);
        throw ParseError({"vtk.kind", "{0} is a VTK file, but no unstructured grid", {path}},
                         {"vtk.kind.remedy", "Write the result as an unstructured grid (.vtu) or a series of them (.pvd).", {}});
    }
    if (entries.empty() || entries.front().files.empty()) {
        failIndex(path, "it names no files");
    }
    return entries;
}

std::vector<std::string> numberedGrids(const std::string& path) {
    return isTimeIndex(headOfFile(path)) ? std::vector<std::string>{} : numberedSiblings(path);
}

std::string wholeOfPiece(const std::string& path) {
    return indexNaming(path, false);
}

std::string canonicalIndex(const std::string& path) {
    std::string current = path;
    for (int depth = 0; depth < 8 && !isTimeIndex(headOfFile(current)); ++depth) {
        const std::string index = indexNaming(current, true);
        if (index.empty()) {
            return current;
        }
        current = index;
    }
    try {
        const std::vector<std::string> own = namesListed(current, headOfFile(current));
        for (const std::string& candidate : filesBeside(current)) {
            const std::string head = endsAsIndex(candidate) ? headOfFile(candidate) : std::string();
            if (!own.empty() && isTimeIndex(head) && namesListed(candidate, head) == own) {
                return candidate;
            }
        }
    } catch (const std::exception&) {
        // What cannot be read as an index stands for itself; opening it says why.
    }
    return current;
}

}  // namespace rubble::io
