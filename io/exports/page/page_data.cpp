#include "io/exports/page/page_data.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace rubble::io {

namespace {

constexpr std::size_t alignment = 8;

}  // namespace

void PackedIntegers::add(std::int64_t number) {
    std::uint64_t rest = static_cast<std::uint64_t>(number) << 1 ^ static_cast<std::uint64_t>(number >> 63);
    while (rest >= 0x80u) {
        m_bytes.push_back(static_cast<char>(rest | 0x80u));
        rest >>= 7;
    }
    m_bytes.push_back(static_cast<char>(rest));
    ++m_count;
}

void PackedIntegers::addSteps(std::span<const std::int64_t> numbers) {
    std::int64_t before = 0;
    for (const std::int64_t number : numbers) {
        add(number - before);
        before = number;
    }
}

void PackedIntegers::addRuns(std::span<const std::int64_t> numbers) {
    for (auto number = numbers.begin(); number != numbers.end();) {
        add(*number);
        const auto next = std::find_if(number + 1, numbers.end(), [](std::int64_t each) { return each != 0; });
        if (*number++ == 0) {
            add(next - number);
            number = next;
        }
    }
}

void PackedPlaces::add(const Vec3& place) {
    Vec3 shown;
    for (int c = 0; c < 3; ++c) {
        const std::int64_t now = std::llround(place[c] / m_step);
        std::int64_t& last = m_before[static_cast<std::size_t>(c)];
        m_numbers.add(now - last);
        last = now;
        shown[c] = m_step * static_cast<double>(now);
    }
    m_largestError = std::max(m_largestError, (shown - place).norm());
}

void PageData::add(std::string_view name, std::string_view type, const void* data, std::size_t bytes, std::size_t count) {
    m_bytes.resize((m_bytes.size() + alignment - 1) / alignment * alignment, '\0');
    m_contents[std::string(name)] = {{"type", type}, {"at", m_bytes.size()}, {"bytes", bytes}, {"count", count}};
    m_bytes.append(static_cast<const char*>(data), bytes);
}

void PageData::add(std::string_view name, std::span<const double> numbers) {
    add(name, "f64", numbers.data(), numbers.size_bytes(), numbers.size());
}

void PageData::add(std::string_view name, std::span<const float> numbers) {
    add(name, "f32", numbers.data(), numbers.size_bytes(), numbers.size());
}

void PageData::add(std::string_view name, std::span<const std::uint8_t> numbers) {
    add(name, "u8", numbers.data(), numbers.size_bytes(), numbers.size());
}

void PageData::add(std::string_view name, const PackedIntegers& numbers) {
    add(name, "packed", numbers.bytes().data(), numbers.bytes().size(), numbers.count());
}

std::string PageData::compressed(const Execution& execution) const {
    z_stream stream{};
    if (deflateInit(&stream, Z_BEST_COMPRESSION) != Z_OK) {
        throw std::bad_alloc();
    }
    std::string out;
    std::vector<char> buffer(std::size_t{1} << 20);
    std::size_t taken = 0;
    int state = Z_OK;
    while (state != Z_STREAM_END) {
        if (execution.cancelled()) {
            deflateEnd(&stream);
            execution.check();
        }
        if (stream.avail_in == 0) {
            const std::size_t next = std::min(buffer.size(), m_bytes.size() - taken);
            // zlib takes its input as bytes that it does not change.
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(m_bytes.data() + taken));
            stream.avail_in = static_cast<uInt>(next);
            taken += next;
        }
        stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
        stream.avail_out = static_cast<uInt>(buffer.size());
        state = deflate(&stream, taken == m_bytes.size() ? Z_FINISH : Z_NO_FLUSH);
        out.append(buffer.data(), buffer.size() - stream.avail_out);
    }
    deflateEnd(&stream);
    return out;
}

}  // namespace rubble::io
