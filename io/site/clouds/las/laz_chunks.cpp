#include "io/site/clouds/las/laz_chunks.h"

#include <algorithm>
#include <optional>

#include "io/base/file_words.h"
#include "io/site/clouds/las/integer_decoder.h"

namespace rubble::io {

namespace {

/// Behind the points of a LAZ stands the place of its table, in front of them.
constexpr std::uint64_t tablePlaceBytes = 8;

struct LazItem {
    int kind = 0;
    int bytes = 0;
    int version = 0;
    bool operator==(const LazItem&) const = default;
};

[[noreturn]] void refusePacking(const CloudFile& file, const std::string& what) {
    refuseContent({"cloud.laz_packing", "{0} is packed in a way that cannot be read: {1}", {file.path(), what}},
                  "Unpack it to LAS, or pack it anew with LASzip 2.0 or later.");
}

/// Parts of a point in their order, as every program of LASzip lays them.
std::vector<LazItem> expectedItems(const LasHead& head, bool layered) {
    const LasLayout& layout = head.layout;
    const auto extra = static_cast<int>(head.recordBytes - layout.bytes);
    std::vector<LazItem> items;
    if (layered) {
        const bool near = layout.format == 8 || layout.format == 10;
        items.push_back({10, 30, 3});
        if (layout.colour >= 0) {
            items.push_back(near ? LazItem{12, 8, 3} : LazItem{11, 6, 3});
        }
        if (layout.waves >= 0) {
            items.push_back({13, 29, 3});
        }
        if (extra > 0) {
            items.push_back({14, extra, 3});
        }
        return items;
    }
    items.push_back({6, 20, 2});
    if (layout.time >= 0) {
        items.push_back({7, 8, 2});
    }
    if (layout.colour >= 0) {
        items.push_back({8, 6, 2});
    }
    if (layout.waves >= 0) {
        items.push_back({9, 29, 1});
    }
    if (extra > 0) {
        items.push_back({0, extra, 2});
    }
    return items;
}

LazLayers::Turns turnsOf(const LasRecord& record, int version) {
    if (version > 3) {
        return LazLayers::Turns::Item4;
    }
    return record.description.find("lazperf") != std::string::npos || record.description.find("laz-rs") != std::string::npos
               ? LazLayers::Turns::OtherItem3
               : LazLayers::Turns::Item3;
}

/// Points and bytes of each chunk, as the table has them; nothing if the table is missing or no table.
std::optional<std::vector<LazChunk>> chunksOfTable(const CloudFile& file, std::uint64_t at, bool countsToo) {
    std::array<unsigned char, 8> head{};
    if (at > file.size() || file.readSome(at, head.data(), head.size()) != head.size() ||
        littleAt<std::uint32_t>(head.data()) != 0) {
        return std::nullopt;
    }
    const std::uint64_t count = littleAt<std::uint32_t>(&head[4]);
    // No chunk takes fewer bytes than its first point.
    if (count > file.size() / 20) {
        return std::nullopt;
    }
    if (count == 0) {
        return std::vector<LazChunk>();
    }
    PackedBytes bytes(file, at + head.size(), file.size());
    ArithmeticDecoder decoder(bytes);
    IntegerDecoder number(32, 2);
    std::vector<LazChunk> chunks(static_cast<std::size_t>(count));
    decoder.start();
    std::int32_t points = 0;
    std::int32_t length = 0;
    for (LazChunk& chunk : chunks) {
        if (countsToo) {
            points = number.decode(decoder, points, 0);
            chunk.points = static_cast<std::uint32_t>(points);
        }
        length = number.decode(decoder, length, 1);
        chunk.end = static_cast<std::uint32_t>(length);
    }
    return bytes.overrun() ? std::nullopt : std::optional(chunks);
}

/// Brings counts and lengths to places in the file. @return whether they fit into it and hold all points
bool placeChunks(std::vector<LazChunk>& chunks, std::uint64_t at, std::uint64_t end, std::uint64_t points, std::uint64_t each) {
    for (LazChunk& chunk : chunks) {
        chunk.points = each > 0 ? std::min(each, points) : chunk.points;
        if (chunk.end > end - at || chunk.points > points) {
            return false;
        }
        chunk.start = at;
        chunk.end += at;
        at = chunk.end;
        points -= chunk.points;
    }
    return points == 0;
}

}  // namespace

LazPacking readLazPacking(const CloudFile& file, const LasHead& head) {
    const LasRecord* record = head.record("laszip encoded", 22204);
    const std::vector<unsigned char> bytes = record != nullptr && record->bytes >= 34
                                                 ? file.bytes(record->start, std::min<std::uint64_t>(record->bytes, 1024))
                                                 : std::vector<unsigned char>();
    if (bytes.empty()) {
        refusePacking(file, "its head says that the points are packed, and not how");
    }
    const int compressor = littleAt<std::uint16_t>(bytes.data());
    const int coder = littleAt<std::uint16_t>(&bytes[2]);
    if (compressor < 1 || compressor > 3 || coder != 0) {
        refusePacking(file, "compressor " + std::to_string(compressor) + ", coder " + std::to_string(coder));
    }
    LazPacking packing;
    packing.layered = compressor == 3;
    packing.chunked = compressor > 1;
    const auto each = littleAt<std::uint32_t>(&bytes[12]);
    packing.chunkPoints = !packing.chunked ? head.points : each == 0xffffffff ? 0 : each;
    if (packing.layered != head.layout.wide || (each == 0 && packing.chunked)) {
        refusePacking(file,
                      "points of format " + std::to_string(head.layout.format) + " by compressor " + std::to_string(compressor));
    }
    const std::vector<LazItem> expected = expectedItems(head, packing.layered);
    const std::size_t count = littleAt<std::uint16_t>(&bytes[32]);
    int newest = 0;
    for (std::size_t i = 0; i < std::max(count, expected.size()); ++i) {
        const std::size_t at = 34 + 6 * i;
        if (i >= count || i >= expected.size() || at + 6 > bytes.size()) {
            refusePacking(file, "its parts are not those of its points");
        }
        LazItem item{littleAt<std::uint16_t>(&bytes[at]), littleAt<std::uint16_t>(&bytes[at + 2]),
                     littleAt<std::uint16_t>(&bytes[at + 4])};
        newest = std::max(newest, item.version);
        if (packing.layered && item.version == 4) {
            item.version = 3;
        }
        if (item != expected[i]) {
            refusePacking(file, "part " + std::to_string(item.kind) + " of " + std::to_string(item.bytes) + " bytes in version " +
                                    std::to_string(item.version));
        }
    }
    packing.turns = turnsOf(*record, newest);
    return packing;
}

std::vector<LazChunk> readLazChunks(const CloudFile& file, const LasHead& head, const LazPacking& packing, Findings& findings) {
    if (!packing.chunked) {
        return {{head.pointsStart, file.size(), head.points}};
    }
    std::array<unsigned char, tablePlaceBytes> place{};
    file.read(head.pointsStart, place.data(), place.size());
    auto at = littleAt<std::uint64_t>(place.data());
    if (at == ~std::uint64_t{0} && file.size() >= place.size()) {
        file.read(file.size() - place.size(), place.data(), place.size());
        at = littleAt<std::uint64_t>(place.data());
    }
    const std::uint64_t first = head.pointsStart + tablePlaceBytes;
    if (at >= first) {
        std::optional<std::vector<LazChunk>> chunks = chunksOfTable(file, at, packing.chunkPoints == 0);
        if (chunks && placeChunks(*chunks, first, at, head.points, packing.chunkPoints)) {
            return *chunks;
        }
    }
    if (head.points == 0) {
        return {};
    }
    if (packing.chunkPoints == 0 && !packing.layered) {
        refuseContent({"cloud.laz_table",
                       "{0}: the table of its chunks is missing or damaged, and nothing else tells them apart",
                       {file.path()}},
                      "The file may be cut short: copy it again from where it came.");
    }
    addFinding(findings, file.path(),
               {"cloud.laz_table_missing",
                "the table of chunks is missing or does not fit the head; chunks were read one after another as far as they go",
                {}},
               "the file may be cut short: compare the number of points with that of the head");
    return {};
}

}  // namespace rubble::io
