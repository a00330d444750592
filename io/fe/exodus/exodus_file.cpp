#include "io/fe/exodus/exodus_file.h"

#include <exodusII.h>
#include <netcdf.h>

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "core/base/error.h"
#include "io/fe/exodus/exodus_layout.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/exodus/library_lock.h"
#include "io/fe/series/later_branch.h"

namespace rubble::io {

namespace {

constexpr int nameLength = 256;

std::string stateText(std::size_t state) {
    return " at state " + englishInteger(static_cast<std::int64_t>(state));
}

/// Buffers for the library's lists of names.
class NameBuffer {
public:
    explicit NameBuffer(std::size_t count) : m_text(count, std::string(nameLength + 1, '\0')) {
        for (std::string& text : m_text) {
            m_pointers.push_back(text.data());
        }
    }
    char** pointers() { return m_pointers.data(); }
    std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (const std::string& text : m_text) {
            result.push_back(shownName(text.c_str()));
        }
        return result;
    }

private:
    std::vector<std::string> m_text;
    std::vector<char*> m_pointers;
};

}  // namespace

ExodusFile::ExodusFile(const std::string& path) : m_path(path) {
    m_unfinished = checkExodusLayout(path);
    const LibraryLock lock;
    ex_opts(0);
    int memoryWord = sizeof(double), fileWord = 0;
    float version = 0.0f;
    m_id = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &memoryWord, &fileWord, &version);
    if (m_id < 0) {
        require(m_id, "the header");
    }
    try {
        ex_set_max_name_length(m_id, nameLength);
        readHeader();
        readBlocks();
        readVariables();
        readTimes();
        m_chunks.emplace(path, m_written.empty() ? 0 : *std::ranges::max_element(m_written) + 1);
        readParts();
        readDecomposition();
    } catch (...) {
        ex_close(m_id);
        throw;
    }
}

ExodusFile::~ExodusFile() {
    const LibraryLock lock;
    ex_close(m_id);
}

