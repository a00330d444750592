// source_digest OUT ROOT LIST: writes a header that names sources by what the compiler sees of them. LIST holds their paths below
// ROOT, one a line. Comments and the amount of white space do not count, so that a better sentence throws away no result. OUT is
// written only where it would change.
#include <xxhash.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace {

std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::cerr << "source_digest: cannot read " << path << '\n';
        std::exit(1);
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A source without its comments, runs of white space as one blank or one line end; what stands in quotes is left as it is.
class Bared {
public:
    explicit Bared(const std::string& text) : m_text(text) {
        while (m_at < m_text.size()) {
            step();
        }
    }

    const std::string& text() const { return m_bare; }

private:
    char at(std::size_t ahead) const { return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0'; }

    void step() {
        if (at(0) == '/' && at(1) == '/') {
            m_at = std::min(m_text.find('\n', m_at), m_text.size());
            gap(' ');
        } else if (at(0) == '/' && at(1) == '*') {
            const std::size_t end = m_text.find("*/", m_at + 2);
            m_at = end == std::string::npos ? m_text.size() : end + 2;
            gap(' ');
        } else if (std::isspace(static_cast<unsigned char>(at(0)))) {
            gap(at(0));
            ++m_at;
        } else if (at(0) == '"' && !m_bare.empty() && m_bare.back() == 'R') {
            const std::string end = ")" + m_text.substr(m_at + 1, m_text.find('(', m_at) - m_at - 1) + "\"";
            take(m_text.find(end, m_at) + end.size() - m_at);
        } else if (at(0) == '"' || (at(0) == '\'' && !separator())) {
            take(quoted());
        } else {
            take(1);
        }
    }

    /// An apostrophe within a number: 1'000.
    bool separator() const { return !m_bare.empty() && std::isxdigit(static_cast<unsigned char>(m_bare.back())) && !m_pending; }

    std::size_t quoted() const {
        std::size_t length = 1;
        while (m_at + length < m_text.size() && at(length) != at(0)) {
            length += at(length) == '\\' ? 2 : 1;
        }
        return length + 1;
    }

    void gap(char space) { m_pending = m_pending == '\n' || space == '\n' ? '\n' : ' '; }

    void take(std::size_t length) {
        if (m_pending && !m_bare.empty()) {
            m_bare += m_pending;
        }
        m_pending = '\0';
        m_bare.append(m_text, m_at, length);
        m_at = std::min(m_at + length, m_text.size());
    }

    const std::string& m_text;
    std::size_t m_at = 0;
    char m_pending = '\0';
    std::string m_bare;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: source_digest OUT ROOT LIST\n";
        return 1;
    }
    std::ifstream list(argv[3]);
    std::string all;
    for (std::string path; std::getline(list, path);) {
        const std::string text = contentOf(std::string(argv[2]) + "/" + path);
        all += path + '\n' + Bared(text).text() + '\n';
    }
    char digest[9];
    std::snprintf(digest, sizeof digest, "%08x", static_cast<unsigned>(XXH3_64bits(all.data(), all.size()) >> 32));
    const std::string header = std::string("#define RUBBLE_SOURCE_DIGEST \"") + digest + "\"\n";
    if (std::ifstream before(argv[1]); before && std::string(std::istreambuf_iterator<char>(before), {}) == header) {
        return 0;
    }
    return (std::ofstream(argv[1]) << header).good() ? 0 : 1;
}
