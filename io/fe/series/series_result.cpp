#include "io/fe/series/series_result.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "core/base/unknown.h"
#include "io/fe/node_fields.h"
#include "io/fe/pieces/doubled_points.h"
#include "io/fe/pieces/duplicate_cells.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/flag_meaning.h"
#include "io/fe/series/later_branch.h"
#include "io/fe/series/mesh_union.h"
#include "io/fe/series/part_membership.h"

namespace rubble::io {

namespace {

/// How the states of a series stand in the union of their meshes.
struct SeriesEpochs {
    std::vector<MeshEpoch> list;
    std::vector<std::uint32_t> ofState;  // [states that count]
    std::vector<std::size_t> written;    // which of the states that were written each is
};

NodeFields fieldsOf(const MeshSeries& series, const SeriesEpochs& epochs, std::size_t nodes, const std::string& path,
                    std::size_t k);

/// Reads the steps of a series into one mesh and its activity.
class SeriesJoin {
public:
    SeriesJoin(const std::string& path, MeshSeries& series, const ImportSettings& settings, const Execution& execution)
        : m_path(path),
          m_series(series),
          m_settings(settings),
          m_execution(execution),
          m_union(path, series.timed()),
          m_parts(settings.deadParts) {}

    void run() {
        m_epochs.written = laterBranch(m_series.times(), m_findings);
        for (const std::size_t written : m_epochs.written) {
            times.push_back(m_series.times()[written]);
        }
        readSteps();
        joinPoints();
        m_epochs.list = m_union.epochs();
        m_findings.append(m_series.findings());
        mesh = std::make_shared<const Mesh>(m_union.finish(m_findings));
        activity = Activity(m_steps.size(), mesh->elementCount());
        decide();
        readDeathTimes();
    }

    SeriesEpochs takeEpochs() { return std::move(m_epochs); }
    Findings takeFindings() { return std::move(m_findings); }

    std::shared_ptr<const Mesh> mesh;
    std::vector<double> times;  // of the states that count
    Activity activity;
    std::string activityFrom;
    std::vector<double> deathTime;

private:
    // Every step is read, since one may have the mesh of the one before; those of an abandoned branch are not kept.
    void readSteps() {
        const Message stage{"fe.steps", "Reading active elements", {}};
        std::optional<SeriesStep> withMesh;
        for (std::size_t written = 0; written < m_series.times().size(); ++written) {
            m_execution.report(stage, static_cast<double>(written) / static_cast<double>(m_series.times().size()));
            SeriesStep step = m_series.step(written);
            m_duplicates.leaveOut(step, m_findings);
            const std::size_t k = m_steps.size();
            std::vector<double> flags = std::move(step.flags);
            if (step.mesh) {
                withMesh = std::move(step);
            }
            if (k >= m_epochs.written.size() || m_epochs.written[k] != written) {
                continue;
            }
            if (withMesh) {
                m_union.add(*withMesh->mesh, withMesh->pieces, withMesh->cells, k);
                m_parts.add(*withMesh->mesh, m_union, k);
                withMesh.reset();
            }
            const auto epoch = static_cast<std::uint32_t>(m_union.epochs().size() - 1);
            m_epochs.ofState.push_back(epoch);
            if (!flags.empty() && flags.size() != m_union.epochs()[epoch].elementCount) {
                throw ParseError({"fe.flag_count",
                                  "{0}: {1} at state {2} has {3} values for {4} elements",
                                  {m_path, m_series.flag().name, k, flags.size(), m_union.epochs()[epoch].elementCount}},
                                 {"fe.flag_count.remedy", "The file is damaged: copy it again or write it again.", {}});
            }
            readFlags(k, flags);
        }
        m_execution.report(stage, 1.0);
    }

    void joinPoints() {
        m_epochs.list = m_union.epochs();
        const WrittenPoints points{
            m_union.mesh(),
            m_union.pieceOfNode(),
            m_union.numbersNodes(),
            m_union.sharesNodes(),
            m_epochs.written.size(),
            [this](std::size_t k) { return fieldsOf(m_series, m_epochs, m_union.mesh().nodeCount(), m_path, k).positions; }};
        if (const std::vector<std::uint32_t> standsFor = doubledPoints(points, m_execution, m_findings); !standsFor.empty()) {
            m_union.joinNodes(standsFor);
        }
    }

    // One bit an element and state: what is there and active.
    void readFlags(std::size_t k, const std::vector<double>& flags) {
        if (!flags.empty() && !m_meaning) {
            decidePolarity(flags);
        }
        const MeshEpoch& epoch = m_union.epochs().back();
        m_last.resize(m_union.elementCount(), true);
        std::vector<bool>& bits = m_steps.emplace_back(epoch.elementCount);
        for (std::size_t i = 0; i < epoch.elementCount; ++i) {
            const std::size_t e = epoch.element(i);
            if (!flags.empty()) {
                m_last[e] = m_meaning->active(flags[i], m_last[e], m_union.elementNumber(e), k);
            }
            bits[i] = m_last[e] && !m_parts.dead(e);
        }
    }

