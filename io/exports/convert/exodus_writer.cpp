#include "io/exports/convert/exodus_writer.h"

#include <exodusII.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "io/base/hdf5_handle.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/exodus/library_lock.h"

namespace rubble::io {

namespace {

constexpr std::size_t longestName = 255;  // that readers of the format bear
constexpr int compression = 1;

/// Elements of one part and one shape.
struct ExodusPart {
    std::uint32_t part = 0;
    ElementShape shape = ElementShape::Hexahedron;
    std::int64_t id = 0;
    std::vector<std::uint32_t> elements;
};

const char* topologyOf(ElementShape shape) {
    static constexpr std::array<const char*, 7> names{"HEX8", "WEDGE6", "PYRAMID5", "TETRA4", "SHELL4", "SHELL3", "BAR2"};
    return names[static_cast<std::size_t>(shape)];
}

// By part, then by shape; elements keep their order.
std::vector<ExodusPart> partsOf(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, ElementShape>, std::vector<std::uint32_t>> groups;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        groups[{mesh.part[e], mesh.shapes[e]}].push_back(static_cast<std::uint32_t>(e));
    }
    std::set<std::int64_t> numbers;
    bool numbered = groups.size() == mesh.parts.size();
    for (const Part& part : mesh.parts) {
        numbered =
            numbered && part.fileId > 0 && part.fileId <= std::numeric_limits<int>::max() && numbers.insert(part.fileId).second;
    }
    std::vector<ExodusPart> blocks;
    for (auto& [key, elements] : groups) {
        const std::int64_t id = numbered ? mesh.parts[key.first].fileId : static_cast<std::int64_t>(blocks.size()) + 1;
        blocks.push_back({key.first, key.second, id, std::move(elements)});
    }
    return blocks;
}

std::string fittingName(const std::string& name) {
    std::string cut = name.substr(0, longestName);
    while (cut.size() < name.size() && !cut.empty() && (static_cast<unsigned char>(name[cut.size()]) & 0xc0) == 0x80) {
        cut.pop_back();
    }
    return cut;
}

bool anyFinite(const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// One file being written. Calls into the library hold its lock; states are read without it.
class ExodusWriter {
public:
    ExodusWriter(const std::string& path, const FeResult& fe, const Vec3& offset)
        : m_path(path), m_fe(fe), m_mesh(fe.mesh()), m_offset(offset), m_blocks(partsOf(fe.mesh())) {
        const LibraryLock lock;
        ex_opts(0);
        int memoryWord = sizeof(double), fileWord = sizeof(double);
        const int wide = wideNumbers() ? EX_MAPS_INT64_DB | EX_IDS_INT64_DB : 0;
        m_id = ex_create(path.c_str(), EX_CLOBBER | EX_NETCDF4 | EX_ALL_INT64_API | wide, &memoryWord, &fileWord);
        require(m_id);
        ex_set_max_name_length(m_id, static_cast<int>(longestName));
        ex_set_option(m_id, EX_OPT_COMPRESSION_LEVEL, compression);
        ex_set_option(m_id, EX_OPT_COMPRESSION_SHUFFLE, 1);
    }
    ~ExodusWriter() {
        const LibraryLock lock;
        if (m_id >= 0) {
            ex_close(m_id);
        }
    }
    ExodusWriter(const ExodusWriter&) = delete;
    ExodusWriter& operator=(const ExodusWriter&) = delete;

    void write(const Execution& execution) {
        writeMesh();
        defineVariables();
        const Message stage{"convert.state", "Writing the states", {}};
        const std::size_t states = m_fe.stateCount();
        for (std::size_t k = 0; k < states; ++k) {
            execution.report(stage, static_cast<double>(k) / static_cast<double>(states));
            writeState(k, m_fe.contents().source->read(k));
        }
        const LibraryLock lock;
        const int id = std::exchange(m_id, -1);
        require(ex_close(id));
        execution.report(stage, 1.0);
    }

private:
    [[noreturn]] void fail() const {
        throw WorldError({"convert.write", "Cannot write {0}: {1}", {m_path, hdf5Reason()}},
                         {"convert.write.remedy", "Check free space and rights of the folder, or choose another place.", {}});
    }
    void require(int status) const {
        if (status < 0) {
            fail();
        }
    }

    bool wideNumbers() const {
        const auto wide = [](std::int64_t number) { return number > std::numeric_limits<int>::max(); };
        return std::any_of(m_mesh.nodeIds.begin(), m_mesh.nodeIds.end(), wide) ||
               std::any_of(m_mesh.elementIds.begin(), m_mesh.elementIds.end(), wide);
    }

    void writeMesh() {
        const LibraryLock lock;
        const auto nodes = static_cast<std::int64_t>(m_mesh.nodeCount()),
                   elements = static_cast<std::int64_t>(m_mesh.elementCount());
        require(ex_put_init(m_id, "Rubble", 3, nodes, elements, static_cast<std::int64_t>(m_blocks.size()), 0, 0));
        writeSource();
        std::array<std::vector<double>, 3> x;
        for (const Vec3& node : m_mesh.nodes) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<Eigen::Index>(axis);
                x[axis].push_back(node[a] + m_offset[a]);
            }
        }
        require(ex_put_coord(m_id, x[0].data(), x[1].data(), x[2].data()));
        require(ex_put_id_map(m_id, EX_NODE_MAP, m_mesh.nodeIds.data()));
        std::vector<std::int64_t> numbers;
        for (const ExodusPart& block : m_blocks) {
            for (const std::uint32_t e : block.elements) {
                numbers.push_back(m_mesh.elementIds[e]);
            }
        }
        for (const ExodusPart& block : m_blocks) {
            writeBlock(block);
        }
        require(ex_put_id_map(m_id, EX_ELEM_MAP, numbers.data()));
        if (m_blocks.size() > m_mesh.parts.size()) {
            writePartsOfBlocks();
        }
    }

