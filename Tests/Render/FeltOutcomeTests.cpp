#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_render/RenderedFocus.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double pi = std::numbers::pi;

/** Velocity of one place, averaged over eight samples each, faded out within its last tenth of a second. */
Eigen::VectorXd slowedProbe (const Render& render)
{
    Eigen::VectorXd slow (render.probeVelocities.cols() / 8);
    const auto fade = 0.1 * render.sampleRate / 8;

    for (Eigen::Index n = 0; n < slow.size(); ++n)
    {
        const auto left = static_cast<double> (slow.size() - 1 - n);
        slow[n] = render.probeVelocities.row (0).segment (8 * n, 8).mean()
                  * (left < fade ? 0.5 - 0.5 * std::cos (pi * left / fade) : 1.0);
    }

    return slow;
}

/** The level of a recorded velocity by sums over all samples and all lines of 2 Hz, without any transform of ours. */
double levelBySums (const Render& render, const SkinThreshold& threshold)
{
    const auto velocity = slowedProbe (render);
    const auto rate = render.sampleRate / 8;
    constexpr double step = 2;
    std::vector<std::complex<double>> lines;

    for (double f = step; f < 2500; f += step)
    {
        std::complex<double> sum = 0, phasor = 1;
        const auto turn = std::polar (1.0, -2 * pi * f / rate);

        for (const auto value : velocity)
        {
            sum += value * phasor;
            phasor *= turn;
        }

        lines.push_back (sum / rate / std::complex (0.0, 2 * pi * f) / thresholdAt (threshold, f));
    }

    double peak = 0, energy = 0, most = 0;
    std::vector<double> squares;

    for (double t = 0; t < 0.4; t += 1 / 8000.0)
    {
        std::complex<double> sum = 0, phasor = std::polar (1.0, 2 * pi * step * t);
        const auto turn = phasor;

        for (const auto& line : lines)
        {
            sum += line * phasor;
            phasor *= turn;
        }

        const auto value = 2 * step * sum.real();
        peak = std::max (peak, std::abs (value));
        squares.push_back (value * value);
        energy += squares.back() - (squares.size() > 800 ? squares[squares.size() - 801] : 0);
        most = std::max (most, energy);
    }

    return 20 * std::log10 (std::max (peak, std::sqrt (2 * most / 800)));
}

RenderedFocus renderFelt (std::optional<double> duration, const std::vector<Finger>& fingers = {})
{
    const auto model = solveDevice (loadDevice ("staple", {}), {}, true);
    RenderOptions options;
    options.duration = duration;
    options.threshold = findSkinThreshold ({});
    auto focus = loadFocus ("demonstrator", {});
    focus.fingers = fingers;
    return renderFocus (model, designFocus (model, focus, options.playback, DesignExtent::playable), options);
}
} // namespace

TEST_CASE ("The felt level at a focus is that of its recorded velocity, summed line by line", "[felt]")
{
    const auto recorded = renderFelt (0.4);
    const auto byHand = levelBySums (recorded.render, findSkinThreshold ({}));
    CHECK (recorded.felt->targets.front().level == Approx (byHand).margin (0.2));

    // A file that ends 25 ms after the focus is felt as the whole event is.
    CHECK (renderFelt ({}).felt->targets.front().level == Approx (byHand).margin (0.2));
}

TEST_CASE ("The demonstrator is felt far from its focus as strongly as there", "[felt]")
{
    const auto felt = renderFelt ({}).felt.value();
    CHECK (felt.contrast().value() == Approx (felt.targets.front().level - felt.elsewhere->level));
    CHECK (std::abs (felt.contrast().value()) < 3);
    CHECK (std::abs (felt.elsewhere->x - 0.024) > feltNeighbourhood);

    const auto strongest = std::max_element (felt.places.begin(), felt.places.end(),
                                             [] (const auto& a, const auto& b) { return a.level < b.level; });
    CHECK (strongest->level >= felt.targets.front().level - 0.1);
    const auto json = feltToJson (felt);
    CHECK (json["contrast_dB"] == felt.contrast().value());
    CHECK (json["targets"].size() == 1);
}

TEST_CASE ("Each finger has its level, and the focus its contrast to it", "[felt]")
{
    Finger finger;
    finger.x = -0.02;
    const auto felt = renderFelt ({}, { finger }).felt.value();
    REQUIRE (felt.bystanders.size() == 1);
    const auto json = feltToJson (felt);
    CHECK (json["bystanders"][0]["place_mm"][0] == Approx (-20));
    CHECK (json["bystanders"][0]["level_dB"] == felt.bystanders[0].level);
    CHECK (json["bystanders"][0]["contrast_dB"] == Approx (felt.targets[0].level - felt.bystanders[0].level));
    CHECK_FALSE (feltToJson (renderFelt ({}).felt.value()).contains ("bystanders"));

    for (const auto& place : felt.places)
        if (std::abs (place.x - finger.x) < 1e-9)
            CHECK (place.level == Approx (felt.bystanders[0].level));
}

