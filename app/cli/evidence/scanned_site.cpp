#include "app/cli/evidence/scanned_site.h"

#include <cmath>

#include "app/cli/frame/option_value.h"
#include "app/cli/frame/text_output.h"
#include "core/base/message.h"

namespace rubble::cli {

ScannedSite scannedSite(const io::RunReader& run, const Inputs& inputs, std::optional<double> time, double liveThreshold,
                        const Execution& execution) {
    const MappedRun mapped{inputs.fe.get(), &run, run.fragments(), run.result(), inputs.terrain, run.origin().scenario};
    return rubble::scannedSite(mapped, time, liveThreshold, execution);
}

Option scannerOption(std::string_view help) {
    return {"--scanner", "E,N,H", true, help};
}

std::vector<Vec3> scannersFrom(const Arguments& arguments) {
    std::vector<Vec3> places;
    for (const std::string& text : arguments.values("--scanner")) {
        const std::vector<std::string> parts = splitAtCommas(text);
        Vec3 place;
        bool sound = parts.size() == 3;
        for (std::size_t k = 0; sound && k < 3; ++k) {
            double& value = place[static_cast<Eigen::Index>(k)];
            sound = parseNumber(parts[k], value) && std::isfinite(value);
        }
        if (!sound) {
            throw wrongValue("--scanner", text, "easting, northing and height in metres, such as 12.5,-3,1.8");
        }
        places.push_back(place);
    }
    return places;
}

std::optional<double> instantFrom(const Arguments& arguments) {
    const auto text = arguments.value("--time");
    double seconds = 0.0;
    if (!text || *text == "end") {
        return std::nullopt;
    }
    if (!parseNumber(*text, seconds) || !std::isfinite(seconds)) {
        throw wrongValue("--time", *text, "seconds with a point as decimal sign, or end");
    }
    return seconds;
}

Json sightedJson(const io::SightedDebris& debris) {
    return {{"fragments_seen", debris.seen},
            {"fragments_not_seen", debris.unseen},
            {"volume_seen_m3", debris.seenVolume},
            {"volume_not_seen_m3", debris.unseenVolume}};
}

std::string sightedText(const io::SightedDebris& debris) {
    return englishInteger(debris.seen) + " fragments seen, " + englishNumber(debris.seenVolume) + " m3; " +
           englishInteger(debris.unseen) + " not seen, " + englishNumber(debris.unseenVolume) + " m3";
}

}  // namespace rubble::cli
