#include "io/fe/fe_copy/copy_writer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/hdf5_handle.h"
#include "io/base/run_driver.h"
#include "io/base/single_precision.h"
#include "io/fe/fe_copy/copy_about.h"
#include "io/fe/fe_copy/copy_layout.h"
#include "io/fe/fe_copy/copy_seal.h"
#include "io/fe/fe_copy/state_chunks.h"

namespace rubble::io {

namespace {

constexpr unsigned compression = 1;
constexpr hsize_t longestChunk = hsize_t{1} << 20;  // rows

/// A dataset to be written: its rows as they lie in memory.
struct Table {
    const void* rows = nullptr;
    hsize_t count = 0;
    hsize_t width = 1;
    hid_t memory = H5I_INVALID_HID;
    hid_t file = H5I_INVALID_HID;
};

/// One copy being written. States are read without the lock of the libraries.
class CopyWriter {
public:
    CopyWriter(const std::string& path, const FeResult& fe, const Vec3& offset)
        : m_path(path), m_fe(fe), m_mesh(fe.mesh()), m_offset(offset) {
        const Hdf5Session session;
        const Hdf5Handle access = runFileAccess();
        m_file = Hdf5Handle(H5Fcreate(path.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, access.get()), H5Fclose);
        if (!m_file.valid()) {
            fail(runDriverOpenError());
        }
        for (const char* name : {"/mesh", "/positions", "/velocities"}) {
            const Hdf5Handle group(H5Gcreate2(m_file.get(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
        }
        putAttribute();
    }

    void write(const Execution& execution) {
        const Message stage{"convert.state", "Writing the states", {}};
        const std::size_t states = m_fe.stateCount();
        for (std::size_t k = 0; k < states; ++k) {
            execution.report(stage, static_cast<double>(k) / static_cast<double>(states));
            writeState(k, m_fe.contents().source->read(k));
        }
        writeTables();
        {
            const Hdf5Session session;
            H5Fflush(m_file.get(), H5F_SCOPE_GLOBAL);
            requireWritten();
        }
        if (!m_file.reset()) {
            fail(EIO);
        }
        execution.report(stage, 1.0);
    }

private:
    [[noreturn]] void fail(int error) const {
        throw WorldError({"convert.write", "Cannot write {0}: {1}", {m_path, systemReason(error)}},
                         {"convert.write.remedy", "Check free space and rights of the folder, or choose another place.", {}});
    }
    void requireWritten() const {
        if (const int error = runDriverError(m_file.get())) {
            fail(error);
        }
    }

    void putAttribute() {
        const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(text.get(), std::strlen(copyFormatName) + 1);
        const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
        const Hdf5Handle format(H5Acreate2(m_file.get(), "format", text.get(), scalar.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
        H5Awrite(format.get(), text.get(), copyFormatName);
        const Hdf5Handle version(H5Acreate2(m_file.get(), "version", H5T_STD_I32LE, scalar.get(), H5P_DEFAULT, H5P_DEFAULT),
                                 H5Aclose);
        H5Awrite(version.get(), H5T_NATIVE_INT, &copyVersion);
    }

    void put(const std::string& name, const Table& table) { put(name, table, longestChunk); }

    ChunkPlace put(const std::string& name, const Table& table, hsize_t chunkRows) {
        const Hdf5Session session;
        const std::array<hsize_t, 2> extent{table.count, table.width};
        const std::array<hsize_t, 2> chunk{std::clamp<hsize_t>(table.count, 1, chunkRows), table.width};
        const int rank = table.width > 1 ? 2 : 1;
        const Hdf5Handle space(H5Screate_simple(rank, extent.data(), nullptr), H5Sclose);
        const Hdf5Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_chunk(how.get(), rank, chunk.data());
        H5Pset_shuffle(how.get());
        H5Pset_deflate(how.get(), compression);
        H5Pset_fill_time(how.get(), H5D_FILL_TIME_NEVER);
        const Hdf5Handle set(H5Dcreate2(m_file.get(), name.c_str(), table.file, space.get(), H5P_DEFAULT, how.get(), H5P_DEFAULT),
                             H5Dclose);
        const bool written =
            set.valid() && (table.count == 0 || H5Dwrite(set.get(), table.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.rows) >= 0);
        requireWritten();
        if (!written) {
            throw WorldError({"convert.write", "Cannot write {0}: {1}", {m_path, hdf5Reason()}},
                             {"convert.write.remedy", "Check free space and rights of the folder, or choose another place.", {}});
        }
        return table.count > 0 ? placeOf(set.get()) : ChunkPlace{};
    }

    Table vectors(const std::vector<Vec3>& values) const {
        const hid_t kept = fitsSinglePrecision(values) ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
        return {values.data(), values.size(), 3, H5T_NATIVE_DOUBLE, kept};
    }

    // All of a state in one chunk, whose place is noted.
    void putState(const char* what, std::size_t k, const std::vector<Vec3>& values) {
        const ChunkPlace place = put(copyStateTable(what, k), vectors(values), std::max<hsize_t>(values.size(), 1));
        m_chunks.insert(m_chunks.end(), {place.address, place.bytes, place.filtersLeftOut});
    }

    // Once it has reached the file.
    ChunkPlace placeOf(hid_t set) const {
        haddr_t address = HADDR_UNDEF;
        hsize_t size = 0;
        unsigned mask = 0;
        const Hdf5Handle space(H5Dget_space(set), H5Sclose);
        const bool known = H5Dflush(set) >= 0 && H5Dget_chunk_info(set, space.get(), 0, nullptr, &mask, &address, &size) >= 0;
        requireWritten();
        return known ? ChunkPlace{static_cast<std::int64_t>(address), static_cast<std::int64_t>(size),
                                  static_cast<std::int64_t>(mask)}
                     : ChunkPlace{};
    }

    void putReals(const std::string& name, const std::vector<double>& values) {
        m_seal.add(values);
        put(name, {values.data(), values.size(), 1, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE});
    }

    void putIntegers(const std::string& name, const std::vector<std::int64_t>& values, hid_t kept) {
        m_seal.add(values);
        put(name, {values.data(), values.size(), 1, H5T_NATIVE_INT64, kept});
    }

    static_assert(sizeof(Vec3) == 3 * sizeof(double));

    void move(std::vector<Vec3>& places) const {
        for (Vec3& place : places) {
            place += m_offset;
        }
    }

    void writeState(std::size_t k, FeState state) {
        move(state.positions);
        putState("positions", k, state.positions);
        if (m_fe.contents().hasVelocity) {
            putState("velocities", k, state.velocities);
        }
        const Digest digest = digestOfState(state);
        m_digests.insert(m_digests.end(), digest.bytes.begin(), digest.bytes.end());
    }

    void writeTables() {
        using namespace copy_table;
        putIntegers(nodeIds, m_mesh.nodeIds, H5T_STD_I64LE);
        std::vector<Vec3> places = m_mesh.nodes;
        move(places);
        std::vector<double> flat;
        for (const Vec3& place : places) {
            flat.insert(flat.end(), place.data(), place.data() + 3);
        }
        m_seal.add(flat);
        put(nodes, vectors(places));
        putIntegers(elementIds, m_mesh.elementIds, H5T_STD_I64LE);
        std::vector<std::int64_t> kinds;
        for (const ElementShape shape : m_mesh.shapes) {
            kinds.push_back(static_cast<std::int64_t>(shape));
        }
        putIntegers(shapes, kinds, H5T_STD_U8LE);
        putIntegers(part, {m_mesh.part.begin(), m_mesh.part.end()}, H5T_STD_U32LE);
        putIntegers(corners, {m_mesh.corners.begin(), m_mesh.corners.end()}, H5T_STD_U32LE);
        putReals(density, m_mesh.density);
        putReals(section, m_mesh.section);
        if (!m_fe.contents().deathTime.empty()) {
            putReals(deathTime, m_fe.contents().deathTime);
        }
        putReals(times, m_fe.times());
        writeActivity();
        const std::string text = aboutText(m_fe);
        std::vector<std::int64_t> letters;
        for (const char letter : text) {
            letters.push_back(static_cast<unsigned char>(letter));
        }
        putIntegers(about, letters, H5T_STD_U8LE);
        putIntegers(chunks, m_chunks, H5T_STD_I64LE);
        putIntegers(digests, m_digests, H5T_STD_U8LE);
        const Digest whole = m_seal.finish();
        put(seal, {whole.bytes.data(), whole.bytes.size(), 1, H5T_NATIVE_UINT8, H5T_STD_U8LE});
    }

    void writeActivity() {
        const std::size_t elements = m_mesh.elementCount(), words = activityWords(elements);
        std::vector<std::int64_t> bits(m_fe.stateCount() * words, 0);
        for (std::size_t k = 0; k < m_fe.stateCount(); ++k) {
            for (std::size_t e = 0; e < elements; ++e) {
                if (m_fe.activity().active(k, idAt<ElementIndex>(e))) {
                    bits[k * words + e / activityBits] |= std::int64_t{1} << (e % activityBits);
                }
            }
        }
        m_seal.add(bits);
        put(copy_table::activity, {bits.data(), m_fe.stateCount(), words, H5T_NATIVE_INT64, H5T_STD_U32LE});
    }

    const std::string& m_path;
    const FeResult& m_fe;
    const Mesh& m_mesh;
    const Vec3 m_offset;
    Hdf5Handle m_file;
    CopySeal m_seal;
    std::vector<std::int64_t> m_chunks;
    std::vector<std::int64_t> m_digests;
};

}  // namespace

void writeFeCopy(const std::string& path, const FeResult& fe, const Vec3& offset, const Execution& execution) {
    CopyWriter(path, fe, offset).write(execution);
}

}  // namespace rubble::io
