#include "io/fe/abaqus/fil_reader.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/fe/abaqus/fil_model.h"
#include "io/fe/abaqus/fil_records.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

enum StateKey {
    elementHeader = 1,
    statusKey = 61,
    displacementKey = 101,
    velocityKey = 102,
    coordinatesKey = 107,
    incrementEnd = 2001
};

/// One increment that counts as a state: where it begins, and what it says of elements.
struct Increment {
    FilPlace place;
    std::vector<bool> recorded;  // [elements] a record of the element is there
    std::vector<bool> active;    // [elements] a record STATUS that is not 0
    std::vector<bool> flagged;   // [elements] a record STATUS
};

class FilSeries : public MeshSeries {
public:
    FilSeries(const std::string& path, const Execution& execution) : m_path(path), m_records(path) {
        FilRecord record;
        FilModel model = readFilModel(path, m_records, record);
        m_mesh = std::move(model.mesh);
        m_freedoms = model.freedoms;
        m_facts.findings = model.findings;
        assign(model.sets);
        for (std::size_t n = 0; n < m_mesh.nodeIds.size(); ++n) {
            m_nodes.emplace(m_mesh.nodeIds[n], n);
        }
        for (std::size_t e = 0; e < m_mesh.elementIds.size(); ++e) {
            m_elements.emplace(m_mesh.elementIds[e], e);
        }
        readIncrements(record, execution);
        m_facts.flag.name = m_hasStatus ? "STATUS" : "records of elements";
        m_facts.flag.activeByName = 1;
    }

    SeriesStep step(std::size_t k) override {
        SeriesStep step;
        if (k == 0) {
            step.mesh = m_mesh;
        }
        const Increment& increment = m_increments[k];
        if (m_hasStatus && std::find(increment.flagged.begin(), increment.flagged.end(), true) != increment.flagged.end()) {
            step.flags.assign(m_mesh.elementCount(), 1.0);
            for (std::size_t e = 0; e < step.flags.size(); ++e) {
                step.flags[e] = increment.flagged[e] && !increment.active[e] ? 0.0 : 1.0;
            }
        } else if (!m_hasStatus && m_someMissing) {
            step.flags.assign(m_mesh.elementCount(), 1.0);
            const bool any = std::find(increment.recorded.begin(), increment.recorded.end(), true) != increment.recorded.end();
            for (std::size_t e = 0; e < step.flags.size(); ++e) {
                step.flags[e] = !any ? unknown : increment.recorded[e] || !m_ever[e] ? 1.0 : 0.0;
            }
        }
        return step;
    }

    SeriesFields fields(std::size_t k) const override {
        SeriesFields fields;
        fields.positions = m_mesh.nodes;
        fields.velocities.assign(m_facts.hasVelocity ? m_mesh.nodeCount() : 0, Vec3::Zero());
        const std::scoped_lock lock(m_mutex);
        m_records.seek(m_increments[k].place);
        FilRecord record;
        m_records.next(record);
        while (m_records.next(record) && record.key != incrementEnd && record.key != filIncrementKey) {
            takeNodal(record, fields);
        }
        return fields;
    }

private:
    void assign(const std::vector<NamedSet>& sets) {
        const std::string path = inputDeckBeside(m_path);
        std::optional<InputDeck> deck;
        if (!path.empty()) {
            deck = readInputDeck(path);
        }
        assignParts(deck ? &*deck : nullptr, sets, m_mesh, m_facts.findings);
    }

    void readIncrements(FilRecord& record, const Execution& execution) {
        const Message stage{"fil.index", "Reading the increments", {}};
        while (record.key == filIncrementKey) {
            execution.report(stage, 0.0);
            const double time = record.real(0);
            const bool whole = readIncrement(record, time);
            if (!whole && m_facts.times.size() > 1) {
                m_facts.findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                                     {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, m_path);
                m_facts.times.pop_back();
                m_increments.pop_back();
            }
            while (record.key != filIncrementKey && m_records.next(record)) {
            }
        }
        m_ever.assign(m_mesh.elementCount(), false);
        for (const Increment& increment : m_increments) {
            for (std::size_t e = 0; e < m_ever.size(); ++e) {
                m_ever[e] = m_ever[e] || increment.recorded[e];
            }
        }
        const bool listed = !deathListBeside(m_path).empty();
        for (const Increment& increment : m_increments) {
            const bool any = std::find(increment.recorded.begin(), increment.recorded.end(), true) != increment.recorded.end();
            m_someMissing = m_someMissing || (any && !listed && increment.recorded != m_ever);
        }
    }

