#include "app/cli/evidence/reached_places.h"

#include <cmath>

#include "app/cli/evidence/ensemble_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/text_output.h"

namespace rubble::cli {

namespace {

/// Finite numbers at commas; empty if one is none.
std::vector<double> finiteNumbers(const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& part : splitAtCommas(text)) {
        double number = 0.0;
        if (!parseNumber(part, number) || !std::isfinite(number)) {
            return {};
        }
        numbers.push_back(number);
    }
    return numbers;
}

/// [members] s, after the first debris that came down anywhere; of a member that is not done, or whose debris did not come there,
/// no number.
std::vector<double> timesAt(const EnsembleReport& report, const ReachedPlace& place) {
    std::vector<double> times;
    for (const EnsembleMember& member : report.members) {
        times.push_back(member.arrivals.firstWithin(place.middle, place.radius) - member.arrivals.first());
    }
    return times;
}

}  // namespace

TimeEvidence parseTimeEvidence(const std::string& text) {
    const std::vector<double> numbers = finiteNumbers(text);
    const auto number = [&](std::size_t i, double otherwise) { return i < numbers.size() ? numbers[i] : otherwise; };
    const TimeEvidence time{
        "time=" + text, {number(1, 0.0), number(2, 0.0)}, number(3, usualTimeRadius), number(0, 0.0), number(4, usualTimeAccuracy)};
    if (numbers.size() < 3 || numbers.size() > 5 || time.time < 0.0 || !(time.radius > 0.0) || time.accuracy < 0.0) {
        throw wrongValue("--against", "time=" + text,
                         "time=SECONDS,X,Y[,RADIUS[,ACCURACY]]: seconds after the first debris that came down, not below zero, a "
                         "place in m, a radius above zero in m, an accuracy in s");
    }
    return time;
}

std::vector<ReachedPlace> reachedPlaces(const Arguments& arguments) {
    std::vector<ReachedPlace> places;
    for (const std::string& text : arguments.values("--reached")) {
        const std::vector<double> numbers = finiteNumbers(text);
        if (numbers.size() < 2 || numbers.size() > 3 || (numbers.size() == 3 && !(numbers[2] > 0.0))) {
            throw wrongValue("--reached", text, "X,Y[,RADIUS]: a place in m and a radius above zero in m");
        }
        places.push_back({{numbers[0], numbers[1]}, numbers.size() == 3 ? numbers[2] : usualTimeRadius});
    }
    return places;
}

Option reachedOption() {
    return {"--reached", "X,Y[,RADIUS]", true,
            "say when debris first lies within a radius of a place, m (radius: 5), in seconds after the first that came down"};
}

Json reachedJson(const EnsembleReport& report, const std::vector<ReachedPlace>& places) {
    Json list = Json::array();
    for (const ReachedPlace& place : places) {
        const std::vector<double> times = timesAt(report, place);
        Json object{{"x_m", place.middle.x()}, {"y_m", place.middle.y()}, {"radius_m", place.radius}};
        object["time_s"] = spreadJson(spreadOf(times));
        object["members_s"] = Json::array();
        for (const double time : times) {
            object["members_s"].push_back(std::isfinite(time) ? Json(time) : Json());
        }
        list.push_back(std::move(object));
    }
    return list;
}

void printReached(std::ostream& out, const EnsembleReport& report, const std::vector<ReachedPlace>& places) {
    if (places.empty()) {
        return;
    }
    printHeading(out, "When debris first lies there, s after the first that came down anywhere");
    TextTable table({{"x [m]", "x_m"},
                     {"y [m]", "y_m"},
                     {"radius [m]", "radius_m"},
                     {"members", "members"},
                     {"mean", "mean"},
                     {"± of members", "deviation"},
                     {"5 %", "p05"},
                     {"95 %", "p95"}});
    for (const ReachedPlace& place : places) {
        const FigureSpread spread = spreadOf(timesAt(report, place));
        table.add({numberCell(place.middle.x()), numberCell(place.middle.y()), numberCell(place.radius),
                   integerCell(static_cast<std::int64_t>(spread.count)), numberCell(spread.mean), numberCell(spread.deviation),
                   numberCell(spread.low), numberCell(spread.high)});
    }
    table.print(out);
}

}  // namespace rubble::cli
