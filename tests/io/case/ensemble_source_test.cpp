#include "io/case/ensemble_source.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "io/case/case_file.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// Causes that one small FE result is taken for, each a case of its own.
class CausesOfASite : public testing::Test {
protected:
    EnsembleSource opened(const std::string& file, const std::string& title, double shifted = 0.0) {
        const std::string path = m_folder / (file + ".rubble");
        Case made = caseForFe(cli::writeSmallCollapse(m_folder / (file + ".exo")), path);
        made.title = title;
        made.frame.origin.x() += shifted;
        saveCase(path, made);
        CaseRequest request;
        request.path = path;
        return openEnsemble(request, made.ensemble, Execution());
    }
    std::vector<std::string> namesOf(std::vector<EnsembleSource> causes) {
        std::vector<std::string> names;
        for (EnsembleSource& cause : causes) {
            joinCauses(cause, names.empty() ? nullptr : &causes.front(), names);
            names.push_back(cause.name);
        }
        return names;
    }

    TemporaryFolder m_folder;
};

TEST_F(CausesOfASite, KeepTheirTitles) {
    EXPECT_EQ(namesOf({opened("west", "west"), opened("pier", "pier")}), (std::vector<std::string>{"west", "pier"}));
}

TEST_F(CausesOfASite, OfOneTitleAreToldApartByTheirFiles) {
    EXPECT_EQ(namesOf({opened("west", "Bridge"), opened("pier", "Bridge"), opened("pier", "Bridge")}),
              (std::vector<std::string>{"Bridge", "Bridge (pier)", "Bridge (pier) 2"}));
}

TEST_F(CausesOfASite, WithoutATitleAreCalledByTheirFiles) {
    EXPECT_EQ(namesOf({opened("west", ""), opened("pier", "")}), (std::vector<std::string>{"west", "pier"}));
}

TEST_F(CausesOfASite, MustBeOfOneSite) {
    EXPECT_THROW(namesOf({opened("west", "west"), opened("pier", "pier", 1.0)}), UsageError);
}

}  // namespace
}  // namespace rubble::io
