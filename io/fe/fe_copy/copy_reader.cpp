#include "io/fe/fe_copy/copy_reader.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "io/fe/fe_copy/copy_layout.h"
#include "io/fe/fe_copy/copy_seal.h"
#include "io/fe/fe_copy/state_chunks.h"
#include "io/fe/mesh_builder.h"
#include "io/fe/vtk/hdf5_table.h"

namespace rubble::io {

namespace {

[[noreturn]] void failDamaged(const std::string& path, const std::string& why) {
    throw ParseError({"fe_copy.damaged", "{0} is damaged: {1}", {path, why}},
                     {"fe_copy.damaged.remedy", "Make the copy again from the result itself: rubble-cli convert.", {}});
}

void requireVersion(const Hdf5Table& file) {
    const std::int64_t version = file.number("/", "version").value_or(0);
    if (version < 1 || version > copyVersion) {
        throw ParseError({"fe_copy.version",
                          "{0} is a copy of version {1}; this program reads up to version {2}",
                          {file.path(), version, copyVersion}},
                         {"fe_copy.version.remedy", "Use a newer version of Rubble, or make the copy again.", {}});
    }
}

std::vector<Vec3> vectorsOf(const std::vector<double>& flat) {
    std::vector<Vec3> vectors(flat.size() / 3);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        vectors[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
    }
    return vectors;
}

// A state has the place of its positions and, behind it, that of its velocities.
constexpr std::size_t numbersOfPlace = 3;
constexpr std::size_t chunkNumbers(bool hasVelocity) {
    return hasVelocity ? 2 * numbersOfPlace : numbersOfPlace;
}

/// The tables of a copy, read in the order of its seal.
class CopyTables {
public:
    explicit CopyTables(const Hdf5Table& file) : m_file(file) {}

    FeCopy read() {
        requireVersion(m_file);
        readMesh();
        m_contents.times = reals(copy_table::times);
        readActivity();
        readAbout();
        m_chunks = integers(copy_table::chunks);
        m_digests = integers(copy_table::digests);
        requireSeal();
        check();
        return {std::move(m_contents), std::move(m_about)};
    }

    std::vector<std::int64_t> takeChunks() { return std::move(m_chunks); }
    std::vector<std::int64_t> takeDigests() { return std::move(m_digests); }

private:
    std::vector<double> reals(const char* name) {
        std::vector<double> values = m_file.reals(name, 0, m_file.shape(name).rows);
        m_seal.add(values);
        return values;
    }
    std::vector<std::int64_t> integers(const char* name) {
        std::vector<std::int64_t> values = m_file.integers(name, 0, m_file.shape(name).rows);
        m_seal.add(values);
        return values;
    }

    std::vector<std::uint32_t> indices(const char* name) {
        std::vector<std::uint32_t> result;
        for (const std::int64_t value : integers(name)) {
            if (value < 0 || value > std::numeric_limits<std::uint32_t>::max()) {
                failDamaged(m_file.path(), std::string(name) + " holds " + std::to_string(value));
            }
            result.push_back(static_cast<std::uint32_t>(value));
        }
        return result;
    }

    void readMesh() {
        Mesh mesh;
        mesh.nodeIds = integers(copy_table::nodeIds);
        mesh.nodes = vectorsOf(reals(copy_table::nodes));
        mesh.elementIds = integers(copy_table::elementIds);
        mesh.offsets.push_back(0);
        for (const std::int64_t kind : integers(copy_table::shapes)) {
            if (kind < 0 || kind > static_cast<std::int64_t>(ElementShape::Beam)) {
                failDamaged(m_file.path(), "an element has the shape " + std::to_string(kind));
            }
            mesh.shapes.push_back(static_cast<ElementShape>(kind));
            mesh.offsets.push_back(mesh.offsets.back() + static_cast<std::uint32_t>(cornerCount(mesh.shapes.back())));
        }
        mesh.part = indices(copy_table::part);
        mesh.corners = indices(copy_table::corners);
        mesh.density = reals(copy_table::density);
        mesh.section = reals(copy_table::section);
        if (m_file.has(copy_table::deathTime)) {
            m_contents.deathTime = reals(copy_table::deathTime);
        }
        m_mesh = std::move(mesh);
    }

    void readActivity() {
        const std::size_t elements = m_mesh.elementCount(), words = activityWords(elements);
        const std::vector<std::int64_t> bits = integers(copy_table::activity);
        if (elements == 0 || m_contents.times.empty() || bits.size() != m_contents.times.size() * words) {
            failDamaged(m_file.path(), "its activity does not go with its states and elements");
        }
        m_contents.activity = Activity(m_contents.times.size(), elements);
        for (std::size_t k = 0; k < m_contents.times.size(); ++k) {
            for (std::size_t e = 0; e < elements; ++e) {
                if ((bits[k * words + e / activityBits] >> (e % activityBits)) & 1) {
                    m_contents.activity.set(k, idAt<ElementIndex>(e), true);
                }
            }
        }
    }

    void readAbout() {
        std::string text;
        for (const std::int64_t letter : integers(copy_table::about)) {
            text += static_cast<char>(letter);
        }
        m_about = aboutFromText(text, m_file.path());
        m_mesh.parts = m_about.parts;
        m_contents.hasVelocity = m_about.hasVelocity;
        m_contents.activityFrom = m_about.activityFrom;
        m_contents.findings = m_about.findings;
    }

