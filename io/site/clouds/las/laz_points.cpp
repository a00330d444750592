#include "io/site/clouds/las/laz_points.h"

#include <algorithm>
#include <cstdlib>

namespace rubble::io {

namespace {

// Offsets in the record of a point of the formats 0 to 5.
constexpr std::size_t intensityAt = 12;
constexpr std::size_t echoesAt = 14;
constexpr std::size_t classAt = 15;
constexpr std::size_t angleAt = 16;
constexpr std::size_t userAt = 17;
constexpr std::size_t pointSourceAt = 18;

template <class Number>
void putAt(unsigned char* bytes, Number number) {
    std::memcpy(bytes, &number, sizeof number);
}

/// The kind of an echo by its number and those of its pulse: sound ones have kinds of their own, others share what is left.
/// The table of the specification of LASzip.
constexpr std::array<std::array<std::uint8_t, 8>, 8> echoKinds{{{15, 14, 13, 12, 11, 10, 9, 8},
                                                                {14, 0, 1, 3, 6, 10, 10, 9},
                                                                {13, 1, 2, 4, 7, 11, 11, 10},
                                                                {12, 3, 4, 5, 8, 12, 12, 11},
                                                                {11, 6, 7, 8, 9, 13, 13, 12},
                                                                {10, 10, 11, 12, 13, 14, 14, 13},
                                                                {9, 10, 11, 12, 13, 14, 15, 14},
                                                                {8, 9, 10, 11, 12, 13, 14, 15}}};

/// An even number of bits, at most so many, and one more for single echoes.
std::uint32_t lengthContext(std::uint32_t bits, std::uint32_t most, std::uint32_t single) {
    return std::min(bits & ~1U, most) + single;
}

}  // namespace

LazPoints::LazPoints(const LasHead& head)
    : m_layout(head.layout),
      m_last(head.recordBytes),
      m_echoes(256),
      m_classes(256),
      m_users(256),
      m_x(32, 2),
      m_y(32, 22),
      m_z(32, 20),
      m_intensity(16, 4),
      m_pointSource(16, 1),
      m_times(false),
      m_waveStep(32, 1),
      m_waveSize(32, 1),
      m_wavePoint(32, 1),
      m_waveAxis(32, 3),
      m_extra(head.recordBytes - head.layout.bytes) {}

void LazPoints::start(const unsigned char* first) {
    std::copy_n(first, m_last.size(), m_last.begin());
    putAt<std::uint16_t>(&m_last[intensityAt], 0);
    m_changed.start(64);
    for (std::vector<SymbolModel>* models : {&m_echoes, &m_classes, &m_users}) {
        for (SymbolModel& model : *models) {
            model.stop();
        }
    }
    for (SymbolModel& model : m_angles) {
        model.start(256);
    }
    for (IntegerDecoder* number :
         {&m_x, &m_y, &m_z, &m_intensity, &m_pointSource, &m_waveStep, &m_waveSize, &m_wavePoint, &m_waveAxis}) {
        number->start();
    }
    m_stepsX = m_stepsY = {};
    m_intensities = {};
    m_heights = {};
    if (m_layout.time >= 0) {
        m_times.start(littleAt<std::uint64_t>(&m_last[static_cast<std::size_t>(m_layout.time)]));
    }
    if (m_layout.colour >= 0) {
        m_colours.start();
    }
    if (m_layout.waves >= 0) {
        m_waveIndex.start(256);
        for (SymbolModel& model : m_waveOffsets) {
            model.start(4);
        }
    }
    m_lastWaveStep = 0;
    m_lastWaveCode = 0;
    for (SymbolModel& model : m_extra) {
        model.start(256);
    }
}

std::uint32_t LazPoints::byContext(ArithmeticDecoder& decoder, std::vector<SymbolModel>& models, unsigned char context) {
    SymbolModel& model = models[context];
    if (!model.started()) {
        model.start(256);
    }
    return decoder.symbol(model);
}

void LazPoints::decode(ArithmeticDecoder& decoder, unsigned char* record) {
    decodeMarks(decoder);
    decodeX(decoder);
    decodeY(decoder);
    decodeHeight(decoder);
    decodeTime(decoder);
    decodeColour(decoder);
    decodeRest(decoder);
    std::copy(m_last.begin(), m_last.end(), record);
}

void LazPoints::decodeBoth(std::array<LazPoints*, 2> points, std::array<ArithmeticDecoder*, 2> decoders,
                           std::array<unsigned char*, 2> records) {
    const auto each = [&](auto step) {
        (points[0]->*step)(*decoders[0]);
        (points[1]->*step)(*decoders[1]);
    };
    each(&LazPoints::decodeMarks);
    each(&LazPoints::decodeX);
    each(&LazPoints::decodeY);
    each(&LazPoints::decodeHeight);
    each(&LazPoints::decodeTime);
    each(&LazPoints::decodeColour);
    each(&LazPoints::decodeRest);
    for (std::size_t k = 0; k < points.size(); ++k) {
        std::copy(points[k]->m_last.begin(), points[k]->m_last.end(), records[k]);
    }
}

void LazPoints::decodeMarks(ArithmeticDecoder& decoder) {
    const std::uint32_t changed = decoder.symbol(m_changed);
    if ((changed & 32) != 0) {
        m_last[echoesAt] = static_cast<unsigned char>(byContext(decoder, m_echoes, m_last[echoesAt]));
    }
    const std::uint32_t echo = m_last[echoesAt] & 7;
    const std::uint32_t echoes = m_last[echoesAt] >> 3 & 7;
    m_echo = {echoKinds[echoes][echo], echo > echoes ? echo - echoes : echoes - echo, echoes == 1 ? 1U : 0U};
    if (changed != 0) {
        std::uint16_t& intensity = m_intensities[m_echo.kind];
        if ((changed & 16) != 0) {
            intensity = static_cast<std::uint16_t>(m_intensity.decode(decoder, intensity, std::min(m_echo.kind, 3U)));
        }
        putAt(&m_last[intensityAt], intensity);
        decodeChanged(decoder, changed);
    }
}

void LazPoints::decodeChanged(ArithmeticDecoder& decoder, std::uint32_t changed) {
    if ((changed & 8) != 0) {
        m_last[classAt] = static_cast<unsigned char>(byContext(decoder, m_classes, m_last[classAt]));
    }
    if ((changed & 4) != 0) {
        const std::size_t direction = m_last[echoesAt] >> 6 & 1;
        m_last[angleAt] = static_cast<unsigned char>(m_last[angleAt] + decoder.symbol(m_angles[direction]));
    }
    if ((changed & 2) != 0) {
        m_last[userAt] = static_cast<unsigned char>(byContext(decoder, m_users, m_last[userAt]));
    }
    if ((changed & 1) != 0) {
        const auto last = littleAt<std::uint16_t>(&m_last[pointSourceAt]);
        putAt(&m_last[pointSourceAt], static_cast<std::uint16_t>(m_pointSource.decode(decoder, last, 0)));
    }
}

void LazPoints::move(std::size_t at, std::int32_t step) {
    putAt(&m_last[at], littleAt<std::uint32_t>(&m_last[at]) + static_cast<std::uint32_t>(step));
}

void LazPoints::decodeX(ArithmeticDecoder& decoder) {
    RunningMedian& steps = m_stepsX[m_echo.kind];
    const std::int32_t step = m_x.decode(decoder, steps.median(), m_echo.single);
    steps.add(step);
    move(0, step);
}

void LazPoints::decodeY(ArithmeticDecoder& decoder) {
    RunningMedian& steps = m_stepsY[m_echo.kind];
    const std::int32_t step = m_y.decode(decoder, steps.median(), lengthContext(m_x.length(), 20, m_echo.single));
    steps.add(step);
    move(4, step);
}

void LazPoints::decodeHeight(ArithmeticDecoder& decoder) {
    std::int32_t& height = m_heights[m_echo.level];
    height = m_z.decode(decoder, height, lengthContext((m_x.length() + m_y.length()) / 2, 18, m_echo.single));
    putAt(&m_last[8], height);
}

void LazPoints::decodeTime(ArithmeticDecoder& decoder) {
    if (m_layout.time >= 0) {
        putAt(&m_last[static_cast<std::size_t>(m_layout.time)], m_times.decode(decoder));
    }
}

void LazPoints::decodeColour(ArithmeticDecoder& decoder) {
    if (m_layout.colour >= 0) {
        unsigned char* colour = &m_last[static_cast<std::size_t>(m_layout.colour)];
        putAt(colour, m_colours.decode(decoder, littleAt<LazColours::Colour>(colour)));
    }
}

void LazPoints::decodeRest(ArithmeticDecoder& decoder) {
    if (m_layout.waves >= 0) {
        decodeWave(decoder);
    }
    for (std::size_t e = 0; e < m_extra.size(); ++e) {
        unsigned char& byte = m_last[m_layout.bytes + e];
        byte = static_cast<unsigned char>(byte + decoder.symbol(m_extra[e]));
    }
}

void LazPoints::decodeWave(ArithmeticDecoder& decoder) {
    unsigned char* wave = &m_last[static_cast<std::size_t>(m_layout.waves)];
    constexpr std::size_t offsetAt = 1;
    constexpr std::size_t sizeAt = 9;
    constexpr std::size_t pointAt = 13;
    wave[0] = static_cast<unsigned char>(decoder.symbol(m_waveIndex));
    auto offset = littleAt<std::uint64_t>(wave + offsetAt);
    m_lastWaveCode = decoder.symbol(m_waveOffsets[m_lastWaveCode]);
    if (m_lastWaveCode == 1) {
        offset += littleAt<std::uint32_t>(wave + sizeAt);
    } else if (m_lastWaveCode == 2) {
        m_lastWaveStep = m_waveStep.decode(decoder, m_lastWaveStep, 0);
        offset += static_cast<std::uint64_t>(std::int64_t{m_lastWaveStep});
    } else if (m_lastWaveCode == 3) {
        offset = decoder.longBits();
    }
    putAt(wave + offsetAt, offset);
    putAt(wave + sizeAt, m_waveSize.decode(decoder, littleAt<std::int32_t>(wave + sizeAt), 0));
    putAt(wave + pointAt, m_wavePoint.decode(decoder, littleAt<std::int32_t>(wave + pointAt), 0));
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        unsigned char* at = wave + pointAt + 4 + 4 * std::size_t{axis};
        putAt(at, m_waveAxis.decode(decoder, littleAt<std::int32_t>(at), axis));
    }
}

}  // namespace rubble::io
