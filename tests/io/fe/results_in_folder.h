#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

/// FE results that a test lays into a folder of its own and opens by their names.
class ResultsInFolder : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const std::string& name, const ImportSettings& settings = {}) {
        return openFe(m_folder / name, settings, {}, Execution{});
    }

    /// What opening it complains of.
    std::string errorOf(const std::string& name) {
        try {
            open(name);
        } catch (const Error& error) {
            return error.what();
        }
        ADD_FAILURE() << name << " was read";
        return {};
    }

    TemporaryFolder m_folder;
};

}  // namespace rubble::io
