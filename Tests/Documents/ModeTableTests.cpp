#include "Support/ErrorText.h"
#include "Support/GridModel.h"

#include <antinode_documents/TableExport.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <sstream>
#include <vector>

using namespace antinode;

namespace
{
/** The fields of all lines, where no field is quoted. */
std::vector<std::vector<std::string>> splitFields (const std::string& text)
{
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines (text);

    for (std::string line; std::getline (lines, line);)
    {
        auto& row = rows.emplace_back();
        std::istringstream fields (line + ',');

        for (std::string field; std::getline (fields, field, ',');)
            row.push_back (field);
    }

    return rows;
}
} // namespace

TEST_CASE ("The table of modes has a row a mode and gives every number back to the bit", "[files]")
{
    const auto model = test::gridModel (7, 3);
    const auto rows = splitFields (encodeModeTable (model));
    REQUIRE (rows.size() == 8);
    CHECK (rows[0]
           == std::vector<std::string> { "mode", "frequency_Hz", "damping_ratio", "error_estimate_relative",
                                         "participation_C1_per_V", "participation_C2_per_V",
                                         "participation_C3_per_V" });

    for (Eigen::Index k = 0; k < 7; ++k)
    {
        const auto& row = rows[static_cast<std::size_t> (k) + 1];
        REQUIRE (row.size() == 7);
        const auto number = [&] (std::size_t column) { return std::strtod (row[column].c_str(), nullptr); };
        CHECK (row[0] == std::to_string (k + 1));
        CHECK (number (1) == model.angularFrequencies[k] / (2 * std::numbers::pi));
        CHECK (number (2) == model.dampingRatios[k]);
        CHECK (number (3) == model.frequencyErrors[k]);

        for (Eigen::Index i = 0; i < 3; ++i)
            CHECK (number (4 + static_cast<std::size_t> (i)) == model.participation (k, i));
    }
}

TEST_CASE ("Names with commas, quotes and line ends are quoted, unknown errors are empty fields", "[files]")
{
    auto model = test::gridModel (1, 3);
    model.ceramics[0].name = "left, upper";
    model.ceramics[1].name = "the \"big\" one";
    model.ceramics[2].name = "two\nlines";
    model.frequencyErrors.resize (0);
    model.angularFrequencies[0] = 2 * std::numbers::pi * 128;
    model.dampingRatios[0] = 0.1;
    model.participation.row (0) << 1, -0.5, 1e-20;
    CHECK (encodeModeTable (model)
           == "mode,frequency_Hz,damping_ratio,error_estimate_relative,\"participation_left, upper_per_V\","
              "\"participation_the \"\"big\"\" one_per_V\",\"participation_two\nlines_per_V\"\n"
              "1,128,0.10000000000000001,,1,-0.5,9.9999999999999995e-21\n");

    model.participation (0, 1) = std::numeric_limits<double>::infinity();
    CHECK (errorText ([&] { encodeModeTable (model); }) == "CSV: has a value that is not finite");
}
