#pragma once

#include <string>
#include <vector>

namespace rubble::bench {

/// A table of the page: what stands over its columns, then rows of as many cells.
struct Table {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

/// Commands, as they stand over the table that was made of what they printed.
struct MeasuredTable {
    std::vector<std::string> commands;
    Table table;
};

/// When, where and with what a section was measured.
struct Circumstances {
    std::string date;         ///< UTC, "2026-11-26 04:50"
    std::string machine;      ///< processor, threads, memory
    std::string commit;       ///< short name of the commit, with a note where the tree has changes
    std::string build;        ///< program, sources and flags
    double loadBefore = 0.0;  ///< mean number of waiting processes in the minute before
    double seconds = 0.0;     ///< wall time of all commands, s
};

/// One measurement on the page, under a heading of its own.
struct Section {
    std::string title;
    std::string about;  ///< what the tables say, in a sentence or two; may be empty
    Circumstances circumstances;
    std::vector<MeasuredTable> tables;
};

/// The table in Markdown. A bar in a cell is escaped; a row with fewer cells than the head is filled with empty ones.
std::string tableText(const Table& table);

/// The section in Markdown, from its heading on.
std::string sectionText(const Section& section);

/// The page with these sections in place of those with the same headings. All else stays as it is, but for what stands before the
/// first section, which becomes `opening`. A section that is new follows the last one before it in `titles`, which gives the order.
/// @param page  the page as it was; may be empty
std::string pageWith(const std::string& page, const std::string& opening, const std::vector<Section>& sections,
                     const std::vector<std::string>& titles);

}  // namespace rubble::bench
