#include "core/scenario/setting_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/scenario/parameters.h"

namespace rubble {

namespace {

/// What lists of settings are joined by, in the languages of the catalogue.
constexpr std::array<std::string_view, 9> joints{", ", " or ", " and ", ", or ", "、", " 或 ", "或 ", " 和 ", "和 "};
/// What stands around a key alone.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> frames{
    {{"(", ")"}, {"（", "）"}, {"Set ", " to "}, {"set ", " to "}, {"将 ", " 设为 "}}};

bool isWordSign(char sign) {
    return (sign >= 'a' && sign <= 'z') || (sign >= 'A' && sign <= 'Z') || (sign >= '0' && sign <= '9') || sign == '_';
}

bool isKeySign(char sign) {
    return (sign >= 'a' && sign <= 'z') || sign == '_';
}

std::size_t endOf(std::string_view text, std::size_t from, bool (*belongs)(char)) {
    while (from < text.size() && belongs(text[from])) {
        ++from;
    }
    return from;
}

const Parameter* rowOf(std::string_view key) {
    const auto rows = parameterTable();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Parameter& row) { return row.key == key; });
    return found != rows.end() ? &*found : nullptr;
}

/// A stretch of a text: words as they are, or a setting.
struct Stretch {
    std::string plain;
    const Parameter* row = nullptr;
    std::string subject{};
    std::string value{};
    bool certain = true;  ///< false: perhaps a word

    bool names() const { return row != nullptr && certain; }
};

/// Takes a text apart.
class Scan {
public:
    explicit Scan(std::string_view text) : m_text(text) {}

    std::vector<Stretch> stretches() {
        while (m_at < m_text.size()) {
            const std::size_t end = endOf(m_text, m_at, isWordSign);
            if (end == m_at) {
                m_plain += m_text[m_at++];
            } else if (const std::size_t keyEnd = endOf(m_text, m_at, isKeySign); !takeKeyed(keyEnd) && !takeKey(keyEnd, end)) {
                m_plain += m_text.substr(m_at, end - m_at);
                m_at = end;
            }
        }
        flush();
        return std::move(m_found);
    }

private:
    /// component[NAME].density
    bool takeKeyed(std::size_t end) {
        const std::size_t close = end < m_text.size() && m_text[end] == '[' ? m_text.find("].", end) : std::string_view::npos;
        if (close == std::string_view::npos || close == end + 1) {
            return false;
        }
        const std::size_t last = endOf(m_text, close + 2, isKeySign);
        const std::string key =
            std::string(m_text.substr(m_at, end - m_at)) + "[*]" + std::string(m_text.substr(close + 1, last - close - 1));
        const Parameter* row = rowOf(key);
        if (row == nullptr) {
            return false;
        }
        const std::string subject(m_text.substr(end + 1, close - end - 1));
        take({{}, row, subject == "NAME" ? std::string() : subject, {}, true}, last);
        return true;
    }

    bool takeKey(std::size_t end, std::size_t wordEnd) {
        const Parameter* row = end == wordEnd ? rowOf(m_text.substr(m_at, end - m_at)) : nullptr;
        if (row == nullptr) {
            return false;
        }
        const bool valued = !valueFrom(end).first.empty();
        const bool compound = (m_at > 0 && m_text[m_at - 1] == '-') || (end < m_text.size() && m_text[end] == '-');
        const bool isWord = row->key.find('_') == std::string_view::npos && !valued;
        if (isWord && compound) {
            return false;
        }
        take({std::string(row->key), row, {}, {}, !isWord}, end);
        return true;
    }

    /// Behind a key: "= latch", "=none"; and where it ends.
    std::pair<std::string, std::size_t> valueFrom(std::size_t from) const {
        std::size_t at = from + (from < m_text.size() && m_text[from] == ' ' ? 1 : 0);
        if (at >= m_text.size() || m_text[at] != '=') {
            return {};
        }
        at += at + 1 < m_text.size() && m_text[at + 1] == ' ' ? 2 : 1;
        std::size_t end = endOf(m_text, at, [](char sign) { return isWordSign(sign) || sign == '-' || sign == '.'; });
        while (end > at && !isWordSign(m_text[end - 1])) {
            --end;  // the stop of the sentence
        }
        const bool begins = at < m_text.size() && isWordSign(m_text[at]);
        return begins ? std::pair(std::string(m_text.substr(at, end - at)), end) : std::pair(std::string(), from);
    }

    void take(Stretch stretch, std::size_t end) {
        flush();
        const auto [value, valueEnd] = valueFrom(end);
        const bool isSwitch = value == "true" || value == "false";
        const bool keyed = stretch.row->keyed();
        if (!value.empty() && (isSwitch || !keyed)) {
            stretch.value = value;
            end = valueEnd;
        }
        m_found.push_back(std::move(stretch));
        m_at = end;
    }

    void flush() {
        if (!m_plain.empty()) {
            m_found.push_back({std::exchange(m_plain, {}), nullptr});
        }
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::string m_plain;
    std::vector<Stretch> m_found;
};

/// Settings among words that may be keys: what stands alone, and what is listed with one.
void recognise(std::vector<Stretch>& all) {
    const auto words = [&](std::size_t i) { return i < all.size() && all[i].row == nullptr ? std::string_view(all[i].plain) : ""; };
    const auto joins = [&](std::size_t i) { return std::find(joints.begin(), joints.end(), words(i)) != joints.end(); };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string_view before = i > 0 ? words(i - 1) : "";
        all[i].certain = all[i].certain || std::any_of(frames.begin(), frames.end(), [&](const auto& frame) {
                             return before.ends_with(frame.first) && words(i + 1).starts_with(frame.second);
                         });
    }
    for (bool more = true; std::exchange(more, false);) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool listed =
                (i >= 2 && joins(i - 1) && all[i - 2].names()) || (i + 2 < all.size() && joins(i + 1) && all[i + 2].names());
            if (!all[i].certain && listed) {
                all[i].certain = more = true;
            }
        }
    }
}

std::string filled(std::string pattern, std::string_view place, const std::string& by) {
    if (const std::size_t at = pattern.find(place); at != std::string::npos) {
        pattern.replace(at, place.size(), by);
    }
    return pattern;
}

std::string nameOf(const Stretch& setting, const CatalogueWords& say) {
    std::string name = "“" + say("parameters", setting.row->label, "") + "”";
    if (!setting.subject.empty()) {
        // The name last: the subject may be a placeholder.
        const std::string of = say("rubble", "%1 of “%2”", "setting-of-component");
        name = filled(filled(of, "%2", setting.subject), "%1", name);
    }
    if (setting.value.empty()) {
        return name;
    }
    std::string value = setting.value;
    std::replace(value.begin(), value.end(), '_', ' ');
    return name + " = " +
           (value == "true"    ? say("rubble", "on", "")
            : value == "false" ? say("rubble", "off", "")
                               : say("choices", value, ""));
}

}  // namespace

std::string withSettingNames(const std::string& text, const CatalogueWords& say) {
    if (text.find_first_of("_=[(（") == std::string::npos && text.find("et ") == std::string::npos) {
        return text;
    }
    std::vector<Stretch> all = Scan(text).stretches();
    recognise(all);
    const CatalogueWords words =
        say ? say : [](std::string_view, std::string_view english, std::string_view) { return std::string(english); };
    std::string named;
    for (const Stretch& each : all) {
        named += each.names() ? nameOf(each, words) : each.plain;
    }
    return named;
}

}  // namespace rubble