TEST_CASE ("A threshold is a table of Hz and um, or says what it lacks", "[felt]")
{
    const auto threshold = readSkinThreshold ("# mine\nHz,um\n100,0.5\n250,0.1\n", "mine.csv");
    CHECK (thresholdAt (threshold, 250) == Approx (1e-7));
    CHECK_THROWS_WITH (readSkinThreshold ("100,0.5\n", "mine.csv"),
                       Catch::Contains ("mine.csv") && Catch::Contains ("at least two lines"));
    CHECK_THROWS_WITH (readSkinThreshold ("100,0.5,1\n250,0.1,1\n", "mine.csv"), Catch::Contains ("3 columns"));
    CHECK_THROWS_WITH (readSkinThreshold ("250,0.5\n100,0.1\n", "mine.csv"), Catch::Contains ("ascending"));
    CHECK_THROWS_WITH (findSkinThreshold ("/no/such.csv"), Catch::Contains ("/no/such.csv"));
}

TEST_CASE ("A focus is felt at the level that it asks for, at its own place and at any other", "[felt]")
{
    const auto model = solveDevice (loadDevice ("staple", {}), {}, true);
    RenderOptions options;
    options.duration = 0.4;
    options.threshold = findSkinThreshold ({});
    const auto focus = loadFocus ("demonstrator", { "focus.targets.0.peak_level_dB_SL=20" });
    REQUIRE (focus.targets.front().level == 20);
    double velocity = 0;

    for (const auto x : { 0.024, -0.024, 0.05 })
    {
        const auto design = designFocus (model, movedTo (focus, x, 0), options.playback, DesignExtent::playable);
        CHECK_FALSE (design.description.targets.front().level);
        CHECK (renderFocus (model, design, options).felt->targets.front().level == Approx (20).margin (0.05));
        velocity = design.description.targets.front().peakVelocity;
    }

    // Everything is linear: twice the velocity is felt 6.02 dB more strongly.
    auto louder = movedTo (focus, 0.05, 0);
    *louder.targets.front().level += 20 * std::log10 (2.0);
    const auto design = designFocus (model, louder, options.playback, DesignExtent::playable);
    CHECK (design.description.targets.front().peakVelocity == Approx (2 * velocity).epsilon (0.005));
}

TEST_CASE ("Targets of one event have levels of their own, as long as they do not keep each other from it", "[felt]")
{
    const auto model = solveDevice (loadDevice ("staple", {}), {}, true);
    RenderOptions options;
    options.threshold = findSkinThreshold ({});
    auto focus = loadFocus ("demonstrator", { "focus.targets.0.peak_level_dB_SL=22" });
    focus.targets.push_back (focus.targets.front());
    focus.targets.back().x = -0.03;
    focus.targets.back().level = 21;
    const auto felt =
        renderFocus (model, designFocus (model, focus, options.playback, DesignExtent::playable), options).felt.value();
    CHECK (felt.targets[0].level == Approx (22).margin (0.05));
    CHECK (felt.targets[1].level == Approx (21).margin (0.05));

    focus.targets.back() = focus.targets.front();
    focus.targets.back().level = 12;
    CHECK_THROWS_AS (designFocus (model, focus, options.playback, DesignExtent::playable), InputError);
}

TEST_CASE ("A level beyond the limits is refused with the one that can be reached", "[felt]")
{
    const auto model = solveDevice (loadDevice ("staple", {}), {}, true);
    const Playback playback { Reconstruction::bandLimited, 48000 };
    auto focus = loadFocus ("demonstrator", { "focus.targets.0.peak_level_dB_SL=60" });

    try
    {
        designFocus (model, focus, playback, DesignExtent::playable);
        FAIL ("60 dB SL are beyond 50 V");
    }
    catch (const LimitError& failure)
    {
        const std::string text (failure.what());
        const auto at = text.find ("up to about ");
        REQUIRE (at != std::string::npos);
        focus.targets.front().level = std::stod (text.substr (at + 12)) - 0.1;
    }

    CHECK_NOTHROW (designFocus (model, focus, playback, DesignExtent::playable));
    *focus.targets.front().level += 6;
    CHECK_THROWS_AS (designFocus (model, focus, playback, DesignExtent::playable), LimitError);
}

TEST_CASE ("A target has a velocity or a level, and what is set replaces the other", "[felt]")
{
    CHECK_FALSE (
        loadFocus ("demonstrator", { "focus.targets.0.peak_level_dB_SL=20", "focus.targets.0.peak_velocity_mm_s=5" })
            .targets.front()
            .level);
    auto document = nlohmann::json (focusToJson (loadFocus ("demonstrator", {})));
    document["targets"][0]["peak_level_dB_SL"] = 20;
    CHECK_THROWS_WITH (readFocus (document, "focus"), Catch::Contains ("peak_velocity_mm_s' and 'peak_level_dB_SL"));
}
