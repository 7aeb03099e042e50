#include <antinode_session/FilterDesigner.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace antinode;

namespace
{
using Clock = FingerMovement::Clock;

Clock::time_point at (double milliseconds)
{
    return Clock::time_point (
        std::chrono::duration_cast<Clock::duration> (std::chrono::duration<double, std::milli> (milliseconds)));
}

Clock::duration milliseconds (double number)
{
    return at (number).time_since_epoch();
}

TouchSettings oneAt (double x, double y)
{
    TouchSettings settings;
    settings.fingers[0] = { static_cast<float> (x), static_cast<float> (y), FingerPresence::plays, FingerLoad::none };
    return settings;
}

/** A finger on an even way, whose places come at an interval and are looked at every ms. */
void move (FingerMovement& movement, double percentPerSecond, double interval, double until)
{
    for (double time = 0; time <= until; time += 1)
        movement.note (oneAt (20 + 1e-3 * percentPerSecond * interval * std::floor (time / interval), 50), at (time));
}
} // namespace

TEST_CASE ("A finger on an even way is foretold where it will be, however often its places come", "[live]")
{
    const auto interval = GENERATE (1.0, 3.0, 10.0, 16.0, 46.0);
    FingerMovement movement;
    move (movement, 60, interval, 200);
    const auto seen = interval * std::floor (200 / interval); // ms, when the last place came
    CAPTURE (interval);
    CHECK (movement.isAnyMoving (at (200)));
    CHECK (movement.expected (at (200), milliseconds (10)).fingers[0].xPercent
           == Approx (20 + 0.06 * std::min (210.0, seen + 60)).margin (0.05));
    CHECK (movement.expected (at (200), milliseconds (10)).fingers[0].yPercent == 50);
}

TEST_CASE ("A finger that stops is foretold where it is, soon after its next place stays out", "[live]")
{
    FingerMovement movement;
    move (movement, 60, 3, 99);
    CHECK (movement.isAnyMoving (at (100)));
    CHECK_FALSE (movement.isAnyMoving (at (112)));
    CHECK (movement.expected (at (112), milliseconds (20)).fingers[0].xPercent == Approx (20 + 0.06 * 99));
}

TEST_CASE ("A finger that rests, leaps or has just begun to move is foretold where it is", "[live]")
{
    FingerMovement movement;
    movement.note (oneAt (20, 50), at (0));
    CHECK_FALSE (movement.isAnyMoving (at (0)));
    movement.note (oneAt (21, 50), at (5000));
    CHECK_FALSE (movement.isAnyMoving (at (5000)));

    for (int i = 0; i < 50; ++i)
    {
        const auto settings = oneAt (i * 37 % 100, i * 61 % 100);
        movement.note (settings, at (6000 + i));
        CHECK (movement.expected (at (6000 + i), milliseconds (30)) == settings);
    }

    movement.note ({}, at (6051));
    CHECK (movement.expected (at (6051), milliseconds (30)) == TouchSettings {});
}

TEST_CASE ("A finger is foretold on the surface", "[live]")
{
    FingerMovement movement;

    for (int i = 0; i <= 20; ++i)
        movement.note (oneAt (94 + 0.3 * i, 4 - 0.2 * i), at (i));

    const auto finger = movement.expected (at (20), milliseconds (40)).fingers[0];
    CHECK (finger.xPercent == 100);
    CHECK (finger.yPercent == 0);
}

TEST_CASE ("Fingers rest from where they came to rest, also while they tremble", "[live]")
{
    FingerMovement movement;
    move (movement, 60, 3, 300);

    for (int i = 1; i <= 600; ++i)
        movement.note (oneAt (38 + 0.2 * (i % 3), 50), at (300 + i));

    CHECK (movement.restedFor (at (900)) > milliseconds (590));
    const auto rest = movement.rest();
    CHECK (std::abs (rest.fingers[0].xPercent - 38) <= 0.5F);
    movement.note (oneAt (40, 50), at (901));
    CHECK (movement.restedFor (at (901)) == milliseconds (0));
    CHECK (movement.rest() == oneAt (40, 50));
}
