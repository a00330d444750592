#include "io/fe/vtk/vtk_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/series/series_result.h"
#include "io/fe/vtk/grid_file.h"
#include "io/fe/vtk/grid_index.h"
#include "io/fe/vtk/grid_series.h"

namespace rubble::io {

namespace {

/// Grids in files of their own.
class FileGrids : public GridSource {
public:
    FileGrids(const std::string& path, bool alone) : m_entries(indexGrids(path, alone)) {
        dropUnfinished();
        readTimes();
    }

    const std::vector<double>& times() const override { return m_times; }
    bool timed() const { return m_timed; }
    /// The last files of the series, if they were not whole and left out.
    const std::vector<std::string>& unfinished() const { return m_unfinished; }
    /// Blocks of the first state that are no unstructured grid.
    const std::vector<std::string>& left() const { return m_entries.front().left; }
    /// Files that are named more than once for a state, and how often.
    std::vector<std::pair<std::string, std::int64_t>> listedAgain() const {
        std::vector<std::pair<std::string, std::int64_t>> all;
        for (const GridEntry& entry : m_entries) {
            std::map<std::string, std::int64_t> times;
            for (const std::string& file : entry.again) {
                ++times.try_emplace(std::filesystem::path(file).filename().string(), 1).first->second;
            }
            all.insert(all.end(), times.begin(), times.end());
        }
        return all;
    }
    /// The first file of each state.
    std::vector<std::string> firstFiles() const {
        std::vector<std::string> files;
        for (const GridEntry& entry : m_entries) {
            files.push_back(entry.indices.empty() ? entry.files.front() : entry.indices.front());
        }
        return files;
    }

    Grid read(std::size_t k, const GridSelection& selection) const override {
        const std::vector<std::string>& parts = m_entries[k].files;
        Grid grid = readGridFile(parts.front(), selection);
        for (std::size_t p = 1; p < parts.size(); ++p) {
            appendGrid(grid, readGridFile(parts[p], selection));
        }
        return grid;
    }

    bool sameCells(std::size_t k, const std::vector<std::string>&) const override {
        return k > 0 && m_entries[k].files == m_entries[k - 1].files;
    }

private:
    // The last states of a series may still be being written.
    void dropUnfinished() {
        for (bool whole = false; m_entries.size() > 1 && !whole;) {
            const std::vector<std::string>& files = m_entries.back().files;
            const auto broken = std::find_if_not(files.begin(), files.end(), isWholeGrid);
            whole = broken == files.end() && !files.empty();
            if (!whole) {
                m_unfinished.push_back(files.empty() ? std::string() : *broken);
                m_entries.pop_back();
            }
        }
    }

    static bool isWholeGrid(const std::string& file) {
        if (isEmptyFile(file)) {
            return false;
        }
        try {
            requireWholeGrid(file);
            return true;
        } catch (const ParseError&) {
            return false;
        }
    }

    // The index, else the files; where neither says them, states are counted.
    void readTimes() {
        for (GridEntry& entry : m_entries) {
            if (!entry.time) {
                entry.time = timeOfGridFile(entry.files.front());
            }
            if (entry.time && !std::isfinite(*entry.time)) {
                throw ParseError(
                    {"vtk.time", "{0} says that its time is {1}", {entry.files.front(), {*entry.time, "s"}}},
                    {"vtk.time.remedy", "Times must be finite: write the file again, or give a .pvd with the times.", {}});
            }
            m_timed &= entry.time.has_value();
        }
        for (std::size_t k = 0; k < m_entries.size(); ++k) {
            m_times.push_back(m_timed ? *m_entries[k].time : static_cast<double>(k));
        }
    }

    std::vector<GridEntry> m_entries;
    std::vector<double> m_times;
    bool m_timed = true;
    std::vector<std::string> m_unfinished;
};

bool listsLegacy(const FileHead& head) {
    return head.bytes.find(".vtk\"") != std::string::npos || head.path.ends_with(".vtk.series");
}

}  // namespace

bool recognisesVtkXml(const FileHead& head) {
    const bool index = head.bytes.find("\"file-series-version\"") != std::string::npos && !listsLegacy(head);
    return !head.packed && (index || head.bytes.substr(0, 1024).find("<VTKFile") != std::string::npos);
}

bool recognisesVtkLegacy(const FileHead& head) {
    const bool index = head.bytes.find("\"file-series-version\"") != std::string::npos && listsLegacy(head);
    return !head.packed && (index || head.bytes.starts_with("# vtk DataFile"));
}

std::vector<std::string> vtkMembers(const std::string& path) {
    std::string index = canonicalIndex(path);
    if (const std::vector<std::string> numbered = numberedGrids(index); !numbered.empty() && (index != path || isEmptyFile(path))) {
        // Whichever piece was given, or a file that is still empty: the first of the series stands for all.
        index = numbered.front();
    }
    std::vector<std::string> files;
    try {
        for (const GridEntry& entry : indexGrids(index, false)) {
            files.insert(files.end(), entry.files.begin(), entry.files.end());
        }
    } catch (const std::exception&) {
        return {index};
    }
    const bool isIndex = std::find(files.begin(), files.end(), index) == files.end();
    if (isIndex) {
        files.insert(files.begin(), index);
    }
    return withDeathList(std::move(files));
}

std::vector<std::string> vtkFilesAlone(const std::string& path) {
    std::vector<std::string> files{path};
    try {
        for (const GridEntry& entry : indexGrids(path, true)) {
            std::copy_if(entry.files.begin(), entry.files.end(), std::back_inserter(files),
                         [&](const std::string& file) { return file != path; });
        }
    } catch (const std::exception&) {
        // Opening it says why.
    }
    return withDeathList(std::move(files));
}

bool isVtkPiece(const std::string& path) {
    return !wholeOfPiece(path).empty();
}

FeResult::Contents readVtk(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    auto source = std::make_unique<const FileGrids>(path, settings.onlyThisFile);
    const FileGrids& grids = *source;
    const bool timed = grids.timed();
    const std::vector<std::string> unfinished = grids.unfinished(), left = grids.left(), states = grids.firstFiles();
    const std::vector<std::pair<std::string, std::int64_t>> again = grids.listedAgain();
    const auto series = std::make_shared<GridSeries>(path, std::move(source), settings);
    if (!timed) {
        // What an index lists are states, whenever they are.
        series->noteMissingTimes(numberedGrids(path).empty() ? std::vector<std::string>{path} : states);
    }
    for (const std::string& file : unfinished) {
        series->noteUnfinished(file);
    }
    for (const std::string& block : left) {
        series->noteLeftBlock(block);
    }
    for (const auto& [file, times] : again) {
        series->noteListedAgain(file, times);
    }
    if (!settings.onlyThisFile) {
        series->noteGaps(numberedGrids(path));
    }
    return readSeries(path, series, settings, execution);
}

}  // namespace rubble::io
