#include "Fuzz.h"

#include <antinode_sweep/SweepCases.h>
#include <antinode_text/JsonText.h>

/** Plans of sweeps and some of their cases. */
void antinode::test::fuzz (std::string_view bytes)
{
    const auto plan = readSweepPlan (parseJson (bytes, "plan"), "plan");
    require (plan.cases >= 1 && plan.cases <= maximumSweepCases);

    for (const auto number : { std::uint64_t { 0 }, plan.cases / 2, plan.cases - 1 })
    {
        for (const auto share : caseShares (plan, number))
            require (share > 0 && share < 1);

        require (caseValues (plan, number).size() == sweptKeys (plan).size());
    }
}
