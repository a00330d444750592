#include "io/fe/bodies/body_columns.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/base/small_letters.h"

namespace rubble::io {

namespace {

struct Unit {
    Quantity quantity;
    std::string_view name;
    double inSi;
};

constexpr double radian = std::numbers::pi / 180.0;
constexpr std::array knownUnits{
    Unit{Quantity::Length, "m", 1.0},        Unit{Quantity::Length, "cm", 0.01},   Unit{Quantity::Length, "mm", 0.001},
    Unit{Quantity::Length, "km", 1000.0},    Unit{Quantity::Length, "ft", 0.3048}, Unit{Quantity::Length, "in", 0.0254},
    Unit{Quantity::Mass, "kg", 1.0},         Unit{Quantity::Mass, "g", 0.001},     Unit{Quantity::Mass, "t", 1000.0},
    Unit{Quantity::Mass, "lb", 0.45359237},  Unit{Quantity::Speed, "m_s", 1.0},    Unit{Quantity::Speed, "mps", 1.0},
    Unit{Quantity::Speed, "cm_s", 0.01},     Unit{Quantity::Speed, "mm_s", 0.001}, Unit{Quantity::Speed, "km_h", 1.0 / 3.6},
    Unit{Quantity::Speed, "ft_s", 0.3048},   Unit{Quantity::Spin, "rad_s", 1.0},   Unit{Quantity::Spin, "deg_s", radian},
    Unit{Quantity::Spin, "rpm", 6 * radian}, Unit{Quantity::Angle, "rad", 1.0},    Unit{Quantity::Angle, "deg", radian},
    Unit{Quantity::Time, "s", 1.0},          Unit{Quantity::Time, "ms", 0.001},    Unit{Quantity::Time, "min", 60.0},
};

constexpr std::array knownColumns{
    TableColumn{"id", Quantity::Text},
    TableColumn{"material", Quantity::Text},
    TableColumn{"group", Quantity::Text},
    TableColumn{"mesh", Quantity::Text},
    TableColumn{"mass", Quantity::Mass},
    TableColumn{"side_x", Quantity::Length},
    TableColumn{"side_y", Quantity::Length},
    TableColumn{"side_z", Quantity::Length},
    TableColumn{"x", Quantity::Length},
    TableColumn{"y", Quantity::Length},
    TableColumn{"z", Quantity::Length},
    TableColumn{"vx", Quantity::Speed},
    TableColumn{"vy", Quantity::Speed},
    TableColumn{"vz", Quantity::Speed},
    TableColumn{"wx_world", Quantity::Spin},
    TableColumn{"wy_world", Quantity::Spin},
    TableColumn{"wz_world", Quantity::Spin},
    TableColumn{"wx_body", Quantity::Spin},
    TableColumn{"wy_body", Quantity::Spin},
    TableColumn{"wz_body", Quantity::Spin},
    TableColumn{"qw", Quantity::Number},
    TableColumn{"qx", Quantity::Number},
    TableColumn{"qy", Quantity::Number},
    TableColumn{"qz", Quantity::Number},
    TableColumn{"roll", Quantity::Angle},
    TableColumn{"pitch", Quantity::Angle},
    TableColumn{"yaw", Quantity::Angle},
    TableColumn{"time", Quantity::Time},
    TableColumn{"measured_x", Quantity::Length},
    TableColumn{"measured_y", Quantity::Length},
    TableColumn{"measured_z", Quantity::Length},
    TableColumn{"measured_qw", Quantity::Number},
    TableColumn{"measured_qx", Quantity::Number},
    TableColumn{"measured_qy", Quantity::Number},
    TableColumn{"measured_qz", Quantity::Number},
    TableColumn{"measured_after", Quantity::Time},
};

bool hasUnit(Quantity quantity) {
    return quantity != Quantity::Text && quantity != Quantity::Number;
}

}  // namespace

std::span<const TableColumn> bodyColumns() {
    return knownColumns;
}

std::string unitsOf(Quantity quantity) {
    std::string list;
    for (const Unit& unit : knownUnits) {
        if (unit.quantity == quantity) {
            list += (list.empty() ? "" : ", ") + std::string(unit.name);
        }
    }
    return list;
}

ReadColumn columnNamed(const std::string& heading) {
    const std::string name = inSmallLetters(heading);
    ReadColumn read;
    for (const std::string_view spin : {"wx", "wy", "wz"}) {
        const bool framed = name.starts_with(std::string(spin) + "_world") || name.starts_with(std::string(spin) + "_body");
        read.withoutFrame = read.withoutFrame || ((name == spin || name.starts_with(std::string(spin) + "_")) && !framed);
    }
    for (const TableColumn& column : knownColumns) {
        const bool alone = name == column.name;
        if (!alone && !(hasUnit(column.quantity) && name.starts_with(std::string(column.name) + "_"))) {
            continue;
        }
        const std::string_view rest = alone ? std::string_view() : std::string_view(name).substr(column.name.size() + 1);
        const auto unit = std::find_if(knownUnits.begin(), knownUnits.end(),
                                       [&](const Unit& u) { return u.quantity == column.quantity && u.name == rest; });
        read.column = &column;
        read.withoutUnit = alone && hasUnit(column.quantity);
        if (unit != knownUnits.end()) {
            read.unit = unit->inSi;
        } else if (!alone) {
            read.unknownUnit = std::string_view(heading).substr(column.name.size() + 1);
        }
        return read;
    }
    return read;
}

}  // namespace rubble::io
