#pragma once

#include <string>

#include "io/run/run_file.h"

namespace rubble {

class Computation;
class Document;

/// Where what the window shows came from: the run, or the inputs and the scenario of now while there is none.
io::RunOrigin shownOrigin(const Document& document, const Computation& computation);

}  // namespace rubble
