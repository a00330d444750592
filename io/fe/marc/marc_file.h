#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/series/byte_window.h"

namespace rubble::io {

/// A list of nodal vectors of an increment and where its numbers begin.
struct MarcVector {
    std::uint64_t offset = 0;
    std::size_t components = 3;
};

/// One increment of a post file.
struct MarcIncrement {
    double time = 0.0;
    std::optional<std::uint64_t> mesh;  ///< where its own mesh begins; nothing: that of the increment before
    std::size_t nodes = 0;
    std::optional<MarcVector> displacement, velocity;
    std::vector<bool> stressed;  ///< [elements of its mesh] some stress is not zero; empty where no stress is written
};

/// A formatted post file of MSC Marc (.t19): index of its increments, and its meshes. Fields of 13 columns, six a line, in blocks
/// between =beg= and =end=. Layout after Marc Volume D, "Post file".
class MarcFile {
public:
    /// Reads through the whole file once. Throws WorldError, ParseError with the byte; an increment that is not whole ends the
    /// file.
    explicit MarcFile(const std::string& path);

    const std::vector<MarcIncrement>& increments() const { return m_increments; }
    /// The mesh that holds for an increment whose own begins at `offset`. Parts are the sets of elements.
    Mesh readMesh(std::uint64_t offset, Findings& findings) const;
    /// Thread-safe.
    std::vector<Vec3> readVectors(const MarcVector& vector, std::size_t nodes) const;
    const Findings& findings() const { return m_findings; }

private:
    /// What holds until a new mesh is written.
    struct Model {
        std::uint64_t offset = 0;
        std::size_t elements = 0, nodes = 0, points = 1, values = 0;
        std::vector<std::int64_t> codes;
    };

    bool wholeIncrement();
    bool readIncrement();
    void readBlock(const std::string& head, std::uint64_t begin, MarcIncrement* increment);
    void readVerification();
    void readCodes();
    void readTimes(MarcIncrement& increment);
    void readStress(MarcIncrement& increment);
    bool readNodal(MarcIncrement& increment);
    void skipToEnd();
    std::size_t count(std::uint64_t value, const char* what) const;
    [[noreturn]] void fail(const std::string& what) const;

    std::string m_path;
    mutable std::mutex m_mutex;
    mutable ByteWindow m_window;
    Model m_model;
    std::vector<MarcIncrement> m_increments;
    Findings m_findings;
};

/// Gives the fields of 13 columns of the lines that follow, one after another.
class MarcFields {
public:
    explicit MarcFields(ByteWindow& window) : m_window(window) {}

    /// The next number. @return false at the end of the block or the file, or where there is none
    bool integer(std::int64_t& value);
    bool real(double& value);
    /// Leaves the rest of the line.
    void newLine() { m_line.clear(); }

private:
    bool field(std::string& text);

    ByteWindow& m_window;
    std::string m_line;
    std::size_t m_at = 0;
};

}  // namespace rubble::io
