#include "io/site/clouds/las/laz_layers.h"

#include <algorithm>

namespace rubble::io {

namespace {

// Offsets in the record of a point of the formats 6 to 10.
constexpr std::size_t wideIntensityAt = 12;
constexpr std::size_t wideEchoesAt = 14;
constexpr std::size_t wideFlagsAt = 15;
constexpr std::size_t wideClassAt = 16;

/// The kind of an echo by its number and those of its pulse, one of six: first and last ones apart, others by how near the
/// last one they are, as the table of the specification of LASzip has it; the table is the same both ways.
std::size_t wideEchoKind(std::size_t echoes, std::size_t echo) {
    constexpr std::array<std::uint8_t, 16> unsound{0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5};
    const std::size_t low = std::min(echoes, echo);
    const std::size_t high = std::max(echoes, echo);
    if (low == 0) {
        return unsound[high];
    }
    if (low == 1) {
        return high < 3 ? high - 1 : 3;
    }
    if (low == 2) {
        return high == 2 ? 2 : high > 10 ? 3 : 4;
    }
    return high == low || (low > 10 && high == low + 1) ? 5 : 4;
}

std::size_t levelOf(std::size_t echoes, std::size_t echo) {
    return std::min<std::size_t>(echoes > echo ? echoes - echo : echo - echoes, 7);
}

std::uint32_t wideLengthContext(std::uint32_t bits, std::uint32_t most, bool single) {
    return std::min(bits & ~1U, most) + (single ? 1 : 0);
}

std::int32_t moved(std::int32_t from, std::int32_t step) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(from) + static_cast<std::uint32_t>(step));
}

std::uint32_t symbolOf(ArithmeticDecoder& decoder, SymbolModel& model, std::uint32_t symbols) {
    if (!model.started()) {
        model.start(symbols);
    }
    return decoder.symbol(model);
}

}  // namespace

struct LazLayers::Channel {
    std::int32_t x = 0, y = 0, z = 0;
    std::uint16_t intensity = 0;
    std::size_t echo = 0, echoes = 0, kind = 0;
    std::uint32_t flags = 0;  ///< class flags, scan direction, edge of flight line
    std::uint32_t number = 0;
    std::uint64_t time = 0;
    bool timeChanged = false;

    std::array<SymbolModel, 8> changes;
    SymbolModel channel, echoSteps;
    std::array<SymbolModel, 16> echoCounts, echoNumbers;
    IntegerDecoder stepX{32, 2}, stepY{32, 22}, height{32, 20}, brightness{16, 4};
    std::array<RunningMedian, 12> stepsX, stepsY;
    std::array<std::int32_t, 8> heights{};
    std::array<std::uint16_t, 8> intensities{};
    std::array<SymbolModel, 64> classes, flagSets;
    LazTimes times{true};

    /// First echo, last echo.
    std::size_t ends() const { return (echo == 1 ? 2U : 0U) + (echo >= echoes ? 1U : 0U); }
};

/// What is learned of colours in one scanner channel.
struct LazLayers::Palette {
    LazColours colours;
    std::uint64_t last = 0;
};

LazLayers::LazLayers(const LasHead& head, Turns turns) : m_layout(head.layout), m_recordBytes(head.recordBytes), m_turns(turns) {}

LazLayers::~LazLayers() = default;

bool LazLayers::kept(std::size_t layer) const {
    return layer <= Intensity || layer == Time || (layer == Colour && m_layout.colour >= 0);
}

bool LazLayers::openLayers(const CloudFile& file, std::uint64_t at) {
    // Lengths of all layers, those of colour, near infrared, wave forms and extra bytes behind the nine of the point.
    const bool near = m_layout.format == 8 || m_layout.format == 10;
    const std::size_t others =
        (near ? 1U : 0U) + (m_layout.waves >= 0 ? 1U : 0U) + (m_recordBytes - m_layout.bytes) + (m_layout.colour >= 0 ? 1U : 0U);
    std::vector<unsigned char> lengths(4 * (1 + std::size_t{Colour} + others));
    if (file.readSome(at, lengths.data(), lengths.size()) != lengths.size()) {
        return false;
    }
    m_points = littleAt<std::uint32_t>(lengths.data());
    at += lengths.size();
    for (std::size_t layer = 0; layer < Colour + others; ++layer) {
        const std::uint64_t bytes = littleAt<std::uint32_t>(&lengths[4 * (layer + 1)]);
        if (bytes > file.size() - at) {
            return false;
        }
        if (layer < m_layers.size()) {
            m_layers[layer].decoder.reset();
            m_layers[layer].bytes.reset();
            if (bytes > 0 && kept(layer)) {
                m_layers[layer].bytes.emplace(file, at, at + bytes);
                m_layers[layer].decoder.emplace(*m_layers[layer].bytes).start();
            }
        }
        at += bytes;
    }
    m_end = at;
    return true;
}

