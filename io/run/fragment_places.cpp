#include "io/run/fragment_places.h"

#include <algorithm>
#include <tuple>

#include "core/base/error.h"

namespace rubble::io {

FragmentPlaces::FragmentPlaces(const RunReader& run) : m_run(run), m_fragments(run.fragments()), m_carriers(run.carriers()) {
    if (!m_fragments) {
        throw ParseError(
            Message{"io.run.not_begun", "The run of {0} was stopped before its simulation began", {run.origin().fePath}},
            Message{"io.run.incomplete.remedy", "Run the case again to the end.", {}});
    }
    std::stable_sort(m_carriers.begin(), m_carriers.end(), [](const Carrier& a, const Carrier& b) {
        return std::tuple(a.fragment, a.from) < std::tuple(b.fragment, b.from);
    });
}

std::vector<FragmentPlaces::Place> FragmentPlaces::carriedAt(double time) const {
    const TrajectoryFrame frame = frameAtTime(m_run, time);
    std::vector<Place> places;
    for (const Carrier& carrier : m_carriers) {
        const std::size_t body = rubble::at(carrier.body);
        if (carrier.from > time || time >= carrier.to || body >= frame.bodies()) {
            continue;
        }
        const Quat turn = frame.orientations[body].cast<double>().normalized();
        const Vec3 position = frame.positions[body].cast<double>();
        const Pose fromHandOver{position + turn * carrier.handOverToBody.position, turn * carrier.handOverToBody.orientation};
        // Should two intervals overlap, the later one holds.
        if (!places.empty() && places.back().fragment == carrier.fragment) {
            places.pop_back();
        }
        places.push_back({carrier.fragment, carrier.body, fromHandOver, frame.speeds[body]});
    }
    return places;
}

std::vector<FragmentPlaces::Place> FragmentPlaces::at(double time) const {
    std::vector<Place> places = carriedAt(time);
    std::erase_if(places, [&](const Place& place) {
        const Fragment& fragment = m_fragments->list[rubble::at(place.fragment)];
        return fragment.birthTime > time || fragment.endTime <= time;
    });
    return places;
}

}  // namespace rubble::io
