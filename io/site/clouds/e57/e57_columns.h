#pragma once

#include <cstdint>
#include <vector>

#include "io/site/clouds/e57/e57_head.h"

namespace rubble::io {

/// The values of one column of an E57 as its bits come in.
class E57Column {
public:
    /// @param kept  its values are wanted; else they are counted only. Those of texts are not
    E57Column(const E57Field& field, bool kept) : m_field(field), m_kept(kept && field.kind != E57Field::Kind::Text) {}

    void add(const unsigned char* bytes, std::size_t count);
    /// Whole values that have come and were not taken.
    std::uint64_t ready() const;
    std::size_t buffered() const { return m_bytes.size(); }
    /// Takes values that are ready; of a column that is not kept it passes over them.
    void take(std::size_t count, std::vector<double>& values);

private:
    std::uint64_t bitsAt(std::uint64_t bit) const;

    E57Field m_field;
    bool m_kept;
    std::vector<unsigned char> m_bytes;
    std::uint64_t m_counted = 0;  ///< bytes of a column that is not kept
    std::uint64_t m_bit = 0;      ///< of the next value
};

/// All columns of the points of a scan, packet by packet.
class E57Columns {
public:
    /// Throws ParseError: there is no section of points.
    /// @param kept  of each column: its values are wanted
    E57Columns(E57Pages& pages, const E57Points& points, const std::vector<bool>& kept);

    std::size_t count() const { return m_columns.size(); }
    E57Column& column(std::size_t i) { return m_columns[i]; }
    /// Reads packets until so many values of every column are ready. @return how many are, fewer at the end of the section
    std::uint64_t fill(std::uint64_t wanted);

private:
    std::uint64_t ready() const;
    void readPacket();
    void takeData(const std::vector<unsigned char>& packet);

    E57Pages& m_pages;
    std::vector<E57Column> m_columns;
    std::uint64_t m_at = 0;
    std::uint64_t m_end = 0;
};

}  // namespace rubble::io
