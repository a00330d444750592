#include "io/fe/exodus/exodus_activity.h"

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/series/flag_meaning.h"

namespace rubble::io {

namespace {

// Some writers say "never" by a very large time.
constexpr double latestTime = 1e15;

// A file without a flag under a known name is read as a sequence of one: what it leaves out is dead.
StatusVariable chooseStatus(const ExodusFile& file, const ImportSettings& settings) {
    const std::vector<std::string>& names = file.variables(ExodusEntity::Element);
    if (const auto found = findStatus(names, settings.statusVariable)) {
        return *found;
    }
    throw UsageError({"exodus.unknown_status", "{0} has no element variable \"{1}\"", {file.path(), settings.statusVariable}},
                     {"exodus.no_status.remedy",
                      "Say which variable tells active from dead elements: --set status_variable=NAME (and active_value=0 or 1), "
                      "or put a list of deaths (element,time) beside it as {1}. Element variables in the file: {0}",
                      {quotedList(names, 100), file.path() + ".deaths.csv"}});
}

/// Reads the flag of all parts that have it, state by state.
class ActivityReader {
public:
    ActivityReader(const ExodusFile& file, const ExodusMesh& mesh, const ImportSettings& settings, const Execution& execution)
        : m_file(file), m_mesh(mesh), m_settings(settings), m_execution(execution), m_status(chooseStatus(file, settings)) {
        const std::size_t states = file.times().size();
        m_result.activity = Activity(states, mesh.mesh.elementCount());
        m_values.resize(mesh.mesh.elementCount());
    }

    ExodusActivity read() {
        countUnflagged();
        const double activeValue = decideActiveValue();
        FlagMeaning meaning(activeValue, m_result.findings);
        const Message stage{"exodus.progress", "Reading active elements", {}};
        const std::size_t states = m_file.times().size();
        for (std::size_t k = 0; k < states; ++k) {
            m_execution.report(stage, static_cast<double>(k) / static_cast<double>(states));
            readState(k, meaning);
        }
        m_execution.report(stage, 1.0);
        describe(activeValue);
        readDeathTimes();
        return std::move(m_result);
    }

private:
    bool flagged(std::size_t part) const { return m_file.has(m_mesh.blocks[part], m_status.index); }

    std::span<double> valuesOf(std::size_t part) {
        return std::span(m_values).subspan(m_mesh.first[part], m_mesh.first[part + 1] - m_mesh.first[part]);
    }

    void countUnflagged() {
        for (std::size_t p = 0; p < m_mesh.blocks.size(); ++p) {
            if (!flagged(p)) {
                m_result.findings.add({"exodus.no_flag", "Elements of blocks without {0} count as always active", {m_status.name}},
                                      {"exodus.no_flag.remedy", "Nothing to do if these blocks cannot fail.", {}},
                                      "\"" + m_mesh.partOfRun(p).name + "\"", static_cast<std::int64_t>(valuesOf(p).size()));
            }
        }
    }

    double decideActiveValue() {
        if (m_settings.activeValue) {
            m_decidedBy = "as set";
            return *m_settings.activeValue;
        }
        if (m_status.activeByName) {
            m_decidedBy = "by its name";
            return *m_status.activeByName;
        }
        m_decidedBy = "held by most elements at the first state";
        std::vector<double> first;
        for (std::size_t p = 0; p < m_mesh.blocks.size() && !m_file.times().empty(); ++p) {
            if (flagged(p)) {
                const std::span<double> values = valuesOf(p);
                m_file.readElement(0, m_status.index, m_mesh.blocks[p], values);
                first.insert(first.end(), values.begin(), values.end());
            }
        }
        return mostCommonFlag(first);
    }

    void readState(std::size_t k, FlagMeaning& meaning) {
        Activity& activity = m_result.activity;
        for (std::size_t p = 0; p < m_mesh.blocks.size(); ++p) {
            const bool known = flagged(p);
            const std::span<double> values = valuesOf(p);
            if (known) {
                m_file.readElement(k, m_status.index, m_mesh.blocks[p], values);
            }
            for (std::size_t i = 0; i < values.size(); ++i) {
                const std::size_t e = m_mesh.first[p] + i;
                const ElementIndex id = idAt<ElementIndex>(e);
                const bool before = k == 0 || activity.active(k - 1, id);
                if (!known || meaning.active(values[i], before, m_mesh.mesh.elementIds[e], k)) {
                    activity.set(k, id, true);
                }
            }
        }
    }

    void describe(double activeValue) {
        const std::size_t elements = m_mesh.mesh.elementCount();
        const std::size_t active = m_file.times().empty() ? elements : m_result.activity.activeCount(0);
        m_result.from = m_status.name + ", " + englishNumber(activeValue) + " is active (" + m_decidedBy + "; " +
                        englishInteger(static_cast<std::int64_t>(active)) + " of " +
                        englishInteger(static_cast<std::int64_t>(elements)) + " active at the first state)";
        if (2 * active < elements) {
            m_result.findings.add({"exodus.polarity", "Most elements are inactive at the first state: {0}", {m_result.from}},
                                  {"exodus.polarity.remedy",
                                   "If the flag is the other way round: --set active_value={0}.",
                                   {activeValue == 0.0 ? 1 : 0}},
                                  m_status.name, static_cast<std::int64_t>(elements - active));
        }
    }

    // The last state knows every death; 0 stands for never.
    void readDeathTimes() {
        const int variable = findAny(
            m_file.variables(ExodusEntity::Element),
            {"death_time", "deathtime", "time_of_death", "tdel", "time_deletion", "time_deletion_element", "deletion_time"});
        if (variable < 0 || m_file.times().empty()) {
            return;
        }
        std::vector<double> times(m_values.size(), 0.0);
        for (std::size_t p = 0; p < m_mesh.blocks.size(); ++p) {
            if (m_file.has(m_mesh.blocks[p], variable)) {
                const std::span<double> part = std::span(times).subspan(m_mesh.first[p], m_mesh.first[p + 1] - m_mesh.first[p]);
                m_file.readElement(m_file.times().size() - 1, variable, m_mesh.blocks[p], part);
            }
        }
        bool any = false;
        for (double& time : times) {
            const bool known = time > 0.0 && time < latestTime;
            if (!known) {
                time = std::numeric_limits<double>::quiet_NaN();
            }
            any |= known;
        }
        if (any) {
            m_result.deathTime = std::move(times);
        }
    }

    const ExodusFile& m_file;
    const ExodusMesh& m_mesh;
    const ImportSettings& m_settings;
    const Execution& m_execution;
    const StatusVariable m_status;
    std::string m_decidedBy;
    std::vector<double> m_values;
    ExodusActivity m_result;
};

}  // namespace

ExodusActivity readExodusActivity(const ExodusFile& file, const ExodusMesh& mesh, const ImportSettings& settings,
                                  const Execution& execution) {
    return ActivityReader(file, mesh, settings, execution).read();
}

}  // namespace rubble::io
