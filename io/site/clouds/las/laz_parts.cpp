#include "io/site/clouds/las/laz_parts.h"

#include <algorithm>

namespace rubble::io {

namespace {

/// Codes of times: multiples of the last difference up to 500 and down to -10, then what is no multiple.
constexpr std::uint32_t multipleMost = 500;
constexpr std::uint32_t multipleLeast = 10;
constexpr std::uint32_t timeStays = multipleMost + multipleLeast + 1;
constexpr std::uint32_t timeIsWhole = timeStays + 1;
constexpr std::uint32_t sequencesMost = 4;

std::int32_t multiple(std::int32_t difference, std::int32_t factor) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(difference) * static_cast<std::uint32_t>(factor));
}

/// One number if all bits of the mask are set, the other if none is.
std::int32_t chosen(std::int32_t mask, std::int32_t one, std::int32_t other) {
    return other ^ ((one ^ other) & mask);
}

/// A step of a colour foretold by what another did, within a byte.
std::uint32_t foretold(std::uint32_t last, std::int32_t change) {
    return static_cast<std::uint32_t>(std::clamp(static_cast<std::int32_t>(last) + change, 0, 255));
}

}  // namespace

void RunningMedian::add(std::int32_t number) {
    // By masks: a compiler makes branches of conditions here, and no processor foretells them.
    const std::int32_t greatest = m_dropGreatest;
    const std::int32_t middle = m_sorted[2];
    m_dropGreatest = -static_cast<std::int32_t>((number < middle) | ((number == middle) & (greatest == 0)));
    // The four that stay, and the new one carried up to its place.
    std::int32_t carried = number;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::int32_t stays = chosen(greatest, m_sorted[i], m_sorted[i + 1]);
        const std::int32_t below = -static_cast<std::int32_t>(stays < carried);
        m_sorted[i] = chosen(below, stays, carried);
        carried = chosen(below, carried, stays);
    }
    m_sorted[4] = carried;
}

void LazTimes::start(std::uint64_t time) {
    m_sequences = {};
    m_sequences[0].time = time;
    m_now = m_newest = 0;
    // Layers have no code for a time that stays.
    const std::uint32_t fewer = m_layered ? 1 : 0;
    m_codes.start(timeIsWhole + sequencesMost - fewer);
    m_codesOfStill.start(2 + sequencesMost - fewer);
    m_whole.start();
}

std::uint64_t LazTimes::decode(ArithmeticDecoder& decoder) {
    // A sound file changes the sequence once at most before it tells the time.
    for (std::uint32_t changes = 0; changes < sequencesMost && !step(decoder); ++changes) {
    }
    return m_sequences[m_now].time;
}

/// @return false: another sequence goes on, and its step follows
bool LazTimes::step(ArithmeticDecoder& decoder) {
    Sequence& now = m_sequences[m_now];
    const bool still = now.difference == 0;
    std::uint32_t code = decoder.symbol(still ? m_codesOfStill : m_codes);
    code += m_layered && (still || code >= timeStays) ? 1 : 0;
    const std::uint32_t whole = still ? 2 : timeIsWhole;
    if (code > whole) {
        m_now = (m_now + code - whole) % sequencesMost;
        return false;
    }
    if (code == whole) {
        takeWhole(decoder);
    } else if (!still) {
        addDifference(decoder, code);
    } else if (code == 1) {
        now.difference = m_whole.decode(decoder, 0, 0);
        now.time += static_cast<std::uint64_t>(std::int64_t{now.difference});
        now.extremes = 0;
    }
    return true;
}

void LazTimes::takeWhole(ArithmeticDecoder& decoder) {
    const auto upper = static_cast<std::int32_t>(m_sequences[m_now].time >> 32);
    m_newest = (m_newest + 1) % sequencesMost;
    const auto high = static_cast<std::uint32_t>(m_whole.decode(decoder, upper, 8));
    m_sequences[m_newest] = {std::uint64_t{high} << 32 | decoder.bits(32), 0, 0};
    m_now = m_newest;
}

void LazTimes::addDifference(ArithmeticDecoder& decoder, std::uint32_t code) {
    if (code == timeStays) {
        return;
    }
    Sequence& now = m_sequences[m_now];
    auto factor = static_cast<std::int32_t>(code);
    std::uint32_t context = code < 10 ? 2 : 3;
    bool extreme = false;
    if (code == 0) {
        context = 7;
        extreme = true;
    } else if (code == 1) {
        context = 1;
        now.extremes = 0;
    } else if (code == multipleMost) {
        context = 4;
        extreme = true;
    } else if (code > multipleMost) {
        factor = static_cast<std::int32_t>(multipleMost) - factor;
        extreme = code == multipleMost + multipleLeast;
        context = extreme ? 6 : 5;
    }
    const std::int32_t difference = m_whole.decode(decoder, multiple(now.difference, factor), context);
    now.time += static_cast<std::uint64_t>(std::int64_t{difference});
    if (extreme) {
        countExtreme(difference);
    }
}

/// Four differences that are no small multiples make a new one to count by.
void LazTimes::countExtreme(std::int32_t difference) {
    Sequence& now = m_sequences[m_now];
    if (++now.extremes > 3) {
        now.difference = difference;
        now.extremes = 0;
    }
}

void LazColours::start() {
    m_changed.start(128);
    for (SymbolModel& model : m_differences) {
        model.start(256);
    }
}

LazColours::Colour LazColours::decode(ArithmeticDecoder& decoder, const Colour& last) {
    const std::uint32_t changed = decoder.symbol(m_changed);
    Colour colour{};
    std::array<std::array<std::uint32_t, 2>, 3> bytes{};
    const auto lastByte = [&](std::size_t channel, std::size_t half) {
        return half == 0 ? last[channel] & 0xffU : static_cast<std::uint32_t>(last[channel] >> 8);
    };
    const auto decoded = [&](std::size_t model, std::uint32_t expected) {
        return (decoder.symbol(m_differences[model]) + expected) & 0xffU;
    };
    for (std::size_t half = 0; half < 2; ++half) {
        bytes[0][half] = (changed >> half & 1) != 0 ? decoded(half, lastByte(0, half)) : lastByte(0, half);
    }
    // Grey where the seventh bit says so.
    bytes[1] = bytes[2] = bytes[0];
    for (std::size_t half = 0; half < 2 && (changed & 64) != 0; ++half) {
        auto change = static_cast<std::int32_t>(bytes[0][half]) - static_cast<std::int32_t>(lastByte(0, half));
        for (std::size_t channel = 1; channel < 3; ++channel) {
            const std::uint32_t before = lastByte(channel, half);
            const std::size_t model = 2 * channel + half;
            bytes[channel][half] = (changed >> model & 1) != 0 ? decoded(model, foretold(before, change)) : before;
            change = (change + static_cast<std::int32_t>(bytes[1][half]) - static_cast<std::int32_t>(lastByte(1, half))) / 2;
        }
    }
    for (std::size_t channel = 0; channel < 3; ++channel) {
        colour[channel] = static_cast<std::uint16_t>(bytes[channel][0] | bytes[channel][1] << 8);
    }
    return colour;
}

}  // namespace rubble::io
