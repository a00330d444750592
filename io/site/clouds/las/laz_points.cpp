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
    m_changeModel.start(64);
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
        m_colour = colourAt(&m_last[static_cast<std::size_t>(m_layout.colour)]);
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

template <class Each>
void LazPoints::decodeSteps(const LasLayout& layout, bool rest, Each each) {
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeChanged(d); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeIntensityLength(d); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeMarks(d); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.m_x.decodeLength(d, p.m_echo.single); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeX(d); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeYLength(d); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeY(d); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeHeightLength(d); });
    each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeHeight(d); });
    if (layout.time >= 0) {
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_times.decodeCode(d); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_times.decodeLength(d); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.keepTime(p.m_times.decodeRest(d)); });
    }
    if (layout.colour >= 0) {
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_colours.decodeChanged(d, p.m_colour); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_colours.decodePart<0>(d); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_colours.decodePart<1>(d); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_colours.decodePart<2>(d); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_colours.decodePart<4>(d); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_colours.decodePart<3>(d); });
        each([](LazPoints& p, ArithmeticDecoder& d) { p.m_colours.decodePart<5>(d); });
        each([](LazPoints& p, ArithmeticDecoder&) { p.keepColour(); });
    }
    if (rest) {
        each([](LazPoints& p, ArithmeticDecoder& d) { p.decodeRest(d); });
    }
}

void LazPoints::decode(ArithmeticDecoder& decoder, unsigned char* record) {
    decodeSteps(m_layout, hasRest(), [&](auto step) { step(*this, decoder); });
    std::copy(m_last.begin(), m_last.end(), record);
}

template <std::size_t Count>
void LazPoints::decodeTogether(const std::array<LazPoints*, Count>& points, const std::array<ArithmeticDecoder*, Count>& decoders,
                               const std::array<unsigned char*, Count>& records) {
    decodeSteps(points[0]->m_layout, points[0]->hasRest(), [&](auto step) {
        for (std::size_t k = 0; k < Count; ++k) {
            step(*points[k], *decoders[k]);
        }
    });
    for (std::size_t k = 0; k < Count; ++k) {
        std::copy(points[k]->m_last.begin(), points[k]->m_last.end(), records[k]);
    }
}

template void LazPoints::decodeTogether<2>(const std::array<LazPoints*, 2>&, const std::array<ArithmeticDecoder*, 2>&,
                                           const std::array<unsigned char*, 2>&);
template void LazPoints::decodeTogether<3>(const std::array<LazPoints*, 3>&, const std::array<ArithmeticDecoder*, 3>&,
                                           const std::array<unsigned char*, 3>&);

void LazPoints::decodeChanged(ArithmeticDecoder& decoder) {
    m_changes = decoder.symbol(m_changeModel);
    if ((m_changes & 32) != 0) {
        m_last[echoesAt] = static_cast<unsigned char>(byContext(decoder, m_echoes, m_last[echoesAt]));
    }
    const std::uint32_t echo = m_last[echoesAt] & 7;
    const std::uint32_t echoes = m_last[echoesAt] >> 3 & 7;
    m_echo = {echoKinds[echoes][echo], echo > echoes ? echo - echoes : echoes - echo, echoes == 1 ? 1U : 0U};
}

void LazPoints::decodeIntensityLength(ArithmeticDecoder& decoder) {
    if ((m_changes & 16) != 0) {
        m_intensity.decodeLength(decoder, std::min(m_echo.kind, 3U));
    }
}

void LazPoints::decodeMarks(ArithmeticDecoder& decoder) {
    if (m_changes == 0) {
        return;
    }
    std::uint16_t& intensity = m_intensities[m_echo.kind];
    if ((m_changes & 16) != 0) {
        intensity = static_cast<std::uint16_t>(m_intensity.decodeRest(decoder, intensity));
    }
    putAt(&m_last[intensityAt], intensity);
    if ((m_changes & 8) != 0) {
        m_last[classAt] = static_cast<unsigned char>(byContext(decoder, m_classes, m_last[classAt]));
    }
    if ((m_changes & 4) != 0) {
        const std::size_t direction = m_last[echoesAt] >> 6 & 1;
        m_last[angleAt] = static_cast<unsigned char>(m_last[angleAt] + decoder.symbol(m_angles[direction]));
    }
    if ((m_changes & 2) != 0) {
        m_last[userAt] = static_cast<unsigned char>(byContext(decoder, m_users, m_last[userAt]));
    }
    if ((m_changes & 1) != 0) {
        const auto last = littleAt<std::uint16_t>(&m_last[pointSourceAt]);
        putAt(&m_last[pointSourceAt], static_cast<std::uint16_t>(m_pointSource.decode(decoder, last, 0)));
    }
}

void LazPoints::move(std::size_t at, std::int32_t step) {
    putAt(&m_last[at], littleAt<std::uint32_t>(&m_last[at]) + static_cast<std::uint32_t>(step));
}

void LazPoints::decodeX(ArithmeticDecoder& decoder) {
    RunningMedian& steps = m_stepsX[m_echo.kind];
    const std::int32_t step = m_x.decodeRest(decoder, steps.median());
    steps.add(step);
    move(0, step);
}

void LazPoints::decodeYLength(ArithmeticDecoder& decoder) {
    m_y.decodeLength(decoder, lengthContext(m_x.length(), 20, m_echo.single));
}

void LazPoints::decodeY(ArithmeticDecoder& decoder) {
    RunningMedian& steps = m_stepsY[m_echo.kind];
    const std::int32_t step = m_y.decodeRest(decoder, steps.median());
    steps.add(step);
    move(4, step);
}

void LazPoints::decodeHeightLength(ArithmeticDecoder& decoder) {
    m_z.decodeLength(decoder, lengthContext((m_x.length() + m_y.length()) / 2, 18, m_echo.single));
}

void LazPoints::decodeHeight(ArithmeticDecoder& decoder) {
    std::int32_t& height = m_heights[m_echo.level];
    height = m_z.decodeRest(decoder, height);
    putAt(&m_last[8], height);
}

void LazPoints::keepTime(std::uint64_t time) {
    putAt(&m_last[static_cast<std::size_t>(m_layout.time)], time);
}

void LazPoints::keepColour() {
    m_colour = m_colours.colour();
    putColour(&m_last[static_cast<std::size_t>(m_layout.colour)], m_colour);
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
