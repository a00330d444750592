#include "io/site/clouds/las/las_records.h"

#include <algorithm>

#include "io/site/clouds/las/las_system.h"

namespace rubble::io {

namespace {

/// What the bytes of classes and returns say, in the two ways that LAS has written them.
struct LasMarks {
    std::uint8_t echo;
    std::uint8_t echoes;
    std::uint8_t kind;
    bool withheld;
};

template <bool Wide>
LasMarks marksOf(const unsigned char* record) {
    const unsigned char echoes = record[14];
    if constexpr (Wide) {
        return {static_cast<std::uint8_t>(echoes & 15), static_cast<std::uint8_t>(echoes >> 4), record[16], (record[15] & 4) != 0};
    } else {
        return {static_cast<std::uint8_t>(echoes & 7), static_cast<std::uint8_t>((echoes >> 3) & 7),
                static_cast<std::uint8_t>(record[15] & 31), (record[15] & 128) != 0};
    }
}

template <bool Wide>
void decodeMarks(const LasHead& head, const unsigned char* records, std::size_t count, CloudBlock& block) {
    bool all = true;
    for (std::size_t i = 0; i < count; ++i) {
        const unsigned char* record = records + i * head.recordBytes;
        const LasMarks marks = marksOf<Wide>(record);
        block.intensity[i] = littleAt<std::uint16_t>(record + 12);
        block.returns[i] = marks.echo;
        block.returnsOf[i] = marks.echoes;
        block.classes[i] = marks.kind;
        all = all && !marks.withheld;
    }
    if (all) {
        return;
    }
    block.fates.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool withheld = marksOf<Wide>(records + i * head.recordBytes).withheld;
        block.fates[i] = withheld ? PointFate::Withheld : PointFate::Taken;
    }
}

}  // namespace

CloudColumns lasColumns(const LasHead& head) {
    const LasLayout& layout = head.layout;
    CloudColumns columns;
    columns.scans = !head.scanners.empty();
    columns.intensity = columns.classes = columns.returns = true;
    columns.colour = layout.colour >= 0;
    columns.times = layout.time >= 0;
    return columns;
}

void decodeLasRecords(const LasHead& head, const unsigned char* records, std::size_t count, CloudBlock& block) {
    block.resize(count, lasColumns(head));
    const std::size_t step = head.recordBytes;
    for (std::size_t i = 0; i < count; ++i) {
        const unsigned char* record = records + i * step;
        for (int axis = 0; axis < 3; ++axis) {
            block.places[i][axis] = littleAt<std::int32_t>(record + 4 * axis) * head.scale[axis] + head.offset[axis];
        }
    }
    head.layout.wide ? decodeMarks<true>(head, records, count, block) : decodeMarks<false>(head, records, count, block);
    for (std::size_t i = 0; i < block.times.size(); ++i) {
        block.times[i] = littleAt<double>(records + i * step + head.layout.time);
    }
    for (std::size_t i = 0; i < block.scans.size(); ++i) {
        constexpr int source = 20;
        const int scanner = littleAt<std::uint16_t>(records + i * step + source) - 1;
        block.scans[i] = static_cast<std::uint16_t>(std::clamp(scanner, 0, static_cast<int>(head.scanners.size()) - 1));
    }
    for (std::size_t i = 0; i < block.colours.size(); ++i) {
        const unsigned char* colour = records + i * step + head.layout.colour;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            block.colours[i][channel] = littleAt<std::uint16_t>(colour + 2 * channel);
        }
    }
}

void describeLas(const CloudFile& file, const LasHead& las, CloudHead& head) {
    head.version = "1." + std::to_string(las.minor);
    head.promised = las.points;
    head.columns = lasColumns(las);
    head.scale = las.scale;
    head.offset = las.offset;
    head.stated = las.stated;
    for (const LasScanner& scanner : las.scanners) {
        CloudScan scan;
        scan.promised = scanner.points;
        scan.pose.position = scanner.place;
        scan.pose.stated = scan.pose.applied = true;
        head.scans.push_back(std::move(scan));
    }
    head.instant = las.instant;
    head.run = las.run;
    head.ours = las.ours;
    head.unread = lasExtraNames(file, las);
    if (las.layout.format == 8 || las.layout.format == 10) {
        head.unread.emplace_back("near infrared");
    }
    if (las.layout.waves >= 0) {
        head.unread.emplace_back("wave forms");
    }
    takeLasSystem(file, las, head);
}

}  // namespace rubble::io
