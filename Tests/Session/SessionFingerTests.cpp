#include "PlayedSession.h"

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr double fingerRate = 48000;
constexpr FocusEvent live { 0, FocusEventKind::trigger, 60, 1 };

/** The largest velocity at the focus of the demonstrator, m/s, with a firm finger on it. */
double peakUnder (test::PlayedSession& played, bool isKnown)
{
    auto focus = test::focusNamed ("demonstrator");
    const auto& target = focus.description.targets.front();
    auto finger = builtInFinger ("firm", target.x, target.y);
    finger.isKnown = isKnown;
    played.session.load (nullptr, std::make_shared<const FocusDocument> (withFingers (focus, { finger })));
    const std::array events { live };
    played.session.waitUntilSettled (events);
    played.play (4800); // The old path ramps to 0.
    return played.play (4800, { live }).row (9).cwiseAbs().maxCoeff();
}
} // namespace

TEST_CASE ("A finger on the focus damps it, and a design that knows it makes up for it", "[session]")
{
    test::PlayedSession played;
    played.prepare (fingerRate);
    const auto wanted = test::focusNamed ("demonstrator").description.targets.front().peakVelocity;
    CHECK (played.play (4800, { live }).row (9).cwiseAbs().maxCoeff() == Approx (wanted).epsilon (0.1));
    const auto unknown = peakUnder (played, false);
    CHECK (unknown > 0.2 * wanted);
    CHECK (unknown < 0.8 * wanted);
    CHECK (peakUnder (played, true) == Approx (wanted).epsilon (0.1));
}

TEST_CASE ("Fingers beside the surface of another device are left out, and that is said", "[session]")
{
    test::PlayedSession played;
    played.prepare (fingerRate);
    const auto before = played.play (2400, { live });
    const auto far = withFingers (test::focusNamed ("demonstrator"), { builtInFinger ("light", 0.5, 0) });
    played.session.load (nullptr, std::make_shared<const FocusDocument> (far));
    const std::array events { live };
    played.session.waitUntilSettled (events);
    CHECK (played.session.snapshot()->fingerError.find ("Played without fingers: ") == 0);
    CHECK (played.session.snapshot()->fingerError.find ("outside the surface") != std::string::npos);
    played.play (4800);
    CHECK (played.play (2400, { live }).topRows (8).isApprox (before.topRows (8)));
    const std::vector<Finger> fingers { builtInFinger ("light", 0.01, 0) };
    played.session.load (nullptr, std::make_shared<const FocusDocument> (withFingers (far, fingers)));
    played.session.waitUntilSettled();
    CHECK (played.session.snapshot()->fingerError.empty());
}

TEST_CASE ("A focus keeps its fingers in its text", "[session]")
{
    auto unknown = builtInFinger ("firm", -0.03, 0);
    unknown.isKnown = false;
    const std::vector<Finger> fingers { builtInFinger ("light", 0.01, 0), unknown };
    const auto focus = withFingers (test::focusNamed ("demonstrator"), fingers);
    const auto again = readFocusDocument (nlohmann::json::parse (focus.text), "focus");
    CHECK (focus.description.fingers == fingers);
    CHECK (again.description.fingers == fingers);
    CHECK (withFingers (focus, {}).text == test::focusNamed ("demonstrator").text);
}
