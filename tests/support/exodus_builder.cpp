#include "tests/support/exodus_builder.h"

#include <exodusII.h>

#include <stdexcept>

#include "io/fe/exodus/library_lock.h"

namespace rubble::io {

namespace {

void require(int status, const char* call) {
    if (status < 0) {
        throw std::runtime_error(call);
    }
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) {
        pointers.push_back(text.data());
    }
    return pointers;
}

/// One file being written.
class Writer {
public:
    Writer(const ExodusBuilder& builder, const std::string& path) : m_builder(builder) {
        ex_opts(0);
        int memoryWord = sizeof(double), fileWord = sizeof(double);
        const int mode = EX_CLOBBER | (builder.netcdf4 ? EX_NETCDF4 : EX_LARGE_MODEL);
        require(m_id = ex_create(path.c_str(), mode, &memoryWord, &fileWord), "ex_create");
    }
    ~Writer() { ex_close(m_id); }

    void mesh() {
        int elements = 0;
        for (const auto& block : m_builder.blocks) {
            elements += block.elements();
        }
        require(ex_put_init(m_id, m_builder.title.c_str(), m_builder.dimensions, static_cast<int>(m_builder.nodes.size()), elements,
                            static_cast<int>(m_builder.blocks.size()), 0, 0),
                "ex_put_init");
        std::array<std::vector<double>, 3> x;
        for (const Vec3& node : m_builder.nodes) {
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                x[static_cast<std::size_t>(axis)].push_back(node[axis]);
            }
        }
        require(ex_put_coord(m_id, x[0].data(), x[1].data(), m_builder.dimensions > 2 ? x[2].data() : nullptr), "ex_put_coord");
        if (!m_builder.nodeNumbers.empty()) {
            require(ex_put_id_map(m_id, EX_NODE_MAP, m_builder.nodeNumbers.data()), "ex_put_id_map");
        }
        if (!m_builder.elementNumbers.empty()) {
            require(ex_put_id_map(m_id, EX_ELEM_MAP, m_builder.elementNumbers.data()), "ex_put_id_map");
        }
        for (const auto& block : m_builder.blocks) {
            put(block);
        }
    }

    void results() {
        variables(EX_NODAL, m_builder.nodal);
        variables(EX_ELEM_BLOCK, m_builder.element);
        if (!m_builder.truthTable.empty()) {
            std::vector<int> table = m_builder.truthTable;
            require(ex_put_truth_table(m_id, EX_ELEM_BLOCK, static_cast<int>(m_builder.blocks.size()),
                                       static_cast<int>(m_builder.element.size()), table.data()),
                    "ex_put_truth_table");
        }
        for (std::size_t k = 0; k < m_builder.times.size(); ++k) {
            require(ex_put_time(m_id, static_cast<int>(k) + 1, &m_builder.times[k]), "ex_put_time");
            state(k);
        }
    }

private:
    void put(const ExodusBuilder::Block& block) {
        require(ex_put_block(m_id, EX_ELEM_BLOCK, block.id, block.topology.c_str(), block.elements(), block.nodesPerElement, 0, 0,
                             block.attributeCount),
                "ex_put_block");
        if (!block.name.empty()) {
            require(ex_put_name(m_id, EX_ELEM_BLOCK, block.id, block.name.c_str()), "ex_put_name");
        }
        if (block.elements() == 0) {
            return;
        }
        require(ex_put_conn(m_id, EX_ELEM_BLOCK, block.id, block.nodes.data(), nullptr, nullptr), "ex_put_conn");
        if (block.attributeCount > 0) {
            require(ex_put_attr(m_id, EX_ELEM_BLOCK, block.id, block.attributes.data()), "ex_put_attr");
        }
        if (!block.attributeNames.empty()) {
            std::vector<std::string> names = block.attributeNames;
            names.resize(static_cast<std::size_t>(block.attributeCount));
            require(ex_put_attr_names(m_id, EX_ELEM_BLOCK, block.id, pointersTo(names).data()), "ex_put_attr_names");
        }
    }

