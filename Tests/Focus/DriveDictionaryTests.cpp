#include "Support/SineBeam.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/ModeDrives.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
FocusDescription dictionaryFocus()
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.02;
    focus.modes.count = 4;
    focus.allocation.method = AllocationMethod::dictionary;
    return focus;
}
} // namespace

TEST_CASE ("The dictionary comes within 1.5 of the bound of all waveforms, with exact velocities", "[dictionary]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = dictionaryFocus();
    const auto design = designFocus (model, focus, {});
    const auto reached = modalVelocities (model, predictStates (model, design.program, focus.focusTime));
    CHECK (peakVoltage (design) < 1.5 * design.lowerBoundVoltage);
    CHECK (peakVoltage (design) > design.lowerBoundVoltage);
    CHECK (design.minimumPeakVoltage <= peakVoltage (design));

    for (const auto mode : design.controlledModes)
        CHECK (reached[mode]
               == Approx (design.target.modalVelocities[mode]).margin (1e-9 * reached.cwiseAbs().maxCoeff()));

    focus.allocation.voltageLimit = 0.9 * peakVoltage (design);
    CHECK_THROWS_AS (designFocus (model, focus, {}), LimitError);
}

TEST_CASE ("Few modes or many, a short time or a long one: the dictionary is within 1.5 of the bound", "[dictionary]")
{
    const auto model = test::sineBeam (20, 6);
    auto focus = dictionaryFocus();

    for (const auto count : { 1, 2, 6, 10 })
        for (const auto time : { 0.008, 0.025 })
        {
            focus.modes.count = count;
            focus.focusTime = time;
            const auto design = designFocus (model, focus, {});
            CAPTURE (count, time);
            CHECK (peakVoltage (design) < 1.5 * design.lowerBoundVoltage);
        }
}

TEST_CASE ("Modes that the dictionary does not control stay nearly at rest", "[dictionary]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = dictionaryFocus();
    focus.modes.count = 8;
    focus.modes.order = ModeOrder::frequency;
    const auto design = designFocus (model, focus, {});
    const auto reached = modalVelocities (model, predictStates (model, design.program, focus.focusTime));
    CHECK (reached.tail (12).norm() < 0.003 * reached.head (8).norm());
}

TEST_CASE ("Drives of the dictionary start from 0 without a slope, are 1 at the focus and go on into their release",
           "[dictionary]")
{
    const auto model = test::sineBeam (5, 2);
    const auto focus = dictionaryFocus();
    const std::vector<int> modes { 0, 3 };
    const auto drives = dictionaryDrives (model, focus, modes, { 2, 0.5 });
    REQUIRE (drives.size() == modes.size() * dictionaryGrowths (2).size() * 2);
    const auto evaluate = [] (const std::vector<Oscillation>& drive, double time)
    {
        double sum = 0;

        for (const auto& oscillation : drive)
            sum += oscillationValue (oscillation, time);

        return sum;
    };

    for (std::size_t l = 0; l < drives.size(); ++l)
    {
        const auto& drive = drives[l];
        const auto start = drive.front().start;
        const auto isCrest = l % 2 == 0;
        CHECK (std::abs (evaluate (drive, start)) < 1e-12);
        CHECK (std::abs (evaluate (drive, start + 1e-8)) < 1e-6);
        CHECK (evaluate (drive, focus.focusTime) == Approx (isCrest ? 1.0 : 0.0).margin (1e-9));
        CHECK (evaluate (drive, focus.focusTime - 1e-9) == Approx (evaluate (drive, focus.focusTime)).margin (1e-3));
    }
}
