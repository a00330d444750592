#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/base/hdf5_handle.h"

namespace rubble::io {

/// An HDF5 file of tables of numbers, open for reading; every member may be called from any thread. Reads throw ParseError naming
/// the file and the table.
class Hdf5Table {
public:
    /// Opens the file, after a look at all its tables in a child process: the packaged HDF5 can crash on a damaged one.
    /// Throws WorldError, ParseError.
    explicit Hdf5Table(const std::string& path);
    /// The same with another look in the child process, for files too large to be looked at whole. @param look  reads from the
    /// table that it is given; what it throws is thrown here
    Hdf5Table(const std::string& path, const std::function<void(const Hdf5Table&)>& look);

    const std::string& path() const { return m_path; }
    /// True if there is a table of numbers of this name.
    bool has(const std::string& name) const;
    /// Rows and values in each; {0, 1} where there is no such table. Throws ParseError for more than the file can hold.
    struct Shape {
        std::uint64_t rows = 0;
        std::uint64_t columns = 1;
    };
    Shape shape(const std::string& name) const;
    /// Whole rows, as they lie there. Throws where the table ends before.
    std::vector<double> reals(const std::string& name, std::uint64_t first, std::uint64_t rows) const;
    std::vector<std::int64_t> integers(const std::string& name, std::uint64_t first, std::uint64_t rows) const;
    /// Names of the tables in a group, sorted; none where there is no such group.
    std::vector<std::string> tablesIn(const std::string& group) const;
    /// Names of the groups in a group, sorted; none where there is no such group.
    std::vector<std::string> groupsIn(const std::string& group) const;
    /// A text attribute of a group or a table; nothing if there is none.
    std::optional<std::string> text(const std::string& group, const std::string& attribute) const;
    /// A whole-number attribute of a group or a table (the first where it is a list); nothing if there is none.
    std::optional<std::int64_t> number(const std::string& group, const std::string& attribute) const;
    /// An attribute of one real number, of a group or a table; nothing if there is none.
    std::optional<double> real(const std::string& group, const std::string& attribute) const;

private:
    template <class T>
    std::vector<T> read(const std::string& name, hid_t type, std::uint64_t first, std::uint64_t rows) const;
    void lookAtAll() const;
    bool hasAttribute(const std::string& group, const std::string& attribute) const;
    struct Attribute;
    /// Nothing if there is none. Throws ParseError where it is damaged.
    std::optional<Attribute> openAttribute(const std::string& group, const std::string& attribute) const;

    std::string m_path;
    std::uint64_t m_bytes = 0;
    Hdf5Handle m_file;
};

}  // namespace rubble::io