    void variables(ex_entity_type type, const std::vector<std::pair<std::string, ExodusBuilder::Field>>& fields) {
        if (fields.empty()) {
            return;
        }
        std::vector<std::string> names;
        for (const auto& field : fields) {
            names.push_back(field.first);
        }
        require(ex_put_variable_param(m_id, type, static_cast<int>(names.size())), "ex_put_variable_param");
        require(ex_put_variable_names(m_id, type, static_cast<int>(names.size()), pointersTo(names).data()),
                "ex_put_variable_names");
    }

    void state(std::size_t k) {
        const int step = static_cast<int>(k) + 1;
        for (std::size_t v = 0; v < m_builder.nodal.size(); ++v) {
            std::vector<double> values;
            for (std::size_t n = 0; n < m_builder.nodes.size(); ++n) {
                values.push_back(m_builder.nodal[v].second(k, n));
            }
            require(ex_put_var(m_id, step, EX_NODAL, static_cast<int>(v) + 1, 1, static_cast<std::int64_t>(values.size()),
                               values.data()),
                    "ex_put_var");
        }
        for (std::size_t v = 0; v < m_builder.element.size(); ++v) {
            std::size_t first = 0;
            for (std::size_t b = 0; b < m_builder.blocks.size(); ++b) {
                const ExodusBuilder::Block& block = m_builder.blocks[b];
                const auto count = static_cast<std::size_t>(block.elements());
                const bool has = m_builder.truthTable.empty() || m_builder.truthTable[b * m_builder.element.size() + v] != 0;
                std::vector<double> values;
                for (std::size_t e = 0; has && e < count; ++e) {
                    values.push_back(m_builder.element[v].second(k, first + e));
                }
                first += count;
                if (!values.empty()) {
                    require(ex_put_var(m_id, step, EX_ELEM_BLOCK, static_cast<int>(v) + 1, block.id,
                                       static_cast<std::int64_t>(count), values.data()),
                            "ex_put_var");
                }
            }
        }
    }

    const ExodusBuilder& m_builder;
    int m_id = -1;
};

}  // namespace

void ExodusBuilder::write(const std::string& path) const {
    const LibraryLock lock;
    Writer writer(*this, path);
    writer.mesh();
    writer.results();
}

std::size_t ExodusBuilder::addCubes(int count, const std::string& name, int id) {
    std::size_t before = 0;
    for (const Block& block : blocks) {
        before += static_cast<std::size_t>(block.elements());
    }
    Block block{.id = id, .name = name, .nodes = {}};
    const double y = 3.0 * static_cast<double>(blocks.size());
    const int start = static_cast<int>(nodes.size()) + 1;
    for (int i = 0; i <= count; ++i) {
        nodes.insert(nodes.end(), {Vec3(i, y, 0), Vec3(i, y + 1, 0), Vec3(i, y + 1, 1), Vec3(i, y, 1)});
    }
    for (int i = 0; i < count; ++i) {
        for (const int offset : {0, 1, 2, 3}) {
            block.nodes.push_back(start + 4 * i + offset);
        }
        for (const int offset : {4, 5, 6, 7}) {
            block.nodes.push_back(start + 4 * i + offset);
        }
    }
    blocks.push_back(block);
    return before;
}

void ExodusBuilder::addStillDisplacement() {
    for (const char* name : {"disp_x", "disp_y", "disp_z"}) {
        nodal.emplace_back(name, [](std::size_t, std::size_t) { return 0.0; });
    }
}

ExodusBuilder ExodusBuilder::threeCubes() {
    ExodusBuilder builder;
    builder.addCubes(3, "row", 1);
    builder.times = {0.0, 0.5, 1.0, 1.5};
    builder.addStillDisplacement();
    return builder;
}

}  // namespace rubble::io
