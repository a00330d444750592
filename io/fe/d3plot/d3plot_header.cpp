#include "io/fe/d3plot/d3plot_header.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/error.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/fe_format.h"

namespace rubble::io {

namespace {

// Words of the control block, by the names of the format's manual.
enum Word : std::size_t {
    FILETYPE = 11,
    NDIM = 15,
    NUMNP,
    ICODE,
    NGLBV,
    IT,
    IU,
    IV,
    IA,
    NEL8,
    NUMMAT8,
    NUMDS,
    NUMST,
    NV3D,
    NEL2,
    NUMMAT2,
    NV1D,
    NEL4,
    NUMMAT4,
    NV2D,
    NEIPH,
    NEIPS,
    MAXINT,
    NMSPH,
    NGPSPH,
    NARBS,
    NELT,
    NUMMATT,
    NV3DT,
    IOSHL,
    IALEMAT = 47,
    NCFDV1,
    NCFDV2,
    NADAPT,
    NMMAT,
    NPEFG = 54,
    NEL48,
    IDTDT,
    EXTRA,
    NEL20 = 64,
    NT3D,
    NEL27,
    NEL21P = 68,
    NEL15T,
    QUADR = 74,
    CUBIC,
    PENOUT = 78,
    ENGOUT,
    KINENG = 81
};

constexpr std::size_t controlWords = 64;
constexpr std::size_t longestExtra = 4096;
constexpr std::size_t knownWords = 82;
constexpr std::int64_t airbagLimit = 10'000'000;

// Kinds of the database by the last digits of the file type.
const char* kindOf(std::int64_t type) {
    switch (type) {
        case 2:
            return "a d3drlf file (dynamic relaxation)";
        case 3:
            return "a d3thdt file (time histories)";
        case 4:
            return "an intfor file (interface forces)";
        case 6:
            return "a blast file";
        case 7:
            return "a cpm file (airbag particles)";
        case 11:
            return "a d3eigv file (eigenvectors)";
        default:
            return nullptr;
    }
}

struct Reading {
    WordFormat format;
    std::array<std::int64_t, controlWords> words{};

    bool plot() const {
        if (words[FILETYPE] <= -2000 || words[FILETYPE] >= 2000) {
            return false;
        }
        const std::int64_t type = std::abs(words[FILETYPE]) % 1000;
        return (type == 1 || type == 5) && shaped();
    }
    bool shaped() const { return words[NDIM] >= 2 && words[NDIM] <= 9 && words[NUMNP] >= 0; }
    // Relatives are told apart from other binary files by more of their words.
    bool relative() const {
        const bool counts =
            std::all_of(words.begin() + NGLBV, words.begin() + IA + 1, [](std::int64_t w) { return w >= 0 && w < 100000000; });
        return kindOf(words[FILETYPE]) && shaped() && words[NUMNP] > 0 && (words[ICODE] == 6 || words[ICODE] == 2) && counts;
    }
};

std::optional<Reading> readingOf(const FileHead& head, bool (Reading::*fits)() const) {
    for (const std::int64_t bytes : {4, 8}) {
        for (const bool bigEndian : {false, true}) {
            Reading reading{{bytes, bigEndian}, {}};
            if (head.packed || hasOtherSignature(head) || head.bytes.size() < controlWords * static_cast<std::size_t>(bytes)) {
                continue;
            }
            const auto* data = reinterpret_cast<const unsigned char*>(head.bytes.data());
            for (std::size_t w = 0; w < controlWords; ++w) {
                reading.words[w] = integerOfWord(data + w * static_cast<std::size_t>(bytes), reading.format);
            }
            if ((reading.*fits)()) {
                return reading;
            }
        }
    }
    return std::nullopt;
}

/// The words of one control block, checked one by one.
class HeaderReader {
public:
    explicit HeaderReader(const D3plotFamily& family) : m_family(family) {
        require(controlWords, "the control block");
        m_words.resize(controlWords);
        m_family.readIntegers(0, m_words);
        const std::int64_t extra = m_words[EXTRA];
        if (extra < 0 || extra > static_cast<std::int64_t>(longestExtra)) {
            fail(EXTRA, "the length of the extension", "0 to 4,096");
        }
        require(static_cast<std::int64_t>(controlWords) + extra, "the control block and its extension");
        m_words.resize(controlWords + static_cast<std::size_t>(extra));
        m_family.readIntegers(0, m_words);
        m_size = static_cast<std::int64_t>(m_words.size());
        m_words.resize(std::max(m_words.size(), knownWords), 0);
    }

