#include "io/fe/exodus/exodus_names.h"

#include <algorithm>

namespace rubble::io {

namespace {

std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        }
    }
    return result;
}

// "disp" and 'x' for disp_x, DISPX, disp-x, disp.x, "disp x"; an empty prefix where the name is no component of a vector.
std::pair<std::string, char> componentOf(std::string_view name) {
    std::string text = lowerCase(name);
    if (text.size() < 2 || text.back() < 'x' || text.back() > 'z') {
        return {};
    }
    const char axis = text.back();
    text.pop_back();
    while (text.size() > 1 && std::string_view("_-. ").find(text.back()) != std::string_view::npos) {
        text.pop_back();
    }
    return {text, axis};
}

struct KnownStatus {
    std::string_view name;
    std::optional<int> active;
};

// Sierra: 1 active, fading to 0. seacas conjoin: 0 alive. Converters of erosion flags disagree, so those names tell nothing.
constexpr std::array<KnownStatus, 15> knownStatus{{{"death_status", 1},
                                                   {"elem_status", 0},
                                                   {"status", 1},
                                                   {"death", 1},
                                                   {"erosion_status", {}},
                                                   {"erosion", {}},
                                                   {"eroded", {}},
                                                   {"element_status", {}},
                                                   {"deletion", {}},
                                                   {"deleted", {}},
                                                   {"fail", {}},
                                                   {"failed", {}},
                                                   {"active", 1},
                                                   {"alive", 1},
                                                   {"activity", {}}}};

// Length of the UTF-8 sequence that starts at text[i]; 0 if it is broken.
std::size_t sequenceLength(std::string_view text, std::size_t i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || i + length > text.size()) {
        return 0;
    }
    for (std::size_t j = 1; j < length; ++j) {
        if ((static_cast<unsigned char>(text[i + j]) & 0xc0) != 0x80) {
            return 0;
        }
    }
    const unsigned char second = length > 1 ? static_cast<unsigned char>(text[i + 1]) : 0;
    // Overlong forms, surrogates and what lies beyond the last code point.
    const bool illegal = (lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) || (lead == 0xf0 && second < 0x90) ||
                         (lead == 0xf4 && second > 0x8f);
    return illegal ? 0 : length;
}

}  // namespace

std::optional<ElementShape> shapeOf(std::string_view topology, std::int64_t nodesPerElement) {
    const std::string word = lowerCase(topology);
    const std::int64_t n = nodesPerElement;
    const auto is = [&](std::string_view start) { return word.starts_with(start); };
    const auto known = [&](ElementShape shape) -> std::optional<ElementShape> {
        return n >= cornerCount(shape) ? std::optional(shape) : std::nullopt;
    };
    if (is("hex") || is("brick")) {
        return known(ElementShape::Hexahedron);
    }
    if (is("wedge") || is("prism") || is("penta")) {
        return known(ElementShape::Wedge);
    }
    if (is("pyr")) {
        return known(ElementShape::Pyramid);
    }
    if (is("tet")) {
        return known(ElementShape::Tetrahedron);
    }
    if (is("tri")) {
        return known(ElementShape::Triangle);
    }
    if (is("quad")) {
        return known(ElementShape::Quadrilateral);
    }
    if (is("shell") || is("membrane")) {
        return n == 3 || n == 6 || n == 7 ? known(ElementShape::Triangle) : known(ElementShape::Quadrilateral);
    }
    // What libMesh and meshio call edges and lines are trusses, beams and rebars.
    constexpr std::array<std::string_view, 9> lines{"bar", "beam", "truss", "rod", "edge", "line", "spring", "cable", "rebar"};
    return std::any_of(lines.begin(), lines.end(), is) ? known(ElementShape::Beam) : std::nullopt;
}

std::optional<VectorVariable> findVector(const std::vector<std::string>& names, std::string_view prefix) {
    const auto [asComponent, unused] = componentOf(std::string(prefix) + "_x");
    VectorVariable result;
    result.index.fill(-1);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto [start, axis] = componentOf(names[i]);
        int* const index = start.empty() || start != asComponent ? nullptr : &result.index[static_cast<std::size_t>(axis - 'x')];
        if (index && *index < 0) {
            *index = static_cast<int>(i);
        }
    }
    if (*std::min_element(result.index.begin(), result.index.end()) < 0) {
        return std::nullopt;
    }
    for (const int index : result.index) {
        result.name += (result.name.empty() ? "" : ", ") + names[static_cast<std::size_t>(index)];
    }
    return result;
}

std::optional<VectorVariable> findDisplacement(const std::vector<std::string>& names) {
    for (const std::string_view prefix : {"disp", "displ", "displacement", "displacements", "u"}) {
        if (auto found = findVector(names, prefix)) {
            return found;
        }
    }
    return std::nullopt;
}

std::optional<VectorVariable> findVelocity(const std::vector<std::string>& names) {
    for (const std::string_view prefix : {"vel", "velo", "velocity", "velocities", "v"}) {
        if (auto found = findVector(names, prefix)) {
            return found;
        }
    }
    return std::nullopt;
}

std::optional<StatusVariable> findStatus(const std::vector<std::string>& names, std::string_view wanted) {
    const auto described = [&](std::size_t i) {
        StatusVariable status{static_cast<int>(i), names[i], {}};
        const std::string name = lowerCase(names[i]);
        for (const KnownStatus& known : knownStatus) {
            if (known.name == name) {
                status.activeByName = known.active;
            }
        }
        return status;
    };
    if (!wanted.empty()) {
        const auto exact = std::find(names.begin(), names.end(), wanted);
        if (exact != names.end()) {
            return described(static_cast<std::size_t>(exact - names.begin()));
        }
        const std::string key = lowerCase(wanted);
        const int found = findAny(names, {key});
        return found < 0 ? std::nullopt : std::optional(described(static_cast<std::size_t>(found)));
    }
    for (const KnownStatus& known : knownStatus) {
        const int found = findAny(names, {known.name});
        if (found >= 0) {
            return described(static_cast<std::size_t>(found));
        }
    }
    return std::nullopt;
}

int findAny(const std::vector<std::string>& names, const std::vector<std::string_view>& known) {
    for (const std::string_view key : known) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (lowerCase(names[i]) == key) {
                return static_cast<int>(i);
            }
        }
    }
    return -1;
}

std::string shownName(std::string_view raw) {
    std::string result;
    for (std::size_t i = 0; i < raw.size();) {
        const std::size_t length = sequenceLength(raw, i);
        const auto lead = static_cast<unsigned char>(raw[i]);
        if (length == 0 || lead < 0x20 || lead == 0x7f) {
            result += '?';
            ++i;
            continue;
        }
        result += raw.substr(i, length);
        i += length;
    }
    result.erase(result.find_last_not_of(' ') + 1);
    return result;
}

}  // namespace rubble::io
