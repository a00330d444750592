#include "io/site/clouds/pcd_cloud.h"

#include <algorithm>
#include <charconv>

#include "io/base/file_words.h"
#include "io/site/clouds/cloud_records.h"
#include "io/site/clouds/text_source.h"

namespace rubble::io {

namespace {

/// A field of a PCD: so many numbers of each point.
struct PcdField {
    std::string name;
    NumberType type{NumberType::Kind::Real, 4};
    std::uint64_t count = 1;
};

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
        words.push_back(word);
    }
    return words;
}

class PcdOpening {
public:
    explicit PcdOpening(const std::string& path) : m_file(std::make_shared<CloudFile>(path)), m_path(path) {
        m_head.format = "PCD";
        readHead();
        std::uint64_t step = 0;
        for (const PcdField& field : m_fields) {
            for (std::uint64_t k = 0; k < field.count; ++k) {
                // Only the first of several numbers of a field is what its name says.
                m_plan.add(k == 0 ? columnRole(field.name) : ColumnRole::Unread, field.name);
            }
            step += field.count * field.type.bytes;
        }
        m_step = step;
        if (!m_plan.hasPlaces()) {
            refuse("its points have no x, y and z");
        }
        m_plan.describe(m_head);
    }

    std::unique_ptr<CloudSource> open() && {
        if (m_coding == "ascii") {
            TextPoints text;
            text.plan = std::move(m_plan);
            text.count = m_points;
            return textCloud(m_file, m_start, std::move(text), std::move(m_head), std::move(m_found));
        }
        if (m_coding == "binary") {
            return recordsCloud(std::make_unique<CloudFile>(m_path), stored(m_start, false), std::move(m_head), std::move(m_found));
        }
        return unpacked();
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        refuseContent({"cloud.pcd", "{0} is no PCD that can be read: {1}", {m_path, what}}, "Export the points anew as PCD 0.7.");
    }

    std::uint64_t wholeIn(std::string_view word, std::string_view entry) const {
        std::uint64_t number = 0;
        const auto end = std::from_chars(word.data(), word.data() + word.size(), number);
        constexpr std::uint64_t most = std::uint64_t{1} << 40;
        if (end.ec != std::errc{} || end.ptr != word.data() + word.size() || number > most) {
            refuse(std::string(entry) + " says \"" + std::string(word.substr(0, 40)) + "\"");
        }
        return number;
    }

    void readHead() {
        CloudLines lines(m_file, 0);
        std::string_view line;
        std::uint64_t width = 0;
        std::uint64_t height = 1;
        constexpr int linesMax = 1000;
        for (int n = 0; n < linesMax && lines.next(line); ++n) {
            const std::vector<std::string_view> words = wordsOf(line);
            if (words.size() < 2 || words[0].starts_with('#')) {
                continue;
            }
            if (words[0] == "VERSION") {
                m_head.version = words[1];
            } else if (words[0] == "WIDTH") {
                width = wholeIn(words[1], "WIDTH");
            } else if (words[0] == "HEIGHT") {
                height = wholeIn(words[1], "HEIGHT");
            } else if (words[0] == "POINTS") {
                m_points = wholeIn(words[1], "POINTS");
            } else if (words[0] == "VIEWPOINT") {
                takeViewpoint(words);
            } else if (words[0] == "DATA") {
                m_coding = words[1];
                m_start = lines.position();
                break;
            } else {
                takeFields(words);
            }
        }
        m_points =
            m_points > 0 ? m_points : width * std::min<std::uint64_t>(height, width > 0 ? (std::uint64_t{1} << 40) / width : 0);
        m_head.coding = m_coding;
        if (m_coding != "ascii" && m_coding != "binary" && m_coding != "binary_compressed") {
            refuse("DATA says \"" + m_coding + "\"");
        }
    }

    void takeFields(const std::vector<std::string_view>& words) {
        if (words[0] == "FIELDS" || words[0] == "COLUMNS") {
            m_fields.resize(words.size() - 1);
        }
        for (std::size_t f = 0; f < m_fields.size() && f + 1 < words.size(); ++f) {
            const std::string_view word = words[f + 1];
            PcdField& field = m_fields[f];
            if (words[0] == "FIELDS" || words[0] == "COLUMNS") {
                field.name = word;
            } else if (words[0] == "SIZE") {
                field.type.bytes = static_cast<std::size_t>(wholeIn(word, "SIZE"));
            } else if (words[0] == "TYPE") {
                field.type.kind = word == "F"   ? NumberType::Kind::Real
                                  : word == "U" ? NumberType::Kind::Unsigned
                                                : NumberType::Kind::Signed;
            } else if (words[0] == "COUNT") {
                field.count = wholeIn(word, "COUNT");
            }
            checkField(field);
        }
    }

