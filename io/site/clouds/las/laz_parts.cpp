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
std::int64_t chosen(std::int64_t mask, std::int64_t one, std::int64_t other) {
    return other ^ ((one ^ other) & mask);
}

/// One number of 32 bits less another where it is the lesser, else 0.
std::int64_t shortfall(std::int64_t one, std::int64_t other) {
    const std::int64_t beyond = one - other;
    return beyond & beyond >> 63;
}

}  // namespace

void RunningMedian::add(std::int32_t number) {
    // By masks: a compiler makes branches of conditions here, and no processor foretells them.
    const std::int64_t added = number;
    const std::array<std::int64_t, 5> old{m_sorted[0], m_sorted[1], m_sorted[2], m_sorted[3], m_sorted[4]};
    const std::int64_t greatest = m_dropGreatest;
    // By the side of the new one; at the median itself it is dropped on the other side than now.
    m_dropGreatest = static_cast<std::int32_t>((added - old[2] - (greatest + 1)) >> 63);
    // The four that stay, with the new one put between them.
    const std::array<std::int64_t, 4> stays{chosen(greatest, old[0], old[1]), chosen(greatest, old[1], old[2]),
                                            chosen(greatest, old[2], old[3]), chosen(greatest, old[3], old[4])};
    // Each place takes the lesser of what stays and what is to be put; the greater is put behind it.
    std::int64_t rest = added;
    for (std::size_t k = 0; k < stays.size(); ++k) {
        const std::int64_t less = stays[k] + shortfall(rest, stays[k]);
        m_sorted[k] = static_cast<std::int32_t>(less);
        rest += stays[k] - less;
    }
    m_sorted[4] = static_cast<std::int32_t>(rest);
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

void LazTimes::decodeCode(ArithmeticDecoder& decoder) {
    m_pending = Pending::Nothing;
    // A sound file changes the sequence once at most before it tells the time.
    for (std::uint32_t changes = 0; changes < sequencesMost && !step(decoder); ++changes) {
    }
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
        m_pending = Pending::Whole;
        m_context = 8;
        m_expected = static_cast<std::int32_t>(now.time >> 32);
    } else if (!still) {
        expectDifference(code);
    } else if (code == 1) {
        m_pending = Pending::First;
        m_context = 0;
        m_expected = 0;
    }
    return true;
}

std::uint64_t LazTimes::decodeRest(ArithmeticDecoder& decoder) {
    if (m_pending == Pending::Nothing) {
        return m_sequences[m_now].time;
    }
    const std::int32_t number = m_whole.decodeRest(decoder, m_expected);
    if (m_pending == Pending::Whole) {
        m_newest = (m_newest + 1) % sequencesMost;
        m_sequences[m_newest] = {std::uint64_t{static_cast<std::uint32_t>(number)} << 32 | decoder.bits(32), 0, 0};
        m_now = m_newest;
        return m_sequences[m_now].time;
    }
    Sequence& now = m_sequences[m_now];
    now.time += static_cast<std::uint64_t>(std::int64_t{number});
    if (m_pending == Pending::First) {
        now.difference = number;
        now.extremes = 0;
    } else if (m_pending == Pending::Extreme) {
        countExtreme(number);
    }
    return now.time;
}

void LazTimes::expectDifference(std::uint32_t code) {
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
    m_context = context;
    m_expected = multiple(now.difference, factor);
    m_pending = extreme ? Pending::Extreme : Pending::Multiple;
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

}  // namespace rubble::io
