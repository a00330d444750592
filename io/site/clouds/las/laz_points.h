#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "io/site/clouds/las/las_head.h"
#include "io/site/clouds/las/laz_parts.h"

namespace rubble::io {

/// Decodes points of the formats 0 to 5 one after another, each from the one before, as LASzip 2 packs them.
class LazPoints {
public:
    explicit LazPoints(const LasHead& head);

    /// Begins a chunk. @param first  the record of its first point, which lies there as it is
    void start(const unsigned char* first);
    /// Writes the record of the next point.
    void decode(ArithmeticDecoder& decoder, unsigned char* record);

private:
    void decodePlace(ArithmeticDecoder& decoder, std::uint32_t echo, bool single);
    void decodeChanged(ArithmeticDecoder& decoder, std::uint32_t changed);
    void decodeWave(ArithmeticDecoder& decoder);
    std::uint32_t byContext(ArithmeticDecoder& decoder, std::vector<SymbolModel>& models, unsigned char context);

    LasLayout m_layout;
    std::vector<unsigned char> m_last;  ///< record of the last point; its intensity is 0 before the second one

    SymbolModel m_changed;
    std::vector<SymbolModel> m_echoes, m_classes, m_users;  ///< [256] by the last value
    std::array<SymbolModel, 2> m_angles;
    IntegerDecoder m_x, m_y, m_z, m_intensity, m_pointSource;
    std::array<RunningMedian, 16> m_stepsX, m_stepsY;
    std::array<std::uint16_t, 16> m_intensities{};
    std::array<std::int32_t, 8> m_heights{};

    LazTimes m_times;
    LazColours m_colours;

    SymbolModel m_waveIndex;
    std::array<SymbolModel, 4> m_waveOffsets;
    IntegerDecoder m_waveStep, m_waveSize, m_wavePoint, m_waveAxis;
    std::int32_t m_lastWaveStep = 0;
    std::uint32_t m_lastWaveCode = 0;

    std::vector<SymbolModel> m_extra;  ///< [extra bytes]
};

}  // namespace rubble::io
