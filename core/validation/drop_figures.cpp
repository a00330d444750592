#include "core/validation/drop_figures.h"

#include <array>

namespace rubble {

std::span<const DropFigure> dropFigures() {
    static constexpr std::array figures{
        DropFigure{"run_out_m", "run-out [m]", [](const DropOutcome& b, const Vec3&) { return b.runOut; }},
        DropFigure{"lateral_m", "lateral place [m]", [](const DropOutcome& b, const Vec3&) { return b.lateral; }},
        DropFigure{"fall_m", "fall [m]", [](const DropOutcome& b, const Vec3&) { return b.fall; }},
        DropFigure{"path_m", "path length [m]", [](const DropOutcome& b, const Vec3&) { return b.trace.path; }},
        DropFigure{"contacts", "contacts", [](const DropOutcome& b, const Vec3&) { return static_cast<double>(b.trace.contacts); }},
        DropFigure{"top_speed_m_s", "top speed [m/s]", [](const DropOutcome& b, const Vec3&) { return b.trace.topSpeed; }},
        DropFigure{"moving_s", "moving for [s]",
                   [](const DropOutcome& b, const Vec3&) { return b.trace.movedLast - b.trace.from; }},
        DropFigure{"x_m", "x at the end [m]",
                   [](const DropOutcome& b, const Vec3& zero) { return b.trace.latest.position.x() + zero.x(); }},
        DropFigure{"y_m", "y at the end [m]",
                   [](const DropOutcome& b, const Vec3& zero) { return b.trace.latest.position.y() + zero.y(); }},
    };
    return figures;
}

}  // namespace rubble