    void checkField(const PcdField& field) const {
        constexpr std::uint64_t countMost = 100'000;
        const std::size_t bytes = field.type.bytes;
        const bool known = bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
        if (!known || field.count > countMost) {
            refuse("its field " + field.name + " has " + std::to_string(field.count) + " numbers of " + std::to_string(bytes) +
                   " bytes");
        }
    }

    /// Where the scanner stood. Points of a PCD are not turned by it.
    void takeViewpoint(const std::vector<std::string_view>& words) {
        std::array<double, 7> numbers{};
        for (std::size_t k = 0; k < numbers.size() && k + 1 < words.size(); ++k) {
            numbers[k] = fieldNumber(words[k + 1], {});
        }
        CloudScan scan;
        scan.pose.position = Vec3(numbers[0], numbers[1], numbers[2]);
        const Quat turn(numbers[3], numbers[4], numbers[5], numbers[6]);
        constexpr double unitError = 1e-3;
        scan.pose.stated = words.size() == 8 && scan.pose.position.allFinite() && std::abs(turn.norm() - 1.0) < unitError;
        if (!scan.pose.stated) {
            return;
        }
        scan.pose.orientation = turn.normalized();
        const bool moved = !scan.pose.position.isZero() || scan.pose.orientation.angularDistance(Quat::Identity()) > 1e-9;
        if (moved) {
            m_head.scans = {scan};
            addFinding(m_found, m_path,
                       {"cloud.viewpoint", "the file names where its scanner stood; its points are taken as placed already", {}},
                       "if they count from the scanner, place the cloud by hand");
        }
    }

    /// @param eachByItself  columns lie one after another, else in records
    StoredPoints stored(std::uint64_t start, bool eachByItself) const {
        StoredPoints points;
        points.count = m_points;
        std::uint64_t at = start;
        std::size_t c = 0;
        for (const PcdField& field : m_fields) {
            for (std::uint64_t k = 0; k < field.count; ++k, ++c) {
                StoredColumn column;
                column.role = m_plan.role(c);
                column.type = field.type;
                column.start = at + k * field.type.bytes;
                column.step = eachByItself ? field.count * field.type.bytes : m_step;
                column.floatBits = column.role == ColumnRole::PackedColour && field.type.bytes == 4;
                points.columns.push_back(column);
            }
            at += field.count * field.type.bytes * (eachByItself ? m_points : 1);
        }
        return points;
    }

    std::unique_ptr<CloudSource> unpacked() {
        /// LZF packs 264 bytes into 3 at most; larger clouds than this do not fit into memory beside a case.
        constexpr std::uint64_t ratioMost = 90;
        constexpr std::uint64_t bytesMost = std::uint64_t{1} << 31;
        std::array<unsigned char, 8> sizes{};
        m_file->read(m_start, sizes.data(), sizes.size());
        const std::uint64_t packed = littleAt<std::uint32_t>(sizes.data());
        const std::uint64_t whole = littleAt<std::uint32_t>(&sizes[4]);
        if (m_step == 0 || whole > bytesMost || whole > ratioMost * packed || m_points > whole / m_step) {
            refuse("its packed bytes cannot hold " + std::to_string(m_points) + " points");
        }
        std::vector<unsigned char> bytes(static_cast<std::size_t>(whole));
        if (!unpackLzf(m_file->bytes(m_start + sizes.size(), packed), bytes)) {
            refuse("its packed bytes are damaged");
        }
        return unpackedCloud(std::move(bytes), stored(0, true), std::move(m_head), std::move(m_found));
    }

    std::shared_ptr<CloudFile> m_file;
    std::string m_path;
    std::vector<PcdField> m_fields;
    std::uint64_t m_points = 0;
    std::uint64_t m_step = 0;
    std::uint64_t m_start = 0;
    std::string m_coding;
    ColumnPlan m_plan;
    CloudHead m_head;
    Findings m_found;
};

}  // namespace

bool unpackLzf(const std::vector<unsigned char>& packed, std::vector<unsigned char>& unpacked) {
    std::size_t to = 0;
    for (std::size_t at = 0; at < packed.size();) {
        const std::size_t control = packed[at++];
        constexpr std::size_t literals = 32;
        if (control < literals) {
            const std::size_t count = control + 1;
            if (count > packed.size() - at || count > unpacked.size() - to) {
                return false;
            }
            std::copy_n(&packed[at], count, &unpacked[to]);
            at += count;
            to += count;
            continue;
        }
        std::size_t count = control >> 5;
        if (count == 7) {
            if (at == packed.size()) {
                return false;
            }
            count += packed[at++];
        }
        count += 2;
        if (at == packed.size()) {
            return false;
        }
        const std::size_t back = ((control & 31) << 8 | packed[at++]) + 1;
        if (back > to || count > unpacked.size() - to) {
            return false;
        }
        for (; count > 0; --count, ++to) {
            unpacked[to] = unpacked[to - back];
        }
    }
    return to == unpacked.size();
}

std::unique_ptr<CloudSource> openPcd(const std::string& path) {
    return PcdOpening(path).open();
}

}  // namespace rubble::io
