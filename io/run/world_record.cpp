#include "io/run/world_record.h"

#include <bit>
#include <cstring>
#include <type_traits>

#include "core/base/error.h"

namespace rubble::io {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view magic = "rubble-world";
constexpr std::uint32_t version = 2;
constexpr std::uint32_t withoutMoving = 1;
constexpr std::size_t digestSize = sizeof(Digest::bytes);
constexpr std::size_t textMost = 4096;
/// Bytes of a fragment: present, centre, box, mass, volume.
constexpr std::size_t fragmentSize = 1 + 15 * sizeof(double);

Digest digestOf(std::string_view bytes) {
    return Hasher().bytes(bytes.data(), bytes.size()).finish();
}

class RecordWriter {
public:
    template <class T>
        requires(std::is_arithmetic_v<T>)
    void number(T value) {
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void vector(const Vec3& v) {
        for (int k = 0; k < 3; ++k) {
            number(v[k]);
        }
    }
    void text(std::string_view text) {
        number(static_cast<std::uint32_t>(text.size()));
        m_bytes += text;
    }
    void digest(const Digest& digest) { m_bytes.append(reinterpret_cast<const char*>(digest.bytes.data()), digestSize); }
    void debris(const Debris& debris) {
        number(debris.time);
        number(static_cast<std::uint64_t>(debris.fragments.size()));
        for (const DebrisFragment& lies : debris.fragments) {
            number(static_cast<std::uint8_t>(lies.present));
            vector(lies.centre);
            vector(lies.box.centre);
            for (const double q :
                 {lies.box.orientation.w(), lies.box.orientation.x(), lies.box.orientation.y(), lies.box.orientation.z()}) {
                number(q);
            }
            vector(lies.box.halfExtents);
            number(lies.mass);
            number(lies.volume);
        }
    }
    std::string finish() && {
        digest(digestOf(m_bytes));
        return std::move(m_bytes);
    }

private:
    std::string m_bytes{magic};
};

class RecordReader {
public:
    RecordReader(std::string_view bytes, const std::string& file) : m_bytes(bytes), m_file(file) {}

    template <class T>
        requires(std::is_arithmetic_v<T>)
    T number() {
        T value{};
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    Vec3 vector() {
        const double x = number<double>();
        const double y = number<double>();
        return {x, y, number<double>()};
    }
    std::string text() {
        const auto size = number<std::uint32_t>();
        if (size > textMost) {
            fail("a text of at most 4096 bytes");
        }
        return std::string(take(size));
    }
    Digest digest() {
        Digest digest;
        std::memcpy(digest.bytes.data(), take(digestSize).data(), digestSize);
        return digest;
    }
    Debris debris() {
        Debris debris;
        debris.time = number<double>();
        const auto count = number<std::uint64_t>();
        if (count > (m_bytes.size() - m_at) / fragmentSize) {
            fail("as many fragments as the file has room for");
        }
        debris.fragments.resize(static_cast<std::size_t>(count));
        for (DebrisFragment& lies : debris.fragments) {
            lies.present = number<std::uint8_t>() != 0;
            lies.centre = vector();
            lies.box.centre = vector();
            const double w = number<double>();
            const Vec3 axis = vector();
            lies.box.orientation = Quat(w, axis.x(), axis.y(), axis.z());
            lies.box.halfExtents = vector();
            lies.mass = number<double>();
            lies.volume = number<double>();
        }
        return debris;
    }
    std::string_view take(std::size_t count) {
        if (count > m_bytes.size() - m_at) {
            fail("more bytes");
        }
        const std::string_view taken = m_bytes.substr(m_at, count);
        m_at += count;
        return taken;
    }
    bool atEnd() const { return m_at == m_bytes.size(); }
    [[noreturn]] void fail(std::string_view expected) const {
        throw ParseError({"io.world.damaged",
                          "{0} is no sound record of a simulated world: at byte {1} {2} were expected.",
                          {m_file, m_at, expected}},
                         {"io.world.damaged.remedy", "It is made again; delete the file if this is said each time.", {}});
    }

private:
    std::string_view m_bytes;
    const std::string& m_file;
    std::size_t m_at = 0;
};

}  // namespace

std::string worldBytes(const WorldOrigin& origin, const SimulatedWorld& world) {
    RecordWriter writer;
    writer.number(version);
    writer.digest(origin.key);
    writer.text(origin.build);
    writer.text(origin.feSha256);
    writer.digest(origin.scenario);
    writer.number(origin.repeat);
    writer.number(origin.birthShift);
    writer.text(origin.machine);
    writer.digest(world.trajectoryHash);
    for (const double number : {world.endTime, world.wallSeconds, world.stepMeanMs, world.stepWorstMs}) {
        writer.number(number);
    }
    writer.number(world.breaches);
    writer.number(world.bodiesPeak);
    writer.number(world.moving);
    writer.debris(world.atRest);
    writer.debris(world.atFeEnd);
    return std::move(writer).finish();
}

std::pair<WorldOrigin, SimulatedWorld> worldFromBytes(std::string_view bytes, const std::string& file) {
    RecordReader whole(bytes, file);
    if (bytes.size() < magic.size() + digestSize || whole.take(magic.size()) != magic) {
        whole.fail("the word rubble-world and a digest");
    }
    const std::string_view content = bytes.substr(0, bytes.size() - digestSize);
    Digest stored;
    std::memcpy(stored.bytes.data(), bytes.data() + content.size(), digestSize);
    if (digestOf(content) != stored) {
        whole.fail("bytes that have the digest at the end");
    }
    RecordReader reader(content, file);
    reader.take(magic.size());
    const auto made = reader.number<std::uint32_t>();
    if (made != version && made != withoutMoving) {
        reader.fail("version 1 or 2");
    }
    WorldOrigin origin;
    origin.key = reader.digest();
    origin.build = reader.text();
    origin.feSha256 = reader.text();
    origin.scenario = reader.digest();
    origin.repeat = reader.number<std::int64_t>();
    origin.birthShift = reader.number<double>();
    origin.machine = reader.text();
    SimulatedWorld world;
    world.trajectoryHash = reader.digest();
    for (double* number : {&world.endTime, &world.wallSeconds, &world.stepMeanMs, &world.stepWorstMs}) {
        *number = reader.number<double>();
    }
    world.breaches = reader.number<std::int64_t>();
    world.bodiesPeak = reader.number<std::int64_t>();
    world.moving = made == withoutMoving ? -1 : reader.number<std::int64_t>();
    world.atRest = reader.debris();
    world.atFeEnd = reader.debris();
    if (!reader.atEnd()) {
        reader.fail("no further bytes");
    }
    return {std::move(origin), std::move(world)};
}

}  // namespace rubble::io
