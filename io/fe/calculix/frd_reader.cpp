#include "io/fe/calculix/frd_reader.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <unordered_map>

#include "io/fe/abaqus/deck_parts.h"
#include "io/fe/abaqus/input_deck.h"
#include "io/fe/calculix/frd_file.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

class FrdSeries : public MeshSeries {
public:
    explicit FrdSeries(const std::string& path) : m_file(path), m_mesh(m_file.mesh()) {
        m_facts.findings.append(m_file.findings());
        for (const FrdState& state : m_file.states()) {
            m_facts.times.push_back(state.time);
        }
        for (std::size_t n = 0; n < m_mesh.nodeIds.size(); ++n) {
            m_nodes.emplace(m_mesh.nodeIds[n], n);
        }
        findGivenNodes(path);
        if (const std::string deck = inputDeckBeside(path); !deck.empty()) {
            m_deck = readInputDeck(deck);
            std::vector<NamedSet> materials;
            for (std::size_t p = 0; p < m_mesh.parts.size(); ++p) {
                NamedSet& set = materials.emplace_back(NamedSet{m_mesh.parts[p].name, {}});
                for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
                    if (m_mesh.part[e] == p) {
                        set.members.push_back(m_mesh.elementIds[e]);
                    }
                }
            }
            assignParts(&*m_deck, materials, m_mesh, m_facts.findings);
        }
        m_facts.flag.activeByName = 1;
        m_byDeck = m_deck && deckChangesElements();
        m_facts.flag.name = m_byDeck ? "MODEL CHANGE of the input deck" : "nodes of elements";
        m_byNodes = !m_byDeck && deathListBeside(path).empty() && someNodesMissing();
        if (m_byNodes) {
            m_facts.findings.add(
                {"frd.inferred",
                 "The file does not say which elements are dead: those with a node that a state leaves out were taken",
                 {}},
                {"frd.inferred.remedy",
                 "Elements whose nodes all belong to living ones are missed: put the input deck (.inp) with its MODEL "
                 "CHANGE beside it.",
                 {}},
                path);
        }
    }

    SeriesStep step(std::size_t k) override {
        SeriesStep step;
        if (k == 0) {
            step.mesh = m_mesh;
        }
        if (m_byDeck) {
            step.flags = flagsByDeck(m_file.states()[k].step);
        } else if (m_byNodes) {
            step.flags = flagsByNodes(k);
        }
        return step;
    }

    SeriesFields fields(std::size_t k) const override {
        SeriesFields fields;
        fields.positions.assign(m_mesh.nodeCount(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        for (std::size_t n = 0; n < m_mesh.nodeCount(); ++n) {
            if (!m_given[n]) {
                fields.positions[n] = m_mesh.nodes[n];
            }
        }
        const FrdValues values = m_file.read(m_file.states()[k]);
        for (std::size_t i = 0; i < values.nodes.size(); ++i) {
            if (const auto found = m_nodes.find(values.nodes[i]); found != m_nodes.end()) {
                fields.positions[found->second] = m_mesh.nodes[found->second] + values.values[i];
            }
        }
        return fields;
    }

private:
    // Displacements may be written for a set of nodes alone: all states leave out the same, so nothing has gone.
    void findGivenNodes(const std::string& path) {
        const auto& states = m_file.states();
        m_given.assign(m_mesh.nodeCount(), true);
        const auto whole = [&](const FrdState& state) { return state.nodes >= m_mesh.nodeCount(); };
        if (states.empty() || someNodesMissing() || std::any_of(states.begin(), states.end(), whole)) {
            return;
        }
        m_given.assign(m_mesh.nodeCount(), false);
        for (const FrdState& state : states) {
            for (const std::int64_t number : m_file.read(state).nodes) {
                if (const auto found = m_nodes.find(number); found != m_nodes.end()) {
                    m_given[found->second] = true;
                }
            }
        }
        std::vector<bool> noted = m_given;
        for (const std::uint32_t node : m_mesh.corners) {
            if (noted[node]) {
                continue;
            }
            noted[node] = true;
            m_facts.findings.add(
                {"frd.node_set", "Nodes of elements have displacements at no state: they were left where they are at rest", {}},
                {"frd.node_set.remedy", "Let the analysis write all nodes: *NODE FILE without NSET.", {}},
                "node " + englishInteger(m_mesh.nodeIds[node]) + "; the first state has " +
                    englishInteger(static_cast<std::int64_t>(states.front().nodes)) + " of " +
                    englishInteger(static_cast<std::int64_t>(m_mesh.nodeCount())) + " nodes (" + path + ")");
        }
    }

    // A deck that changes contacts alone, or elements of another model, says nothing of deaths.
    bool deckChangesElements() const {
        return std::any_of(m_deck->changes.begin(), m_deck->changes.end(), [&](const DeckChange& change) {
            return std::any_of(m_mesh.elementIds.begin(), m_mesh.elementIds.end(),
                               [&](std::int64_t number) { return change.elements.contains(number); });
        });
    }

    bool someNodesMissing() const {
        const auto& states = m_file.states();
        return std::any_of(states.begin(), states.end(),
                           [&](const FrdState& state) { return state.nodes != states.front().nodes; });
    }

    std::vector<double> flagsByDeck(std::int64_t step) const {
        std::vector<double> flags(m_mesh.elementCount(), 1.0);
        for (const DeckChange& change : m_deck->changes) {
            for (std::size_t e = 0; change.step <= step && e < flags.size(); ++e) {
                if (change.elements.contains(m_mesh.elementIds[e])) {
                    flags[e] = change.remove ? 0.0 : 1.0;
                }
            }
        }
        return flags;
    }

    std::vector<double> flagsByNodes(std::size_t k) const {
        std::vector<bool> there(m_mesh.nodeCount(), false);
        for (const std::int64_t number : m_file.read(m_file.states()[k]).nodes) {
            if (const auto found = m_nodes.find(number); found != m_nodes.end()) {
                there[found->second] = true;
            }
        }
        std::vector<double> flags;
        for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
            const auto corners = m_mesh.cornersOf(idAt<ElementIndex>(e));
            const bool whole =
                std::all_of(corners.begin(), corners.end(), [&](std::uint32_t node) { return there[node] || !m_given[node]; });
            flags.push_back(whole ? 1.0 : 0.0);
        }
        return flags;
    }

    FrdFile m_file;
    Mesh m_mesh;
    std::optional<InputDeck> m_deck;
    bool m_byDeck = false, m_byNodes = false;
    std::unordered_map<std::int64_t, std::size_t> m_nodes;  // by number
    std::vector<bool> m_given;                              // by any state [nodes]
};

}  // namespace

bool recognisesFrd(const FileHead& head) {
    const std::string& bytes = head.bytes;
    return !head.packed && (bytes.starts_with("    1C") || bytes.starts_with("    1U")) &&
           (bytes.find("\n    1U") != std::string::npos || bytes.find("\n    2C") != std::string::npos);
}

std::vector<std::string> frdMembers(const std::string& path) {
    std::vector<std::string> files{path};
    if (std::string deck = inputDeckBeside(path); !deck.empty()) {
        files.push_back(std::move(deck));
    }
    return withDeathList(std::move(files));
}

FeResult::Contents readFrd(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    return readSeries(path, std::make_shared<FrdSeries>(path), settings, execution);
}

}  // namespace rubble::io
