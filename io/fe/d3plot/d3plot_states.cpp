#include "io/fe/d3plot/d3plot_states.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/error.h"
#include "io/fe/series/later_branch.h"

namespace rubble::io {

namespace {

/// Adds up lengths that a damaged file may make as large as it likes; more than the family holds is an error.
class Counter {
public:
    explicit Counter(const D3plotFamily& family) : m_family(family) {}

    /// Adds count * width and gives the place before.
    std::int64_t add(std::int64_t count, std::int64_t width = 1) {
        const std::int64_t place = m_words;
        std::int64_t words = 0;
        if (__builtin_mul_overflow(count, width, &words) || __builtin_add_overflow(m_words, words, &m_words) ||
            m_words > mostWords) {
            throw ParseError({"d3plot.huge_state",
                              "{0}: a state would take more than {1} words; the files have {2}",
                              {m_family.path(), mostWords, m_family.words()}},
                             {"d3plot.bad_word.remedy", "The file is damaged, or no d3plot: copy it again.", {}});
        }
        return place;
    }

    std::int64_t words() const { return m_words; }

private:
    static constexpr std::int64_t mostWords = std::int64_t{1} << 40;

    const D3plotFamily& m_family;
    std::int64_t m_words = 0;
};

std::int64_t temperatures(std::int64_t thermal) {
    switch (thermal % 10) {
        case 0:
            return 0;
        case 1:
            return 1;
        case 2:
            return 1 + 3;
        default:
            return 3 + 3;
    }
}

/// Walks through the files and takes state after state.
class StateFinder {
public:
    StateFinder(const D3plotFamily& family, const D3plotGeometry& geometry, const D3plotStateLayout& layout,
                const Execution& execution)
        : m_family(family), m_layout(layout), m_execution(execution), m_word(geometry.end) {
        for (std::size_t file = 0; file < family.files(); ++file) {
            m_longest = std::max(m_longest, family.wordsOf(file));
            m_lastFilled = family.wordsOf(file) > 0 ? file : m_lastFilled;
        }
    }

    D3plotStates find() {
        const Message stage{"d3plot.states", "Finding the states", {}};
        while (!m_done && m_word < m_family.words()) {
            m_execution.report(stage, static_cast<double>(m_word) / static_cast<double>(m_family.words()));
            step();
        }
        m_execution.report(stage, 1.0);
        noteEmptyFiles();
        keepLaterBranch();
        return std::move(m_states);
    }

private:
    void step() {
        const std::size_t file = m_family.fileOf(m_word);
        const std::int64_t next = m_family.firstWord(file + 1);
        const double time = m_family.readFloat(m_word);
        if (isEndMark(time)) {
            m_word = next;
            return;
        }
        // A state that fits into no file of the family goes on in the next ones; one that would fit is cut off.
        const bool spans = m_layout.words > m_longest && next - m_word < m_layout.words;
        const std::int64_t available = (spans ? m_family.words() : next) - m_word;
        if (available < m_layout.words) {
            leftOver(file, next, time);
            return;
        }
        if (padding(time)) {
            m_word = next;
            return;
        }
        if (!spans && ofAnotherLength(file, next)) {
            noteForeign(m_family.placeOf(m_word));
            m_word = next;
            return;
        }
        take(time);
    }

    void noteForeign(const std::string& place) {
        m_states.findings.add({"d3plot.foreign_file", "Files whose states have another length were left out", {}},
                              {"d3plot.cut_state.remedy", "Copy the files again; check that all are of one analysis.", {}}, place);
    }

    // A file that was written to its end, where the end does not follow a whole state; asked once for each file.
    bool ofAnotherLength(std::size_t file, std::int64_t next) {
        if (m_judged != file) {
            m_judged = file;
            m_foreign = !endsWithMark(next) && closed(next);
        }
        return m_foreign;
    }

    // Whole states from here to the end mark of the file, or to its last word.
    bool endsWithMark(std::int64_t next) const {
        const std::int64_t left = (next - m_word) % m_layout.words;
        for (std::int64_t word = m_word + m_layout.words; word < next; word += m_layout.words) {
            if (isEndMark(m_family.readFloat(word))) {
                return true;
            }
        }
        return left == 0;
    }

    // The end mark of a file of the other word length or byte order, as the words of this family hold it.
    bool isEndMarkOfOtherWords(double word) const {
        constexpr std::uint32_t single = 0xc97423f0u, highOfDouble = 0xc12e847eu;
        const auto isMark = [](std::uint32_t bits) {
            return bits == single || bits == highOfDouble || bits == __builtin_bswap32(single) ||
                   bits == __builtin_bswap32(highOfDouble);
        };
        if (m_family.format().bytes == sizeof(float)) {
            return isMark(std::bit_cast<std::uint32_t>(static_cast<float>(word)));
        }
        const auto bits = std::bit_cast<std::uint64_t>(word);
        return isMark(static_cast<std::uint32_t>(bits)) || isMark(static_cast<std::uint32_t>(bits >> 32));
    }

    // Whether the last word of a file that is not zero is the end mark: then all of it was written.
    bool closed(std::int64_t next) const {
        constexpr std::int64_t wordsAtOnce = 8192;
        std::vector<double> words;
        for (std::int64_t end = next; end > m_word; end -= static_cast<std::int64_t>(words.size())) {
            words.resize(static_cast<std::size_t>(std::min(wordsAtOnce, end - m_word)));
            m_family.readFloats(end - static_cast<std::int64_t>(words.size()), words);
            const auto last = std::find_if(words.rbegin(), words.rend(), [](double word) { return word != 0.0; });
            if (last != words.rend()) {
                return isEndMark(*last) || isEndMarkOfOtherWords(*last);
            }
        }
        return false;
    }