bool LazLayers::start(const CloudFile& file, std::uint64_t at, unsigned char* record) {
    if (file.readSome(at, record, m_recordBytes) != m_recordBytes || !openLayers(file, at + m_recordBytes)) {
        return false;
    }
    for (std::unique_ptr<Channel>& channel : m_channels) {
        channel.reset();
    }
    Channel first;
    first.x = littleAt<std::int32_t>(record);
    first.y = littleAt<std::int32_t>(record + 4);
    first.z = littleAt<std::int32_t>(record + 8);
    first.intensity = littleAt<std::uint16_t>(record + wideIntensityAt);
    first.echo = record[wideEchoesAt] & 15U;
    first.echoes = record[wideEchoesAt] >> 4U;
    // Class flags, then scan direction and edge; the scanner channel between them is kept apart.
    first.flags = (record[wideFlagsAt] & 15U) | (record[wideFlagsAt] >> 2U & 48U);
    first.number = record[wideClassAt];
    first.time = littleAt<std::uint64_t>(record + m_layout.time);
    m_now = m_colourNow = record[wideFlagsAt] >> 4U & 3U;
    startChannel(m_now, first);
    for (std::unique_ptr<Palette>& palette : m_palettes) {
        palette.reset();
    }
    if (m_layout.colour >= 0) {
        m_colour = colourAt(record + m_layout.colour);
        startPalette(m_now);
    }
    return true;
}

/// Every channel begins with the last point of that before it.
LazLayers::Channel& LazLayers::startChannel(std::size_t number, const Channel& from) {
    m_channels[number] = std::make_unique<Channel>();
    Channel& channel = *m_channels[number];
    channel.x = from.x;
    channel.y = from.y;
    channel.z = from.z;
    channel.intensity = from.intensity;
    channel.echo = from.echo;
    channel.echoes = from.echoes;
    channel.flags = from.flags;
    channel.number = from.number;
    channel.time = from.time;
    channel.heights.fill(from.z);
    channel.intensities.fill(from.intensity);
    channel.times.start(from.time);
    return channel;
}

LazLayers::Channel& LazLayers::channelOf(std::uint32_t changed) {
    if ((changed & 64) != 0) {
        Channel& last = *m_channels[m_now];
        m_now = (m_now + symbolOf(*m_layers[Place].decoder, last.channel, 3) + 1) % m_channels.size();
        if (m_channels[m_now] == nullptr) {
            startChannel(m_now, last);
        }
    }
    return *m_channels[m_now];
}

void LazLayers::decode(unsigned char* record) {
    const Channel& last = *m_channels[m_now];
    const std::size_t context = (last.echo == 1 ? 1U : 0U) + (last.echo >= last.echoes ? 2U : 0U) + (last.timeChanged ? 4U : 0U);
    const std::uint32_t changed = symbolOf(*m_layers[Place].decoder, m_channels[m_now]->changes[context], 128);
    Channel& channel = channelOf(changed);
    channel.timeChanged = (changed & 16) != 0;
    decodeEchoes(channel, changed, channel.timeChanged);
    decodeLayers(channel, (changed & 64) != 0);
    write(channel, record);
}

void LazLayers::decodeEchoes(Channel& channel, std::uint32_t changed, bool timeChanges) {
    ArithmeticDecoder& decoder = *m_layers[Place].decoder;
    if ((changed & 4) != 0) {
        channel.echoes = symbolOf(decoder, channel.echoCounts[channel.echoes], 16);
    }
    constexpr std::size_t numbers = 16;
    switch (changed & 3) {
        case 1:
            channel.echo = (channel.echo + 1) % numbers;
            break;
        case 2:
            channel.echo = (channel.echo + numbers - 1) % numbers;
            break;
        case 3:
            channel.echo = timeChanges ? symbolOf(decoder, channel.echoNumbers[channel.echo], numbers)
                                       : (channel.echo + symbolOf(decoder, channel.echoSteps, 13) + 2) % numbers;
            break;
        default:
            break;
    }
}