void ExodusFile::require(int status, const std::string& what) const {
    if (status >= 0) {
        return;
    }
    const char* text = nullptr;
    const char* function = nullptr;
    int error = 0;
    ex_get_err(&text, &function, &error);
    throw ParseError(
        {"exodus.read", "{0}: cannot read {1} ({2})", {m_path, what, error < 0 ? nc_strerror(error) : "it is not there"}},
        {"exodus.read.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
}

void ExodusFile::readHeader() {
    const auto count = [&](int inquiry) {
        const std::int64_t value = ex_inquire_int(m_id, inquiry);
        require(static_cast<int>(std::min<std::int64_t>(value, 0)), "the header");
        return static_cast<std::size_t>(value);
    };
    m_dimensions = static_cast<int>(count(EX_INQ_DIM));
    m_nodes = count(EX_INQ_NODES);
    m_elements = count(EX_INQ_ELEM);
    m_blocks.resize(count(EX_INQ_ELEM_BLK));
}

void ExodusFile::readBlocks() {
    if (m_blocks.empty()) {
        return;
    }
    std::vector<std::int64_t> ids(m_blocks.size());
    require(ex_get_ids(m_id, EX_ELEM_BLOCK, ids.data()), "the block numbers");
    NameBuffer names(m_blocks.size());
    require(ex_get_names(m_id, EX_ELEM_BLOCK, names.pointers()), "the block names");
    const std::vector<std::string> blockNames = names.names();
    std::int64_t first = 0;
    for (std::size_t b = 0; b < m_blocks.size(); ++b) {
        const std::string what = "block " + std::to_string(ids[b]);
        ex_block block{};
        block.id = ids[b];
        block.type = EX_ELEM_BLOCK;
        require(ex_get_block_param(m_id, &block), what);
        m_blocks[b] = {ids[b], blockNames[b], shownName(block.topology), block.num_entry, block.num_nodes_per_entry, {}, first};
        first += block.num_entry;
        if (block.num_entry > 0 && block.num_attribute > 0) {
            NameBuffer attributes(static_cast<std::size_t>(block.num_attribute));
            require(ex_get_attr_names(m_id, EX_ELEM_BLOCK, ids[b], attributes.pointers()), "the attributes of " + what);
            m_blocks[b].attributes = attributes.names();
        }
    }
    if (first != static_cast<std::int64_t>(m_elements)) {
        throw ParseError(
            {"exodus.element_sum", "{0}: the blocks hold {1} elements, but the header says {2}", {m_path, first, m_elements}},
            {"exodus.element_sum.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
    }
}

void ExodusFile::readVariables() {
    const auto read = [&](ex_entity_type type, std::vector<std::string>& names) {
        int count = 0;
        require(ex_get_variable_param(m_id, type, &count), "the number of variables");
        if (count > 0) {
            NameBuffer buffer(static_cast<std::size_t>(count));
            require(ex_get_variable_names(m_id, type, count, buffer.pointers()), "the names of the variables");
            names = buffer.names();
        }
    };
    read(EX_NODAL, m_nodeVariables);
    read(EX_ELEM_BLOCK, m_elementVariables);
    m_truthTable.assign(m_blocks.size() * m_elementVariables.size(), 0);
    if (!m_truthTable.empty()) {
        require(ex_get_truth_table(m_id, EX_ELEM_BLOCK, static_cast<int>(m_blocks.size()),
                                   static_cast<int>(m_elementVariables.size()), m_truthTable.data()),
                "the truth table of the element variables");
    }
}

void ExodusFile::readTimes() {
    const std::int64_t count = ex_inquire_int(m_id, EX_INQ_TIME);
    require(static_cast<int>(std::min<std::int64_t>(count, 0)), "the number of states");
    std::vector<double> times(static_cast<std::size_t>(count) - std::min(m_unfinished, static_cast<std::size_t>(count)));
    for (std::size_t k = 0; k < times.size() && m_unfinished > 0; ++k) {
        require(ex_get_time(m_id, static_cast<int>(k) + 1, &times[k]), "the time of a state");
    }
    if (!times.empty() && m_unfinished == 0) {
        require(ex_get_all_times(m_id, times.data()), "the times of the states");
    }
    if (m_unfinished > 0) {
        m_findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                       {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, m_path,
                       static_cast<std::int64_t>(m_unfinished));
    }
    m_written = laterBranch(times, m_findings);
    for (const std::size_t written : m_written) {
        m_times.push_back(times[written]);
    }
}

void ExodusFile::readDecomposition() {
    const auto dimension = [&](const char* name, std::int64_t otherwise) {
        int id = -1;
        std::size_t length = 0;
        const bool there = nc_inq_dimid(m_id, name, &id) == NC_NOERR && nc_inq_dimlen(m_id, id, &length) == NC_NOERR;
        return there ? static_cast<std::int64_t>(length) : otherwise;
    };
    m_processors = dimension("num_processors", 1);
    m_elementsOfAll = dimension("num_elems_global", static_cast<std::int64_t>(m_elements));
}

void ExodusFile::readParts() {
    int variable = -1;
    if (nc_inq_varid(m_id, exodusPartVariable, &variable) != NC_NOERR || m_blocks.empty()) {
        return;
    }
    std::vector<long long> parts(m_blocks.size());
    if (nc_get_var_longlong(m_id, variable, parts.data()) == NC_NOERR) {
        m_partsOfBlocks.assign(parts.begin(), parts.end());
    }
}

bool ExodusFile::has(std::size_t block, int variable) const {
    return m_truthTable[block * m_elementVariables.size() + static_cast<std::size_t>(variable)] != 0;
}

std::vector<double> ExodusFile::coordinates(int axis) const {
    std::vector<double> values(m_nodes);
    if (m_nodes > 0) {
        const LibraryLock lock;
        require(ex_get_coord(m_id, axis == 0 ? values.data() : nullptr, axis == 1 ? values.data() : nullptr,
                             axis == 2 ? values.data() : nullptr),
                "the coordinates");
    }
    return values;
}

std::vector<std::int64_t> ExodusFile::numbers(ExodusEntity entity) const {
    const bool nodes = entity == ExodusEntity::Node;
    std::vector<std::int64_t> values(nodes ? m_nodes : m_elements);
    if (!values.empty()) {
        const LibraryLock lock;
        require(ex_get_id_map(m_id, nodes ? EX_NODE_MAP : EX_ELEM_MAP, values.data()),
                nodes ? "the node numbers" : "the element numbers");
    }
    return values;
}

std::vector<std::int64_t> ExodusFile::connectivity(std::size_t block) const {
    const ExodusBlock& b = m_blocks[block];
    std::vector<std::int64_t> values(static_cast<std::size_t>(b.elements * b.nodesPerElement));
    if (!values.empty()) {
        const LibraryLock lock;
        require(ex_get_conn(m_id, EX_ELEM_BLOCK, b.id, values.data(), nullptr, nullptr),
                "the elements of block " + std::to_string(b.id));
    }
    return values;
}

std::vector<double> ExodusFile::attribute(std::size_t block, std::size_t index) const {
    const ExodusBlock& b = m_blocks[block];
    std::vector<double> values(static_cast<std::size_t>(b.elements));
    if (!values.empty()) {
        const LibraryLock lock;
        require(ex_get_one_attr(m_id, EX_ELEM_BLOCK, b.id, static_cast<int>(index) + 1, values.data()),
                "the attributes of block " + std::to_string(b.id));
    }
    return values;
}

void ExodusFile::readNodal(std::size_t state, int variable, std::span<double> values) const {
    assert(values.size() == m_nodes);
    if (values.empty() || m_chunks->read("vals_nod_var" + std::to_string(variable + 1), m_written[state], values)) {
        return;
    }
    const LibraryLock lock;
    require(ex_get_var(m_id, static_cast<int>(m_written[state]) + 1, EX_NODAL, variable + 1, 1, static_cast<std::int64_t>(m_nodes),
                       values.data()),
            m_nodeVariables[static_cast<std::size_t>(variable)] + stateText(state));
}

void ExodusFile::readElement(std::size_t state, int variable, std::size_t block, std::span<double> values) const {
    const ExodusBlock& b = m_blocks[block];
    assert(values.size() == static_cast<std::size_t>(b.elements));
    const std::string dataset = "vals_elem_var" + std::to_string(variable + 1) + "eb" + std::to_string(block + 1);
    if (values.empty() || m_chunks->read(dataset, m_written[state], values)) {
        return;
    }
    const LibraryLock lock;
    require(ex_get_var(m_id, static_cast<int>(m_written[state]) + 1, EX_ELEM_BLOCK, variable + 1, b.id, b.elements, values.data()),
            m_elementVariables[static_cast<std::size_t>(variable)] + " of block " + std::to_string(b.id) + stateText(state));
}

}  // namespace rubble::io