    void requireSeal() {
        const Digest expected = m_seal.finish();
        const std::vector<std::int64_t> found = m_file.integers(copy_table::seal, 0, m_file.shape(copy_table::seal).rows);
        if (!std::equal(found.begin(), found.end(), expected.bytes.begin(), expected.bytes.end())) {
            failDamaged(m_file.path(), "its tables are not those that it was sealed with");
        }
    }

    // The seal keeps out damage, not a writer that is wrong.
    void check() {
        const Mesh& mesh = m_mesh;
        const std::size_t nodes = mesh.nodeCount(), elements = mesh.elementCount();
        const auto inside = [](const std::vector<std::uint32_t>& indices, std::size_t size) {
            return std::all_of(indices.begin(), indices.end(), [size](std::uint32_t index) { return index < size; });
        };
        const bool lengths = mesh.nodeIds.size() == nodes && mesh.elementIds.size() == elements && mesh.part.size() == elements &&
                             mesh.density.size() == elements && mesh.section.size() == elements &&
                             mesh.corners.size() == mesh.offsets.back() &&
                             (m_contents.deathTime.empty() || m_contents.deathTime.size() == elements) &&
                             m_chunks.size() == m_contents.times.size() * chunkNumbers(m_contents.hasVelocity) &&
                             m_digests.size() == m_contents.times.size() * sizeof(Digest::bytes);
        if (!lengths || !inside(mesh.corners, nodes) || !inside(mesh.part, mesh.parts.size()) ||
            !std::all_of(mesh.nodes.begin(), mesh.nodes.end(), usablePlace)) {
            failDamaged(m_file.path(), "its tables do not go together");
        }
        m_contents.mesh = std::make_shared<const Mesh>(std::move(m_mesh));
    }

    const Hdf5Table& m_file;
    FeResult::Contents m_contents;
    CopySeal m_seal;
    Mesh m_mesh;
    CopyAbout m_about;
    std::vector<std::int64_t> m_chunks;
    std::vector<std::int64_t> m_digests;
};

/// States of a copy, each held against its digest.
class CopySource : public StateSource {
public:
    CopySource(std::string path, const FeResult::Contents& contents, std::vector<std::int64_t> chunks,
               std::vector<std::int64_t> digests)
        : m_path(std::move(path)),
          m_file(m_path),
          m_times(contents.times),
          m_nodes(contents.mesh->nodeCount()),
          m_hasVelocity(contents.hasVelocity),
          m_chunks(std::move(chunks)),
          m_digests(std::move(digests)) {}

    FeState read(std::size_t k) const override {
        FeState state;
        state.time = m_times[k];
        const std::size_t first = k * chunkNumbers(m_hasVelocity);
        state.positions = vectors(first, k);
        if (m_hasVelocity) {
            state.velocities = vectors(first + numbersOfPlace, k);
        }
        const Digest digest = digestOfState(state);
        const auto expected = m_digests.begin() + static_cast<std::ptrdiff_t>(k * digest.bytes.size());
        if (!std::equal(digest.bytes.begin(), digest.bytes.end(), expected) ||
            !std::all_of(state.positions.begin(), state.positions.end(), usablePlace)) {
            fail(k);
        }
        return state;
    }

private:
    [[noreturn]] void fail(std::size_t k) const { failDamaged(m_path, "state " + std::to_string(k) + " is not what was written"); }

    std::vector<Vec3> vectors(std::size_t first, std::size_t k) const {
        auto read = m_file.read({m_chunks[first], m_chunks[first + 1], m_chunks[first + 2]}, m_nodes);
        if (!read) {
            fail(k);
        }
        return std::move(*read);
    }

    const std::string m_path;
    const StateChunks m_file;
    const std::vector<double> m_times;
    const std::size_t m_nodes;
    const bool m_hasVelocity;
    const std::vector<std::int64_t> m_chunks;
    const std::vector<std::int64_t> m_digests;
};

}  // namespace

bool recognisesFeCopy(const FileHead& head) {
    return head.hdf5Format == copyFormatName;
}

FeCopy openFeCopy(const std::string& path) {
    const Hdf5Table file(path, [](const Hdf5Table& look) { CopyTables(look).read(); });
    CopyTables tables(file);
    FeCopy copy = tables.read();
    copy.contents.source = std::make_shared<const CopySource>(path, copy.contents, tables.takeChunks(), tables.takeDigests());
    return copy;
}

FeResult::Contents readFeCopy(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    execution.report({"fe_copy.open", "Reading the copy", {}}, 0.0);
    FeResult::Contents contents = openFeCopy(path).contents;
    ImportSettings others = settings;
    others.units = ImportSettings{}.units;
    others.upAxis = ImportSettings{}.upAxis;
    if (!(others == ImportSettings{})) {
        contents.findings.add({"fe_copy.settled", "The copy has settled which elements are active: import settings do nothing", {}},
                              {"fe_copy.settled.remedy", "Open the result that it was made from to choose other variables.", {}},
                              path);
    }
    contents.declared = FileUnits{};
    execution.report({"fe_copy.open", "Reading the copy", {}}, 1.0);
    return contents;
}

}  // namespace rubble::io
