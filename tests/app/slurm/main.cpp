#include <gtest/gtest.h>

#include "tests/app/slurm/one_node.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    testing::AddGlobalTestEnvironment(new rubble::OneNode);
    return RUN_ALL_TESTS();
}
