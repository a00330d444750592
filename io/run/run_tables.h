#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "io/run/run_members.h"

namespace rubble::io {

/// Rows of numbers: how a run file keeps lists of structures. Every member becomes one or more columns of doubles, which hold all
/// 32-bit ids exactly.
namespace table {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Appends the numbers of one structure.
struct Packer {
    std::vector<double>& out;

    template <class T>
    void operator()(const char*, const T& member) {
        if constexpr (Plain<T>) {
            out.push_back(static_cast<double>(member));
        } else if constexpr (std::is_same_v<T, Quat>) {
            out.insert(out.end(), member.coeffs().data(), member.coeffs().data() + 4);
        } else if constexpr (std::is_same_v<T, Vec3> || std::is_same_v<T, Mat3>) {
            out.insert(out.end(), member.data(), member.data() + member.size());
        } else {
            Members<T>::each(*this, member);
        }
    }
};

/// Takes the numbers of one structure, in the same order.
struct Unpacker {
    const double* in;

    template <class T>
    void operator()(const char*, T& member) {
        if constexpr (Plain<T>) {
            member = number<T>(*in++);
        } else if constexpr (std::is_same_v<T, Quat>) {
            take(member.coeffs().data(), 4);
        } else if constexpr (std::is_same_v<T, Vec3> || std::is_same_v<T, Mat3>) {
            take(member.data(), static_cast<std::size_t>(member.size()));
        } else {
            Members<T>::each(*this, member);
        }
    }

private:
    /// A damaged file may hold anything; what no id can be becomes the largest id, which every check of ranges refuses.
    template <class T>
    static T number(double stored) {
        if constexpr (std::is_floating_point_v<T>) {
            return stored;
        } else {
            const bool whole = stored >= 0.0 && stored <= 4294967295.0;
            return static_cast<T>(whole ? static_cast<std::uint32_t>(stored) : 0xFFFFFFFFu);
        }
    }
    void take(double* to, std::size_t count) {
        std::copy(in, in + count, to);
        in += count;
    }
};

/// Collects the names of the columns: "box.centre.x".
struct Namer {
    std::vector<std::string> names;
    std::string prefix;

    template <class T>
    void operator()(const char* name, const T& member) {
        const std::string path = prefix + name;
        if constexpr (Plain<T>) {
            names.push_back(path);
        } else if constexpr (std::is_same_v<T, Quat>) {
            number(path, {"x", "y", "z", "w"});
        } else if constexpr (std::is_same_v<T, Vec3>) {
            number(path, {"x", "y", "z"});
        } else if constexpr (std::is_same_v<T, Mat3>) {
            number(path, {"xx", "yx", "zx", "xy", "yy", "zy", "xz", "yz", "zz"});
        } else {
            Namer inner{{}, path + "."};
            Members<T>::each(inner, member);
            names.insert(names.end(), inner.names.begin(), inner.names.end());
        }
    }

private:
    void number(const std::string& path, std::initializer_list<const char*> parts) {
        for (const char* part : parts) {
            names.push_back(path + "." + part);
        }
    }
};

}  // namespace table

/// Names of the columns of a table of T.
template <class T>
std::vector<std::string> columnNames() {
    const T example{};
    table::Namer namer{{}, {}};
    Members<T>::each(namer, example);
    return namer.names;
}

/// Number of columns of a table of T.
template <class T>
std::size_t columnCount() {
    static const std::size_t count = columnNames<T>().size();
    return count;
}

/// Rows of a table, one after the other [rows * columnCount<T>()].
template <class T>
std::vector<double> packRows(std::span<const T> rows) {
    std::vector<double> numbers;
    numbers.reserve(rows.size() * columnCount<T>());
    table::Packer packer{numbers};
    for (const T& row : rows) {
        Members<T>::each(packer, row);
    }
    return numbers;
}

/// The structures behind the rows of a table.
template <class T>
std::vector<T> unpackRows(std::span<const double> numbers) {
    std::vector<T> rows(numbers.size() / columnCount<T>());
    table::Unpacker unpacker{numbers.data()};
    for (T& row : rows) {
        Members<T>::each(unpacker, row);
    }
    return rows;
}

}  // namespace rubble::io
