#include "io/fe/abaqus/input_deck.h"
#include "io/fe/ansys/cdb_file.h"
#include "io/fe/series/death_list.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Reads any bytes as an input deck, as a macro with kills and as a list of deaths.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzFile(bytes, size, "deck.txt", [](const std::string& path) {
        std::vector<double> times;
        Findings findings;
        io::readKills(path, times, findings);
        try {
            io::readDeathList(path);
        } catch (const Error&) {
        }
        const io::InputDeck deck = io::readInputDeck(path);
        for (std::int64_t element = 0; element < 100; ++element) {
            if (const io::DeckSection* section = deck.sectionOf(element)) {
                deck.densityOf(*section);
            }
        }
        return FeResult::Contents{};
    });
    return 0;
}