    // What is left of a file after its last state: zeros fill it up, anything else is a state that was not written whole.
    void leftOver(std::size_t file, std::int64_t next, double time) {
        if (time != 0.0 || m_family.firstWord(file) == m_word) {
            const bool spans = m_layout.words > m_longest, last = file == m_lastFilled || spans;
            const std::string place = m_family.placeOf(m_word) + ": " + englishInteger(next - m_word) + " of " +
                                      englishInteger(m_layout.words) + " words";
            if (!spans && closed(next)) {
                noteForeign(place);
            } else if (last) {
                m_states.findings.add({"d3plot.incomplete", "The last state is not complete and was left out", {}},
                                      {"d3plot.incomplete.remedy", "Open the result again once the analysis has gone on.", {}},
                                      place);
            } else {
                noteCutState(place);
            }
            m_done = spans;
        }
        m_word = next;
    }

    void noteCutState(const std::string& place) {
        m_states.findings.add(
            {"d3plot.cut_state", "A state within the series is cut off or of another length; it was left out", {}},
            {"d3plot.cut_state.remedy", "Copy the files again; check that all are of one analysis.", {}}, place);
    }

    // Files that were made and not filled, or lost in copying: nothing of their states stands anywhere.
    void noteEmptyFiles() {
        for (std::size_t file = 0; file < m_family.files(); ++file) {
            if (m_family.wordsOf(file) > 0) {
                continue;
            }
            if (file < m_lastFilled) {
                noteCutState(m_family.fileName(file) + ": 0 of " + englishInteger(m_layout.words) + " words");
            } else {
                m_states.findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                                      {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}},
                                      m_family.fileName(file));
            }
        }
    }

    // Zeros that fill up a file may be longer than a state of a small model.
    bool padding(double time) const {
        if (time != 0.0 || m_states.times.empty()) {
            return false;
        }
        std::vector<double> values(static_cast<std::size_t>(std::min<std::int64_t>(m_layout.words, 65536)));
        m_family.readFloats(m_word, values);
        return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
    }

    void keepLaterBranch() {
        const std::vector<std::size_t> kept = laterBranch(m_states.times, m_states.findings);
        for (std::size_t k = 0; k < kept.size(); ++k) {
            m_states.begin[k] = m_states.begin[kept[k]];
            m_states.times[k] = m_states.times[kept[k]];
        }
        m_states.begin.resize(kept.size());
        m_states.times.resize(kept.size());
    }

    void take(double time) {
        const std::int64_t begin = m_word;
        m_word += m_layout.words;
        if (!std::isfinite(time)) {
            throw ParseError(
                {"d3plot.bad_time", "{0}: the time of state {1} is {2}", {m_family.placeOf(begin), m_states.times.size(), time}},
                {"d3plot.bad_word.remedy", "The file is damaged, or no d3plot: copy it again.", {}});
        }
        m_states.begin.push_back(begin);
        m_states.times.push_back(time);
    }

    const D3plotFamily& m_family;
    const D3plotStateLayout& m_layout;
    const Execution& m_execution;
    std::int64_t m_word;
    std::int64_t m_longest = 0;
    std::size_t m_lastFilled = 0;  // the last file that is not empty
    std::size_t m_judged = std::numeric_limits<std::size_t>::max();
    bool m_foreign = false;
    bool m_done = false;
    D3plotStates m_states;
};

}  // namespace

D3plotStateLayout layoutOfStates(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry) {
    Counter counter(family);
    D3plotStateLayout layout;
    const std::int64_t nodes = header.nodes;
    counter.add(1 + header.globals);
    layout.coordinates = counter.add(header.coordinates > 0 ? 3 : 0, nodes);
    counter.add(temperatures(header.thermal) + (header.thermal / 10 % 10 == 1 ? 1 : 0), nodes);
    counter.add((header.derivatives % 10 == 1 ? 1 : 0) + (header.derivatives / 10 % 10 == 1 ? 6 : 0), nodes);
    counter.add(3 * header.penetration + (header.contactEnergy ? 1 : 0) + (header.kineticEnergy ? 1 : 0), nodes);
    layout.velocities = counter.add(header.velocities ? 3 : 0, nodes);
    counter.add(header.accelerations ? 3 : 0, nodes);
    counter.add(header.solidThermal, header.solids);
    layout.solids = counter.add(header.solids, header.solidWords);
    layout.thickShells = counter.add(header.thickShells, header.thickShellWords);
    layout.beams = counter.add(header.beams, header.beamWords);
    layout.shells = counter.add(header.shells - geometry.rigidShells, header.shellWords);
    layout.deletion = counter.add(0);
    if (header.deletion == DeletionTable::Nodes) {
        counter.add(nodes);
    } else if (header.deletion == DeletionTable::Elements) {
        counter.add(header.solids + header.thickShells + header.shells + header.beams);
    }
    layout.particles = counter.add(header.particles, geometry.particleWords);
    counter.add(geometry.airbagWords);
    counter.add(geometry.roadWords);
    layout.words = counter.words();
    return layout;
}

D3plotStates findD3plotStates(const D3plotFamily& family, const D3plotGeometry& geometry, const D3plotStateLayout& layout,
                              const Execution& execution) {
    return StateFinder(family, geometry, layout, execution).find();
}

}  // namespace rubble::io
