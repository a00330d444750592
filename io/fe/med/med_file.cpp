#include "io/fe/med/med_file.h"

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/hdf5_extent.h"
#include "io/base/native_lock.h"
#include "io/base/trial.h"
#include "io/fe/exodus/exodus_names.h"

// libmed may be built for parallel HDF5 and then names MPI in functions that are not called here.
struct ompi_communicator_t;
struct ompi_info_t;
using MPI_Comm = ompi_communicator_t*;
using MPI_Info = ompi_info_t*;
#include <med.h>

namespace rubble::io {

namespace {

// As for all tables of HDF5: what needs more than this per byte of the file is damaged.
constexpr std::uint64_t bestCompression = 1100;
// Values that the child reads to find out whether the library bears them.
constexpr std::int64_t mostTried = std::int64_t{1} << 25;
// Names in a damaged file may be longer than they should be.
constexpr std::size_t spare = 4096;

// libmed may bring an HDF5 of its own, which goes round in circles at the end of the program as ours would (see hdf5_handle.cpp).
// What libmed itself calls is asked for, since both have functions of that name.
bool endWithoutTheLibraryOfMed() {
    Dl_info med{};
    if (::dladdr(reinterpret_cast<const void*>(&MEDfileOpen), &med) == 0) {
        return false;
    }
    void* const library = ::dlopen(med.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    const auto withoutExit = library == nullptr ? nullptr : reinterpret_cast<int (*)()>(::dlsym(library, "H5dont_atexit"));
    return withoutExit != nullptr && withoutExit() >= 0;
}

const bool endsWithoutTheLibraryOfMed = endWithoutTheLibraryOfMed();

constexpr std::array cellTypes{MED_POINT1,  MED_SEG2,  MED_SEG3,   MED_SEG4,    MED_TRIA3,  MED_TRIA6,   MED_TRIA7,     MED_QUAD4,
                               MED_QUAD8,   MED_QUAD9, MED_TETRA4, MED_TETRA10, MED_PYRA5,  MED_PYRA13,  MED_PENTA6,    MED_PENTA15,
                               MED_PENTA18, MED_HEXA8, MED_HEXA20, MED_HEXA27,  MED_OCTA12, MED_POLYGON, MED_POLYHEDRON};

bool isFixed(int type) {
    return type < MED_POLYGON;
}

[[noreturn]] void failMed(const std::string& path, const std::string& what) {
    throw ParseError({"med.unreadable", "{0} cannot be read as MED: {1}", {path, what}},
                     {"med.unreadable.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

// The library speaks where it fails: what it cannot count is damaged, and the child says so.
med_int counted(med_int count, const std::string& path, const std::string& what) {
    if (count < 0) {
        failMed(path, what);
    }
    return count;
}

/// Listens to what the library says of a file, as long as it lives: it complains of damage and goes on, and leaves objects open.
class Complaints {
public:
    Complaints() : m_words(::memfd_create("complaints", MFD_CLOEXEC)), m_before(::dup(STDERR_FILENO)) {
        std::fflush(stderr);
        ::dup2(m_words, STDERR_FILENO);
    }
    ~Complaints() {
        std::fflush(stderr);
        ::dup2(m_before, STDERR_FILENO);
        ::close(m_before);
        ::close(m_words);
    }
    Complaints(const Complaints&) = delete;
    Complaints& operator=(const Complaints&) = delete;

    bool any() const {
        std::fflush(stderr);
        return ::lseek(m_words, 0, SEEK_END) > 0;
    }

private:
    int m_words, m_before;
};

// How often this process has a file open: what the library leaves open in a damaged file would be read in place of the next.
std::size_t timesOpen(const std::string& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::canonical(path, error);
    std::size_t count = 0;
    for (std::filesystem::directory_iterator entry("/proc/self/fd", error), end; !error && entry != end; entry.increment(error)) {
        std::error_code closed;
        count += std::filesystem::read_symlink(entry->path(), closed) == whole && !closed ? 1 : 0;
    }
    return count;
}

std::vector<char> textBuffer(std::size_t length) {
    return std::vector<char>(length + spare, '\0');
}

// Names are filled up with blanks.
std::string nameIn(const char* text, std::size_t width) {
    return shownName(std::string_view(text, strnlen(text, width)));
}

med_entity_type entityOf(MedPlace place) {
    return place == MedPlace::Nodes ? MED_NODE : place == MedPlace::Cells ? MED_CELL : MED_NODE_ELEMENT;
}

med_field_type typeOf(med_idt file, const std::string& field) {
    const med_int components = std::max<med_int>(MEDfieldnComponentByName(file, field.c_str()), 0);
    std::vector<char> mesh = textBuffer(MED_NAME_SIZE), unit = textBuffer(MED_SNAME_SIZE);
    std::vector<char> names = textBuffer(static_cast<std::size_t>(components) * MED_SNAME_SIZE), units = names;
    med_bool local = MED_TRUE;
    med_field_type type = MED_FLOAT64;
    med_int steps = 0;
    MEDfieldInfoByName(file, field.c_str(), mesh.data(), &local, &type, names.data(), units.data(), unit.data(), &steps);
    return type;
}

template <class T>
std::vector<double> realsIn(const std::vector<unsigned char>& bytes, std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        T value{};
        std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
        values[i] = static_cast<double>(value);
    }
    return values;
}

std::vector<double> realsOf(const std::vector<unsigned char>& bytes, std::size_t count, med_field_type type) {
    switch (type) {
        case MED_FLOAT32:
            return realsIn<float>(bytes, count);
        case MED_INT32:
            return realsIn<std::int32_t>(bytes, count);
        case MED_INT64:
            return realsIn<std::int64_t>(bytes, count);
        case MED_INT:
            return realsIn<med_int>(bytes, count);
        default:
            return realsIn<double>(bytes, count);
    }
}

std::vector<std::int64_t> wide(const std::vector<med_int>& numbers) {
    return {numbers.begin(), numbers.end()};
}

med_int countOf(med_idt file, const std::string& mesh, const MedStep& step, med_entity_type entity, int type, med_data_type data) {
    med_bool changed = MED_FALSE, transformed = MED_FALSE;
    const bool cells = entity == MED_CELL;
    return MEDmeshnEntity(file, mesh.c_str(), static_cast<med_int>(step.number), static_cast<med_int>(step.iteration), entity, type,
                          data, cells ? MED_NODAL : MED_NO_CMODE, &changed, &transformed);
}

}  // namespace

MedFile::MedFile(const std::string& path) : m_path(path) {
    std::error_code error;
    m_bytes = std::filesystem::file_size(path, error);
    if (error) {
        failToRead(path);
    }
    requireWholeHdf5(path);
    const std::scoped_lock lock(nativeLibraries());
    const auto look = [this] {
        const Complaints complaints;
        const std::size_t before = timesOpen(m_path);
        open();
        lookAtAll();
        close();
        if (complaints.any() || timesOpen(m_path) > before) {
            failMed(m_path, "the library complains of it");
        }
    };
    if (!survivesTrial(look)) {
        throw ParseError({"med.crash", "{0} is damaged so that the MED library fails on it", {path}},
                         {"med.unreadable.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
    }
    open();
}

MedFile::~MedFile() {
    const std::scoped_lock lock(nativeLibraries());
    close();
}

void MedFile::open() {
    m_file = MEDfileOpen(m_path.c_str(), MED_ACC_RDONLY);
    if (m_file < 0) {
        med_bool hdf = MED_FALSE, med = MED_FALSE;
        const bool known = MEDfileCompatibility(m_path.c_str(), &hdf, &med) >= 0 && hdf == MED_TRUE;
        failMed(m_path, known && med == MED_FALSE ? "it is of a version of MED that the library does not know"
                                                  : "the library does not open it");
    }
}

void MedFile::close() {
    if (m_file >= 0) {
        MEDfileClose(m_file);
    }
    m_file = -1;
}

void MedFile::lookAtAll() const {
    std::int64_t budget = mostTried;
    for (const MedField& field : fields()) {
        for (const MedStep& step : field.steps) {
            for (const MedPlace place : {MedPlace::Nodes, MedPlace::Cells, MedPlace::CellNodes}) {
                for (const MedValues& values : this->values(field, step, place, budget > 0)) {
                    budget -= static_cast<std::int64_t>(values.values.size());
                }
            }
        }
    }
    // Behind the fields: once a mesh is known, only its types of cells are asked for.
    for (const std::string& name : meshNames()) {
        mesh(name);
    }
}

std::size_t MedFile::bounded(std::int64_t count, std::size_t each, const std::string& what) const {
    const std::uint64_t most = m_bytes * bestCompression / std::max<std::size_t>(each, 1);
    if (count < 0 || static_cast<std::uint64_t>(count) > most) {
        failMed(m_path, what + " counts " + std::to_string(count) + ", which the file cannot hold");
    }
    return static_cast<std::size_t>(count);
}

std::vector<std::string> MedFile::meshNames() const {
    const std::scoped_lock lock(nativeLibraries());
    std::vector<std::string> names;
    const med_int count = counted(MEDnMesh(m_file), m_path, "its meshes");
    for (int m = 1; m <= count; ++m) {
        const med_int axes = counted(MEDmeshnAxis(m_file, m), m_path, "axes");
        std::vector<char> name = textBuffer(MED_NAME_SIZE), text = textBuffer(MED_COMMENT_SIZE), unit = textBuffer(MED_SNAME_SIZE);
        std::vector<char> axisNames = textBuffer(static_cast<std::size_t>(axes) * MED_SNAME_SIZE), axisUnits = axisNames;
        med_int space = 0, dimension = 0, steps = 0;
        med_mesh_type type = MED_UNDEF_MESH_TYPE;
        med_sorting_type sorting = MED_SORT_UNDEF;
        med_axis_type axis = MED_UNDEF_AXIS_TYPE;
        if (MEDmeshInfo(m_file, m, name.data(), &space, &dimension, &type, text.data(), unit.data(), &sorting, &steps, &axis,
                        axisNames.data(), axisUnits.data()) < 0) {
            failMed(m_path, "mesh " + std::to_string(m));
        }
        names.emplace_back(name.data(), strnlen(name.data(), MED_NAME_SIZE));
    }
    return names;
}

MedMesh MedFile::mesh(const std::string& name) const {
    const std::scoped_lock lock(nativeLibraries());
    MedMesh mesh;
    mesh.name = name;
    const med_int axes = counted(MEDmeshnAxisByName(m_file, name.c_str()), m_path, "axes");
    std::vector<char> text = textBuffer(MED_COMMENT_SIZE), unit = textBuffer(MED_SNAME_SIZE);
    std::vector<char> axisNames = textBuffer(static_cast<std::size_t>(axes) * MED_SNAME_SIZE), axisUnits = axisNames;
    med_int space = 0, dimension = 0, steps = 0;
    med_mesh_type type = MED_UNDEF_MESH_TYPE;
    med_sorting_type sorting = MED_SORT_UNDEF;
    med_axis_type axis = MED_UNDEF_AXIS_TYPE;
    if (MEDmeshInfoByName(m_file, name.c_str(), &space, &dimension, &type, text.data(), unit.data(), &sorting, &steps, &axis,
                          axisNames.data(), axisUnits.data()) < 0) {
        failMed(m_path, "its mesh \"" + shownName(name) + "\"");
    }
    if (type != MED_UNSTRUCTURED_MESH || axis != MED_CARTESIAN || space < 1 || space > 3) {
        throw ParseError(
            {"med.mesh", "{0}: the mesh {1} is no unstructured one in Cartesian coordinates", {m_path, shownName(name)}},
            {"med.mesh.remedy", "Write it as an unstructured mesh.", {}});
    }
    mesh.axes = space;
    mesh.steps = steps;
    MedStep first;
    med_int number = MED_NO_DT, iteration = MED_NO_IT;
    if (steps > 0) {
        counted(MEDmeshComputationStepInfo(m_file, name.c_str(), 1, &number, &iteration, &first.time), m_path, "steps of its mesh");
        first.number = number;
        first.iteration = iteration;
    }
    readNodes(first, mesh);
    for (const int cellType : cellTypes) {
        readCells(name, first, cellType, mesh.cells);
    }
    readFamilies(mesh);
    for (const MedCells& block : mesh.cells) {
        if (std::find(m_types.begin(), m_types.end(), block.type) == m_types.end()) {
            m_types.push_back(block.type);
        }
    }
    return mesh;
}

void MedFile::readNodes(const MedStep& step, MedMesh& mesh) const {
    const auto number = static_cast<med_int>(step.number), iteration = static_cast<med_int>(step.iteration);
    const auto axes = static_cast<std::size_t>(mesh.axes);
    const char* const name = mesh.name.c_str();
    const std::size_t nodes =
        bounded(countOf(m_file, mesh.name, step, MED_NODE, MED_NONE, MED_COORDINATE), axes * sizeof(double), "nodes");
    std::vector<double> places(nodes * axes);
    if (nodes > 0 && MEDmeshNodeCoordinateRd(m_file, name, number, iteration, MED_FULL_INTERLACE, places.data()) < 0) {
        failMed(m_path, "coordinates of nodes");
    }
    for (std::size_t n = 0; n < nodes; ++n) {
        Vec3 place = Vec3::Zero();
        for (std::size_t a = 0; a < axes; ++a) {
            place[static_cast<Eigen::Index>(a)] = places[n * axes + a];
        }
        mesh.nodes.push_back(place);
    }
    if (nodes > 0 && counted(countOf(m_file, mesh.name, step, MED_NODE, MED_NONE, MED_NUMBER), m_path, "numbers") ==
                         static_cast<med_int>(nodes)) {
        std::vector<med_int> numbers(nodes);
        counted(MEDmeshEntityNumberRd(m_file, name, number, iteration, MED_NODE, MED_NONE, numbers.data()), m_path, "numbers");
        mesh.nodeNumbers = wide(numbers);
    }
}

void MedFile::readCells(const std::string& mesh, const MedStep& step, int type, std::vector<MedCells>& cells) const {
    const auto number = static_cast<med_int>(step.number), iteration = static_cast<med_int>(step.iteration);
    const med_data_type data = isFixed(type) ? MED_CONNECTIVITY : MED_INDEX_NODE;
    const med_int found = counted(countOf(m_file, mesh, step, MED_CELL, type, data), m_path, "cells");
    if (found == 0) {
        return;
    }
    const std::size_t width = isFixed(type) ? static_cast<std::size_t>(type % 100) : 1;
    MedCells block;
    block.type = type;
    block.count = bounded(found, width * sizeof(med_int), "cells");
    if (!isFixed(type)) {
        block.count -= type == MED_POLYGON ? 1 : 0;  // an index has one entry more than there are cells
        cells.push_back(std::move(block));
        return;
    }
    std::vector<med_int> nodes(block.count * width), list(block.count);
    if (MEDmeshElementConnectivityRd(m_file, mesh.c_str(), number, iteration, MED_CELL, type, MED_NODAL, MED_FULL_INTERLACE,
                                     nodes.data()) < 0) {
        failMed(m_path, "nodes of cells of type " + std::to_string(type));
    }
    block.nodes = wide(nodes);
    if (counted(countOf(m_file, mesh, step, MED_CELL, type, MED_NUMBER), m_path, "numbers") == found) {
        counted(MEDmeshEntityNumberRd(m_file, mesh.c_str(), number, iteration, MED_CELL, type, list.data()), m_path, "numbers");
        block.numbers = wide(list);
    }
    if (counted(countOf(m_file, mesh, step, MED_CELL, type, MED_FAMILY_NUMBER), m_path, "families") == found) {
        counted(MEDmeshEntityFamilyNumberRd(m_file, mesh.c_str(), number, iteration, MED_CELL, type, list.data()), m_path,
                "families");
        block.families = wide(list);
    }
    cells.push_back(std::move(block));
}

void MedFile::readFamilies(MedMesh& mesh) const {
    const med_int families = counted(MEDnFamily(m_file, mesh.name.c_str()), m_path, "families");
    for (int f = 1; f <= families; ++f) {
        const std::size_t groups =
            bounded(counted(MEDnFamilyGroup(m_file, mesh.name.c_str(), f), m_path, "groups"), MED_LNAME_SIZE, "groups");
        std::vector<char> name = textBuffer(MED_NAME_SIZE), list = textBuffer(groups * MED_LNAME_SIZE);
        med_int number = 0;
        if (MEDfamilyInfo(m_file, mesh.name.c_str(), f, name.data(), &number, list.data()) < 0) {
            failMed(m_path, "family " + std::to_string(f));
        }
        std::vector<std::string>& names = mesh.groups[number];
        for (std::size_t g = 0; g < groups; ++g) {
            names.push_back(nameIn(list.data() + g * MED_LNAME_SIZE, MED_LNAME_SIZE));
        }
    }
}

std::vector<MedField> MedFile::fields() const {
    const std::scoped_lock lock(nativeLibraries());
    std::vector<MedField> fields;
    const med_int count = counted(MEDnField(m_file), m_path, "its fields");
    for (int f = 1; f <= count; ++f) {
        const std::size_t components =
            bounded(counted(MEDfieldnComponent(m_file, f), m_path, "components"), MED_SNAME_SIZE, "components of fields");
        std::vector<char> name = textBuffer(MED_NAME_SIZE), mesh = name, unit = textBuffer(MED_SNAME_SIZE);
        std::vector<char> names = textBuffer(components * MED_SNAME_SIZE), units = names;
        med_bool local = MED_TRUE;
        med_field_type type = MED_FLOAT64;
        med_int steps = 0;
        if (MEDfieldInfo(m_file, f, name.data(), mesh.data(), &local, &type, names.data(), units.data(), unit.data(), &steps) < 0) {
            failMed(m_path, "field " + std::to_string(f));
        }
        MedField& field = fields.emplace_back();
        field.name.assign(name.data(), strnlen(name.data(), MED_NAME_SIZE));
        field.mesh.assign(mesh.data(), strnlen(mesh.data(), MED_NAME_SIZE));
        for (std::size_t c = 0; c < components; ++c) {
            field.components.push_back(nameIn(names.data() + c * MED_SNAME_SIZE, MED_SNAME_SIZE));
        }
        for (int s = 1; s <= steps; ++s) {
            med_int number = 0, iteration = 0;
            med_float time = 0.0;
            if (MEDfieldComputingStepInfo(m_file, field.name.c_str(), s, &number, &iteration, &time) < 0) {
                failMed(m_path, "step " + std::to_string(s) + " of " + shownName(field.name));
            }
            field.steps.push_back({number, iteration, time});
        }
    }
    return fields;
}

std::vector<MedValues> MedFile::values(const MedField& field, const MedStep& step, MedPlace place, bool numbers) const {
    const std::scoped_lock lock(nativeLibraries());
    std::vector<MedValues> list;
    const auto number = static_cast<med_int>(step.number), iteration = static_cast<med_int>(step.iteration);
    const auto read = [&](int type) {
        std::vector<char> profile = textBuffer(MED_NAME_SIZE), points = profile;
        const med_int profiles =
            MEDfieldnProfile(m_file, field.name.c_str(), number, iteration, entityOf(place), type, profile.data(), points.data());
        counted(profiles, m_path, "profiles of " + shownName(field.name));
        for (int p = 1; p <= profiles; ++p) {
            list.push_back(readValues(field, step, place, type, p, numbers));
        }
    };
    if (place == MedPlace::Nodes) {
        read(MED_NONE);
    } else {
        for (const int type : m_types.empty() ? std::vector<int>(cellTypes.begin(), cellTypes.end()) : m_types) {
            read(type);
        }
    }
    return list;
}

MedValues MedFile::readValues(const MedField& field, const MedStep& step, MedPlace place, int type, int profile,
                              bool numbers) const {
    const auto number = static_cast<med_int>(step.number), iteration = static_cast<med_int>(step.iteration);
    std::vector<char> name = textBuffer(MED_NAME_SIZE), where = name;
    med_int size = 0, points = 0;
    const med_int count = MEDfieldnValueWithProfile(m_file, field.name.c_str(), number, iteration, entityOf(place), type, profile,
                                                    MED_COMPACT_STMODE, name.data(), &size, where.data(), &points);
    const std::size_t components = std::max<std::size_t>(field.components.size(), 1);
    MedValues values;
    values.type = type;
    values.points = bounded(std::max<med_int>(points, 1), components, "points of " + shownName(field.name));
    values.count = bounded(count, values.points * components, "values of " + shownName(field.name));
    if (name[0] != '\0') {
        const std::size_t listed = bounded(MEDprofileSizeByName(m_file, name.data()), 1, "a profile");
        std::vector<med_int> entities(listed);
        if (listed != values.count || (listed > 0 && MEDprofileRd(m_file, name.data(), entities.data()) < 0)) {
            failMed(m_path, "a profile of " + shownName(field.name));
        }
        values.entities = wide(entities);
    }
    if (numbers && values.count > 0) {
        const std::size_t total = values.count * values.points * components;
        std::vector<unsigned char> bytes(total * sizeof(double));
        if (MEDfieldValueWithProfileRd(m_file, field.name.c_str(), number, iteration, entityOf(place), type, MED_COMPACT_STMODE,
                                       name.data(), MED_FULL_INTERLACE, MED_ALL_CONSTITUENT, bytes.data()) < 0) {
            failMed(m_path, "values of " + shownName(field.name));
        }
        values.values = realsOf(bytes, total, typeOf(m_file, field.name));
    }
    return values;
}

}  // namespace rubble::io