    D3plotHeader read() {
        refuseForeign();
        D3plotHeader header;
        header.title = shownName(m_family.readText(0, 10));
        header.words = m_size;
        header.fileType = m_words[FILETYPE];
        header.wideIds = header.fileType > 1000;
        header.dimension = m_words[NDIM];
        readCounts(header);
        readOutput(header);
        readDeletion(header);
        return header;
    }

private:
    void require(std::int64_t words, const std::string& what) const {
        if (m_family.words() < words) {
            throw ParseError({"d3plot.cut_header",
                              "{0} is cut off: {1} takes {2} bytes, the file has {3}",
                              {m_family.path(), what, words * m_family.format().bytes, m_family.words() * m_family.format().bytes}},
                             {"d3plot.cut.remedy", "Copy the file again, or wait until the analysis has written it.", {}});
        }
    }

    [[noreturn]] void fail(std::size_t word, const std::string& what, const std::string& expected) const {
        throw ParseError(
            {"d3plot.bad_word",
             "{0}: {1} (word {2}, {3}) is {4}; expected: {5}",
             {m_family.path(), what, word, m_family.placeOf(static_cast<std::int64_t>(word)), m_words[word], expected}},
            {"d3plot.bad_word.remedy", "The file is damaged, or no d3plot: copy it again.", {}});
    }

    [[noreturn]] void refuse(std::size_t word, const std::string& what, const std::string& remedy) const {
        throw ParseError(
            {"d3plot.refused", "{0} {1}, which cannot be read (word {2} is {3})", {m_family.path(), what, word, m_words[word]}},
            {"d3plot.refused.remedy", "{0}", {remedy}});
    }

    void refuseForeign() const {
        const std::int64_t type = m_words[FILETYPE];
        if (const char* kind = kindOf(type)) {
            refuse(FILETYPE, std::string("is ") + kind, "Give the d3plot of the analysis.");
        }
        if (type < 0) {
            refuse(FILETYPE, "was written with *DATABASE_EXTENT_BINARY_COMP and leaves out parts of the states",
                   "Run the analysis without it.");
        }
        const std::int64_t dimension = m_words[NDIM];
        if (dimension == 2) {
            refuse(NDIM, "has two dimensions", "Give a three-dimensional analysis.");
        }
        if (dimension == 3) {
            refuse(NDIM, "packs three node numbers into a word, as very old versions did", "Write it with a newer version.");
        }
        if (dimension == 8 || dimension == 9) {
            refuse(NDIM, "leaves out the nodes of rigid bodies", "Write it without the rigid body data (*DATABASE_BINARY_D3PLOT).");
        }
        if (m_words[NCFDV1] != 0 || m_words[NCFDV2] != 0) {
            refuse(NCFDV1, "has flow variables", "Write it without them.");
        }
        if (m_words[QUADR] > 0 || m_words[CUBIC] > 0 || m_words[NEL27] > 0 || m_words[NEL21P] > 0 || m_words[NEL15T] > 0) {
            refuse(QUADR, "has elements of higher order in full", "Write it without QUADR in *DATABASE_EXTENT_BINARY.");
        }
    }

    // A count of things that take at least one word each, in the geometry or in every state.
    std::int64_t count(std::size_t word, const char* what) const {
        if (m_words[word] < 0 || m_words[word] > m_family.words()) {
            fail(word, what, "0 to " + englishInteger(m_family.words()) + ", the words of all files");
        }
        return m_words[word];
    }

