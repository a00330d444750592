#include "io/site/clouds/cloud_columns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/small_letters.h"
#include "io/base/file_words.h"
#include "io/base/length_unit.h"
#include "io/base/trimmed.h"
#include "io/fe/meshes/raw_mesh.h"
#include "io/site/clouds/cloud_file.h"

namespace rubble::io {

namespace {

/// A number held to what a column can keep; what is none is 0.
template <class Whole>
Whole wholeOf(double number) {
    constexpr auto most = static_cast<double>(std::numeric_limits<Whole>::max());
    return number > 0.0 ? static_cast<Whole>(std::min(std::round(number), most)) : Whole{0};
}

bool isPlace(ColumnRole role) {
    return role >= ColumnRole::X && role <= ColumnRole::Z;
}

template <class Number>
double storedNumber(const unsigned char* bytes, bool bigEndian) {
    std::array<unsigned char, sizeof(Number)> own{};
    std::copy_n(bytes, sizeof(Number), own.begin());
    if (bigEndian) {
        std::reverse(own.begin(), own.end());
    }
    return static_cast<double>(littleAt<Number>(own.data()));
}

}  // namespace

ColumnRole columnRole(std::string_view name) {
    std::string low = inSmallLetters(name);
    for (const std::string_view prefix : {"//", "scalar_", "diffuse_"}) {
        if (low.starts_with(prefix)) {
            low.erase(0, prefix.size());
        }
    }
    using enum ColumnRole;
    static const std::vector<std::pair<ColumnRole, std::vector<std::string_view>>> names{
        {X, {"x", "easting", "e", "east"}},
        {Y, {"y", "northing", "n", "north"}},
        {Z, {"z", "elevation", "height", "h"}},
        {Intensity, {"intensity", "i", "reflectance", "intensities"}},
        {Red, {"red", "r"}},
        {Green, {"green", "g"}},
        {Blue, {"blue", "b"}},
        {PackedColour, {"rgb", "rgba"}},
        {Class, {"class", "classification", "classes"}},
        {Return, {"return", "return_number", "returnnumber", "return number"}},
        {Returns, {"returns", "number_of_returns", "numberofreturns", "number of returns"}},
        {Time, {"time", "gps_time", "gpstime", "timestamp"}}};
    for (const auto& [role, all] : names) {
        if (std::find(all.begin(), all.end(), low) != all.end()) {
            return role;
        }
    }
    return Unread;
}

ColumnHeading columnHeading(const std::string& path, std::string_view heading) {
    ColumnHeading whole{columnRole(heading)};
    if (whole.role != ColumnRole::Unread) {
        return whole;
    }
    const std::size_t bracket = heading.find_first_of("([");
    if (bracket != std::string_view::npos && !heading.empty() && (heading.back() == ')' || heading.back() == ']')) {
        std::string_view bare = trimmed(heading.substr(0, bracket));
        bare.remove_suffix(bare.ends_with('_') ? 1 : 0);
        const std::string unit(trimmed(heading.substr(bracket + 1, heading.size() - bracket - 2)));
        if (!isPlace(columnRole(bare))) {
            return whole;
        }
        const std::optional<double> metres = metresInUnit(unit);
        if (!metres) {
            refuseContent(
                {"cloud.unit_unknown", "{0}: \"{1}\" behind \"{2}\" is no unit of length that is known", {path, unit, bare}},
                "Write the unit as m, cm, mm, km, ft or US ft, or leave the brackets out.");
        }
        return {columnRole(bare), unit, metres};
    }
    for (std::size_t at = heading.find_first_of("_ "); at != std::string_view::npos; at = heading.find_first_of("_ ", at + 1)) {
        const std::string_view unit = heading.substr(at + 1);
        const ColumnRole role = columnRole(heading.substr(0, at));
        if (const std::optional<double> metres = metresInUnit(unit); metres && isPlace(role)) {
            return {role, std::string(unit), metres};
        }
    }
    return whole;
}

void ColumnPlan::add(ColumnRole role, std::string_view name) {
    // A second column of one role would take the place of the first.
    const bool again = role != ColumnRole::Unread && has(role);
    m_roles.push_back(again ? ColumnRole::Unread : role);
    if (m_roles.back() == ColumnRole::Unread) {
        m_unread.emplace_back(name);
    }
}

bool ColumnPlan::has(ColumnRole role) const {
    return std::find(m_roles.begin(), m_roles.end(), role) != m_roles.end();
}

void ColumnPlan::describe(CloudHead& head) const {
    using enum ColumnRole;
    head.columns.intensity = has(Intensity);
    head.columns.colour = (has(Red) && has(Green) && has(Blue)) || has(PackedColour);
    head.columns.classes = has(Class);
    head.columns.returns = has(Return);
    head.columns.times = has(Time);
    head.fullColour = 255.0;
    head.unread = m_unread;
}

void ColumnPlan::put(CloudBlock& block, std::size_t i, ColumnRole role, double number, double colourScale) {
    using enum ColumnRole;
    switch (role) {
        case X:
        case Y:
        case Z:
            block.places[i][static_cast<Eigen::Index>(role) - static_cast<Eigen::Index>(X)] = number;
            break;
        case Intensity:
            block.intensity[i] = static_cast<float>(number);
            break;
        case Red:
        case Green:
        case Blue:
            if (!block.colours.empty()) {
                block.colours[i][static_cast<std::size_t>(role) - static_cast<std::size_t>(Red)] =
                    wholeOf<std::uint16_t>(number * colourScale);
            }
            break;
        case PackedColour: {
            const auto packed = wholeOf<std::uint32_t>(number);
            block.colours[i] = {static_cast<std::uint16_t>(packed >> 16 & 0xff), static_cast<std::uint16_t>(packed >> 8 & 0xff),
                                static_cast<std::uint16_t>(packed & 0xff)};
            break;
        }
        case Class:
            block.classes[i] = wholeOf<std::uint16_t>(number);
            break;
        case Return:
            block.returns[i] = wholeOf<std::uint8_t>(number);
            break;
        case Returns:
            if (!block.returnsOf.empty()) {
                block.returnsOf[i] = wholeOf<std::uint8_t>(number);
            }
            break;
        case Time:
            block.times[i] = number;
            break;
        case Unread:
            break;
    }
}

double numberAt(const unsigned char* bytes, NumberType type, bool bigEndian) {
    using Kind = NumberType::Kind;
    switch (type.bytes) {
        case 1:
            return type.kind == Kind::Signed ? storedNumber<std::int8_t>(bytes, bigEndian)
                                             : storedNumber<std::uint8_t>(bytes, bigEndian);
        case 2:
            return type.kind == Kind::Signed ? storedNumber<std::int16_t>(bytes, bigEndian)
                                             : storedNumber<std::uint16_t>(bytes, bigEndian);
        case 4:
            return type.kind == Kind::Real     ? storedNumber<float>(bytes, bigEndian)
                   : type.kind == Kind::Signed ? storedNumber<std::int32_t>(bytes, bigEndian)
                                               : storedNumber<std::uint32_t>(bytes, bigEndian);
        default:
            return type.kind == Kind::Real     ? storedNumber<double>(bytes, bigEndian)
                   : type.kind == Kind::Signed ? storedNumber<std::int64_t>(bytes, bigEndian)
                                               : storedNumber<std::uint64_t>(bytes, bigEndian);
    }
}

double stepOfBlock(const CloudBlock& block) {
    double most = 0.0;
    for (const Vec3& place : block.places) {
        const double size = place.cwiseAbs().maxCoeff();
        most = std::isfinite(size) ? std::max(most, size) : most;
    }
    return stepOfFloat(most);
}

}  // namespace rubble::io