/// Layers take turns, symbol by symbol: each waits for the one before it in its layer only, so that a processor works on some.
void LazLayers::decodeLayers(Channel& channel, bool switched) {
    ArithmeticDecoder& place = *m_layers[Place].decoder;
    const bool single = channel.echoes == 1;
    const std::size_t ends = channel.ends();
    const std::size_t kind = 2 * wideEchoKind(channel.echoes, channel.echo) + (channel.timeChanged ? 1 : 0);
    Palette* const palette = paletteOf(switched);
    ArithmeticDecoder* const colour = palette != nullptr && m_layers[Colour].there() ? &*m_layers[Colour].decoder : nullptr;
    ArithmeticDecoder* const time = channel.timeChanged && m_layers[Time].there() ? &*m_layers[Time].decoder : nullptr;
    ArithmeticDecoder* const bright = m_layers[Intensity].there() ? &*m_layers[Intensity].decoder : nullptr;

    if (colour != nullptr) {
        palette->colours.decodeChanged(*colour, m_colour);
    }
    channel.stepX.decodeLength(place, single ? 1 : 0);
    if (bright != nullptr) {
        channel.brightness.decodeLength(*bright, static_cast<std::uint32_t>(ends));
    }
    if (colour != nullptr) {
        palette->colours.decodePart<0>(*colour);
    }
    const std::int32_t stepX = channel.stepX.decodeRest(place, channel.stepsX[kind].median());
    if (time != nullptr) {
        channel.times.decodeCode(*time);
    }
    if (colour != nullptr) {
        palette->colours.decodePart<1>(*colour);
    }
    channel.stepsX[kind].add(stepX);
    channel.x = moved(channel.x, stepX);
    channel.stepY.decodeLength(place, wideLengthContext(channel.stepX.length(), 20, single));
    if (bright != nullptr) {
        std::uint16_t& intensity = channel.intensities[2 * ends + (channel.timeChanged ? 1 : 0)];
        intensity = static_cast<std::uint16_t>(channel.brightness.decodeRest(*bright, intensity));
        channel.intensity = intensity;
    }
    if (colour != nullptr) {
        palette->colours.decodePart<2>(*colour);
    }
    const std::int32_t stepY = channel.stepY.decodeRest(place, channel.stepsY[kind].median());
    if (time != nullptr) {
        channel.times.decodeLength(*time);
    }
    if (colour != nullptr) {
        palette->colours.decodePart<4>(*colour);
    }
    channel.stepsY[kind].add(stepY);
    channel.y = moved(channel.y, stepY);
    std::int32_t& height = channel.heights[levelOf(channel.echoes, channel.echo)];
    const std::uint32_t bits = (channel.stepX.length() + channel.stepY.length()) / 2;
    if (m_layers[Height].there()) {
        channel.height.decodeLength(*m_layers[Height].decoder, wideLengthContext(bits, 18, single));
    }
    if (time != nullptr) {
        channel.time = channel.times.decodeRest(*time);
    }
    if (colour != nullptr) {
        palette->colours.decodePart<3>(*colour);
    }
    if (m_layers[Class].there()) {
        SymbolModel& model = channel.classes[(channel.number & 31U) * 2 + (ends == 3 ? 1 : 0)];
        channel.number = symbolOf(*m_layers[Class].decoder, model, 256);
    }
    if (m_layers[Height].there()) {
        height = channel.height.decodeRest(*m_layers[Height].decoder, height);
        channel.z = height;
    }
    if (colour != nullptr) {
        palette->colours.decodePart<5>(*colour);
        m_colour = palette->colours.colour();
    }
    if (palette != nullptr) {
        m_palettes[m_known]->last = m_colour;
    }
    if (m_layers[Flags].there()) {
        channel.flags = symbolOf(*m_layers[Flags].decoder, channel.flagSets[channel.flags], 64);
    }
}

void LazLayers::startPalette(std::size_t channel) {
    m_palettes[channel] = std::make_unique<Palette>();
    m_palettes[channel]->colours.start();
    m_palettes[channel]->last = m_colour;
}

/// What the colour of the next point is decoded by, from that which m_colour is then; null: there are no colours.
LazLayers::Palette* LazLayers::paletteOf(bool switched) {
    if (m_layout.colour < 0) {
        return nullptr;
    }
    const std::size_t channel = m_turns == Turns::Item3 && !switched ? 0 : m_now;
    m_known = m_turns == Turns::Item4 ? channel : m_colourNow;
    if (m_palettes[channel] == nullptr) {
        m_colour = m_palettes[m_colourNow]->last;
        startPalette(channel);
        m_known = channel;
    }
    m_colourNow = channel;
    m_colour = m_palettes[m_known]->last;
    return m_palettes[channel].get();
}

void LazLayers::write(const Channel& channel, unsigned char* record) const {
    std::fill_n(record, m_recordBytes, static_cast<unsigned char>(0));
    const auto put = [record](std::size_t at, const auto& number) { std::memcpy(record + at, &number, sizeof number); };
    put(0, channel.x);
    put(4, channel.y);
    put(8, channel.z);
    put(wideIntensityAt, channel.intensity);
    record[wideEchoesAt] = static_cast<unsigned char>(channel.echo | channel.echoes << 4U);
    record[wideFlagsAt] =
        static_cast<unsigned char>((channel.flags & 15U) | static_cast<std::uint32_t>(m_now) << 4U | (channel.flags & 48U) << 2U);
    record[wideClassAt] = static_cast<unsigned char>(channel.number);
    put(static_cast<std::size_t>(m_layout.time), channel.time);
    if (m_layout.colour >= 0) {
        putColour(record + m_layout.colour, m_colour);
    }
}

bool LazLayers::overrun() const {
    return std::any_of(m_layers.begin(), m_layers.end(), [](const Layer& layer) { return layer.bytes && layer.bytes->overrun(); });
}

}  // namespace rubble::io
