#include "tests/fuzz/made_med.h"

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "io/fe/med/med_file.h"

namespace rubble {

namespace {

constexpr std::array types{1, 102, 103, 203, 204, 209, 304, 305, 306, 308, 320, 327, 312, 400, 500};
constexpr std::array fieldNames{"RESU____DEPL", "RESU____VITE", "RESU____SIEF_ELGA", "RESU____STATUS", "disp", "OTHER___DEPL"};
constexpr std::array components{"DX", "DY", "DZ", "V1", "STATUS"};
constexpr std::size_t mostCells = 64;

/// Values of one field at one of its steps.
struct MadeValues {
    std::size_t field = 0, step = 0;
    io::MedPlace place = io::MedPlace::Nodes;
    io::MedValues values;
};

struct MadeMed {
    io::MedMesh mesh;
    std::vector<io::MedField> fields;
    std::vector<MadeValues> values;
};

MadeMed& madeMed() {
    static MadeMed made;
    return made;
}

/// Takes bytes off their row; zeros behind its end.
class Row {
public:
    Row(const std::uint8_t* bytes, std::size_t size) : m_at(bytes), m_left(size) {}
    bool empty() const { return m_left == 0; }
    std::uint8_t take() {
        const std::uint8_t value = m_left > 0 ? *m_at : std::uint8_t{0};
        m_at += m_left > 0 ? 1 : 0;
        m_left -= m_left > 0 ? 1 : 0;
        return value;
    }
    double real() {
        float value = 0.0F;
        std::array<std::uint8_t, sizeof(float)> bytes{};
        for (std::uint8_t& byte : bytes) {
            byte = take();
        }
        std::memcpy(&value, bytes.data(), sizeof(float));
        return static_cast<double>(value);
    }

private:
    const std::uint8_t* m_at;
    std::size_t m_left;
};

void addCells(Row& row) {
    io::MedCells block;
    block.type = types[row.take() % types.size()];
    const std::uint8_t given = row.take();
    block.count = 1 + row.take() % mostCells;
    for (const io::MedCells& other : madeMed().mesh.cells) {
        if (other.type == block.type) {
            return;  // a file has one block of a type
        }
    }
    const std::size_t width = block.type < 400 ? static_cast<std::size_t>(block.type % 100) : 0;
    for (std::size_t i = 0; i < block.count * width; ++i) {
        block.nodes.push_back(static_cast<std::int8_t>(row.take()));
    }
    for (std::size_t c = 0; c < block.count && width > 0; ++c) {
        if ((given & 1) != 0) {
            block.numbers.push_back(row.take());
        }
        if ((given & 2) != 0) {
            block.families.push_back(static_cast<std::int8_t>(row.take()));
        }
    }
    madeMed().mesh.cells.push_back(std::move(block));
}

void addValues(Row& row) {
    if (madeMed().fields.empty()) {
        return;
    }
    MadeValues made;
    made.field = row.take() % madeMed().fields.size();
    const io::MedField& field = madeMed().fields[made.field];
    made.step = row.take();
    made.place = static_cast<io::MedPlace>(row.take() % 3);
    made.values.type = made.place == io::MedPlace::Nodes ? 0 : types[row.take() % types.size()];
    made.values.points = 1 + row.take() % 3;
    made.values.count = row.take() % mostCells;
    const bool profile = (row.take() & 1) != 0;
    for (std::size_t i = 0; i < made.values.count && profile; ++i) {
        made.values.entities.push_back(static_cast<std::int8_t>(row.take()));
    }
    for (std::size_t i = 0; i < made.values.count * made.values.points * std::max<std::size_t>(field.components.size(), 1); ++i) {
        made.values.values.push_back(row.real());
    }
    madeMed().values.push_back(std::move(made));
}

void addEntry(Row& row) {
    io::MedMesh& mesh = madeMed().mesh;
    switch (row.take() % 7) {
        case 0:
            mesh.nodes.emplace_back(Vec3::Zero());
            for (double& coordinate : mesh.nodes.back()) {
                coordinate = row.real();
            }
            return;
        case 1:
            addCells(row);
            return;
        case 2:
            mesh.groups[static_cast<std::int8_t>(row.take())].emplace_back(1, static_cast<char>('A' + row.take() % 8));
            return;
        case 3:
            madeMed().fields.push_back({fieldNames[row.take() % fieldNames.size()], "mesh", {}, {}});
            for (std::size_t c = row.take() % components.size(); c > 0; --c) {
                madeMed().fields.back().components.emplace_back(components[c - 1]);
            }
            return;
        case 4:
            if (!madeMed().fields.empty()) {
                madeMed().fields.back().steps.push_back({row.take(), row.take(), row.real()});
            }
            return;
        case 5:
            mesh.axes = 1 + row.take() % 3;
            mesh.nodeNumbers.assign(row.take() % 2 == 0 ? 0 : mesh.nodes.size(), row.take());
            return;
        default:
            addValues(row);
    }
}

}  // namespace

void makeMed(const std::uint8_t* bytes, std::size_t size) {
    madeMed() = {};
    madeMed().mesh.name = "mesh";
    for (Row row(bytes, size); !row.empty();) {
        addEntry(row);
    }
    // The library hands over as many numbers as there are nodes.
    if (madeMed().mesh.nodeNumbers.size() != madeMed().mesh.nodes.size()) {
        madeMed().mesh.nodeNumbers.clear();
    }
}

}  // namespace rubble

namespace rubble::io {

MedFile::MedFile(const std::string& path) : m_path(path) {}

MedFile::~MedFile() = default;

std::vector<std::string> MedFile::meshNames() const {
    return {madeMed().mesh.name};
}

MedMesh MedFile::mesh(const std::string&) const {
    return madeMed().mesh;
}

std::vector<MedField> MedFile::fields() const {
    return madeMed().fields;
}

std::vector<MedValues> MedFile::values(const MedField& field, const MedStep& step, MedPlace place, bool) const {
    std::vector<MedValues> list;
    for (const MadeValues& made : madeMed().values) {
        const MedField& own = madeMed().fields[made.field];
        if (own.name == field.name && own.components == field.components && made.step == static_cast<std::size_t>(step.number) &&
            made.place == place) {
            list.push_back(made.values);
        }
    }
    return list;
}

}  // namespace rubble::io
