#pragma once

#include <string>

#include "io/fe/bodies/body_table.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// The table of a set as its definition says: `table`, further tables that are joined on a column (`join`), names of columns in
/// place of their own (`columns`), and what stands in every row (`constants`).
/// Throws WorldError, ParseError: a table or column that is not there, a row that has none to be joined with; names file and line.
NamedColumns joinedTable(const JsonCursor& definition, const std::string& folder);

}  // namespace rubble::io
