#include "tests/fuzz/made_tables.h"

#include <array>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "io/fe/fe_copy/copy_layout.h"
#include "io/fe/fe_copy/copy_seal.h"
#include "io/fe/vtk/hdf5_table.h"

namespace rubble {

namespace {

namespace table = io::copy_table;

// New ones go to the end here as well.
constexpr std::array groups{"/",
                            "/VTKHDF",
                            "/VTKHDF/Steps",
                            "/MODEL_STAGE[1]",
                            "/MODEL_STAGE[2]",
                            "/MODEL_STAGE[1]/MODEL/ELEMENTS/56-Brick[400:0]",
                            "/MODEL_STAGE[1]/RESULTS/ON_NODES/DISPLACEMENT/DATA/STEP_0",
                            "/MODEL_STAGE[1]/RESULTS/ON_NODES/DISPLACEMENT/DATA/STEP_1",
                            "/MODEL_STAGE[2]/RESULTS/ON_NODES/DISPLACEMENT/DATA/STEP_2"};
constexpr std::array attributes{"Type", "Version", "NSteps", "version", "format", "STEP", "TIME", "GEOMETRY"};
constexpr std::array texts{"UnstructuredGrid", "PolyData", "rubble-fe", ""};
// New names go to the end: the corpus knows them by their place.
constexpr std::array names{"/VTKHDF/NumberOfPoints",
                           "/VTKHDF/NumberOfCells",
                           "/VTKHDF/NumberOfConnectivityIds",
                           "/VTKHDF/Points",
                           "/VTKHDF/Types",
                           "/VTKHDF/Offsets",
                           "/VTKHDF/Connectivity",
                           "/VTKHDF/PointData/displacement",
                           "/VTKHDF/PointData/velocity",
                           "/VTKHDF/PointData/NODE_ID",
                           "/VTKHDF/CellData/STATUS",
                           "/VTKHDF/CellData/ELEMENT_ID",
                           "/VTKHDF/CellData/PART_ID",
                           "/VTKHDF/CellData/density",
                           "/VTKHDF/CellData/vtkGhostType",
                           "/VTKHDF/Steps/Values",
                           "/VTKHDF/Steps/PartOffsets",
                           "/VTKHDF/Steps/NumberOfParts",
                           "/VTKHDF/Steps/PointOffsets",
                           "/VTKHDF/Steps/CellOffsets",
                           "/VTKHDF/Steps/ConnectivityIdOffsets",
                           "/VTKHDF/Steps/PointDataOffsets/displacement",
                           "/VTKHDF/Steps/CellDataOffsets/STATUS",
                           table::about,
                           table::times,
                           table::activity,
                           table::nodeIds,
                           table::nodes,
                           table::elementIds,
                           table::shapes,
                           table::part,
                           table::corners,
                           table::density,
                           table::section,
                           table::deathTime,
                           table::chunks,
                           table::digests,
                           "/a",
                           "/b",
                           "/c",
                           "/MODEL_STAGE[1]/MODEL/NODES/ID",
                           "/MODEL_STAGE[1]/MODEL/NODES/COORDINATES",
                           "/MODEL_STAGE[1]/MODEL/ELEMENTS/56-Brick[400:0]",
                           "/MODEL_STAGE[1]/MODEL/ELEMENTS/5-ElasticBeam3d[1:0]",
                           "/MODEL_STAGE[1]/MODEL/SECTION_ASSIGNMENTS/SECTION_1[Fiber]/ASSIGNMENT",
                           "/MODEL_STAGE[1]/MODEL/SECTION_ASSIGNMENTS/SECTION_1[Fiber]/FIBER_DATA",
                           "/MODEL_STAGE[1]/RESULTS/ON_NODES/DISPLACEMENT/ID",
                           "/MODEL_STAGE[1]/RESULTS/ON_NODES/DISPLACEMENT/DATA/STEP_0",
                           "/MODEL_STAGE[1]/RESULTS/ON_NODES/DISPLACEMENT/DATA/STEP_1",
                           "/MODEL_STAGE[1]/RESULTS/ON_NODES/VELOCITY/DATA/STEP_1",
                           "/MODEL_STAGE[2]/MODEL/NODES/ID",
                           "/MODEL_STAGE[2]/MODEL/NODES/COORDINATES",
                           "/MODEL_STAGE[2]/MODEL/ELEMENTS/56-Brick[400:0]",
                           "/MODEL_STAGE[2]/RESULTS/ON_NODES/DISPLACEMENT/ID",
                           "/MODEL_STAGE[2]/RESULTS/ON_NODES/DISPLACEMENT/DATA/STEP_2"};

struct MadeTable {
    std::uint64_t columns = 1;
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
    std::uint64_t rows() const { return std::max(reals.size(), integers.size()) / columns; }
};

struct Made {
    std::map<std::string, MadeTable> tables;
    std::map<std::string, std::int64_t> numbers;
    std::map<std::string, std::string> words;
    io::CopySeal seal;  // of what was read since the last one was asked for
};

Made& made() {
    static Made tables;
    return tables;
}

std::string attributeKey(const std::string& group, const std::string& name) {
    return group + "@" + name;
}

/// Takes values off bytes; zeros behind their end.
class Bytes {
public:
    Bytes(const std::uint8_t* bytes, std::size_t size) : m_at(bytes), m_left(size) {}
    bool empty() const { return m_left == 0; }
    template <class T>
    T take() {
        T value{};
        const std::size_t count = std::min(sizeof(T), m_left);
        std::memcpy(&value, m_at, count);
        m_at += count;
        m_left -= count;
        return value;
    }
    std::size_t left() const { return m_left; }

private:
    const std::uint8_t* m_at;
    std::size_t m_left;
};

void makeTable(Bytes& bytes, std::uint8_t kind) {
    MadeTable& made_table = made().tables[names[bytes.take<std::uint8_t>() % names.size()]];
    made_table = {};
    made_table.columns = 1 + bytes.take<std::uint8_t>() % 10;
    const std::uint64_t values = made_table.columns * bytes.take<std::uint16_t>();
    const bool wide = (kind & 4) != 0;
    for (std::uint64_t i = 0; i < values && bytes.left() > 0; ++i) {
        if ((kind & 1) == 0) {
            made_table.integers.push_back(wide ? bytes.take<std::int64_t>() : bytes.take<std::int8_t>());
        } else {
            made_table.reals.push_back(wide ? bytes.take<double>() : static_cast<double>(bytes.take<float>()));
        }
    }
}

}  // namespace

void makeTables(const std::uint8_t* data, std::size_t size) {
    made() = {};
    for (Bytes bytes(data, size); !bytes.empty();) {
        const auto kind = bytes.take<std::uint8_t>();
        if ((kind & 2) != 0) {
            makeTable(bytes, kind);
            continue;
        }
        const std::string group = groups[bytes.take<std::uint8_t>() % groups.size()];
        const std::string key = attributeKey(group, attributes[bytes.take<std::uint8_t>() % attributes.size()]);
        if ((kind & 1) == 0) {
            made().numbers[key] = bytes.take<std::int8_t>();
        } else {
            made().words[key] = texts[bytes.take<std::uint8_t>() % texts.size()];
        }
    }
}

}  // namespace rubble

