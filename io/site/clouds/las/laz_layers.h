#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "io/site/clouds/las/las_head.h"
#include "io/site/clouds/las/laz_parts.h"

namespace rubble::io {

/// Decodes chunks of points of the formats 6 to 10, whose attributes lie in layers, as LASzip 3 packs them. Layers of what no
/// cloud keeps (scan angles, user bytes, point sources, near infrared, wave forms, extra bytes) are passed over.
class LazLayers {
public:
    /// How colours go on where points of several scanner channels take turns.
    enum class Turns : std::uint8_t {
        Item4,      ///< each channel by itself, as version 4 of the item has it
        Item3,      ///< as LASzip wrote version 3: in channel 0, but for the point that changes the channel
        OtherItem3  ///< as other programs write version 3: the point that changes the channel is told from the one before
    };
    LazLayers(const LasHead& head, Turns turns);
    ~LazLayers();

    /// Begins a chunk: reads its first point and the lengths of its layers.
    /// @param record  gets the first point
    /// @return false: the chunk does not fit into what is left of the file
    bool start(const CloudFile& file, std::uint64_t at, unsigned char* record);
    /// Points that the chunk says it has, the first among them; with another number a table of chunks is right.
    std::uint32_t points() const { return m_points; }
    /// Behind the chunk.
    std::uint64_t end() const { return m_end; }
    /// There are points behind the first one: no program packs them into nothing.
    bool holdsMore() const { return m_layers[Place].there(); }
    /// Writes the record of the next point, if there is one; what is passed over is 0.
    void decode(unsigned char* record);
    /// A layer ended before its points did.
    bool overrun() const;

private:
    /// What is learned of the points of one scanner channel.
    struct Channel;
    struct Palette;
    /// A layer with its decoder; one of no bytes says that nothing changes.
    struct Layer {
        std::optional<PackedBytes> bytes;
        std::optional<ArithmeticDecoder> decoder;
        bool there() const { return decoder.has_value(); }
    };
    enum LayerName : std::uint8_t { Place, Height, Class, Flags, Intensity, Angle, User, PointSource, Time, Colour, layerCount };

    bool kept(std::size_t layer) const;
    bool openLayers(const CloudFile& file, std::uint64_t at);
    Channel& startChannel(std::size_t number, const Channel& from);
    void startPalette(std::size_t channel);
    Channel& channelOf(std::uint32_t changed);
    void decodeEchoes(Channel& channel, std::uint32_t changed, bool timeChanges);
    void decodeLayers(Channel& channel, bool switched);
    Palette* paletteOf(bool switched);
    void write(const Channel& channel, unsigned char* record) const;

    LasLayout m_layout;
    std::size_t m_recordBytes;
    Turns m_turns;
    std::uint32_t m_points = 0;
    std::uint64_t m_end = 0;
    std::array<Layer, layerCount> m_layers;
    std::array<std::unique_ptr<Channel>, 4> m_channels;
    std::array<std::unique_ptr<Palette>, 4> m_palettes;
    std::size_t m_now = 0;
    std::size_t m_colourNow = 0;  ///< channel that colours are decoded by
    std::size_t m_known = 0;      ///< channel whose last colour the next one is told from
    std::uint64_t m_colour = 0;
};

}  // namespace rubble::io