    void decidePolarity(const std::vector<double>& flags) {
        const SeriesFlag& flag = m_series.flag();
        double activeValue = 1.0;
        std::string decidedBy = "as set";
        if (m_settings.activeValue) {
            activeValue = *m_settings.activeValue;
        } else if (flag.activeByName) {
            activeValue = *flag.activeByName;
            decidedBy = "by its name";
        } else {
            activeValue = mostCommonFlag(flags);
            decidedBy = "held by most elements at the first state";
        }
        m_meaning.emplace(activeValue, m_findings);
        activityFrom = flag.name + ", " + englishNumber(activeValue) + " is active (" + decidedBy + ")";
    }

    void decide() {
        const std::string list = deathListBeside(m_path);
        const std::string byParts = m_parts.decidedBy();
        const bool flagged = m_meaning.has_value() || !byParts.empty();
        m_parts.note(m_findings, m_path);
        if (!byParts.empty()) {
            activityFrom += (activityFrom.empty() ? "" : "; ") + byParts;
        }
        markActive();
        if (flagged && m_series.flag().alwaysZeroIsRigid) {
            reviveRigid();
        }
        if (!flagged && !list.empty() && !someLeave()) {
            activityFrom = applyDeathList(list, *mesh, times, activity, deathTime, m_findings);
            describeFirst();
            return;
        }
        if (!list.empty()) {
            noteUnusedDeathList(list, m_findings);
        }
        if (!flagged) {
            noteNothingMissing();
        }
        if (m_union.epochs().size() > 1 && flagged) {
            activityFrom += "; missing elements are dead";
        }
        describeFirst();
    }

    void describeFirst() {
        const std::size_t elements = mesh->elementCount(), active = activity.activeCount(0);
        activityFrom += " (" + englishInteger(static_cast<std::int64_t>(active)) + " of " +
                        englishInteger(static_cast<std::int64_t>(elements)) + " active at the first state)";
        if (2 * active < elements) {
            m_findings.add({"fe.polarity", "Most elements are inactive at the first state: {0}", {activityFrom}},
                           {"fe.polarity.remedy", "If the flag is the other way round: --set active_value=0 or 1.", {}},
                           m_series.flag().name, static_cast<std::int64_t>(elements - active));
        }
    }

    void markActive() {
        for (std::size_t k = 0; k < m_steps.size(); ++k) {
            const MeshEpoch& epoch = m_epochs.list[m_epochs.ofState[k]];
            for (std::size_t i = 0; i < epoch.elementCount; ++i) {
                activity.set(k, idAt<ElementIndex>(epoch.element(i)), m_steps[k][i]);
            }
        }
    }

    // Elements that a later state leaves out are dead; those that come later say nothing of deaths.
    bool someLeave() const {
        for (std::size_t k = 1; k < m_steps.size(); ++k) {
            for (std::size_t e = 0; e < mesh->elementCount(); ++e) {
                if (activity.active(k - 1, idAt<ElementIndex>(e)) && !activity.active(k, idAt<ElementIndex>(e))) {
                    return true;
                }
            }
        }
        return false;
    }

    // What the flag calls dead from the first state to the last, while others live, is rigid.
    void reviveRigid() {
        std::int64_t count = 0;
        std::string example;
        for (std::size_t e = 0; e < mesh->elementCount(); ++e) {
            const ElementIndex id = idAt<ElementIndex>(e);
            bool ever = false;
            for (std::size_t k = 0; k < m_steps.size() && !ever; ++k) {
                ever = activity.active(k, id);
            }
            if (!ever) {
                for (std::size_t k = 0; k < m_steps.size(); ++k) {
                    activity.set(k, id, true);
                }
                if (count++ == 0) {
                    example = "element " + englishInteger(mesh->elementIds[e]);
                }
            }
        }
        if (count > 0) {
            m_findings.add({"fe.rigid",
                            "Elements that {0} calls dead at every state were taken for rigid ones that stand",
                            {m_series.flag().name}},
                           {"fe.rigid.remedy", "Give the animation files themselves: they tell rigid from dead.", {}}, example,
                           count);
        }
    }

    // A result in which nothing dies is a result; the user is told how to say what does.
    void noteNothingMissing() {
        bool missing = false;
        for (std::size_t k = 0; k < m_steps.size(); ++k) {
            missing = missing || activity.activeCount(k) != mesh->elementCount();
        }
        activityFrom = missing ? "missing elements are dead" : "nothing says which elements are dead";
        if (!missing) {
            noteNoDeaths(m_path, mesh->elementCount(), m_series.flag().choices, m_findings);
        }
    }

