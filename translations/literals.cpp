#include "translations/literals.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace rubble::translations {

namespace {

/// Reads tokens of C++ one after another; white space and comments are passed over.
class Scanner {
public:
    explicit Scanner(std::string_view source) : m_source(source) {}

    /// The next token; empty at the end. A string literal comes with its quotes.
    std::string_view next() {
        passOver();
        const std::size_t start = m_at;
        if (m_at >= m_source.size()) {
            return {};
        }
        const char first = m_source[m_at];
        if (m_source.substr(m_at, 2) == "R\"") {
            const std::size_t open = m_source.find('(', m_at);
            const std::string close = ")" + std::string(m_source.substr(m_at + 2, open - m_at - 2)) + "\"";
            const std::size_t end = m_source.find(close, open);
            m_at = end == std::string_view::npos ? m_source.size() : end + close.size();
        } else if (first == '"' || first == '\'') {
            for (++m_at; m_at < m_source.size() && m_source[m_at] != first; ++m_at) {
                m_at += m_source[m_at] == '\\' ? 1 : 0;
            }
            ++m_at;
        } else if (isWord(first)) {
            // Digits may be grouped by single quotes.
            while (m_at < m_source.size() &&
                   (isWord(m_source[m_at]) || (m_source[m_at] == '\'' && std::isdigit(static_cast<unsigned char>(first)) != 0))) {
                ++m_at;
            }
        } else {
            ++m_at;
        }
        return m_source.substr(start, m_at - start);
    }

private:
    static bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

    void passOver() {
        while (m_at < m_source.size()) {
            if (std::isspace(static_cast<unsigned char>(m_source[m_at])) != 0) {
                ++m_at;
            } else if (m_source.substr(m_at, 2) == "//" || m_source[m_at] == '#') {
                m_at = std::min(m_source.size(), m_source.find('\n', m_at));
            } else if (m_source.substr(m_at, 2) == "/*") {
                const std::size_t end = m_source.find("*/", m_at);
                m_at = end == std::string_view::npos ? m_source.size() : end + 2;
            } else {
                return;
            }
        }
    }

    std::string_view m_source;
    std::size_t m_at = 0;
};

std::string unescaped(std::string_view quoted) {
    std::string text;
    for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
        if (quoted[i] == '\\' && i + 2 < quoted.size()) {
            ++i;
            text += quoted[i] == 'n' ? '\n' : quoted[i] == 't' ? '\t' : quoted[i];
        } else {
            text += quoted[i];
        }
    }
    return text;
}

}  // namespace

std::vector<Literal> literalsOf(std::string_view source) {
    std::vector<Literal> literals;
    Scanner scanner(source);
    std::string last;      // the literal before, while only commas and brackets follow it
    bool joining = false;  // the token before was a literal
    bool asserting = false;
    for (std::string_view token = scanner.next(); !token.empty(); token = scanner.next()) {
        if (token.front() == '"' && !asserting) {
            if (joining) {
                literals.back().text += unescaped(token);
            } else {
                literals.push_back({unescaped(token), last});
            }
            joining = true;
            continue;
        }
        if (joining) {
            last = literals.back().text;
            joining = false;
        }
        asserting = token == "static_assert" || (asserting && token != ";");
        if (token != "," && token != "{" && token != "(") {
            // What is chosen by a condition follows the id as well: {"id", many ? "words" : "word"}.
            const bool condition = token != ";" && token != "}" && token.size() > 0;
            if (!(condition && !last.empty() && last.find('.') != std::string::npos && last.find(' ') == std::string::npos)) {
                last.clear();
            }
        }
    }
    return literals;
}

bool isPhrase(const Literal& literal) {
    static const std::regex words(R"([A-Za-z]{2,}[,:;.]? [A-Za-z{(]|\{\d\}[,:;]? [a-z(])");
    static const std::regex id(R"([a-z0-9_]*(\.[a-z0-9_]+)+)");
    static const std::regex lower("[a-z]{2}");
    const std::string& text = literal.text;
    // What begins or ends in the middle of a sentence is put together by the program and cannot be translated on its own.
    const bool odd = std::count(text.begin(), text.end(), '"') % 2 == 1 || text.ends_with("= '");
    const bool torn = text.empty() || odd || std::string_view(" \"),;#\n").find(text.front()) != std::string_view::npos ||
                      (text.back() == ' ' && !text.ends_with(": ")) || text.back() == '(';
    const bool quoted =
        !text.empty() && text.front() == '"' && std::count(text.begin(), text.end(), '"') % 2 == 0 && text.back() != ' ';
    if ((torn && !quoted && text != ", or auto") || !std::regex_search(text, lower)) {
        return false;
    }
    return std::regex_search(text, words) || (std::regex_match(literal.before, id) && !std::regex_match(text, id));
}

}  // namespace rubble::translations
