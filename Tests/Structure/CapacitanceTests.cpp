#include "StructureExamples.h"

#include <antinode_base/InputError.h>
#include <antinode_structure/DescribedCeramic.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** One of the demonstrator's: 9 x 5 x 0.5 mm of NCE51, permittivity 1850 after its maker's data sheet. */
const auto pair = ceramicPair (0, 0.009, 0.005, 0.5e-3);
} // namespace

TEST_CASE ("A ceramic of 9 x 5 x 0.5 mm has 1.474 nF, a pair twice that in parallel and half of it in series",
           "[structure]")
{
    auto ceramic = pair;
    CHECK (capacitance (ceramic) == Approx (2 * 1.4742e-9).epsilon (1e-4));
    ceramic.wiring = CeramicWiring::series;
    CHECK (capacitance (ceramic) == Approx (0.5 * 1.4742e-9).epsilon (1e-4));
    ceramic.mounting = CeramicMounting::oneSide;
    CHECK (capacitance (ceramic) == Approx (1.4742e-9).epsilon (1e-4));
    ceramic.capacitance = 2.1e-9; // As measured.
    CHECK (capacitance (ceramic) == 2.1e-9);
}

TEST_CASE ("The lower of slew rate and current into the capacitance limits a ceramic", "[structure]")
{
    auto common = plainCommon (1e-3);
    common.ceramics = { pair };
    CHECK (slewLimit (common, 0) == 0);
    common.slewLimit = 2e6;
    CHECK (slewLimit (common, 0) == 2e6);
    common.currentLimit = 5e-3;
    CHECK (slewLimit (common, 0) == Approx (5e-3 / (2 * 1.4742e-9)).epsilon (1e-4)); // 1.70 V/us
    common.slewLimit = 1e6;
    CHECK (slewLimit (common, 0) == 1e6);
    common.ceramics[0].material.permittivityRelative = 0;
    CHECK_THROWS_WITH (slewLimit (common, 0),
                       Catch::Contains ("device: current limit: needs the capacitance of ceramic 1"));
}
