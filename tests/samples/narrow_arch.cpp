// Writes what lies in the inner half of the first rib of the reinforced concrete arch as a result of its own: a sixth of its
// elements, with all of its states and kinds of parts. Tests of the window that need no more than a collapsing bridge open it.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>

#include "io/fe/fe_reader.h"
#include "tests/support/exodus_builder.h"

namespace {

using namespace rubble;

/// Across the bridge, m.
struct Strip {
    double from = std::numeric_limits<double>::infinity();
    double to = -std::numeric_limits<double>::infinity();
};

double across(const Mesh& mesh, ElementIndex e) {
    double sum = 0.0;
    for (const std::uint32_t corner : mesh.cornersOf(e)) {
        sum += mesh.nodes[corner].y();
    }
    return sum / static_cast<double>(mesh.cornersOf(e).size());
}

/// Half the width of a part.
Strip halfOf(const Mesh& mesh, const std::string& part) {
    Strip strip;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        if (mesh.parts[mesh.part[e]].name == part) {
            const double y = across(mesh, idAt<ElementIndex>(e));
            strip.from = std::min(strip.from, y);
            strip.to = std::max(strip.to, y);
        }
    }
    strip.to = 0.5 * (strip.from + strip.to);
    return strip;
}

/// Elements of a strip as blocks of a file, with their nodes.
class Cut {
public:
    explicit Cut(std::shared_ptr<const FeResult> fe) : m_fe(std::move(fe)) {
        const Mesh& mesh = m_fe->mesh();
        const Strip strip = halfOf(mesh, "arch rib 1");
        for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
            addPart(mesh, p, strip);
        }
    }

    void write(const std::string& path) {
        const FeResult& fe = *m_fe;
        m_file.times = fe.times();
        m_file.netcdf4 = true;
        m_file.title = "a sixth of the reinforced concrete arch";
        std::vector<std::shared_ptr<const FeState>> states;
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            states.push_back(fe.state(k));
        }
        const std::array<const char*, 3> axes{"disp_x", "disp_y", "disp_z"};
        for (int axis = 0; axis < 3; ++axis) {
            m_file.nodal.emplace_back(axes[static_cast<std::size_t>(axis)], [&, axis](std::size_t state, std::size_t node) {
                const std::size_t of = m_nodes[node];
                return states[state]->positions[of][axis] - fe.mesh().nodes[of][axis];
            });
        }
        m_file.element.emplace_back("STATUS", [&](std::size_t state, std::size_t e) {
            return fe.activity().active(state, idAt<ElementIndex>(m_elements[e])) ? 1.0 : 0.0;
        });
        m_file.write(path);
    }
    std::size_t elements() const { return m_elements.size(); }

private:
    void addPart(const Mesh& mesh, std::size_t part, const Strip& strip) {
        io::ExodusBuilder::Block block;
        block.id = static_cast<int>(part) + 1;
        block.name = mesh.parts[part].name;
        bool shells = false;
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            const auto index = idAt<ElementIndex>(e);
            const double y = across(mesh, index);
            if (mesh.part[e] != part || y < strip.from || y > strip.to) {
                continue;
            }
            shells = isShell(mesh.shapes[e]);
            for (const std::uint32_t corner : mesh.cornersOf(index)) {
                block.nodes.push_back(nodeOf(mesh, corner));
            }
            block.attributes.push_back(mesh.density[e]);
            if (shells) {
                block.attributes.push_back(mesh.section[e]);
            }
            m_elements.push_back(e);
        }
        if (block.nodes.empty()) {
            return;
        }
        block.topology = shells ? "SHELL4" : "HEX8";
        block.nodesPerElement = shells ? 4 : 8;
        block.attributeNames = shells ? std::vector<std::string>{"DENSITY", "THICKNESS"} : std::vector<std::string>{"DENSITY"};
        block.attributeCount = shells ? 2 : 1;
        m_file.blocks.push_back(std::move(block));
    }
    /// Its number in the file, from 1.
    int nodeOf(const Mesh& mesh, std::uint32_t node) {
        const auto [known, isNew] = m_numbers.emplace(node, static_cast<int>(m_nodes.size()) + 1);
        if (isNew) {
            m_nodes.push_back(node);
            m_file.nodes.push_back(mesh.nodes[node]);
        }
        return known->second;
    }

    std::shared_ptr<const FeResult> m_fe;
    io::ExodusBuilder m_file;
    std::vector<std::size_t> m_elements;
    std::vector<std::size_t> m_nodes;
    std::map<std::uint32_t, int> m_numbers;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: rubble-narrow-arch IN OUT\n");
        return 2;
    }
    Cut cut(rubble::io::openFe(argv[1], {}, {}, Execution()));
    cut.write(argv[2]);
    std::printf("%zu elements\n", cut.elements());
    return 0;
}