    void readDeathTimes() {
        const auto known = m_series.deathTimes();
        if (known.empty()) {
            return;
        }
        if (m_union.renumbered()) {
            m_findings.add(
                {"fe.renumbered_times", "Exact times of death were left out: numbers do not stay with their elements", {}},
                {"fe.renumbered_times.remedy", "Nothing to do: these deaths are known by their states.", {}}, m_path,
                static_cast<std::int64_t>(known.size()));
            return;
        }
        const std::unordered_map<std::int64_t, double> byNumber{known.begin(), known.end()};
        deathTime.assign(mesh->elementCount(), unknown);
        for (std::size_t e = 0; e < mesh->elementCount(); ++e) {
            if (const auto found = byNumber.find(mesh->elementIds[e]); found != byNumber.end()) {
                deathTime[e] = found->second;
            }
        }
    }

    const std::string& m_path;
    MeshSeries& m_series;
    const ImportSettings& m_settings;
    const Execution& m_execution;
    MeshUnion m_union;
    DuplicateCells m_duplicates;
    SeriesEpochs m_epochs;
    Findings m_findings;
    PartMembership m_parts;
    std::optional<FlagMeaning> m_meaning;
    std::vector<std::vector<bool>> m_steps;  // active or not, in the order of each state's mesh
    std::vector<bool> m_last;                // the newest known, in the order of the union
};

NodeFields fieldsOf(const MeshSeries& series, const SeriesEpochs& epochs, std::size_t nodes, const std::string& path,
                    std::size_t k) {
    const SeriesFields fields = series.fields(epochs.written[k]);
    const MeshEpoch& epoch = epochs.list[epochs.ofState[k]];
    if (fields.positions.size() != epoch.nodeCount || (!fields.velocities.empty() && fields.velocities.size() != epoch.nodeCount)) {
        throw ParseError({"fe.state_changed",
                          "{0}: state {1} has {2} nodes instead of the {3} it had when it was opened",
                          {path, k, fields.positions.size(), epoch.nodeCount}},
                         {"fe.state_changed.remedy", "Open the result again.", {}});
    }
    // Nodes that this state does not have stay without a value: the source puts them where they were at first.
    NodeFields result;
    result.positions.assign(nodes, Vec3::Constant(unknown));
    result.velocities.assign(series.hasVelocity() ? nodes : 0, Vec3::Constant(unknown));
    for (std::size_t i = 0; i < fields.positions.size(); ++i) {
        result.positions[epoch.node(i)] = fields.positions[i];
    }
    for (std::size_t i = 0; i < fields.velocities.size() && !result.velocities.empty(); ++i) {
        result.velocities[epoch.node(i)] = fields.velocities[i];
    }
    if (fields.velocities.empty()) {
        std::fill(result.velocities.begin(), result.velocities.end(), Vec3(Vec3::Zero()));
    }
    return result;
}

}  // namespace

FeResult::Contents readSeries(const std::string& path, std::shared_ptr<MeshSeries> series, const ImportSettings& settings,
                              const Execution& execution) {
    if (series->times().empty()) {
        throw ParseError({"fe.no_states", "{0} has no states: it is a mesh without results", {path}},
                         {"fe.no_states.remedy", "Give the result file of the analysis, not its input mesh.", {}});
    }
    SeriesJoin join(path, *series, settings, execution);
    join.run();
    FeResult::Contents contents;
    contents.mesh = join.mesh;
    contents.times = join.times;
    contents.hasVelocity = series->hasVelocity();
    contents.activity = join.activity;
    contents.activityFrom = join.activityFrom;
    contents.deathTime = join.deathTime;
    contents.findings = join.takeFindings();
    const auto read = [series, epochs = join.takeEpochs(), nodes = join.mesh->nodeCount(), path](std::size_t k) {
        return fieldsOf(*series, epochs, nodes, path, k);
    };
    contents.source = std::make_shared<const FieldSource>(path, join.mesh, join.activity, contents.times, read);
    return contents;
}

void noteNoDeaths(const std::string& path, std::size_t elements, const std::vector<std::string>& choices, Findings& findings) {
    const std::string list = path + ".deaths.csv";
    const Message what{"fe.no_deaths", "Nothing says which elements are dead: all count as active", {}};
    Message remedy{"fe.no_deaths.remedy",
                   "Put a list of deaths (element,time) beside it as {0}, or let the analysis write the status of its elements.",
                   {list}};
    if (!choices.empty()) {
        remedy = {"fe.no_deaths.choices",
                  "Name the flag: --set status_variable=NAME (there are {0}), or put a list of deaths (element,time) beside it as "
                  "{1}.",
                  {quotedList(choices, 100), list}};
    }
    findings.add(what, remedy, path, static_cast<std::int64_t>(elements));
}

std::vector<std::string> withDeathList(std::vector<std::string> files) {
    if (const std::string list = deathListBeside(files.front()); !list.empty()) {
        files.push_back(list);
    }
    return files;
}

}  // namespace rubble::io