    void readCounts(D3plotHeader& header) const {
        header.nodes = count(NUMNP, "the number of nodes");
        header.tenNodes = m_words[NEL8] < 0;
        if (m_words[NEL8] < -m_family.words() || m_words[NEL8] > m_family.words()) {
            fail(NEL8, "the number of solids", "at most " + englishInteger(m_family.words()) + ", the words of all files");
        }
        header.solids = std::abs(m_words[NEL8]);
        header.beams = count(NEL2, "the number of beams");
        header.shells = count(NEL4, "the number of shells");
        header.thickShells = count(NELT, "the number of thick shells");
        header.particles = count(NMSPH, "the number of particles");
        header.idWords = count(NARBS, "the length of the numbers");
        header.fluidMaterials = count(IALEMAT, "the number of fluid materials");
        header.adapted = count(NADAPT, "the number of adapted elements");
        // The word on airbags says in its millions that there are discrete elements instead.
        header.discreteSpheres = m_words[NPEFG] > airbagLimit;
        header.airbags = header.discreteSpheres ? 0 : count(NPEFG, "the word on airbags");
        header.eightNodeShells = count(NEL48, "the number of shells of eight nodes");
        header.twentyNodeSolids = count(NEL20, "the number of solids of twenty nodes");
        header.parts = count(NMMAT, "the number of parts");
        if (header.parts == 0) {
            header.parts =
                count(NUMMAT8, "the number of materials of solids") + count(NUMMAT2, "the number of materials of beams") +
                count(NUMMAT4, "the number of materials of shells") + count(NUMMATT, "the number of materials of thick shells") +
                count(NGPSPH, "the number of materials of particles");
        }
    }

    void readOutput(D3plotHeader& header) const {
        header.globals = count(NGLBV, "the number of global values");
        header.thermal = count(IT, "the word on temperatures");
        header.coordinates = m_words[IU];
        if (header.coordinates < 0 || header.coordinates > 2) {
            fail(IU, "the word on coordinates", "0, 1 or 2");
        }
        header.velocities = m_words[IV] != 0;
        header.accelerations = m_words[IA] != 0;
        header.solidWords = count(NV3D, "the number of values of a solid");
        header.beamWords = count(NV1D, "the number of values of a beam");
        header.shellWords = count(NV2D, "the number of values of a shell");
        header.thickShellWords = count(NV3DT, "the number of values of a thick shell");
        header.solidExtra = count(NEIPH, "the number of history variables of a solid");
        header.shellExtra = count(NEIPS, "the number of history variables of a shell");
        for (std::size_t i = 0; i < 4; ++i) {
            header.shellOutput[i] = m_words[IOSHL + i] == 1000;
        }
        header.derivatives = count(IDTDT, "the word on derivatives");
        header.solidThermal = count(NT3D, "the number of thermal values of a solid");
        header.penetration = count(PENOUT, "the word on penetration");
        if (header.penetration > 2) {
            fail(PENOUT, "the word on penetration", "0, 1 or 2");
        }
        header.contactEnergy = m_words[ENGOUT] > 0;
        header.kineticEnergy = m_words[KINENG] > 0;
    }

    // The number of points through the thickness carries the option as well.
    void readDeletion(D3plotHeader& header) const {
        constexpr std::int64_t elementTable = 10000;
        const std::int64_t points = m_words[MAXINT];
        if (points < -2 * elementTable || points > 2 * elementTable) {
            fail(MAXINT, "the number of points through the thickness", "-20,000 to 20,000");
        }
        if (std::abs(points) >= elementTable) {
            header.deletion = DeletionTable::Elements;
            header.points = std::abs(points) - elementTable;
        } else {
            header.deletion = points < 0 ? DeletionTable::Nodes : DeletionTable::None;
            header.points = std::abs(points);
        }
    }

    const D3plotFamily& m_family;
    std::vector<std::int64_t> m_words;
    std::int64_t m_size = 0;
};

}  // namespace

bool recognisesD3plot(const FileHead& head) {
    return readingOf(head, &Reading::plot) || readingOf(head, &Reading::relative);
}

std::optional<WordFormat> d3plotWordFormat(const FileHead& head) {
    for (const auto fits : {&Reading::plot, &Reading::relative}) {
        if (const auto reading = readingOf(head, fits)) {
            return reading->format;
        }
    }
    return std::nullopt;
}

D3plotHeader readD3plotHeader(const D3plotFamily& family) {
    return HeaderReader(family).read();
}

}  // namespace rubble::io
