#include "io/fe/ansys/cdb_reader.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <unordered_map>

#include "core/base/error.h"
#include "io/fe/ansys/cdb_file.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

// The macro of the same name, else the only one in the folder.
std::string macroBeside(const std::string& path) {
    std::error_code ignored;
    const std::string own = fs::path(path).replace_extension(".mac").string();
    if (fs::is_regular_file(own, ignored)) {
        return own;
    }
    std::vector<std::string> macros;
    for (const std::string& other : filesBeside(path)) {
        if (other.ends_with(".mac")) {
            macros.push_back(other);
        }
    }
    return macros.size() == 1 ? macros.front() : "";
}

/// One database a state.
class CdbSeries : public MeshSeries {
public:
    explicit CdbSeries(std::vector<std::string> files) : m_files(std::move(files)) {
        noteNumberGaps(m_files, m_facts.findings);
        dropEmptyEnd();
        bool timed = true;
        for (std::size_t k = 0; k < m_files.size(); ++k) {
            requireNotEmpty(m_files[k]);
            const std::optional<CdbModel> model = readUnlessUnfinished(k);
            if (!model) {
                break;
            }
            m_facts.findings.append(model->findings);
            if (k == 0) {
                model->straight.note(m_facts.findings);
            }
            timed = timed && model->time.has_value();
            m_facts.times.push_back(model->time.value_or(0.0));
        }
        m_files.resize(m_facts.times.size());
        if (!timed) {
            m_facts.timed = false;
            for (std::size_t k = 0; k < m_facts.times.size(); ++k) {
                m_facts.times[k] = static_cast<double>(k);
            }
            m_facts.findings.add(
                {"vtk.no_times", "The series does not say when its states are: they were taken one second apart", {}},
                {"cdb.no_times.remedy",
                 "Write a line /COM,TIME=T into each file; if the files are no states of one analysis, set only_this_file=true.",
                 {}},
                takenForStates(m_files), static_cast<std::int64_t>(m_facts.times.size()));
        }
        m_facts.flag.name = "birth/death field";
    }

    SeriesStep step(std::size_t k) override {
        CdbModel model = readCdb(m_files[k]);
        SeriesStep step;
        step.flags = std::move(model.flags);
        step.mesh = std::move(model.mesh);
        return step;
    }

    SeriesFields fields(std::size_t k) const override {
        SeriesFields fields;
        fields.positions = readCdb(m_files[k]).mesh.nodes;
        return fields;
    }

private:
    // Files that an analysis has made and not yet filled.
    void dropEmptyEnd() {
        while (m_files.size() > 1 && isEmptyFile(m_files.back())) {
            noteUnfinished(m_files.back());
            m_files.pop_back();
        }
    }

    void noteUnfinished(const std::string& file) {
        m_facts.findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                             {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, file);
    }

    // The last state of a series may still be being written.
    std::optional<CdbModel> readUnlessUnfinished(std::size_t k) {
        try {
            CdbModel model = readCdb(m_files[k]);
            if (model.mesh.nodeCount() > 0 || k == 0 || k + 1 < m_files.size()) {
                return model;
            }
        } catch (const ParseError&) {
            if (k == 0 || k + 1 < m_files.size()) {
                throw;
            }
        }
        noteUnfinished(m_files[k]);
        return std::nullopt;
    }

    std::vector<std::string> m_files;
};

/// One database and the kills of a macro, or times of a list of deaths.
class KilledMesh : public MeshSeries {
public:
    KilledMesh(const std::string& path, const std::string& macro) : m_model(readCdb(path)) {
        m_facts.findings = m_model.findings;
        m_model.straight.note(m_facts.findings);
        if (!macro.empty()) {
            m_kills = readKills(macro, m_facts.times, m_facts.findings);
            m_facts.flag.name = "EKILL of " + fs::path(macro).filename().string();
            m_facts.flag.activeByName = 1;
        } else if (const std::string list = deathListBeside(path); !list.empty()) {
            for (const DeathEntry& entry : readDeathList(list)) {
                if (m_facts.times.empty() || entry.time > m_facts.times.back()) {
                    m_facts.times.push_back(entry.time);
                }
            }
        }
        if (m_facts.times.empty() || m_facts.times.front() > 0.0) {
            m_facts.times.insert(m_facts.times.begin(), 0.0);
        }
        m_facts.findings.add(
            {"cdb.still", "The file has no displacements: nodes stay where they are", {}},
            {"cdb.still.remedy", "Give a series of .cdb files with updated coordinates (UPCOORD), one a state.", {}}, path);
    }

    SeriesStep step(std::size_t k) override {
        SeriesStep step;
        if (k == 0) {
            step.mesh = m_model.mesh;
        }
        if (!m_kills.empty()) {
            std::unordered_map<std::int64_t, bool> active;
            for (const KillEvent& kill : m_kills) {
                if (kill.time <= m_facts.times[k]) {
                    active[kill.element] = kill.active;
                }
            }
            for (const std::int64_t number : m_model.mesh.elementIds) {
                const auto found = active.find(number);
                step.flags.push_back(found == active.end() || found->second ? 1.0 : 0.0);
            }
        }
        return step;
    }

    SeriesFields fields(std::size_t) const override {
        SeriesFields fields;
        fields.positions = m_model.mesh.nodes;
        return fields;
    }

private:
    CdbModel m_model;
    std::vector<KillEvent> m_kills;
};

}  // namespace

bool recognisesCdb(const FileHead& head) {
    return !head.packed && beginsAsCdb(head.bytes);
}

std::vector<std::string> cdbMembers(const std::string& path) {
    std::vector<std::string> files = numberedSiblings(path);
    return files.size() == 1 ? cdbFilesAlone(path) : withDeathList(std::move(files));
}

std::vector<std::string> cdbFilesAlone(const std::string& path) {
    std::vector<std::string> files{path};
    if (std::string macro = macroBeside(path); !macro.empty()) {
        files.push_back(std::move(macro));
    }
    return withDeathList(std::move(files));
}

FeResult::Contents readCdbs(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    std::vector<std::string> files = settings.onlyThisFile ? std::vector<std::string>{path} : numberedSiblings(path);
    std::shared_ptr<MeshSeries> series;
    if (files.size() > 1) {
        series = std::make_shared<CdbSeries>(std::move(files));
    } else {
        series = std::make_shared<KilledMesh>(path, macroBeside(path));
    }
    return readSeries(path, std::move(series), settings, execution);
}

}  // namespace rubble::io
