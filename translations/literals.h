#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubble::translations {

/// A string literal of a C++ source: adjacent literals joined, escapes resolved.
struct Literal {
    std::string text;
    std::string before;  ///< the literal before it where only a comma or a bracket stands between; empty otherwise
};

/// All string literals of a C++ source but those of #include and static_assert.
std::vector<Literal> literalsOf(std::string_view source);

/// Whether a literal is for people: a sentence or words with a space between, or what follows the id of a message.
bool isPhrase(const Literal& literal);

}  // namespace rubble::translations
