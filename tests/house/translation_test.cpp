#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/places.h"
#include "translations/literals.h"

namespace rubble::house {

namespace {

namespace fs = std::filesystem;

struct Entry {
    std::string context;
    std::string source;
    std::string translation;
    bool unfinished = false;
};

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string unescaped(std::string text) {
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
            text.replace(at, from.size(), to);
        }
    }
    return text;
}

/// What stands between two marks, from a place on, which moves behind it; nothing if there is none before `end`.
std::string between(const std::string& text, const std::string& open, const std::string& close, std::size_t& at, std::size_t end) {
    const std::size_t start = text.find(open, at);
    if (start == std::string::npos || start >= end) {
        at = std::string::npos;
        return {};
    }
    const std::size_t stop = text.find(close, start + open.size());
    at = stop + close.size();
    return text.substr(start + open.size(), stop - start - open.size());
}

std::vector<Entry> entriesOf(const std::string& catalogue) {
    std::vector<Entry> entries;
    for (std::size_t at = catalogue.find("<context>"); at != std::string::npos; at = catalogue.find("<context>", at)) {
        const std::size_t end = catalogue.find("</context>", at);
        const std::string context = between(catalogue, "<name>", "</name>", at, end);
        for (std::size_t message = at; message != std::string::npos;) {
            const std::string body = between(catalogue, "<message", "</message>", message, end);
            if (message == std::string::npos) {
                break;
            }
            std::size_t inside = 0;
            Entry entry{context, unescaped(between(body, "<source>", "</source>", inside, body.size())), {}, false};
            const std::size_t translation = body.find("<translation", inside);
            const std::size_t words = body.find('>', translation);
            entry.unfinished = body.substr(translation, words - translation).find("type=") != std::string::npos;
            const std::size_t stop = body.find("</translation>", words);
            entry.translation = stop == std::string::npos ? std::string() : unescaped(body.substr(words + 1, stop - words - 1));
            entries.push_back(std::move(entry));
        }
        at = end;
    }
    return entries;
}

const fs::path& catalogue() {
    static const fs::path path = fs::path(sourcePath("translations/rubble_zh_CN.ts"));
    return path;
}

/// %1, %L1, {0}: which values a text has places for.
std::multiset<std::string> placesIn(const std::string& text) {
    static const std::regex place(R"(%L?\d|\{\d\}|%n)");
    std::multiset<std::string> places;
    for (std::sregex_iterator at(text.begin(), text.end(), place); at != std::sregex_iterator(); ++at) {
        places.insert(at->str());
    }
    return places;
}

std::multiset<std::string> tagsIn(const std::string& text) {
    static const std::regex tag(R"(</?[a-z][a-z0-9]*)");
    std::multiset<std::string> tags;
    for (std::sregex_iterator at(text.begin(), text.end(), tag); at != std::sregex_iterator(); ++at) {
        tags.insert(at->str());
    }
    return tags;
}

class TemporaryCatalogue {
public:
    TemporaryCatalogue() : m_folder(fs::temp_directory_path() / ("rubble-catalogue-" + std::to_string(::getpid()))) {
        fs::create_directories(m_folder);
    }
    ~TemporaryCatalogue() { fs::remove_all(m_folder); }
    fs::path file(const char* name) const { return m_folder / name; }

private:
    fs::path m_folder;
};

TEST(Translation, TheCatalogueHoldsExactlyWhatTheSourcesSay) {
    const TemporaryCatalogue folder;
    const fs::path phrases = folder.file("phrases_source.cpp");
    const fs::path updated = folder.file("rubble_zh_CN.ts");
    fs::copy_file(catalogue(), updated);
    const std::string root = sourcePath();
    const std::string collect = std::string(RUBBLE_PHRASES) + " " + root + " " + phrases.string() + " > /dev/null";
    ASSERT_EQ(std::system(collect.c_str()), 0);
    const std::string update = std::string(RUBBLE_LUPDATE) + " -silent -locations none -no-obsolete -I " + root + " " + root +
                               "/app/gui " + root + "/widgets " + phrases.string() + " -ts " + updated.string() + " 2> /dev/null";
    ASSERT_EQ(std::system(update.c_str()), 0);
    std::set<std::pair<std::string, std::string>> kept;
    for (const Entry& entry : entriesOf(contentOf(catalogue()))) {
        kept.emplace(entry.context, entry.source);
    }
    ASSERT_GT(kept.size(), 1500u);
    std::size_t there = 0;
    for (const Entry& entry : entriesOf(contentOf(updated))) {
        ++there;
        EXPECT_TRUE(kept.contains({entry.context, entry.source}))
            << "new in the sources, add it by `cmake --build BUILD -t translations`: " << entry.context << ": " << entry.source;
    }
    EXPECT_EQ(there, kept.size()) << "entries that the sources no longer have: run the target translations";
}

