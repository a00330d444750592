#pragma once

#include <string>
#include <string_view>

namespace rubble {

/// Collects a page for man(1): source text for troff with the macros of man(7).
class ManPage {
public:
    /// @param name     of the program, "rubble-cli"
    /// @param summary  one line, without a point
    ManPage(std::string_view name, std::string_view summary);

    ManPage& section(std::string_view title);
    ManPage& subsection(std::string_view title);
    ManPage& paragraph(std::string_view text);
    /// A term, an option for example, and what it means.
    ManPage& item(std::string_view term, std::string_view meaning);

    const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

}  // namespace rubble
