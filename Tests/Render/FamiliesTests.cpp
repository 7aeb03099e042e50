#include <field/field.h>
#include <files/files.h>
#include <foundations/foundations.h>
#include <measure/measure.h>
#include <plate/plate.h>
#include <results/results.h>
#include <signal/signal.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("The headers of the families are enough to design a focus and to play it", "[render]")
{
    const auto model = solveStructure (loadDevice ("staple", {}));
    const auto design = designFocus (model, loadFocus ("demonstrator", {}), {}, DesignExtent::playable);
    CHECK (peakVoltage (design) <= design.program.voltageLimits.maxCoeff());
    CHECK (renderFocus (model, design, {}).truncatedScore.vScore > 0.9999);
}
