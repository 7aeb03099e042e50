#include "Support/SinePlate.h"

#include <antinode_reports/ModesReport.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("The report of modes names each with its strongest ceramic", "[command line]")
{
    const auto model = test::SinePlate().model (60);
    const auto page = modesReport (model);
    REQUIRE (page.sections.size() == 4);
    const auto& table = page.sections.back().tables.front();
    REQUIRE (table.rows.size() == 60);
    REQUIRE (table.header.size() == 5);   // no errors are known
    CHECK (table.rows[0][1] == "339.70"); // pi / 2 (1 / a^2 + 1 / b^2) sqrt (D / mu)
    Eigen::Index best = 0;
    model.participation.row (41).cwiseAbs().maxCoeff (&best);
    CHECK (table.rows[41][3] == model.ceramics[static_cast<std::size_t> (best)].name);
    CHECK (page.sections[1].figures[0].caption.find ("The lowest 48 of 60 modes") == 0);

    // An edge on springs is drawn, and named below the picture.
    const auto elastic = modesReport (model, { linePiece ({ 0, 0 }, { 0.1, 0 }, 0) });
    const auto& picture = elastic.sections[0].figures[0];
    CHECK (std::get<PlanView> (picture.chart).elasticPieces.size() == 1);
    CHECK (picture.caption.find ("rest on springs") != std::string::npos);
    CHECK (page.sections[0].figures[0].caption.find ("springs") == std::string::npos);

    auto without = model;
    without.ceramics.clear();
    without.participation.resize (60, 0);
    CHECK (modesReport (without).sections.size() == 3);
}
