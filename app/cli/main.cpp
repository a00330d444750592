#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "core/base/memory.h"

int main(int argc, char** argv) {
    rubble::keepFreedMemory();
    const std::vector<std::string> words(argv + 1, argv + argc);
    const bool progress = isatty(STDERR_FILENO) == 1;
    return static_cast<int>(rubble::cli::performCommandLine(words, std::cout, std::cerr, progress));
}
