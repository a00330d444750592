#include "io/site/clouds/distance_files.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/csv_text.h"
#include "io/base/files.h"
#include "io/site/clouds/cloud_system.h"
#include "io/site/clouds/point_writer.h"

namespace rubble::io {

namespace {

std::uint8_t significance(const CoreDistance& core) {
    return std::isnan(core.detection) ? 255 : static_cast<std::uint8_t>(core.significant() ? 1 : 0);
}

double greatestSignificant(const CloudComparison& made) {
    double most = 0.0;
    for (const CoreDistance& core : made.distances) {
        most = core.significant() ? std::max(most, std::abs(core.distance)) : most;
    }
    return most;
}

/// Red above, blue below, grey where nothing is significant; each of a byte.
std::array<std::uint8_t, 3> colourOf(const CoreDistance& core, double most) {
    if (!core.significant()) {
        return {160, 160, 160};
    }
    const auto pale = static_cast<std::uint8_t>(std::lround(200.0 * (1.0 - std::abs(core.distance) / most)));
    return core.distance > 0.0 ? std::array<std::uint8_t, 3>{220, pale, pale} : std::array<std::uint8_t, 3>{pale, pale, 220};
}

void appendMeasures(FileBytes& bytes, const CoreDistance& core) {
    appendNumber(bytes, core.distance);
    appendNumber(bytes, core.detection);
    appendNumber(bytes, static_cast<float>(core.first.roughness));
    appendNumber(bytes, static_cast<float>(core.second.roughness));
    appendNumber(bytes, core.first.points);
    appendNumber(bytes, core.second.points);
    appendNumber(bytes, significance(core));
}

constexpr std::array<WrittenColumn, 7> measures{{{"distance", 10, "double", 8},
                                                 {"level_of_detection", 10, "double", 8},
                                                 {"roughness_first", 9, "float", 4},
                                                 {"roughness_second", 9, "float", 4},
                                                 {"points_first", 5, "uint", 4},
                                                 {"points_second", 5, "uint", 4},
                                                 {"significant", 1, "uchar", 1}}};

}  // namespace

void writeDistanceCloud(const std::string& path, const CloudComparison& made) {
    const double most = greatestSignificant(made);
    const CloudUnits& units = made.first.head.units;
    // Numbers that were brought to other units are not those of the system, or of its part.
    const bool metres = made.unit == 1.0;
    std::string crs = metres && units.metres != 1.0 ? "" : made.first.head.crs;
    if (metres && units.heightMetres != 1.0) {
        crs = systemInPlan(crs);
    }
    WrittenCloud cloud{made.cores.size(), {}, crs, {measures.begin(), measures.end()}};
    for (const Vec3& core : made.cores) {
        cloud.box.extend(core);
    }
    writePoints(path, cloud, [&](std::size_t k, WrittenPoint& point) {
        point.place = made.cores[k];
        point.colour = colourOf(made.distances[k], most);
        appendMeasures(point.more, made.distances[k]);
    });
}

void writeDistances(std::ostream& out, const CloudComparison& made) {
    out << "x,y,z,state,distance,level_of_detection,significant,roughness_first,roughness_second,points_first,points_second,pairs,"
           "mean_first,mean_second,normal_x,normal_y,normal_z\n";
    std::string line;
    for (std::size_t k = 0; k < made.cores.size(); ++k) {
        const CoreDistance& core = made.distances[k];
        line.clear();
        for (const double value : made.cores[k]) {
            line += exactNumber(value) + ',';
        }
        line += coreStateNames[static_cast<std::size_t>(core.state)];
        line += ',' + exactNumber(core.distance) + ',' + exactNumber(core.detection) + ',';
        if (!std::isnan(core.detection)) {
            line += core.significant() ? '1' : '0';
        }
        line += ',' + exactNumber(core.first.roughness) + ',' + exactNumber(core.second.roughness);
        line +=
            ',' + std::to_string(core.first.points) + ',' + std::to_string(core.second.points) + ',' + std::to_string(core.pairs);
        line += ',' + exactNumber(core.first.mean) + ',' + exactNumber(core.second.mean);
        for (const double value : core.normal) {
            line += ',' + exactNumber(value);
        }
        out << line << '\n';
    }
}

bool namesDistances(const std::string& path) {
    return namesWrittenCloud(path) || hasEnding(path, ".csv");
}

void writeDistanceFile(const std::string& path, const CloudComparison& made) {
    if (namesWrittenCloud(path)) {
        writeDistanceCloud(path, made);
    } else {
        writeAtomically(path, [&](std::ostream& out) { writeDistances(out, made); });
    }
}

}  // namespace rubble::io