namespace rubble::io {

namespace {

[[noreturn]] void failTable(const std::string& path, const std::string& name) {
    throw ParseError({"fuzz.table", "{0}: {1} cannot be read", {path, name}}, {"fuzz.remedy", "None.", {}});
}

template <class From, class To>
std::vector<To> rowsOf(const MadeTable& table, const std::vector<From>& all, std::uint64_t first, std::uint64_t rows) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first * table.columns);
    std::vector<To> list;
    for (auto value = begin; value != begin + static_cast<std::ptrdiff_t>(rows * table.columns); ++value) {
        // As HDF5 converts: what does not fit becomes the nearest that does.
        if constexpr (std::is_same_v<From, double> && !std::is_same_v<To, double>) {
            list.push_back(*value > -9e18 && *value < 9e18 ? static_cast<To>(*value) : 0);
        } else {
            list.push_back(static_cast<To>(*value));
        }
    }
    return list;
}

}  // namespace

Hdf5Table::Hdf5Table(const std::string& path) : Hdf5Table(path, [](const Hdf5Table&) {}) {}

Hdf5Table::Hdf5Table(const std::string& path, const std::function<void(const Hdf5Table&)>& look) : m_path(path) {
    made().seal = {};
    look(*this);
}

bool Hdf5Table::has(const std::string& name) const {
    return name == copy_table::seal || made().tables.contains(name);
}

Hdf5Table::Shape Hdf5Table::shape(const std::string& name) const {
    const auto found = made().tables.find(name);
    return found == made().tables.end() ? Shape{} : Shape{found->second.rows(), found->second.columns};
}

template <class T>
std::vector<T> Hdf5Table::read(const std::string& name, hid_t, std::uint64_t first, std::uint64_t rows) const {
    const auto found = made().tables.find(name);
    if (found == made().tables.end() || first > found->second.rows() || rows > found->second.rows() - first) {
        failTable(m_path, name);
    }
    const MadeTable& table = found->second;
    std::vector<T> values = table.integers.empty() ? rowsOf<double, T>(table, table.reals, first, rows)
                                                   : rowsOf<std::int64_t, T>(table, table.integers, first, rows);
    made().seal.add(values);
    return values;
}

std::vector<double> Hdf5Table::reals(const std::string& name, std::uint64_t first, std::uint64_t rows) const {
    return read<double>(name, 0, first, rows);
}

// The seal is always sound: damage that it keeps out is no test of what comes behind it.
std::vector<std::int64_t> Hdf5Table::integers(const std::string& name, std::uint64_t first, std::uint64_t rows) const {
    if (name == copy_table::seal) {
        const Digest digest = made().seal.finish();
        made().seal = {};
        return {digest.bytes.begin(), digest.bytes.end()};
    }
    return read<std::int64_t>(name, 0, first, rows);
}

std::vector<std::string> Hdf5Table::tablesIn(const std::string& group) const {
    std::vector<std::string> list;
    for (const auto& [name, table] : made().tables) {
        if (name.starts_with(group + "/") && name.find('/', group.size() + 1) == std::string::npos) {
            list.push_back(name.substr(group.size() + 1));
        }
    }
    return list;
}

// The first step of every name below the group.
std::vector<std::string> Hdf5Table::groupsIn(const std::string& group) const {
    const std::string front = group == "/" ? "/" : group + "/";
    std::set<std::string> found;
    for (const auto& [name, table] : made().tables) {
        const std::size_t end = name.starts_with(front) ? name.find('/', front.size()) : std::string::npos;
        if (end != std::string::npos) {
            found.insert(name.substr(front.size(), end - front.size()));
        }
    }
    return {found.begin(), found.end()};
}

std::optional<double> Hdf5Table::real(const std::string& group, const std::string& attribute) const {
    const std::optional<std::int64_t> whole = number(group, attribute);
    return whole ? std::optional(static_cast<double>(*whole)) : std::nullopt;
}

std::optional<std::string> Hdf5Table::text(const std::string& group, const std::string& attribute) const {
    const auto found = made().words.find(attributeKey(group, attribute));
    return found == made().words.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::int64_t> Hdf5Table::number(const std::string& group, const std::string& attribute) const {
    const auto found = made().numbers.find(attributeKey(group, attribute));
    return found == made().numbers.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace rubble::io
