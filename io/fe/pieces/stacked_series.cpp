#include "io/fe/pieces/stacked_series.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/error.h"
#include "core/base/unknown.h"

namespace rubble::io {

namespace {

// What the same time may differ by where it is written twice.
constexpr double rounding = 1e-9;

template <class T>
void appendAll(std::vector<T>& values, const std::vector<T>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

std::uint32_t partOf(const Part& part, std::vector<Part>& parts) {
    const auto known = std::find_if(parts.begin(), parts.end(),
                                    [&](const Part& other) { return other.name == part.name && other.fileId == part.fileId; });
    const auto place = static_cast<std::uint32_t>(known - parts.begin());
    if (known == parts.end()) {
        parts.push_back(part);
    }
    return place;
}

}  // namespace

StackedSeries::StackedSeries(std::vector<SeriesPiece> pieces) : m_pieces(std::move(pieces)), m_meshes(m_pieces.size()) {
    const MeshSeries& first = *m_pieces.front().series;
    m_facts.flag = first.flag();
    m_facts.hasVelocity = first.hasVelocity();
    m_facts.timed = first.timed();
    std::size_t states = first.times().size(), most = states;
    const SeriesPiece* shortest = &m_pieces.front();
    for (const SeriesPiece& piece : m_pieces) {
        const std::vector<double>& times = piece.series->times();
        most = std::max(most, times.size());
        if (times.size() < states) {
            states = times.size();
            shortest = &piece;
        }
        for (std::size_t k = 0; k < std::min(times.size(), first.times().size()); ++k) {
            if (std::abs(times[k] - first.times()[k]) > rounding * std::max(std::abs(times[k]), std::abs(first.times()[k]))) {
                throw ParseError({"pieces.times",
                                  "{0} has the time {1} at state {2}, where {3} has {4}: they are no pieces of one result",
                                  {piece.file, {times[k], "s"}, k, m_pieces.front().file, {first.times()[k], "s"}}},
                                 {"pieces.times.remedy", "Copy all pieces of one analysis anew.", {}});
            }
        }
        if (m_facts.flag.name.empty() && !piece.series->flag().name.empty()) {
            m_facts.flag = piece.series->flag();
        }
    }
    m_facts.times.assign(first.times().begin(), first.times().begin() + static_cast<std::ptrdiff_t>(states));
    // A piece that is cut off has said so.
    if (states < most && shortest->series->findings().count("fe.unfinished") == 0) {
        m_own.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                  {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, shortest->file,
                  static_cast<std::int64_t>(most - states));
    }
    gatherFindings();
}

void StackedSeries::gatherFindings() {
    m_facts.findings = m_own;
    for (const SeriesPiece& piece : m_pieces) {
        m_facts.findings.append(piece.series->findings());
    }
}

SeriesStep StackedSeries::step(std::size_t k) {
    SeriesStep whole;
    bool changed = false, flagged = false;
    std::vector<std::vector<double>> flags;
    for (std::size_t p = 0; p < m_pieces.size(); ++p) {
        SeriesStep step = m_pieces[p].series->step(k);
        if (step.mesh) {
            m_meshes[p] = std::move(*step.mesh);
            changed = true;
        }
        flagged = flagged || !step.flags.empty();
        flags.push_back(std::move(step.flags));
    }
    if (changed) {
        whole.mesh = stacked();
        MeshPiece end;
        for (const Mesh& mesh : m_meshes) {
            end = {end.nodes + mesh.nodeCount(), end.elements + mesh.elementCount()};
            whole.pieces.push_back(end);
        }
    }
    for (std::size_t p = 0; p < m_pieces.size() && flagged; ++p) {
        flags[p].resize(m_meshes[p].elementCount(), unknown);
        appendAll(whole.flags, flags[p]);
    }
    gatherFindings();
    return whole;
}

Mesh StackedSeries::stacked() const {
    Mesh whole;
    whole.offsets.push_back(0);
    for (const Mesh& mesh : m_meshes) {
        const auto firstNode = static_cast<std::uint32_t>(whole.nodes.size());
        const auto firstCorner = static_cast<std::uint32_t>(whole.corners.size());
        appendAll(whole.nodes, mesh.nodes);
        appendAll(whole.nodeIds, mesh.nodeIds);
        appendAll(whole.elementIds, mesh.elementIds);
        appendAll(whole.shapes, mesh.shapes);
        std::transform(mesh.corners.begin(), mesh.corners.end(), std::back_inserter(whole.corners),
                       [firstNode](std::uint32_t corner) { return corner + firstNode; });
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            whole.offsets.push_back(mesh.offsets[e + 1] + firstCorner);
            whole.part.push_back(partOf(mesh.parts[mesh.part[e]], whole.parts));
            whole.density.push_back(mesh.density.empty() ? unknown : mesh.density[e]);
            whole.section.push_back(mesh.section.empty() ? unknown : mesh.section[e]);
        }
    }
    return whole;
}

SeriesFields StackedSeries::fields(std::size_t k) const {
    SeriesFields whole;
    bool velocities = m_facts.hasVelocity;
    for (const SeriesPiece& piece : m_pieces) {
        const SeriesFields fields = piece.series->fields(k);
        velocities = velocities && fields.velocities.size() == fields.positions.size();
        appendAll(whole.positions, fields.positions);
        appendAll(whole.velocities, fields.velocities);
    }
    if (!velocities) {
        whole.velocities.clear();
    }
    return whole;
}

std::vector<std::pair<std::int64_t, double>> StackedSeries::deathTimes() const {
    std::vector<std::pair<std::int64_t, double>> times;
    for (const SeriesPiece& piece : m_pieces) {
        appendAll(times, piece.series->deathTimes());
    }
    return times;
}

}  // namespace rubble::io