    // From what it was made, as far as 80 characters a line go.
    void writeSource() {
        std::array<std::string, 3> lines{"converted by Rubble from " + m_fe.contents().format, "SHA-256 " + m_fe.contents().sha256,
                                         "lengths in m, z up, mass in kg"};
        std::array<char*, 3> pointers{};
        for (std::size_t i = 0; i < lines.size(); ++i) {
            lines[i].resize(std::min<std::size_t>(lines[i].size(), MAX_LINE_LENGTH));
            pointers[i] = lines[i].data();
        }
        require(ex_put_info(m_id, static_cast<int>(lines.size()), pointers.data()));
    }

    void writeBlock(const ExodusPart& block) {
        std::vector<std::pair<std::string, std::vector<double>>> attributes;
        const auto add = [&](const char* name, const std::vector<double>& of) {
            std::vector<double> values;
            for (const std::uint32_t e : block.elements) {
                values.push_back(of[e]);
            }
            if (anyFinite(values)) {
                attributes.emplace_back(name, std::move(values));
            }
        };
        if (!isSolid(block.shape)) {
            add(isShell(block.shape) ? "thickness" : "area", m_mesh.section);
        }
        add("density", m_mesh.density);
        const int corners = cornerCount(block.shape);
        require(ex_put_block(m_id, EX_ELEM_BLOCK, block.id, topologyOf(block.shape),
                             static_cast<std::int64_t>(block.elements.size()), corners, 0, 0,
                             static_cast<std::int64_t>(attributes.size())));
        require(ex_put_name(m_id, EX_ELEM_BLOCK, block.id, fittingName(m_mesh.parts[block.part].name).c_str()));
        std::vector<std::int64_t> nodes;
        for (const std::uint32_t e : block.elements) {
            for (const std::uint32_t node : m_mesh.cornersOf(idAt<ElementIndex>(e))) {
                nodes.push_back(static_cast<std::int64_t>(node) + 1);
            }
        }
        require(ex_put_conn(m_id, EX_ELEM_BLOCK, block.id, nodes.data(), nullptr, nullptr));
        std::vector<char*> names;
        for (std::size_t a = 0; a < attributes.size(); ++a) {
            require(ex_put_one_attr(m_id, EX_ELEM_BLOCK, block.id, static_cast<int>(a) + 1, attributes[a].second.data()));
            names.push_back(attributes[a].first.data());
        }
        if (!names.empty()) {
            require(ex_put_attr_names(m_id, EX_ELEM_BLOCK, block.id, names.data()));
        }
    }

