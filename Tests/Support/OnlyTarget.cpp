// Runs a test program with one of Highway's targets only, whatever the processor could do: ANTINODE_TEST_TARGET=AVX3,
// AVX2, SSSE3 or EMU128, the plain x86-64. 77 where the processor does not have it. Scripts/processors does so for the
// cases tagged [processors].

#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

#include <hwy/targets.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{
constexpr int skipped = 77;

struct OnlyTarget : Catch::TestEventListenerBase
{
    using Catch::TestEventListenerBase::TestEventListenerBase;

    void testRunStarting (const Catch::TestRunInfo&) override
    {
        const auto* wanted = std::getenv ("ANTINODE_TEST_TARGET");

        if (wanted == nullptr)
            return;

        for (auto targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1)
            if (const auto target = targets & -targets; hwy::TargetName (target) == std::string (wanted))
            {
                hwy::SetSupportedTargetsForTest (target);
                return;
            }

        std::printf ("this processor does not have %s\n", wanted);
        std::exit (skipped);
    }
};
} // namespace

CATCH_REGISTER_LISTENER (OnlyTarget)
