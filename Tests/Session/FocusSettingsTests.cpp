#include "PlayedSession.h"

#include <antinode_documents/FocusFile.h>
#include <antinode_session/FocusSettings.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Parameters that say what a focus says leave it as it is, to the bit", "[session]")
{
    for (const auto& name : factoryNames (LibraryKind::focus))
    {
        INFO (name);
        const auto isPlate = name.starts_with ("glass") || name.starts_with ("phone") || name.starts_with ("aluminium");
        const auto surface = deviceExtent (test::deviceNamed (isPlate ? "glass-148x210" : "staple").description);
        const auto focus = test::focusNamed (name).description;
        auto settings = settingsFromFocus (focus, surface, {});
        CHECK (focusToJson (withSettings (focus, settings, surface)) == focusToJson (focus));

        // A host may keep a parameter as a share of its range: the last digits of a float differ.
        settings.xPercent = std::nextafter (settings.xPercent, 100.0F);
        settings.widthMillimetres = std::nextafter (settings.widthMillimetres, 0.0F);
        CHECK (focusToJson (withSettings (focus, settings, surface)) == focusToJson (focus));
    }
}

TEST_CASE ("Parameters change what they name, and later foci follow the first", "[session]")
{
    const auto surface = deviceExtent (test::deviceNamed ("glass-148x210").description);
    const auto focus = test::focusNamed ("glass-two").description;
    auto settings = settingsFromFocus (focus, surface, {});
    settings.xPercent = 50;
    settings.peakVelocityMillimetresPerSecond *= 2;
    settings.growth = 4;
    settings.brake = 20;
    settings.voltageLimitVolts = 33;
    settings.modeCount = 12;
    const auto changed = withSettings (focus, settings, surface);
    CHECK (changed.targets[0].x == Approx (0.5 * surface.xMaximum));
    CHECK (changed.targets[1].x - changed.targets[0].x == Approx (focus.targets[1].x - focus.targets[0].x));
    CHECK (changed.targets[1].peakVelocity == Approx (2 * focus.targets[1].peakVelocity));
    CHECK (changed.transients.growth == std::vector<double> { 4 });
    CHECK (changed.transients.brake == 20);
    CHECK (changed.allocation.voltageLimit == 33);
    CHECK (changed.modes.count == 12);
}

TEST_CASE (
    "Another method than samples up to the limit leaves off what is felt elsewhere, and the focus can be read again",
    "[session]")
{
    const auto surface = deviceExtent (test::deviceNamed ("glass-148x210").description);
    auto focus = test::focusNamed ("glass-two").description;
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = upToLimits;
    focus.felt.emplace();
    auto settings = settingsFromFocus (focus, surface, {});
    CHECK (withSettings (focus, settings, surface).felt);
    settings.method = AllocationMethod::exact;
    const auto changed = withSettings (focus, settings, surface);
    CHECK_FALSE (changed.felt);
    CHECK_NOTHROW (readFocus (focusToJson (changed), "focus"));
}

TEST_CASE ("A method that a host keeps although it is no longer offered changes a focus as it did", "[session]")
{
    const auto surface = deviceExtent (test::deviceNamed ("staple").description);
    auto focus = test::focusNamed ("demonstrator").description;
    focus.allocation.robust = Robustness {};
    auto settings = settingsFromFocus (focus, surface, {});
    const auto by = [&] (const RetiredMethod& retired)
    {
        settings.method = retired.method;
        settings.retired = &retired;
        return withSettings (focus, settings, surface);
    };

    for (const auto& retired : retiredMethods)
    {
        const auto changed = by (retired);
        CHECK (changed.allocation.retired == &retired);
        CHECK (changed.allocation.isUpToLimits() == retired.isUpToLimits);
        CHECK_FALSE (changed.allocation.robust); // None of them took it.
        CHECK (settingsFromFocus (changed, surface, settings) == settings);
    }

    // What was felt elsewhere of a free waveform goes with another method, also with one that plays samples.
    focus = by (retiredMethods.back());
    focus.felt.emplace();
    CHECK (withSettings (focus, settings, surface).felt);
    settings.retired = nullptr;
    const auto near = withSettings (focus, settings, surface);
    CHECK (near.allocation.isNearBound());
    CHECK_FALSE (near.felt);
    CHECK (near.allocation.retired == nullptr);
}
