#include "io/fe/exodus/exodus_sequence.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/fe/exodus/exodus_displacement.h"
#include "io/fe/exodus/exodus_files.h"

namespace rubble::io {

namespace {

constexpr std::size_t mostOpen = 16;

void addInto(std::vector<Vec3>& vectors, const ExodusFile& file, const VectorVariable& variable, std::size_t state) {
    std::vector<double> values(vectors.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        file.readNodal(state, variable.index[axis], values);
        for (std::size_t n = 0; n < values.size(); ++n) {
            vectors[n][static_cast<Eigen::Index>(axis)] += values[n];
        }
    }
}

}  // namespace

ExodusSequence::ExodusSequence(std::vector<std::string> files, const ImportSettings& settings)
    : m_files(std::move(files)), m_settings(settings) {
    dropUnfinished();
    for (std::size_t f = 0; f < m_files.size(); ++f) {
        addStates(f, *file(f));
        if (f > 0 && exodusName(m_files[f]).number != exodusName(m_files[f - 1]).number + 1) {
            m_facts.findings.add(
                {"exodus.sequence_gap", "Files of the sequence are missing: states between them are not known", {}},
                {"exodus.sequence_gap.remedy", "Copy the whole sequence.", {}}, m_files[f]);
        }
    }
    const auto first = file(0);
    const std::vector<std::string>& names = first->variables(ExodusEntity::Element);
    m_facts.flag.choices = names;
    if (const auto status = findStatus(names, settings.statusVariable)) {
        m_facts.flag.name = status->name;
        m_facts.flag.activeByName = status->activeByName;
    } else if (!settings.statusVariable.empty()) {
        throw UsageError(
            {"exodus.unknown_status", "{0} has no element variable \"{1}\"", {first->path(), settings.statusVariable}},
            {"exodus.sequence_status.remedy", "Leave the name out: elements that a file of the sequence leaves out are dead.", {}});
    }
    m_facts.hasVelocity = findVelocity(first->variables(ExodusEntity::Node)).has_value();
}

// The last file of a sequence may still be being written.
void ExodusSequence::dropUnfinished() {
    try {
        file(m_files.size() - 1);
    } catch (const ParseError&) {
        if (m_files.size() == 1) {
            throw;
        }
        m_facts.findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                             {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, m_files.back());
        m_files.pop_back();
    }
}

// Codes that write the last state before a change again as the first of the next file write it twice.
void ExodusSequence::addStates(std::size_t f, const ExodusFile& file) {
    requireThreeDimensions(file);
    m_facts.findings.append(file.findings());
    for (std::size_t k = 0; k < file.times().size(); ++k) {
        m_facts.times.push_back(file.times()[k]);
        m_states.push_back({f, k});
    }
}

bool ExodusSequence::empty() const {
    return file(0)->elementCount() == 0;
}

std::shared_ptr<const ExodusFile> ExodusSequence::file(std::size_t f) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = std::find_if(m_open.begin(), m_open.end(), [f](const auto& open) { return open.first == f; });
    if (found != m_open.end()) {
        m_open.splice(m_open.begin(), m_open, found);
        return found->second;
    }
    m_open.emplace_front(f, std::make_shared<const ExodusFile>(m_files[f]));
    while (m_open.size() > mostOpen) {
        m_open.pop_back();
    }
    return m_open.front().second;
}

SeriesStep ExodusSequence::step(std::size_t k) {
    SeriesStep step;
    const State& state = m_states[k];
    const auto source = file(state.file);
    if (k == 0 || m_states[k - 1].file != state.file) {
        m_mesh = readExodusMesh(*source);
        m_facts.findings.append(m_mesh.findings);
        step.mesh = m_mesh.mesh;
    }
    const auto status =
        m_facts.flag.name.empty() ? std::nullopt : findStatus(source->variables(ExodusEntity::Element), m_facts.flag.name);
    if (status) {
        step.flags.assign(m_mesh.mesh.elementCount(), std::numeric_limits<double>::quiet_NaN());
        for (std::size_t p = 0; p < m_mesh.blocks.size(); ++p) {
            if (source->has(m_mesh.blocks[p], status->index)) {
                source->readElement(state.state, status->index, m_mesh.blocks[p],
                                    std::span(step.flags).subspan(m_mesh.first[p], m_mesh.first[p + 1] - m_mesh.first[p]));
            }
        }
    }
    return step;
}

SeriesFields ExodusSequence::fields(std::size_t k) const {
    const State& state = m_states[k];
    const auto source = file(state.file);
    SeriesFields fields;
    fields.positions.assign(source->nodeCount(), Vec3::Zero());
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double> values = source->coordinates(axis);
        for (std::size_t n = 0; n < values.size(); ++n) {
            fields.positions[n][axis] = values[n];
        }
    }
    if (const auto displacement = chooseDisplacement(*source, m_settings)) {
        addInto(fields.positions, *source, *displacement, state.state);
    }
    if (const auto velocity = findVelocity(source->variables(ExodusEntity::Node)); velocity && m_facts.hasVelocity) {
        fields.velocities.assign(source->nodeCount(), Vec3::Zero());
        addInto(fields.velocities, *source, *velocity, state.state);
    }
    return fields;
}

}  // namespace rubble::io
