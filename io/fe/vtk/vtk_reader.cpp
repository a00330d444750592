#include "io/fe/vtk/vtk_reader.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "io/fe/series/series_result.h"
#include "io/fe/vtk/grid_file.h"
#include "io/fe/vtk/grid_index.h"
#include "io/fe/vtk/grid_series.h"

namespace rubble::io {

namespace {

/// Grids in files of their own.
class FileGrids : public GridSource {
public:
    explicit FileGrids(const std::string& path) : m_entries(indexGrids(path)) {
        dropUnfinished();
        readTimes();
    }

    const std::vector<double>& times() const override { return m_times; }
    bool timed() const { return m_timed; }
    /// The last file of the series, if it was not whole and left out.
    const std::string& unfinished() const { return m_unfinished; }

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
    // The last state of a series may still be being written.
    void dropUnfinished() {
        if (m_entries.size() > 1) {
            try {
                requireWholeGrids(m_entries.back().files);
            } catch (const ParseError&) {
                m_unfinished = m_entries.back().files.front();
                m_entries.pop_back();
            }
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
        if (m_timed && !std::is_sorted(m_entries.begin(), m_entries.end(), before)) {
            std::stable_sort(m_entries.begin(), m_entries.end(), before);
        }
        for (std::size_t k = 0; k < m_entries.size(); ++k) {
            m_times.push_back(m_timed ? *m_entries[k].time : static_cast<double>(k));
        }
    }

    static bool before(const GridEntry& a, const GridEntry& b) { return *a.time < *b.time; }

    std::vector<GridEntry> m_entries;
    std::vector<double> m_times;
    bool m_timed = true;
    std::string m_unfinished;
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
    const std::string index = canonicalIndex(path);
    std::vector<std::string> files;
    try {
        for (const GridEntry& entry : indexGrids(index)) {
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

FeResult::Contents readVtk(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    auto source = std::make_unique<const FileGrids>(path);
    const bool timed = source->timed();
    const std::string unfinished = source->unfinished();
    const auto series = std::make_shared<GridSeries>(path, std::move(source), settings);
    if (!timed) {
        series->noteMissingTimes();
    }
    if (!unfinished.empty()) {
        series->noteUnfinished(unfinished);
    }
    series->noteGaps(numberedGrids(path));
    return readSeries(path, series, settings, execution);
}

}  // namespace rubble::io
