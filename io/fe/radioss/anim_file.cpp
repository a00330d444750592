#include "io/fe/radioss/anim_file.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/error.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/radioss/anim_stream.h"

namespace rubble::io {

namespace {

constexpr std::int64_t magicNow = 0x542C;
constexpr std::size_t nameBytes = 81, partBytes = 50;

// Flags of the header by their places.
enum Flag : std::size_t { MASSES, NUMBERS, SOLIDS, BEAMS, HIERARCHY, HISTORIES, SHELL_SKEWS, PARTICLES };

/// Reads the blocks in their order and keeps what is wanted.
class AnimReader {
public:
    AnimReader(const std::string& path, AnimWanted wanted) : m_stream(path), m_wanted(wanted) {}

    AnimState read() {
        readHead();
        readShellBlock();
        if (m_wanted == AnimWanted::Nodes) {
            return std::move(m_state);
        }
        if (m_flags[SOLIDS] != 0) {
            readSolidBlock();
        }
        if (m_flags[BEAMS] != 0) {
            readBeamBlock();
        }
        if (m_flags[PARTICLES] != 0) {
            skipHierarchy();
            skipHistories();
            readParticleBlock();
        }
        return std::move(m_state);
    }

private:
    bool everything() const { return m_wanted == AnimWanted::Everything; }

    void readHead() {
        const std::int64_t magic = m_stream.integer("the first word");
        if (magic != magicNow) {
            throw ParseError({"anim.magic",
                              "{0} is an animation file of another version: it begins with {1}, {2} is read",
                              {m_stream.path(), magic, magicNow}},
                             {"anim.magic.remedy", "Run the analysis with OpenRadioss, or a newer version.", {}});
        }
        m_state.time = m_stream.real("the time");
        m_stream.skip({3, nameBytes}, "the texts of the header");
        m_flags = m_stream.integers(10, "the flags of the header");
    }