    // Two increments at one time: a step begins where the one before ends, and the newer counts.
    bool readIncrement(FilRecord& record, double time) {
        if (!m_facts.times.empty() && time == m_facts.times.back()) {
            m_facts.times.pop_back();
            m_increments.pop_back();
        }
        Increment increment;
        increment.place = m_records.place();
        increment.recorded.resize(m_mesh.elementCount());
        increment.active = increment.flagged = increment.recorded;
        std::size_t element = m_mesh.elementCount();
        bool ended = false;
        while (!ended && m_records.next(record) && record.key != filIncrementKey) {
            ended = record.key == incrementEnd;
            m_facts.hasVelocity = m_facts.hasVelocity || record.key == velocityKey;
            if (record.key == elementHeader) {
                const auto found = record.integer(3) == 4 ? m_elements.end() : m_elements.find(record.integer(0));
                element = found == m_elements.end() ? m_mesh.elementCount() : found->second;
                if (element < m_mesh.elementCount()) {
                    increment.recorded[element] = true;
                }
            } else if (record.key == statusKey && element < m_mesh.elementCount()) {
                takeStatus(record.real(0), element, increment);
            }
        }
        m_facts.times.push_back(time);
        m_increments.emplace_back(std::move(increment));
        return ended || !m_records.cutOff();
    }

    void takeStatus(double status, std::size_t element, Increment& increment) {
        m_hasStatus = true;
        const bool active = status != 0.0;
        if (increment.flagged[element] && increment.active[element] != active) {
            m_facts.findings.add(
                {"fil.status_differs", "Points of one element do not agree whether it is active; it counts as active", {}},
                {"fil.status_differs.remedy", "Nothing to do if the element dies soon after.", {}},
                "element " + englishInteger(m_mesh.elementIds[element]));
        }
        increment.flagged[element] = true;
        increment.active[element] = increment.active[element] || active;
    }

    void takeNodal(const FilRecord& record, SeriesFields& fields) const {
        if (record.key != displacementKey && record.key != velocityKey && record.key != coordinatesKey) {
            return;
        }
        const auto found = m_nodes.find(record.integer(0));
        if (found == m_nodes.end()) {
            return;
        }
        const std::size_t node = found->second;
        Vec3 value = Vec3::Zero();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t place = record.key == coordinatesKey ? axis + 1 : m_freedoms[axis];
            value[static_cast<Eigen::Index>(axis)] = place > 0 && place < record.size() ? record.real(place) : 0.0;
        }
        if (record.key == displacementKey) {
            fields.positions[node] = m_mesh.nodes[node] + value;
        } else if (record.key == coordinatesKey) {
            fields.positions[node] = value;
        } else if (!fields.velocities.empty()) {
            fields.velocities[node] = value;
        }
    }

    std::string m_path;
    mutable FilRecords m_records;
    mutable std::mutex m_mutex;
    Mesh m_mesh;
    std::array<std::size_t, 3> m_freedoms{};
    std::unordered_map<std::int64_t, std::size_t> m_nodes, m_elements;  // by number
    std::vector<Increment> m_increments;
    std::vector<bool> m_ever;  // elements of which there is a record at all
    bool m_hasStatus = false, m_someMissing = false;
};

}  // namespace

bool recognisesFil(const FileHead& head) {
    return !head.packed && beginsAsFil(head.bytes);
}

std::vector<std::string> filMembers(const std::string& path) {
    std::vector<std::string> files{path};
    if (std::string deck = inputDeckBeside(path); !deck.empty()) {
        files.push_back(std::move(deck));
    }
    return withDeathList(std::move(files));
}

FeResult::Contents readFil(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    return readSeries(path, std::make_shared<FilSeries>(path, execution), settings, execution);
}

}  // namespace rubble::io
