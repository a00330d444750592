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
    /// Chunks that are unpacked at once in the least time.
    static constexpr std::size_t lanes = 3;
    /// The same of some chunks at once. Each symbol waits for the one before it in its chunk only, so that a processor works on
    /// all of them.
    /// @tparam Count  2 or 3 chunks
    template <std::size_t Count>
    static void decodeTogether(const std::array<LazPoints*, Count>& points, const std::array<ArithmeticDecoder*, Count>& decoders,
                               const std::array<unsigned char*, Count>& records);

private:
    // The steps of a point in their order, of one symbol each as a rule.
    void decodeChanged(ArithmeticDecoder& decoder);
    void decodeIntensityLength(ArithmeticDecoder& decoder);
    void decodeMarks(ArithmeticDecoder& decoder);
    void decodeX(ArithmeticDecoder& decoder);
    void decodeYLength(ArithmeticDecoder& decoder);
    void decodeY(ArithmeticDecoder& decoder);
    void decodeHeightLength(ArithmeticDecoder& decoder);
    void decodeHeight(ArithmeticDecoder& decoder);
    void keepTime(std::uint64_t time);
    void keepColour();
    void decodeRest(ArithmeticDecoder& decoder);
    template <class Each>
    static void decodeSteps(const LasLayout& layout, bool rest, Each each);
    bool hasRest() const { return m_layout.waves >= 0 || !m_extra.empty(); }

    void move(std::size_t at, std::int32_t step);
    void decodeWave(ArithmeticDecoder& decoder);
    std::uint32_t byContext(ArithmeticDecoder& decoder, std::vector<SymbolModel>& models, unsigned char context);

    /// How an echo is expected to lie: its kind by number and echoes, its level below the last one, whether it is the only one.
    struct Echo {
        std::uint32_t kind = 0;
        std::uint32_t level = 0;
        std::uint32_t single = 0;  ///< 1: it is
    };
    LasLayout m_layout;
    Echo m_echo;
    std::uint32_t m_changes = 0;        ///< bits of what the point has of its own
    std::vector<unsigned char> m_last;  ///< record of the last point; its intensity is 0 before the second one

    SymbolModel m_changeModel;
    std::vector<SymbolModel> m_echoes, m_classes, m_users;  ///< [256] by the last value
    std::array<SymbolModel, 2> m_angles;
    IntegerDecoder m_x, m_y, m_z, m_intensity, m_pointSource;
    std::array<RunningMedian, 16> m_stepsX, m_stepsY;
    std::array<std::uint16_t, 16> m_intensities{};
    std::array<std::int32_t, 8> m_heights{};

    LazTimes m_times;
    LazColours m_colours;
    std::uint64_t m_colour = 0;

    SymbolModel m_waveIndex;
    std::array<SymbolModel, 4> m_waveOffsets;
    IntegerDecoder m_waveStep, m_waveSize, m_wavePoint, m_waveAxis;
    std::int32_t m_lastWaveStep = 0;
    std::uint32_t m_lastWaveCode = 0;

    std::vector<SymbolModel> m_extra;  ///< [extra bytes]
};

}  // namespace rubble::io
