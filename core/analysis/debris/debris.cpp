#include "core/analysis/debris/debris.h"

#include <cassert>

#include "core/trajectory/record_archive.h"

namespace rubble {

Debris debrisOf(const FragmentSet& fragments, const Components& components, std::span<const Carrier> carriers,
                const TrajectoryFrame& frame) {
    std::vector<const Carrier*> latest(fragments.size(), nullptr);
    for (const Carrier& carrier : carriers) {
        assert(at(carrier.fragment) < fragments.size());
        if (carrier.from <= frame.time) {
            latest[at(carrier.fragment)] = &carrier;
        }
    }
    Debris debris;
    debris.time = frame.time;
    debris.fragments.resize(fragments.size());
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        const Fragment& fragment = fragments.list[f];
        DebrisFragment& lies = debris.fragments[f];
        lies.mass = fragment.mass;
        lies.volume = components.volume[at(fragment.element)];
        lies.centre = fragment.centre;
        lies.box = fragment.box;
        const Carrier* carrier = latest[f];
        const bool alive = fragment.birthTime <= frame.time && frame.time < fragment.endTime;
        if (!carrier || !alive || frame.time >= carrier->to || at(carrier->body) >= frame.bodies()) {
            continue;
        }
        const std::size_t body = at(carrier->body);
        if (frame.states[body] == BodyState::Removed) {
            continue;
        }
        const Pose bodyPose{frame.positions[body].cast<double>(), frame.orientations[body].cast<double>().normalized()};
        const Pose& handOver = carrier->handOverToBody;
        lies.present = true;
        lies.centre = bodyPose * (handOver * fragment.centre);
        lies.box.centre = bodyPose * (handOver * fragment.box.centre);
        lies.box.orientation = (bodyPose.orientation * handOver.orientation * fragment.box.orientation).normalized();
    }
    return debris;
}

Debris debrisAt(const FragmentSet& fragments, const Components& components, const TrajectoryReader& trajectory, double time) {
    return debrisOf(fragments, components, trajectory.carriers(), frameAtTime(trajectory, time));
}

void DebrisRecorder::begin(const RunDescription& description) {
    m_fragments = description.fragments;
    m_components = description.components;
    m_feEnd = description.fe->times().back();
    m_carriers.clear();
    m_atFeEnd = m_last = TrajectoryFrame{};
}

void DebrisRecorder::addBodies(std::span<const BodyRecord>, std::span<const Carrier> carriers) {
    m_carriers.insert(m_carriers.end(), carriers.begin(), carriers.end());
}

void DebrisRecorder::commit(const TrajectoryFrame& frame) {
    m_last = frame;
    // FE states are always recorded, at their exact time.
    if (frame.time == m_feEnd) {
        m_atFeEnd = frame;
    }
}

std::optional<std::string> DebrisRecorder::mark() {
    Archive archive;
    archive(m_carriers, m_atFeEnd, m_last);
    return std::move(archive).take();
}

bool DebrisRecorder::resume(const RunDescription& description, std::string_view mark) {
    DebrisRecorder::begin(description);
    Archive archive(mark);
    archive(m_carriers, m_atFeEnd, m_last);
    return archive.atEnd();
}

Debris DebrisRecorder::debris(DebrisInstant instant) const {
    assert(m_fragments && m_components);
    return debrisOf(*m_fragments, *m_components, m_carriers, instant == DebrisInstant::AtRest ? m_last : m_atFeEnd);
}

}  // namespace rubble
