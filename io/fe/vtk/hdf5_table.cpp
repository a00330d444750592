#include "io/fe/vtk/hdf5_table.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/hdf5_extent.h"
#include "io/base/trial.h"

namespace rubble::io {

namespace {

// Deflate cannot do better: a table that needs more than this per byte of the file is damaged.
constexpr std::uint64_t bestCompression = 1100;
constexpr unsigned mostDimensions = 8;
constexpr int deepestGroup = 6;  // groups in groups
// Values that the child reads to find out whether the library bears them.
constexpr std::uint64_t mostTried = std::uint64_t{1} << 25;

[[noreturn]] void failTable(const std::string& path, const std::string& name, const std::string& why) {
    throw ParseError({"hdf5.table", "{0}: the table {1} cannot be read: {2}", {path, name, why}},
                     {"hdf5.table.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

Hdf5Handle openFile(const std::string& path) {
    const Hdf5Session quiet;
    Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file.valid()) {
        throw ParseError({"hdf5.open", "{0} cannot be opened as HDF5: {1}", {path, hdf5Reason()}},
                         {"hdf5.open.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
    }
    return file;
}

// Every step of a path must be there, else HDF5 calls it an error.
bool exists(hid_t file, const std::string& name) {
    for (std::size_t slash = name.find('/', 1);; slash = name.find('/', slash + 1)) {
        if (H5Lexists(file, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) {
            return false;
        }
        if (slash == std::string::npos) {
            return H5Oexists_by_name(file, name.c_str(), H5P_DEFAULT) > 0;
        }
    }
}

bool holdsNumbers(hid_t table) {
    const Hdf5Handle type(H5Dget_type(table), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type.get());
    return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

Hdf5Handle openTable(hid_t file, const std::string& name) {
    if (!exists(file, name)) {
        return {};
    }
    Hdf5Handle table(H5Oopen(file, name.c_str(), H5P_DEFAULT), H5Oclose);
    const bool right = table.valid() && H5Iget_type(table.get()) == H5I_DATASET && holdsNumbers(table.get());
    return right ? std::move(table) : Hdf5Handle();
}

std::vector<hsize_t> extentOf(hid_t table) {
    const Hdf5Handle space(H5Dget_space(table), H5Sclose);
    const int rank = space.valid() ? H5Sget_simple_extent_ndims(space.get()) : -1;
    if (rank < 0 || rank > static_cast<int>(mostDimensions)) {
        return {};
    }
    std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
    return extent.empty() ? std::vector<hsize_t>{1} : extent;
}

std::vector<std::string> namesIn(hid_t file, const std::string& group) {
    std::vector<std::string> names;
    if (!exists(file, group)) {
        return names;
    }
    const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        auto& found = *static_cast<std::vector<std::string>*>(list);
        found.emplace_back(name);
        return found.size() > 100'000 ? 1 : 0;
    };
    hsize_t at = 0;
    H5Literate_by_name(file, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, &at, collect, &names, H5P_DEFAULT);
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

Hdf5Table::Hdf5Table(const std::string& path) : Hdf5Table(path, [](const Hdf5Table& table) { table.lookAtAll(); }) {}

Hdf5Table::Hdf5Table(const std::string& path, const std::function<void(const Hdf5Table&)>& lookAt) : m_path(path) {
    std::error_code error;
    m_bytes = std::filesystem::file_size(path, error);
    if (error) {
        failToRead(path);
    }
    requireWholeHdf5(path);
    {
        const std::scoped_lock lock(nativeLibraries());
        // Files that this process has open are open in the child too.
        const auto look = [&] {
            const ssize_t before = H5Fget_obj_count(static_cast<hid_t>(H5F_OBJ_ALL), H5F_OBJ_ALL);
            m_file = openFile(m_path);
            lookAt(*this);
            m_file.reset();
            // What the library leaves open where it fails would stay open in this process.
            if (H5Fget_obj_count(static_cast<hid_t>(H5F_OBJ_ALL), H5F_OBJ_ALL) > before) {
                failTable(m_path, "(some)", "the library fails on it");
            }
        };
        if (!survivesTrial(look)) {
            throw ParseError({"hdf5.crash", "{0} is damaged so that the HDF5 library fails on it", {path}},
                             {"hdf5.open.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
        }
    }
    m_file = openFile(path);
}

// Every table as far as the budget goes, then the first row of each; as deep as the readers look.
void Hdf5Table::lookAtAll() const {
    std::uint64_t budget = mostTried;
    std::vector<std::pair<std::string, int>> open{{"/", 0}};
    while (!open.empty()) {
        const auto [group, depth] = open.back();
        open.pop_back();
        text(group, "Type");
        number(group, "Version");
        number(group, "NSteps");
        for (const std::string& name : namesIn(m_file.get(), group)) {
            const std::string full = (group == "/" ? "" : group) + "/" + name;
            if (has(full)) {
                real(full, "TIME");
                number(full, "STEP");
                number(full, "GEOMETRY");
                const Shape size = shape(full);
                const std::uint64_t values = size.rows * size.columns;
                const bool whole = values <= budget;
                budget -= whole ? values : 0;
                reals(full, 0, whole ? size.rows : std::min<std::uint64_t>(size.rows, 1));
            } else if (depth < deepestGroup) {
                open.emplace_back(full, depth + 1);
            }
        }
    }
}

bool Hdf5Table::has(const std::string& name) const {
    const Hdf5Session quiet;
    return openTable(m_file.get(), name).valid();
}

Hdf5Table::Shape Hdf5Table::shape(const std::string& name) const {
    const Hdf5Session quiet;
    const Hdf5Handle table = openTable(m_file.get(), name);
    if (!table.valid()) {
        return {};
    }
    const std::vector<hsize_t> extent = extentOf(table.get());
    if (extent.empty()) {
        failTable(m_path, name, "it has no shape");
    }
    const std::uint64_t most = m_bytes * bestCompression;
    Shape shape{extent[0], 1};
    for (std::size_t d = 1; d < extent.size(); ++d) {
        if (extent[d] != 0 && shape.columns > most / extent[d]) {
            failTable(m_path, name, "its rows are longer than the file");
        }
        shape.columns *= extent[d];
    }
    if (shape.columns != 0 && shape.rows > most / shape.columns) {
        failTable(m_path, name,
                  "it has " + englishInteger(static_cast<std::int64_t>(std::min<std::uint64_t>(shape.rows, INT64_MAX))) +
                      " rows, more than the file can hold");
    }
    return shape;
}

template <class T>
std::vector<T> Hdf5Table::read(const std::string& name, hid_t type, std::uint64_t first, std::uint64_t rows) const {
    const Shape whole = shape(name);
    const Hdf5Session quiet;
    const Hdf5Handle table = openTable(m_file.get(), name);
    if (!table.valid()) {
        failTable(m_path, name, "it is not there");
    }
    if (first > whole.rows || rows > whole.rows - first) {
        failTable(m_path, name,
                  "rows " + std::to_string(first) + " to " + std::to_string(first + rows) + " were asked for, but there are " +
                      std::to_string(whole.rows));
    }
    std::vector<T> values(rows * whole.columns);
    if (values.empty()) {
        return values;
    }
    std::vector<hsize_t> start = extentOf(table.get()), count = start;
    std::fill(start.begin(), start.end(), 0);
    const Hdf5Handle space(H5Dget_space(table.get()), H5Sclose);
    if (H5Sget_simple_extent_ndims(space.get()) > 0) {
        start[0] = first;
        count[0] = rows;
        H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    }
    const hsize_t length = values.size();
    const Hdf5Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
    if (H5Dread(table.get(), type, memory.get(), space.get(), H5P_DEFAULT, values.data()) < 0) {
        failTable(m_path, name, hdf5Reason());
    }
    return values;
}

std::vector<double> Hdf5Table::reals(const std::string& name, std::uint64_t first, std::uint64_t rows) const {
    return read<double>(name, H5T_NATIVE_DOUBLE, first, rows);
}

std::vector<std::int64_t> Hdf5Table::integers(const std::string& name, std::uint64_t first, std::uint64_t rows) const {
    return read<std::int64_t>(name, H5T_NATIVE_INT64, first, rows);
}

std::vector<std::string> Hdf5Table::tablesIn(const std::string& group) const {
    const Hdf5Session quiet;
    std::vector<std::string> names = namesIn(m_file.get(), group);
    std::erase_if(names, [&](const std::string& name) { return !has(group + "/" + name); });
    return names;
}

std::vector<std::string> Hdf5Table::groupsIn(const std::string& group) const {
    const Hdf5Session quiet;
    std::vector<std::string> names = namesIn(m_file.get(), group);
    std::erase_if(names, [&](const std::string& name) {
        const Hdf5Handle object(H5Oopen(m_file.get(), ((group == "/" ? "" : group) + "/" + name).c_str(), H5P_DEFAULT), H5Oclose);
        return !object.valid() || H5Iget_type(object.get()) != H5I_GROUP;
    });
    return names;
}

bool Hdf5Table::hasAttribute(const std::string& group, const std::string& attribute) const {
    if (!exists(m_file.get(), group)) {
        return false;
    }
    const htri_t there = H5Aexists_by_name(m_file.get(), group.c_str(), attribute.c_str(), H5P_DEFAULT);
    if (there < 0) {
        failTable(m_path, group + ":" + attribute, "it is damaged");
    }
    return there > 0;
}

struct Hdf5Table::Attribute {
    Hdf5Handle handle;
    Hdf5Handle type;
    hssize_t count = 0;  ///< of values
};

std::optional<Hdf5Table::Attribute> Hdf5Table::openAttribute(const std::string& group, const std::string& attribute) const {
    if (!hasAttribute(group, attribute)) {
        return std::nullopt;
    }
    Attribute found;
    found.handle = {H5Aopen_by_name(m_file.get(), group.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
    found.type = {found.handle.valid() ? H5Aget_type(found.handle.get()) : H5I_INVALID_HID, H5Tclose};
    const Hdf5Handle space(found.handle.valid() ? H5Aget_space(found.handle.get()) : H5I_INVALID_HID, H5Sclose);
    if (!found.type.valid() || !space.valid()) {
        failTable(m_path, group + ":" + attribute, "it is damaged");
    }
    found.count = H5Sget_simple_extent_npoints(space.get());
    return found;
}

std::optional<std::string> Hdf5Table::text(const std::string& group, const std::string& attribute) const {
    const Hdf5Session quiet;
    const std::optional<Attribute> found = openAttribute(group, attribute);
    if (!found || H5Tget_class(found->type.get()) != H5T_STRING || found->count != 1) {
        return std::nullopt;
    }
    if (H5Tis_variable_str(found->type.get()) > 0) {
        char* value = nullptr;
        const bool read = H5Aread(found->handle.get(), found->type.get(), static_cast<void*>(&value)) >= 0 && value;
        std::string result = read ? value : "";
        if (value) {
            H5free_memory(value);
        }
        return result;
    }
    const std::size_t size = H5Tget_size(found->type.get());
    if (size == 0 || size > 4096) {
        return std::nullopt;
    }
    std::string value(size, '\0');
    if (H5Aread(found->handle.get(), found->type.get(), value.data()) < 0) {
        return std::nullopt;
    }
    value.resize(std::min(value.find('\0'), value.size()));
    return value;
}

std::optional<std::int64_t> Hdf5Table::number(const std::string& group, const std::string& attribute) const {
    const Hdf5Session quiet;
    const std::optional<Attribute> found = openAttribute(group, attribute);
    if (!found || H5Tget_class(found->type.get()) != H5T_INTEGER || found->count < 1 || found->count > 64) {
        return std::nullopt;
    }
    std::array<std::int64_t, 64> values{};
    return H5Aread(found->handle.get(), H5T_NATIVE_INT64, values.data()) < 0 ? std::nullopt : std::optional(values[0]);
}

std::optional<double> Hdf5Table::real(const std::string& group, const std::string& attribute) const {
    const Hdf5Session quiet;
    const std::optional<Attribute> found = openAttribute(group, attribute);
    const H5T_class_t kind = found ? H5Tget_class(found->type.get()) : H5T_NO_CLASS;
    if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || found->count != 1) {
        return std::nullopt;
    }
    double value = 0.0;
    return H5Aread(found->handle.get(), H5T_NATIVE_DOUBLE, &value) < 0 ? std::nullopt : std::optional(value);
}

}  // namespace rubble::io
