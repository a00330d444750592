#include "core/base/help/man_page.h"

#include <algorithm>
#include <cctype>

#include "core/base/build.h"

namespace rubble {

namespace {

// A hyphen that is to be copied from the page is a minus; a point or quote at the start of a line would be a request.
std::string plain(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        const bool lineStart = escaped.empty() || escaped.back() == '\n';
        if (lineStart && (c == '.' || c == '\'')) {
            escaped += "\\&";
        }
        if (c == '\\') {
            escaped += "\\e";
        } else if (c == '-') {
            escaped += "\\-";
        } else if (c == '~') {
            escaped += "\\(ti";
        } else if (c == '^') {
            escaped += "\\(ha";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

std::string inQuotes(std::string_view text) {
    std::string inside = plain(text);
    for (std::size_t i = inside.find('"'); i != std::string::npos; i = inside.find('"', i + 4)) {
        inside.replace(i, 1, "\\(dq");
    }
    return '"' + inside + '"';
}

}  // namespace

ManPage::ManPage(std::string_view name, std::string_view summary) {
    std::string title(name);
    std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    m_text = ".TH " + inQuotes(title) + " 1 \"\" " + inQuotes("Rubble " + std::string(versionText())) + " \"User Commands\"\n";
    section("NAME");
    m_text += plain(name) + " \\- " + plain(summary) + '\n';
}

ManPage& ManPage::section(std::string_view title) {
    m_text += ".SH " + inQuotes(title) + '\n';
    return *this;
}

ManPage& ManPage::subsection(std::string_view title) {
    m_text += ".SS " + inQuotes(title) + '\n';
    return *this;
}

ManPage& ManPage::paragraph(std::string_view text) {
    m_text += ".PP\n" + plain(text) + '\n';
    return *this;
}

ManPage& ManPage::item(std::string_view term, std::string_view meaning) {
    m_text += ".TP\n.B " + inQuotes(term) + '\n' + plain(meaning) + '\n';
    return *this;
}

}  // namespace rubble
