#include "io/fe/radioss/radioss_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/fe/node_fields.h"
#include "io/fe/radioss/radioss_mesh.h"
#include "io/fe/series/later_branch.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr std::uint8_t deleted = 0, active = 1, rigid = 255;

bool allDigits(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// A name taken apart: run, number, ending.
struct NumberedName {
    std::string run;
    std::int64_t number = -1;
    bool packed = false;
};

NumberedName nameOf(std::string name, const std::string& marks, const std::string& ending) {
    NumberedName result;
    result.packed = name.ends_with(".gz");
    name.resize(name.size() - (result.packed ? 3 : 0));
    if (!name.ends_with(ending)) {
        return {};
    }
    name.resize(name.size() - ending.size());
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::string number = name.substr(digits);
    result.run = name.substr(0, digits);
    const bool marked = marks.empty() || (!result.run.empty() && marks.find(result.run.back()) != std::string::npos);
    if (!marked || !allDigits(number) || number.size() < 3 || number.size() > 9) {
        return {};
    }
    result.number = std::stoll(number);
    return result;
}

/// Reads the status of all files and keeps what belongs to a state.
class RadiossRunReader {
public:
    RadiossRunReader(const RadiossRun& run, const Execution& execution) : m_run(run), m_execution(execution) {}

    FeResult::Contents read() {
        const Message stage{"anim.open", "Reading the states", {}};
        m_execution.report(stage, 0.0);
        const AnimState first = m_run.read(m_run.files.front(), AnimWanted::Everything);
        requireTime(m_run.files.front(), first.time);
        const StarterDeck deck = readStarterDeck(m_run.deck);
        m_mesh = makeRadiossMesh(m_run.files.front(), first, deck.parts);
        m_declared = unitsOf(deck);
        for (std::size_t i = 0; i < m_run.files.size(); ++i) {
            m_execution.report(stage, static_cast<double>(i) / static_cast<double>(m_run.files.size()));
            readStatus(i, first);
        }
        m_execution.report(stage, 1.0);
        keepLaterBranch();
        return finish(first);
    }

private:
    void requireTime(const std::string& path, double time) const {
        if (!std::isfinite(time)) {
            throw ParseError({"anim.bad_time", "{0}: the time of the state is {1}", {path, time}},
                             {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
        }
    }

    void readStatus(std::size_t i, const AnimState& first) {
        const std::string& path = m_run.files[i];
        AnimState state;
        try {
            state = m_run.read(path, AnimWanted::Status);
        } catch (const ParseError& error) {
            if (error.message().id != "anim.cut" || i == 0) {
                throw;
            }
            noteCut(path, i + 1 == m_run.files.size());
            return;
        }
        requireTime(path, state.time);
        requireSameMesh(path, state, first);
        m_files.push_back(path);
        m_times.push_back(state.time);
        m_rows.push_back(rowOf(state));
        keepDeletion(state);
    }

    void keepLaterBranch() {
        const std::vector<std::size_t> kept = laterBranch(m_times, m_findings);
        for (std::size_t k = 0; k < kept.size(); ++k) {
            m_files[k] = m_files[kept[k]];
            m_times[k] = m_times[kept[k]];
            m_rows[k] = m_rows[kept[k]];
            m_deletions[k] = m_deletions[kept[k]];
        }
        m_files.resize(kept.size());
        m_times.resize(kept.size());
        m_rows.resize(kept.size());
        m_deletions.resize(kept.size());
        settleDeletions();
    }

    void noteCut(const std::string& path, bool last) {
        const std::string name = fs::path(path).filename().string();
        if (last) {
            m_findings.add({"anim.incomplete", "The last state is not complete and was left out", {}},
                           {"anim.incomplete.remedy", "Open the result again once the analysis has gone on.", {}}, name);
        } else {
            m_findings.add({"anim.cut_state", "States within the series are cut off and were left out", {}},
                           {"anim.cut_state.remedy", "Copy these files again.", {}}, name);
        }
    }

    void requireSameMesh(const std::string& path, const AnimState& state, const AnimState& first) const {
        for (std::size_t kind = 0; kind < animKinds; ++kind) {
            if (state.elements[kind].count != first.elements[kind].count || state.elements[kind].ids != first.elements[kind].ids) {
                throw ParseError({"anim.other_mesh",
                                  "{0} has other elements than {1}: {2} of one kind, where there were {3}, or other numbers",
                                  {path, m_run.files.front(), state.elements[kind].count, first.elements[kind].count}},
                                 {"anim.other_mesh.remedy", "Check that all files are of one run; move the others away.", {}});
            }
        }
    }

    // Whether elements are active, in the order of the mesh.
    std::vector<bool> rowOf(const AnimState& state) {
        std::vector<bool> row;
        row.reserve(m_mesh.places.size());
        for (std::size_t e = 0; e < m_mesh.places.size(); ++e) {
            const auto& [kind, place] = m_mesh.places[e];
            const std::uint8_t off = state.of(kind).off[place];
            m_rigid += m_rows.empty() && off == rigid ? 1 : 0;
            if (off != deleted && off != active && off != rigid) {
                m_findings.add({"anim.odd_status", "The status of elements is neither 0, 1 nor 255; these count as active", {}},
                               {"anim.odd_status.remedy", "Check these elements; the file may be damaged.", {}},
                               "element " + englishInteger(m_mesh.mesh.elementIds[e]) + " at time " + englishNumber(state.time) +
                                   ": " + std::to_string(off));
            }
            row.push_back(off != deleted);
        }
        return row;
    }

    void keepDeletion(const AnimState& state) {
        std::vector<std::pair<std::size_t, double>>& times = m_deletions.emplace_back();
        for (std::size_t e = 0; e < m_mesh.places.size(); ++e) {
            const auto& [kind, place] = m_mesh.places[e];
            const std::vector<double>& deletion = state.of(kind).deletion;
            if (place < deletion.size() && deletion[place] > 0.0 && std::isfinite(deletion[place])) {
                times.emplace_back(e, deletion[place]);
            }
        }
    }

    // The newest state knows best.
    void settleDeletions() {
        m_deletion.assign(m_mesh.places.size(), unknown);
        for (const auto& times : m_deletions) {
            for (const auto& [e, time] : times) {
                m_deletion[e] = time;
            }
        }
    }

    FeResult::Contents finish(const AnimState& first) {
        const std::size_t states = m_times.size(), elements = m_mesh.places.size();
        FeResult::Contents contents;
        contents.activity = Activity(states, elements);
        for (std::size_t k = 0; k < states; ++k) {
            for (std::size_t e = 0; e < elements; ++e) {
                contents.activity.set(k, idAt<ElementIndex>(e), m_rows[k][e]);
            }
        }
        contents.activityFrom = m_run.activeFrom;
        if (m_rigid > 0) {
            contents.activityFrom += " (" + englishInteger(m_rigid) + " rigid)";
        }
        contents.declared = m_declared;
        settleDeathTimes(contents);
        contents.mesh = std::make_shared<const Mesh>(std::move(m_mesh.mesh));
        contents.times = m_times;
        contents.hasVelocity = !first.velocities.empty();
        contents.source = makeSource(contents);
        contents.findings = std::move(m_mesh.findings);
        contents.findings.append(m_findings);
        noteGaps(contents.findings);
        return contents;
    }

    // An exact time lies between the last state that shows the element and the first that does not.
    void settleDeathTimes(FeResult::Contents& contents) {
        const double rounding = 1e-6;
        bool any = false;
        for (std::size_t e = 0; e < m_deletion.size(); ++e) {
            const auto id = idAt<ElementIndex>(e);
            std::size_t k = 0;
            while (k < m_times.size() && contents.activity.active(k, id)) {
                ++k;
            }
            double& time = m_deletion[e];
            if (std::isnan(time)) {
                continue;
            }
            const bool dies = k > 0 && k < m_times.size();
            const double slack = dies ? rounding * std::max(std::abs(m_times[k]), std::abs(time)) : 0.0;
            if (!dies || time < m_times[k - 1] - slack || time > m_times[k] + slack) {
                m_findings.add({"anim.death_time",
                                "Times of deletion lie outside the interval in which the element dies; they were left out",
                                {}},
                               {"anim.death_time.remedy", "Nothing to do: these deaths are known by their states.", {}},
                               "element " + englishInteger(m_mesh.mesh.elementIds[e]) + ": " + englishNumber(time));
                time = unknown;
                continue;
            }
            any = true;
        }
        if (any) {
            contents.deathTime = std::move(m_deletion);
        }
    }

    std::shared_ptr<const StateSource> makeSource(const FeResult::Contents& contents) {
        const auto read = m_run.read;
        const std::size_t nodes = m_mesh.fileNodes;
        const auto particles = std::make_shared<const Particles>(std::move(m_mesh.particles));
        const bool velocity = contents.hasVelocity;
        return std::make_shared<const FieldSource>(
            m_run.files.front(), contents.mesh, contents.activity, m_times,
            [read, nodes, particles, velocity, files = m_files](std::size_t k) {
                AnimState state = read(files[k], AnimWanted::Nodes);
                if (state.positions.size() != nodes || state.velocities.size() != (velocity ? nodes : 0)) {
                    throw ParseError({"anim.other_nodes",
                                      "{0} has {1} nodes and {2} velocities; expected: {3} and {4}",
                                      {files[k], state.positions.size(), state.velocities.size(), nodes, velocity ? nodes : 0}},
                                     {"anim.other_mesh.remedy", "Check that all files are of one run; move the others away.", {}});
                }
                NodeFields fields{std::move(state.positions), std::move(state.velocities)};
                particles->appendCorners(fields.positions);
                if (velocity) {
                    particles->appendVelocities(fields.velocities);
                }
                return fields;
            });
    }

    void noteGaps(Findings& findings) const {
        std::int64_t before = -1;
        for (const std::string& file : m_run.files) {
            const std::string whole = fs::path(file).filename().string();
            std::string_view name = whole;
            for (const std::string_view ending : {".gz", ".vtk"}) {
                name.remove_suffix(name.ends_with(ending) ? ending.size() : 0);
            }
            const std::string digits(name.substr(name.find_last_not_of("0123456789") + 1));
            const std::int64_t number = allDigits(digits) && digits.size() < 10 ? std::stoll(digits) : -1;
            if (before >= 0 && number != before + 1) {
                findings.add({"anim.gap", "Numbers are missing in the series; deaths are known less exactly there", {}},
                             {"anim.gap.remedy", "Copy the missing files beside the others.", {}},
                             "before " + fs::path(file).filename().string(), number - before - 1);
            }
            before = number;
        }
    }

    const RadiossRun& m_run;
    const Execution& m_execution;
    RadiossMesh m_mesh;
    std::vector<std::string> m_files;
    std::vector<double> m_times;
    std::vector<std::vector<bool>> m_rows;
    std::int64_t m_rigid = 0;
    std::vector<std::vector<std::pair<std::size_t, double>>> m_deletions;  // element and time, of each state
    std::vector<double> m_deletion;
    std::optional<FileUnits> m_declared;
    Findings m_findings;
};

}  // namespace

std::vector<std::string> numberedMembers(const std::string& path, const std::string& marks, const std::string& ending) {
    const fs::path folder = fs::path(path).parent_path();
    const NumberedName own = nameOf(fs::path(path).filename().string(), marks, ending);
    if (own.number < 0) {
        return {path};
    }
    std::map<std::int64_t, std::pair<bool, std::string>> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const fs::path name = entry->path().filename();
        const NumberedName other = nameOf(name.string(), marks, ending);
        if (other.number < 0 || other.run != own.run) {
            continue;
        }
        // Of a file that lies there both ways the unpacked one is read.
        const auto known = found.find(other.number);
        if (known == found.end() || known->second.first) {
            found[other.number] = {other.packed, (folder / name).string()};
        }
    }
    std::vector<std::string> members;
    for (const auto& [number, file] : found) {
        members.push_back(file.second);
    }
    return members.empty() ? std::vector<std::string>{path} : members;
}

FeResult::Contents readRadiossRun(const RadiossRun& run, const Execution& execution) {
    return RadiossRunReader(run, execution).read();
}

}  // namespace rubble::io