    std::size_t count(std::int64_t value, const char* what) const {
        constexpr std::int64_t most = std::int64_t{1} << 31;
        if (value < 0 || value >= most) {
            throw ParseError({"anim.bad_count",
                              "{0}: the number of {1} before byte {2} is {3}; expected: 0 or more",
                              {m_stream.path(), what, m_stream.place(), value}},
                             {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
        }
        return static_cast<std::size_t>(value);
    }

    std::vector<std::size_t> counts(std::size_t number, const char* what) {
        std::vector<std::size_t> result;
        for (const std::int64_t value : m_stream.integers(number, what)) {
            result.push_back(count(value, what));
        }
        return result;
    }

    std::vector<std::string> names(std::size_t number) {
        std::vector<std::string> result;
        for (std::size_t i = 0; i < number; ++i) {
            result.push_back(shownName(m_stream.text(nameBytes, "a name")));
        }
        return result;
    }

    std::vector<Vec3> vectors(std::size_t number, const char* what) {
        const std::vector<double> values = m_stream.reals(3 * number, what);
        std::vector<Vec3> result(number);
        for (std::size_t i = 0; i < number; ++i) {
            result[i] = Vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
        }
        return result;
    }

    void readShellBlock() {
        const std::vector<std::size_t> n = counts(8, "nodes, shells and values");
        const std::size_t nodes = n[0], shells = n[1], parts = n[2], functions = n[3], values = n[4], vectorCount = n[5],
                          tensors = n[6];
        m_nodes = nodes;
        m_stream.skip({12, n[7]}, "the local axes");
        if (m_wanted == AnimWanted::Status) {
            m_stream.skip({12, nodes}, "the coordinates");
        } else {
            m_state.positions = vectors(nodes, "the coordinates");
        }
        AnimElements& elements = m_state.of(AnimKind::Shell);
        readElements(AnimKind::Shell, shells, parts);
        m_stream.skip({6, nodes}, "the normals");
        const std::vector<std::string> list = names(functions + values);
        m_stream.skip({4, functions, nodes}, "the values of nodes");
        readValues(elements, {list.begin() + static_cast<std::ptrdiff_t>(functions), list.end()});
        for (const std::string& name : names(vectorCount)) {
            m_vectorNames.push_back(name);
        }
        readVectors(nodes);
        if (m_wanted == AnimWanted::Nodes) {
            return;
        }
        m_stream.skip({nameBytes, tensors}, "names of tensors");
        m_stream.skip({12, tensors, shells}, "the tensors of shells");
        if (m_flags[MASSES] != 0) {
            readMass(elements);
            m_stream.skip({4, nodes}, "the masses of nodes");
        }
        if (m_flags[NUMBERS] != 0) {
            if (everything()) {
                m_state.nodeIds = m_stream.integers(nodes, "the numbers of nodes");
            } else {
                m_stream.skip({4, nodes}, "the numbers of nodes");
            }
            elements.ids = m_stream.integers(shells, "the numbers of shells");
        }
        skipPartHierarchy(parts);
    }

    void readVectors(std::size_t nodes) {
        for (const std::string& name : m_vectorNames) {
            if (name == "Velocity" && m_wanted != AnimWanted::Status) {
                m_state.velocities = vectors(nodes, "the velocities");
            } else {
                m_stream.skip({12, nodes}, "a vector of nodes");
            }
        }
    }

    void readElements(AnimKind kind, std::size_t number, std::size_t parts) {
        AnimElements& elements = m_state.of(kind);
        elements.count = number;
        const std::size_t width = animWidth(kind);
        if (everything()) {
            elements.nodes = m_stream.integers(width * number, "the nodes of elements");
            const auto wrong = std::find_if(elements.nodes.begin(), elements.nodes.end(), [this](std::int64_t node) {
                return node < 0 || node >= static_cast<std::int64_t>(m_nodes);
            });
            if (wrong != elements.nodes.end()) {
                throw ParseError({"anim.bad_node",
                                  "{0}: an element in the block before byte {1} uses node {2} of {3}",
                                  {m_stream.path(), m_stream.place(), *wrong + 1, m_nodes}},
                                 {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
            }
        } else {
            m_stream.skip({4, width, number}, "the nodes of elements");
        }
        elements.off = m_stream.bytes(number, "the state of elements");
        const std::vector<std::int64_t> ends = m_stream.integers(parts, "the parts");
        for (std::size_t p = 0; p < parts; ++p) {
            elements.parts.push_back(partNamed(m_stream.text(partBytes, "the name of a part")));
        }
        if (everything()) {
            sortIntoParts(elements, ends);
        }
    }

    // The list of parts gives the first element after each.
    void sortIntoParts(AnimElements& elements, const std::vector<std::int64_t>& ends) const {
        std::uint32_t part = 0;
        for (std::size_t e = 0; e < elements.count; ++e) {
            while (part < ends.size() && static_cast<std::int64_t>(e) >= ends[part]) {
                ++part;
            }
            if (part == ends.size()) {
                throw ParseError({"anim.no_part",
                                  "{0}: element {1} of {2} in the block before byte {3} belongs to none of {4} parts",
                                  {m_stream.path(), e + 1, elements.count, m_stream.place(), ends.size()}},
                                 {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
            }
            elements.part.push_back(part);
        }
    }

    // "%8d:NAME"
    static AnimPart partNamed(const std::string& text) {
        const std::size_t colon = text.find(':');
        AnimPart part;
        part.id = std::strtoll(text.c_str(), nullptr, 10);
        const std::string name = shownName(colon == std::string::npos ? text : text.substr(colon + 1));
        part.name = name.substr(std::min(name.find_first_not_of(' '), name.size()));
        return part;
    }

    void readValues(AnimElements& elements, const std::vector<std::string>& list) {
        for (const std::string& name : list) {
            std::vector<double>* target = name == "TIME DELETION ELEMENT"       ? &elements.deletion
                                          : name == "Density" && everything()   ? &elements.density
                                          : name == "Thickness" && everything() ? &elements.thickness
                                                                                : nullptr;
            if (target && m_wanted != AnimWanted::Nodes) {
                *target = m_stream.reals(elements.count, "the values of elements");
            } else {
                m_stream.skip({4, elements.count}, "the values of elements");
            }
        }
    }

    void readMass(AnimElements& elements) {
        if (everything()) {
            elements.mass = m_stream.reals(elements.count, "the masses of elements");
        } else {
            m_stream.skip({4, elements.count}, "the masses of elements");
        }
    }

    void skipPartHierarchy(std::size_t parts) {
        if (m_flags[HIERARCHY] != 0) {
            m_stream.skip({12, parts}, "the materials of parts");
        }
    }

    void finishBlock(AnimElements& elements, std::size_t parts) {
        if (m_flags[MASSES] != 0) {
            readMass(elements);
        }
        if (m_flags[NUMBERS] != 0) {
            elements.ids = m_stream.integers(elements.count, "the numbers of elements");
        }
        skipPartHierarchy(parts);
    }

    void readSolidBlock() {
        const std::vector<std::size_t> n = counts(4, "solids and their values");
        AnimElements& elements = m_state.of(AnimKind::Solid);
        readElements(AnimKind::Solid, n[0], n[1]);
        readValues(elements, names(n[2]));
        m_stream.skip({nameBytes, n[3]}, "names of tensors");
        m_stream.skip({24, n[3], n[0]}, "the tensors of solids");
        finishBlock(elements, n[1]);
    }

    void readBeamBlock() {
        const std::vector<std::size_t> n = counts(5, "beams and their values");
        AnimElements& elements = m_state.of(AnimKind::Beam);
        readElements(AnimKind::Beam, n[0], n[1]);
        readValues(elements, names(n[2]));
        m_stream.skip({nameBytes, n[3]}, "names of tensors");
        m_stream.skip({36, n[3], n[0]}, "the forces of beams");
        if (n[4] != 0) {
            m_stream.skip({4, n[0]}, "the axes of beams");
        }
        finishBlock(elements, n[1]);
    }

    void skipHierarchy() {
        if (m_flags[HIERARCHY] == 0) {
            return;
        }
        const std::size_t subsets = counts(1, "subsets").front();
        for (std::size_t s = 0; s < subsets; ++s) {
            m_stream.skip({partBytes + 4}, "a subset");
            for (int list = 0; list < 4; ++list) {
                m_stream.skip({4, counts(1, "members of a subset").front()}, "members of a subset");
            }
        }
        const std::vector<std::size_t> n = counts(2, "materials and properties");
        m_stream.skip({partBytes + 4, n[0] + n[1]}, "materials and properties");
    }

    void skipHistories() {
        if (m_flags[HISTORIES] == 0) {
            return;
        }
        for (const std::size_t number : counts(4, "time histories")) {
            m_stream.skip({4 + partBytes, number}, "time histories");
        }
    }

    void readParticleBlock() {
        const std::vector<std::size_t> n = counts(4, "particles and their values");
        AnimElements& elements = m_state.of(AnimKind::Particle);
        readElements(AnimKind::Particle, n[0], n[1]);
        readValues(elements, names(n[2]));
        m_stream.skip({nameBytes, n[3]}, "names of tensors");
        m_stream.skip({24, n[3], n[0]}, "the tensors of particles");
        finishBlock(elements, n[1]);
    }

    AnimStream m_stream;
    const AnimWanted m_wanted;
    std::vector<std::int64_t> m_flags;
    std::size_t m_nodes = 0;
    std::vector<std::string> m_vectorNames;
    AnimState m_state;
};

}  // namespace

std::size_t animWidth(AnimKind kind) {
    constexpr std::array<std::size_t, animKinds> widths{8, 4, 2, 1};
    return widths[static_cast<std::size_t>(kind)];
}

AnimState readAnimFile(const std::string& path, AnimWanted wanted) {
    return AnimReader(path, wanted).read();
}

}  // namespace rubble::io
