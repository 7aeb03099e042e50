#include "Support/SineBeam.h"

#include <antinode_learning/LearningPasses.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
/** Two plays of a beam: how the last one was predicted, RMS of the noise, and what the fit left. */
LearntFocus twoPlays (const ModalModel& model, double surprise, double nominalSurprise, double residual = 1)
{
    LearntFocus focus;
    focus.learnt.model = model;
    focus.learnt.residual = residual;
    focus.learnt.unexplained = 0.01;
    focus.passes.resize (2);
    focus.passes.front().estimatedError = 0.1;
    focus.passes.back().estimatedError = 0.01;
    focus.passes.back().surprise = surprise;
    focus.passes.back().nominalSurprise = nominalSurprise;
    return focus;
}

LearntModes fitWith (double residual, double largestMove)
{
    LearntModes learnt;
    learnt.residual = residual;
    learnt.largestMove = largestMove;
    return learnt;
}
} // namespace

TEST_CASE ("What was learnt has to leave a quarter of the power beyond the noise, half of it near the noise",
           "[learning]")
{
    const auto model = test::sineBeam (4, 2);
    const auto spread = sameSpread (model.modes(), 0.01, 0.1, 0.05);
    const auto isUsed = [&] (double surprise, double nominal, double residual = 1)
    { return refusalOf (twoPlays (model, surprise, nominal, residual), model, spread).empty(); };

    CHECK (isUsed (25, 60));
    CHECK_FALSE (isUsed (45, 60));
    CHECK (isUsed (1.2, 2.1));
    // Here the share is 1 / 2.1, nearly a half.
    CHECK (isUsed (1.5, 2.1));
    CHECK_FALSE (isUsed (1.7, 2.1));
    CHECK (isUsed (2.1, 4));
    CHECK_FALSE (isUsed (2.3, 4));
    CHECK (isUsed (1.9, 3));
    CHECK_FALSE (isUsed (2, 3));
    CHECK (isUsed (1.1, 1.3));
    CHECK_FALSE (isUsed (1.25, 1.3));
    // Below .1 of the noise's power there is nothing to learn.
    CHECK_FALSE (isUsed (1, 1.04));
    // There is less noise than was said: the fit leaves half of it.
    CHECK_FALSE (isUsed (1.1, 1.3, 0.5));
    CHECK (isUsed (0.6, 1.3, 0.5));
}

TEST_CASE ("Sensors that are ten times louder or less loud than predicted are refused, however well explained",
           "[learning]")
{
    const auto model = test::sineBeam (4, 2);
    const auto spread = sameSpread (model.modes(), 0.01, 0.1, 0.05);

    for (const auto loudness : { 1e-6, 0.09, 11.0, 1e6 })
    {
        auto focus = twoPlays (model, 1, 60);
        focus.passes.back().loudness = loudness;
        CHECK_THAT (refusalOf (focus, model, spread), Catch::Contains ("Check sensors, channels and units."));
    }

    for (const auto loudness : { 0.2, 1.0, 5.0 })
    {
        auto focus = twoPlays (model, 1, 60);
        focus.passes.back().loudness = loudness;
        CHECK (refusalOf (focus, model, spread).empty());
    }
}

TEST_CASE ("Near the noise the last play has to be less than half as wrong as the first", "[learning]")
{
    const auto model = test::sineBeam (4, 2);
    const auto spread = sameSpread (model.modes(), 0.01, 0.1, 0.05);
    const auto isUsed = [&] (double surprise, double nominal, double lastError)
    {
        auto focus = twoPlays (model, surprise, nominal);
        focus.passes.back().estimatedError = lastError;
        return refusalOf (focus, model, spread).empty();
    };
    CHECK (isUsed (1.3, 2.5, 0.045));
    CHECK_FALSE (isUsed (1.3, 2.5, 0.055));
    // What predicts ten times better needs no other proof.
    CHECK (isUsed (1.3, 25, 0.09));
}

TEST_CASE ("Plays end where one was predicted three times worse and is not explained afterwards", "[learning]")
{
    const auto model = test::sineBeam (4, 2);
    const auto isMisledBy = [&] (double surprise, double nominal, double residual)
    {
        const auto focus = twoPlays (model, surprise, nominal, residual);
        return isMisled (focus.passes.back(), focus.learnt);
    };
    CHECK (isMisledBy (40, 10, 4));
    CHECK_FALSE (isMisledBy (40, 10, 1.1));
    CHECK_FALSE (isMisledBy (20, 10, 4));
}

TEST_CASE ("What is used is doubted where a frequency is more than six deviations off", "[learning]")
{
    auto focus = twoPlays (test::sineBeam (4, 2), 1, 60);
    focus.learnt.largestMove = 5.9;
    CHECK (warningOf (focus).empty());
    focus.learnt.largestMove = 7.3;
    CHECK_THAT (warningOf (focus), Catch::Contains ("A frequency is more than 6 of its standard deviations off"));
    focus.refusal = "Sensors are swapped.";
    CHECK (warningOf (focus).empty());
}

TEST_CASE ("A fit is stuck that leaves three times the noise, or a frequency six deviations off", "[learning]")
{
    CHECK_FALSE (isStuck (fitWith (2.9, 5.9)));
    CHECK (isStuck (fitWith (3.1, 0)));
    CHECK (isStuck (fitWith (1, 6.1)));
}

TEST_CASE ("A frequency that is as far off by a second fit is no sign of a wrong minimum", "[learning]")
{
    CHECK_FALSE (isStuck (fitWith (1, 7.6), 7));
    CHECK (isStuck (fitWith (1, 7.8), 7));
    CHECK (isStuck (fitWith (3.1, 7), 7));
}
