#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/run/fragment_places.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

const Vec3 unknownPlace = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

// Shortest text that reads back to the same number; nothing where the number is not known.
std::string numberText(double number) {
    if (!std::isfinite(number)) {
        return {};
    }
    std::array<char, 40> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), end.ptr};
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + "\"";
}

// A run that was stopped has no outcome; its frames still say where the fragments were, but not at what speed they hit.
std::vector<FragmentOutcome> outcomesFromFrames(const RunReader& run, const Execution& execution) {
    const FragmentPlaces places(run);
    const FragmentSet& fragments = places.fragments();
    const FragmentOutcome unknown{unknownPlace, unknownPlace.x(), unknownPlace, unknownPlace.x()};
    std::vector<FragmentOutcome> outcomes(fragments.size(), unknown);
    if (run.frameCount() == 0) {
        return outcomes;
    }
    const double last = run.frameTime(run.frameCount() - 1);
    std::map<double, std::vector<std::size_t>> births;
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        if (fragments.list[f].birthTime <= last) {
            births[fragments.list[f].birthTime].push_back(f);
        }
    }
    const auto centre = [&](const FragmentPlaces::Place& place) {
        return place.fromHandOver * fragments.list[at(place.fragment)].centre;
    };
    for (const auto& birth : births) {
        execution.check();
        for (const FragmentPlaces::Place& place : places.carriedAt(birth.first)) {
            if (fragments.list[at(place.fragment)].birthTime == birth.first) {
                outcomes[at(place.fragment)].birthPosition = centre(place);
            }
        }
    }
    for (const FragmentPlaces::Place& place : places.at(last)) {
        outcomes[at(place.fragment)].finalPosition = centre(place);
    }
    return outcomes;
}

struct Row {
    std::ostream& out;
    bool first = true;

    Row& operator<<(const std::string& text) {
        out << (first ? "" : ",") << text;
        first = false;
        return *this;
    }
    Row& operator<<(double number) { return *this << numberText(number); }
    Row& operator<<(const Vec3& v) { return *this << v.x() << v.y() << v.z(); }
};

}  // namespace

void exportFragments(const std::string& path, const RunReader& run, const Execution& execution) {
    std::vector<FragmentId> all(FragmentPlaces(run).fragments().size());
    for (std::size_t f = 0; f < all.size(); ++f) {
        all[f] = idAt<FragmentId>(f);
    }
    exportFragments(path, run, all, execution);
}

void exportFragments(const std::string& path, const RunReader& run, std::span<const FragmentId> chosen,
                     const Execution& execution) {
    const auto fragments = FragmentPlaces(run).fragments().list;
    const std::vector<std::string> components = run.componentNames();
    const std::vector<std::int64_t> elementIds = run.elementIds();
    const auto clustering = run.clustering();
    const auto result = run.result();
    const bool whole = result && result->fragments.size() == fragments.size();
    const std::vector<FragmentOutcome> outcomes = whole ? result->fragments : outcomesFromFrames(run, execution);
    const SitePlace site(run.origin().frame, run.origin().site);
    writeAtomically(path, [&](std::ostream& out) {
        out << "fragment_id,element_id,component,cluster_id,birth_time_s,birth_x_m,birth_y_m,birth_z_m,final_x_m,final_y_m,final_z_"
               "m,"
               "birth_speed_m_s,impact_speed_m_s,mass_kg\n";
        for (std::size_t row = 0; row < chosen.size(); ++row) {
            const std::size_t f = at(chosen[row]);
            if (row % 4096 == 0) {
                execution.report(Message{"io.export.fragments", "Writing {0}", {path}},
                                 static_cast<double>(row) / static_cast<double>(chosen.size()));
            }
            const FragmentOutcome& outcome = outcomes[f];
            const std::size_t component = at(fragments[f].component);
            const bool clustered = clustering && f < clustering->of.size();
            Row{out} << std::to_string(f) << std::to_string(elementIds[f])
                     << (component < components.size() ? quoted(components[component]) : std::string())
                     << (clustered ? std::to_string(at(clustering->of[f])) : std::string()) << fragments[f].birthTime
                     << site.toWorld(outcome.birthPosition) << site.toWorld(outcome.finalPosition) << outcome.birthSpeed
                     << outcome.impactSpeed << fragments[f].mass;
            out << '\n';
        }
    });
    writeProvenance(path, provenanceText(run));
    execution.report(Message{"io.export.fragments", "Writing {0}", {path}}, 1.0);
}

}  // namespace rubble::io
