#include "io/validation/kept_validation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/unknown.h"
#include "io/validation/validation_json.h"
#include "tests/scenes/validation_records.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;

TEST(KeptValidation, IsReadBackAsItWas) {
    const TemporaryFolder cache;
    const ValidationRecord record = scenes::tossRecord();
    keepValidation(record, cache.path());
    ValidationRecord other = record;
    other.folder = "/somewhere/else";
    keepValidation(other, cache.path());
    keepValidation(record, cache.path());
    Findings findings;
    const std::vector<ValidationRecord> kept = keptValidations(cache.path(), findings);
    ASSERT_EQ(kept.size(), 2u) << "one of each set";
    EXPECT_TRUE(findings.empty());
    EXPECT_EQ(kept[0].folder, "");
    EXPECT_EQ(kept[1].folder, "/somewhere/else");
    EXPECT_EQ(validationJson(kept[0]).text(), validationJson(record).text());
    EXPECT_TRUE(std::isnan(kept[0].variants[0].figures[1].value.low)) << "a number that is none stays none";
}

TEST(KeptValidation, WhatIsDamagedIsAFindingAndWhatIsNotThereIsNone) {
    const TemporaryFolder cache;
    Findings findings;
    EXPECT_TRUE(keptValidations(cache.path() + "/none", findings).empty());
    EXPECT_TRUE(findings.empty());
    keepValidation(scenes::tossRecord(), cache.path());
    for (const auto& file : fs::recursive_directory_iterator(cache.path())) {
        if (file.is_regular_file()) {
            std::ofstream(file.path()) << "{\"id\": 3}";
        }
    }
    EXPECT_TRUE(keptValidations(cache.path(), findings).empty());
    ASSERT_EQ(findings.list().size(), 1u);
    EXPECT_EQ(findings.list()[0].what.id, "validation.damaged");
}

}  // namespace
}  // namespace rubble::io