TEST(Translation, NothingIsUnfinished) {
    for (const Entry& entry : entriesOf(contentOf(catalogue()))) {
        EXPECT_FALSE(entry.unfinished) << entry.context << ": " << entry.source;
        EXPECT_FALSE(entry.translation.empty()) << entry.context << ": " << entry.source;
    }
}

TEST(Translation, PlacesOfValuesAndTagsAreThoseOfTheSource) {
    for (const Entry& entry : entriesOf(contentOf(catalogue()))) {
        EXPECT_EQ(placesIn(entry.source), placesIn(entry.translation)) << entry.source << " → " << entry.translation;
        EXPECT_EQ(tagsIn(entry.source), tagsIn(entry.translation)) << entry.source << " → " << entry.translation;
    }
}

// What stands on screen is said again in another language by looking it up: within one class the way back must be no guess.
TEST(Translation, NoTwoTextsOfAClassHaveOneTranslation) {
    std::map<std::pair<std::string, std::string>, std::string> sources;
    for (const Entry& entry : entriesOf(contentOf(catalogue()))) {
        if (entry.context != "messages" && entry.context != "options") {
            const auto [known, added] = sources.emplace(std::pair(entry.context, entry.translation), entry.source);
            EXPECT_TRUE(added) << entry.context << ": " << known->second << " and " << entry.source << " are both "
                               << entry.translation;
        }
    }
}

// Words that stand beside others keep the white space that parts them.
TEST(Translation, WhiteSpaceAtTheEndsIsThatOfTheSource) {
    for (const Entry& entry : entriesOf(contentOf(catalogue()))) {
        if (!entry.unfinished && !entry.source.empty() && !entry.source.ends_with(": ")) {
            EXPECT_EQ(entry.source.front() == ' ', entry.translation.front() == ' ') << entry.source;
            EXPECT_EQ(entry.source.back() == ' ', entry.translation.back() == ' ') << entry.source;
        }
    }
}

// The window says "fragments" by one word only; the list of terms stands in translations/README.md.
TEST(Translation, TermsOfTheGlossaryAreKept) {
    const std::string glossary = contentOf(fs::path(sourcePath("translations/README.md")));
    std::map<std::string, std::string> terms;
    const std::regex row(R"(\|([A-Za-z][^|]*)\|([^|]+)\|)");
    for (std::sregex_iterator at(glossary.begin(), glossary.end(), row); at != std::sregex_iterator(); ++at) {
        terms[(*at)[1].str()] = (*at)[2].str();
    }
    ASSERT_GT(terms.size(), 20u);
    for (const Entry& entry : entriesOf(contentOf(catalogue()))) {
        for (const auto& [english, chinese] : terms) {
            if (entry.source == english) {
                EXPECT_EQ(entry.translation, chinese) << entry.context << ": " << entry.source;
            }
        }
    }
}

TEST(Translation, LiteralsAreJoinedAndUnescaped) {
    const auto found =
        translations::literalsOf("f({\"a.b\", \"One \\\"two\\\" \"\n  \"three\", {}}); // \"no\"\n#include \"x.h\"\n");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].text, "One \"two\" three");
    EXPECT_EQ(found[1].before, "a.b");
    EXPECT_TRUE(translations::isPhrase(found[1]));
    EXPECT_FALSE(translations::isPhrase(found[0]));
}

}  // namespace

}  // namespace rubble::house
