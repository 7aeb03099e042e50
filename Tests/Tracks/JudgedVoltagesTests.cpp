#include "Support/ErrorText.h"
#include "Support/SinePlate.h"

#include <antinode_render/PerformedWaveforms.h>
#include <antinode_render/PlayedTracks.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <tuple>
#include <utility>

using namespace antinode;

namespace
{
WaveformsDescription clickAndSilence()
{
    WaveformsDescription description;
    description.band = { 100, 800 };
    description.tracks.resize (1);
    auto& point = description.tracks[0].point;
    std::tie (point.x, point.y) = std::pair (0.05, 0.06);
    description.tracks[0].events[0].signal = ClickSignal { 350 };
    description.tracks[0].events[0].level.value = 1e-6;
    description.silent.resize (1);
    std::tie (description.silent[0].x, description.silent[0].y) = std::pair (0.15, 0.04);
    return description;
}

TrackSettings settings()
{
    TrackSettings settings;
    settings.threshold = { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };
    return settings;
}

const ModalModel& plate()
{
    static const auto model = test::SinePlate().model (20);
    return model;
}

const PerformedWaveforms& designed()
{
    static const auto performed = performWaveforms (plate(), plate(), clickAndSilence(), settings());
    return performed;
}

PerformedWaveforms judged (const Eigen::MatrixXd& voltages, const WaveformsDescription& description)
{
    return judgeVoltages (plate(), plate(), description, settings(), voltages);
}

/** The designed voltages behind silence, as in a recording that was started earlier. */
Eigen::MatrixXd recorded (Eigen::Index silence)
{
    const auto& voltages = designed().design.voltages.values;
    Eigen::MatrixXd longer = Eigen::MatrixXd::Zero (voltages.rows(), silence + voltages.cols());
    longer.rightCols (voltages.cols()) = voltages;
    return longer;
}
} // namespace

TEST_CASE ("A recording of voltages has the scores of their design, wherever it begins", "[tracks][render]")
{
    const auto silence = GENERATE (0, 1234);
    const auto result = judged (recorded (silence), clickAndSilence());
    const auto& own = designed();
    CHECK (result.played.trigger == own.played.trigger + silence);
    CHECK (*result.likeness > 0.9999);
    CHECK (result.design.warnings.empty());
    CHECK (result.design.peaks.maxCoeff() == Approx (own.design.peaks.maxCoeff()));

    for (std::size_t p = 0; p < 2; ++p)
    {
        CHECK (result.scores.fingers[p].reachedPeak == Approx (own.scores.fingers[p].reachedPeak));
        CHECK (result.scores.suppression (p) == Approx (own.scores.suppression (p)).margin (1));
    }

    const auto json = performedToJson (result);
    CHECK (json["likeness"].get<double>() == *result.likeness);
    CHECK_FALSE (json.contains ("design_error"));
}

TEST_CASE ("Recorded voltages of another sign or half the level are told from those that are right", "[tracks][render]")
{
    const auto reversed = judged (-recorded (0), clickAndSilence());
    REQUIRE_FALSE (reversed.design.warnings.empty());
    CHECK (reversed.design.warnings[0].find ("order, sign and scale") != std::string::npos);

    // Half of the motion is missing: -6 dB.
    const auto quiet = judged (0.5 * recorded (0), clickAndSilence());
    CHECK (quiet.scores.suppression (0) == Approx (-6.02).margin (0.05));

    const auto nothing = judged (0 * recorded (0), clickAndSilence());
    CHECK (*nothing.likeness == 0);
    CHECK (nothing.scores.suppression (0) == Approx (0).margin (1e-6));
}

TEST_CASE ("Recorded voltages that do not belong to the device or the points are refused", "[tracks][render]")
{
    const Eigen::MatrixXd voltages = recorded (0);
    CHECK (errorText ([&] { judged (voltages.topRows (3), clickAndSilence()); })
               .find ("have 3 channels; allowed: " + std::to_string (plate().actuators()))
           != std::string::npos);
    auto moving = clickAndSilence();
    moving.silent[0].path = { { 0, 0.15, 0.04 }, { 0.05, 0.14, 0.04 } };
    CHECK (errorText ([&] { judged (voltages, moving); }).find ("have a path") != std::string::npos);
}
