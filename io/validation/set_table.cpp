#include "io/validation/set_table.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace rubble::io {

namespace {

constexpr std::uintmax_t mostBytes = std::uintmax_t{256} << 20;

/// A table with its heading.
struct HeadedTable {
    std::string path;
    DelimitedTable table;
    std::vector<std::string> names;

    std::size_t indexOf(const std::string& name) const {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            throw ParseError({"validation.no_column", "{0} has no column {1}", {path, name}},
                             {"validation.no_column.remedy", "Correct the heading, or what set.json says of it.", {}});
        }
        return static_cast<std::size_t>(found - names.begin());
    }
};

HeadedTable readHeaded(const std::string& folder, const std::string& name) {
    HeadedTable read{(std::filesystem::path(folder) / name).string(), {}, {}};
    read.table = readDelimitedTable(read.path, mostBytes);
    if (read.table.rows.size() < 2) {
        throw ParseError({"bodies.none", "{0} holds no bodies", {read.path}},
                         {"bodies.none.remedy", "Give a heading and one line for each body.", {}});
    }
    const DelimitedRow heading = read.table.rows.front();
    read.names = heading.fields;
    read.table.rows.erase(read.table.rows.begin());
    for (DelimitedRow& row : read.table.rows) {
        requireNoMoreFields(read.path, heading, row);
        row.fields.resize(read.names.size());
    }
    return read;
}

/// Adds the fields of the rows of another table that have the same text in a column. Columns of both keep their first name; those
/// of the other are known as TABLE.COLUMN.
void join(HeadedTable& left, const HeadedTable& right, const std::string& on, const std::string& prefix) {
    const std::size_t ours = left.indexOf(on), theirs = right.indexOf(on);
    std::map<std::string, const DelimitedRow*> rows;
    for (const DelimitedRow& row : right.table.rows) {
        if (!rows.emplace(row.fields[theirs], &row).second) {
            throw ParseError({"validation.join_twice",
                              "{0}: line {1} has {2} in the column {3}, as a line before",
                              {right.path, row.line, row.fields[theirs], on}},
                             {"validation.join_twice.remedy", "Keep one line for each.", {}});
        }
    }
    for (DelimitedRow& row : left.table.rows) {
        const auto found = rows.find(row.fields[ours]);
        if (found == rows.end()) {
            throw ParseError({"validation.join_none",
                              "{0}: line {1} has {2} in the column {3}, which {4} does not have",
                              {left.path, row.line, row.fields[ours], on, right.path}},
                             {"validation.join_none.remedy", "Add the line there, or take the body out of the table.", {}});
        }
        row.fields.insert(row.fields.end(), found->second->fields.begin(), found->second->fields.end());
    }
    for (const std::string& name : right.names) {
        left.names.push_back(prefix + "." + name);
    }
}

}  // namespace

NamedColumns joinedTable(const JsonCursor& definition, const std::string& folder) {
    HeadedTable table = readHeaded(folder, definition["table"].text());
    if (definition.has("join")) {
        for (const JsonCursor& other : definition["join"].elements()) {
            other.allowOnly({"table", "on"});
            const std::string name = other["table"].text();
            join(table, readHeaded(folder, name), other["on"].text(), std::filesystem::path(name).stem().string());
        }
    }
    NamedColumns columns{table.path, table.table, {}, {}};
    if (!definition.has("columns")) {
        columns.names = table.names;
    } else {
        std::vector<std::size_t> taken;
        for (const auto& [name, own] : definition["columns"].members()) {
            taken.push_back(table.indexOf(own.text()));
            columns.names.push_back(name);
        }
        for (DelimitedRow& row : columns.table.rows) {
            std::vector<std::string> fields;
            for (const std::size_t i : taken) {
                fields.push_back(row.fields[i]);
            }
            row.fields = std::move(fields);
        }
    }
    if (definition.has("constants")) {
        for (const auto& [name, text] : definition["constants"].members()) {
            columns.constants.emplace_back(name, text.text());
        }
    }
    return columns;
}

}  // namespace rubble::io
