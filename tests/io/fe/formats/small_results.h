#pragma once

#include <string>

namespace rubble::io {

/// Results of two bricks side by side, of which the second dies between the second and the third of three states at 0, 1 and 2 s,
/// as text in several formats. The nodes move by 0.1 along x from state to state.
std::string smallFil();
std::string smallFrd();
std::string smallMarc(bool removed);
/// One state of three; the time stands in a comment.
std::string smallCdb(int state);
/// A deck with density 2400 and the removal in the third step.
std::string smallDeck();

}  // namespace rubble::io
