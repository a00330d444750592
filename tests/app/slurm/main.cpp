#include <gtest/gtest.h>

#include "tests/app/slurm/one_node.h"
#include "tests/support/run_tests.h"

int main(int argc, char** argv) {
    testing::AddGlobalTestEnvironment(new rubble::OneNode);
    return rubble::runTests(argc, argv);
}
