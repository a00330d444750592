#include "io/site/clouds/las/las_head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/base/file_words.h"
#include "io/base/trimmed.h"
#include "io/json/run_behind.h"
#include "io/site/clouds/point_writer.h"

namespace rubble::io {

namespace {

constexpr std::size_t shortestHead = 227;
constexpr std::size_t newestHead = 375;
/// More records of any file would only take memory.
constexpr std::size_t recordsMax = 10'000;

std::string fixedText(const unsigned char* bytes, std::size_t count) {
    const auto* begin = reinterpret_cast<const char*>(bytes);
    const char* end = std::find(begin, begin + count, '\0');
    return std::string(trimmed({begin, static_cast<std::size_t>(end - begin)}));
}

[[noreturn]] void refuseLas(const CloudFile& file, Message what) {
    what.arguments.insert(what.arguments.begin(), Argument(file.path()));
    refuseContent(std::move(what), "The file may be damaged: copy it again from where it came, or write it anew as LAS 1.4.");
}

/// Reads records one after another until one does not fit before `end`. @return how many were left out
std::uint64_t readRecords(const CloudFile& file, std::uint64_t at, std::uint64_t count, std::uint64_t end, bool extended,
                          std::vector<LasRecord>& records) {
    const std::size_t head = extended ? 60 : 54;
    std::array<unsigned char, 60> bytes{};
    for (std::uint64_t r = 0; r < count; ++r) {
        if (records.size() >= recordsMax || at > end || end - at < head || file.readSome(at, bytes.data(), head) != head) {
            return count - r;
        }
        LasRecord record;
        record.user = fixedText(&bytes[2], 16);
        record.id = littleAt<std::uint16_t>(&bytes[18]);
        record.bytes = extended ? littleAt<std::uint64_t>(&bytes[20]) : littleAt<std::uint16_t>(&bytes[20]);
        record.description = fixedText(&bytes[extended ? 28 : 22], 32);
        record.start = at + head;
        if (record.bytes > end - record.start) {
            return count - r;
        }
        at = record.start + record.bytes;
        records.push_back(std::move(record));
    }
    return 0;
}

void takeExtents(const unsigned char* bytes, LasHead& head) {
    for (int axis = 0; axis < 3; ++axis) {
        head.scale[axis] = littleAt<double>(bytes + 131 + 8 * axis);
        head.offset[axis] = littleAt<double>(bytes + 155 + 8 * axis) + 0.0;  // no minus before a zero
    }
    const auto bound = [&](int index) { return littleAt<double>(bytes + 179 + 8 * index); };
    const Vec3 high(bound(0), bound(2), bound(4));
    const Vec3 low(bound(1), bound(3), bound(5));
    if (low.allFinite() && high.allFinite() && (low.array() <= high.array()).all()) {
        head.stated.extend(low);
        head.stated.extend(high);
    }
}

void checkExtents(const CloudFile& file, const LasHead& head) {
    const bool sound = head.scale.allFinite() && head.offset.allFinite() && (head.scale.array() != 0.0).all();
    if (!sound) {
        refuseLas(file, {"cloud.las_scale", "{0}: scale or offset of the coordinates is no number that can be used", {}});
    }
}

void takeLayout(const CloudFile& file, const unsigned char* bytes, LasHead& head) {
    // LAZ marks its points in the highest bit; an early program took the one below as well.
    const int format = bytes[104] & 0x3f;
    head.packed = (bytes[104] & 0xc0) != 0;
    const std::optional<LasLayout> layout = lasLayout(format);
    if (!layout) {
        refuseLas(file, {"cloud.las_format", "{0} has points of format {1}, which LAS 1.0 to 1.4 do not know", {format}});
    }
    head.layout = *layout;
    head.recordBytes = littleAt<std::uint16_t>(bytes + 105);
    if (head.recordBytes < head.layout.bytes) {
        refuseLas(file, {"cloud.las_record",
                         "{0}: a point takes {1} bytes, less than the {2} of its format {3}",
                         {head.recordBytes, head.layout.bytes, format}});
    }
}

/// Records of both kinds; those behind the points only where the head knows them.
void takeRecords(const CloudFile& file, const unsigned char* bytes, std::size_t headBytes, LasHead& head, Findings& findings) {
    std::uint64_t left = readRecords(file, headBytes, littleAt<std::uint32_t>(bytes + 100), std::min(head.pointsStart, file.size()),
                                     false, head.records);
    if (head.minor >= 4 && headBytes >= newestHead) {
        left += readRecords(file, littleAt<std::uint64_t>(bytes + 235), littleAt<std::uint32_t>(bytes + 243), file.size(), true,
                            head.records);
    }
    if (left > 0) {
        addFinding(findings, file.path(),
                   {"cloud.records_cut", "records of the head that cannot be as long as they say were left out", {}},
                   "check the coordinate system; it may have stood in one of them", static_cast<std::int64_t>(left));
    }
}

/// Where the scanners of a scan of ours stood; nothing where the record is damaged.
void takeScanners(const CloudFile& file, LasHead& head) {
    const LasRecord* record = head.record(scannerUser, scannerRecord);
    if (record == nullptr || !head.layout.wide || record->bytes == 0 || record->bytes % scannerBytes != 0 ||
        record->bytes > std::numeric_limits<std::uint16_t>::max()) {
        return;
    }
    const std::vector<unsigned char> bytes = file.bytes(record->start, record->bytes);
    for (std::size_t at = 0; at < bytes.size(); at += scannerBytes) {
        const Vec3 place(littleAt<double>(&bytes[at]), littleAt<double>(&bytes[at + 8]), littleAt<double>(&bytes[at + 16]));
        head.scanners.push_back({place, littleAt<std::uint64_t>(&bytes[at + 24])});
    }
}

/// Which instant of a run a scan of ours shows; nothing where the record is damaged.
void takeInstant(const CloudFile& file, LasHead& head) {
    const LasRecord* record = head.record(scannerUser, instantRecord);
    if (record != nullptr && record->bytes == sizeof(double)) {
        const double seconds = littleAt<double>(file.bytes(record->start, record->bytes).data());
        head.instant = std::isfinite(seconds) ? std::optional(seconds) : std::nullopt;
    }
}

/// Of which run a scan of ours is; nothing where the record is damaged.
void takeRun(const CloudFile& file, LasHead& head) {
    const LasRecord* record = head.record(scannerUser, runRecord);
    if (record == nullptr || record->bytes != fingerprintDigits) {
        return;
    }
    const std::vector<unsigned char> bytes = file.bytes(record->start, record->bytes);
    head.run = fingerprintOf({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// What one descriptor of the extra bytes names.
constexpr std::size_t extraDescriptor = 192;

}  // namespace

std::optional<LasLayout> lasLayout(int format) {
    static const std::array<LasLayout, 11> layouts{{{0, 20, false, -1, -1, -1},
                                                    {1, 28, false, 20, -1, -1},
                                                    {2, 26, false, -1, 20, -1},
                                                    {3, 34, false, 20, 28, -1},
                                                    {4, 57, false, 20, -1, 28},
                                                    {5, 63, false, 20, 28, 34},
                                                    {6, 30, true, 22, -1, -1},
                                                    {7, 36, true, 22, 30, -1},
                                                    {8, 38, true, 22, 30, -1},
                                                    {9, 59, true, 22, -1, 30},
                                                    {10, 67, true, 22, 30, 38}}};
    return format >= 0 && format < 11 ? std::optional(layouts[static_cast<std::size_t>(format)]) : std::nullopt;
}

const LasRecord* LasHead::record(std::string_view user, std::uint16_t id) const {
    const auto found =
        std::find_if(records.begin(), records.end(), [&](const LasRecord& r) { return r.user == user && r.id == id; });
    return found == records.end() ? nullptr : &*found;
}

LasHead readLasHead(const CloudFile& file, Findings& findings) {
    std::array<unsigned char, newestHead> bytes{};
    const std::size_t got = file.readSome(0, bytes.data(), bytes.size());
    if (got < shortestHead) {
        file.failCut();
    }
    LasHead head;
    head.minor = bytes[25];
    if (bytes[24] != 1 || head.minor > 4) {
        refuseLas(file, {"cloud.las_version", "{0} is LAS {1}.{2}; 1.0 to 1.4 can be read", {int{bytes[24]}, int{bytes[25]}}});
    }
    const std::size_t headBytes = littleAt<std::uint16_t>(&bytes[94]);
    head.pointsStart = littleAt<std::uint32_t>(&bytes[96]);
    if (headBytes < shortestHead || head.pointsStart < headBytes) {
        refuseLas(file, {"cloud.las_head", "{0}: the head says that its points begin inside it, at byte {1}", {head.pointsStart}});
    }
    if (head.pointsStart > file.size()) {
        file.failCut();
    }
    takeLayout(file, bytes.data(), head);
    takeExtents(bytes.data(), head);
    checkExtents(file, head);
    head.wkt = head.minor >= 4 && (bytes[6] & 0x10) != 0;
    head.points = littleAt<std::uint32_t>(&bytes[107]);
    if (head.minor >= 4 && headBytes >= newestHead && got >= newestHead) {
        const auto wide = littleAt<std::uint64_t>(&bytes[247]);
        head.points = wide > 0 ? wide : head.points;
    }
    takeRecords(file, bytes.data(), headBytes, head, findings);
    takeScanners(file, head);
    takeInstant(file, head);
    takeRun(file, head);
    // What another program wrote anew from a cloud of ours keeps our records, and names itself.
    constexpr std::size_t programAt = 58;
    head.ours = fixedText(&bytes[programAt], 32) == writingProgram || !head.scanners.empty() || !head.run.empty();
    return head;
}

std::vector<std::string> lasExtraNames(const CloudFile& file, const LasHead& head) {
    std::vector<std::string> names;
    if (head.recordBytes == head.layout.bytes) {
        return names;
    }
    if (const LasRecord* record = head.record("LASF_Spec", 4)) {
        const std::vector<unsigned char> bytes = file.bytes(record->start, std::min<std::uint64_t>(record->bytes, 65'535));
        for (std::size_t at = 0; at + extraDescriptor <= bytes.size(); at += extraDescriptor) {
            names.push_back(fixedText(&bytes[at + 4], 32));
        }
    }
    if (names.empty()) {
        names.emplace_back("extra bytes");
    }
    return names;
}

}  // namespace rubble::io