    // Readers that do not know it see blocks of the same name.
    void writePartsOfBlocks() {
        int dimension = -1, variable = -1;
        std::vector<int> parts;
        for (const ExodusPart& block : m_blocks) {
            parts.push_back(static_cast<int>(block.part));
        }
        const bool written = nc_redef(m_id) == NC_NOERR && nc_inq_dimid(m_id, "num_el_blk", &dimension) == NC_NOERR &&
                             nc_def_var(m_id, exodusPartVariable, NC_INT, 1, &dimension, &variable) == NC_NOERR &&
                             nc_enddef(m_id) == NC_NOERR && nc_put_var_int(m_id, variable, parts.data()) == NC_NOERR;
        if (!written) {
            fail();
        }
    }

    void defineVariables() {
        const LibraryLock lock;
        std::vector<std::string> nodal{"disp_x", "disp_y", "disp_z"}, element{"STATUS"};
        if (m_fe.contents().hasVelocity) {
            nodal.insert(nodal.end(), {"vel_x", "vel_y", "vel_z"});
        }
        if (!m_fe.contents().deathTime.empty()) {
            element.emplace_back("death_time");
        }
        define(EX_NODAL, nodal);
        define(EX_ELEM_BLOCK, element);
    }

    void define(ex_entity_type type, std::vector<std::string>& names) {
        std::vector<char*> pointers;
        for (std::string& name : names) {
            pointers.push_back(name.data());
        }
        require(ex_put_variable_param(m_id, type, static_cast<int>(names.size())));
        require(ex_put_variable_names(m_id, type, static_cast<int>(names.size()), pointers.data()));
    }

    void writeState(std::size_t k, const FeState& state) {
        const LibraryLock lock;
        const int step = static_cast<int>(k) + 1;
        require(ex_put_time(m_id, step, &state.time));
        std::vector<double> values(m_mesh.nodeCount());
        for (int axis = 0; axis < 3; ++axis) {
            for (std::size_t n = 0; n < values.size(); ++n) {
                values[n] = state.positions[n][axis] - m_mesh.nodes[n][axis];
            }
            writeNodal(step, axis + 1, values);
        }
        for (int axis = 0; axis < 3 && m_fe.contents().hasVelocity; ++axis) {
            for (std::size_t n = 0; n < values.size(); ++n) {
                values[n] = state.velocities[n][axis];
            }
            writeNodal(step, axis + 4, values);
        }
        for (const ExodusPart& block : m_blocks) {
            writeElements(step, 1, block,
                          [&](std::uint32_t e) { return m_fe.activity().active(k, idAt<ElementIndex>(e)) ? 1.0 : 0.0; });
            if (!m_fe.contents().deathTime.empty()) {
                writeElements(step, 2, block, [&](std::uint32_t e) {
                    const double time = m_fe.contents().deathTime[e];
                    return std::isfinite(time) ? time : 0.0;
                });
            }
        }
        // A full disk shows here, not at the end.
        require(ex_update(m_id));
    }

    void writeNodal(int step, int variable, const std::vector<double>& values) {
        require(ex_put_var(m_id, step, EX_NODAL, variable, 1, static_cast<std::int64_t>(values.size()), values.data()));
    }

    template <class Value>
    void writeElements(int step, int variable, const ExodusPart& block, const Value& valueOf) {
        std::vector<double> values;
        for (const std::uint32_t e : block.elements) {
            values.push_back(valueOf(e));
        }
        require(ex_put_var(m_id, step, EX_ELEM_BLOCK, variable, block.id, static_cast<std::int64_t>(values.size()), values.data()));
    }

    const std::string& m_path;
    const FeResult& m_fe;
    const Mesh& m_mesh;
    const Vec3& m_offset;
    const std::vector<ExodusPart> m_blocks;
    int m_id = -1;
};

}  // namespace

void writeExodus(const std::string& path, const FeResult& fe, const Vec3& offset, const Execution& execution) {
    ExodusWriter(path, fe, offset).write(execution);
}

}  // namespace rubble::io
