#include "io/fe/xdmf/xdmf_item.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "io/base/trimmed.h"
#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace {

constexpr std::uint64_t mostValues = std::uint64_t{1} << 34;

// What no whole number can hold becomes one that no table has entries for.
template <class T>
T converted(double value) {
    if constexpr (std::is_same_v<T, double>) {
        return value;
    } else {
        return std::abs(value) < 9e15 ? static_cast<T>(value) : std::numeric_limits<T>::min();
    }
}

template <class From, class T>
T valueFrom(const char* bytes, bool swap) {
    std::array<char, sizeof(From)> raw{};
    std::copy(bytes, bytes + sizeof(From), raw.begin());
    if (swap) {
        std::reverse(raw.begin(), raw.end());
    }
    if constexpr (std::is_floating_point_v<From>) {
        return converted<T>(std::bit_cast<From>(raw));
    } else {
        return static_cast<T>(std::bit_cast<From>(raw));
    }
}

}  // namespace

void XdmfItems::fail(const std::string& what) const {
    throw ParseError({"xdmf.layout", "{0} cannot be read as XDMF: {1}", {m_path, what}},
                     {"xdmf.layout.remedy", "Write the result as .vtu files with a .pvd, or with its values in HDF5.", {}});
}

pugi::xml_node XdmfItems::resolved(pugi::xml_node node) const {
    pugi::xml_node item = node;
    for (int hops = 0; item && item.attribute("Reference"); ++hops) {
        const std::string reference = item.attribute("Reference").as_string();
        const std::string path = reference == "XML" ? std::string(trimmed(item.child_value())) : reference;
        try {
            item = item.root().select_node(path.c_str()).node();
        } catch (const pugi::xpath_exception&) {
            item = {};
        }
        if (!item || hops > 10) {
            fail("the reference \"" + path.substr(0, 100) + "\" leads nowhere");
        }
    }
    return item;
}

pugi::xml_node XdmfItems::itemOf(pugi::xml_node owner) const {
    return resolved(resolved(owner).child("DataItem"));
}

std::vector<std::uint64_t> XdmfItems::dimensions(pugi::xml_node item) const {
    std::vector<std::uint64_t> list;
    std::istringstream text(item.attribute("Dimensions").as_string());
    std::uint64_t all = 1;
    for (std::string word; text >> word;) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size() || (value != 0 && all > mostValues / value)) {
            fail("the dimensions \"" + std::string(item.attribute("Dimensions").as_string()).substr(0, 60) + "\" make no sense");
        }
        all *= value;
        list.push_back(value);
    }
    return list;
}

std::uint64_t XdmfItems::countOf(pugi::xml_node item) const {
    std::uint64_t count = 1;
    for (const std::uint64_t dimension : dimensions(item)) {
        count *= dimension;
    }
    return count;
}

std::pair<std::string, std::string> XdmfItems::placeOf(pugi::xml_node item) const {
    if (std::string(item.attribute("Format").as_string("XML")) != "HDF") {
        return {};
    }
    const std::string text(trimmed(item.child_value()));
    // The colon of a drive stands behind one letter.
    std::size_t colon = text.rfind(":/");
    if (colon == std::string::npos || colon <= 1) {
        colon = text.rfind(':');
    }
    if (colon == std::string::npos || colon <= 1 || colon + 1 == text.size()) {
        fail("the place \"" + text.substr(0, 100) + "\" is not FILE:/TABLE");
    }
    const std::string table = text.substr(colon + 1);
    return {namedFile(m_path, text.substr(0, colon)), table.starts_with('/') ? table : '/' + table};
}

const Hdf5Table& XdmfItems::file(const std::string& path) const {
    const std::scoped_lock lock(m_mutex);
    std::unique_ptr<const Hdf5Table>& file = m_files[path];
    if (!file) {
        file = std::make_unique<const Hdf5Table>(path);
    }
    return *file;
}

template <class T>
std::vector<T> XdmfItems::fromText(const std::string& text, std::uint64_t count) const {
    std::vector<T> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (values.size() < count) {
        while (at < end && std::string_view(" \t\r\n,").find(*at) != std::string_view::npos) {
            ++at;
        }
        double value = 0.0;
        const auto result = std::from_chars(at, end, value);
        if (result.ec != std::errc{}) {
            fail("a list of " + std::to_string(count) + " numbers ends after " + std::to_string(values.size()));
        }
        values.push_back(converted<T>(value));
        at = result.ptr;
    }
    return values;
}

template <class T>
std::vector<T> XdmfItems::fromBinary(pugi::xml_node item, std::uint64_t count) const {
    const std::string path = namedFile(m_path, std::string(trimmed(item.child_value())));
    const std::string type = item.attribute("NumberType").as_string("Float");
    const auto bytes = static_cast<std::size_t>(item.attribute("Precision").as_int(4));
    const std::uint64_t seek = item.attribute("Seek").as_ullong(0);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || (bytes != 4 && bytes != 8) || seek > size || count > (size - seek) / bytes) {
        fail("the binary file " + path + " does not hold the " + std::to_string(count) + " values that it should");
    }
    const bool big = std::string(item.attribute("Endian").as_string("Native")) == "Big";
    std::ifstream file(path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(seek));
    std::string raw(count * bytes, '\0');
    file.read(raw.data(), static_cast<std::streamsize>(raw.size()));
    std::vector<T> values;
    for (std::uint64_t i = 0; i < count; ++i) {
        const char* at = raw.data() + i * bytes;
        if (type == "Float") {
            values.push_back(bytes == 4 ? valueFrom<float, T>(at, big) : valueFrom<double, T>(at, big));
        } else {
            values.push_back(bytes == 4 ? valueFrom<std::int32_t, T>(at, big) : valueFrom<std::int64_t, T>(at, big));
        }
    }
    return values;
}

template <class T>
std::vector<T> XdmfItems::read(pugi::xml_node item) const {
    const std::string kind = item.attribute("ItemType").as_string("Uniform");
    if (kind != "Uniform") {
        fail("items of type " + kind.substr(0, 40) + " are not read");
    }
    const std::string format = item.attribute("Format").as_string("XML");
    const std::uint64_t count = countOf(item);
    if (format == "HDF") {
        const auto [path, table] = placeOf(item);
        const Hdf5Table& heavy = file(path);
        const std::uint64_t rows = heavy.shape(table).rows;
        std::vector<T> values;
        if constexpr (std::is_same_v<T, double>) {
            values = heavy.reals(table, 0, rows);
        } else {
            values = heavy.integers(table, 0, rows);
        }
        if (values.size() != count) {
            fail("the table " + table + " has " + std::to_string(values.size()) + " values instead of " + std::to_string(count));
        }
        return values;
    }
    if (format == "XML") {
        return fromText<T>(item.child_value(), count);
    }
    if (format == "Binary") {
        return fromBinary<T>(item, count);
    }
    fail("items of format " + format.substr(0, 40) + " are not read");
}

std::vector<double> XdmfItems::reals(pugi::xml_node item) const {
    return read<double>(item);
}

std::vector<std::int64_t> XdmfItems::integers(pugi::xml_node item) const {
    return read<std::int64_t>(item);
}

}  // namespace rubble::io
