#include "MeasuredBeam.h"

#include <antinode_measurement/Excitation.h>
#include <antinode_numerics/Fourier.h>

#include <Support/ErrorText.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("Quick lengths are the least ones with factors 2, 3 and 5 only")
{
    CHECK (quickLength (1) == 4);
    CHECK (quickLength (4) == 4);
    CHECK (quickLength (4.1) == 8);
    CHECK (quickLength (96000) == 96000);
    CHECK (quickLength (96001) == 97200);
    CHECK (quickLength (1000003) == 1012500);
}

TEST_CASE ("The waveform between samples is larger than they are")
{
    // A tone at a quarter of the rate, sampled 45 degrees off its peaks.
    Eigen::VectorXd tone (400);

    for (Eigen::Index n = 0; n < tone.size(); ++n)
        tone[n] = std::sin (std::numbers::pi * (0.5 * static_cast<double> (n) + 0.25));

    CHECK (tone.maxCoeff() == Approx (std::sqrt (0.5)));
    CHECK (peakBetweenSamples (tone) == Approx (1).epsilon (1e-6));
}

TEST_CASE ("A multisine has equal lines, nothing between them, and a crest factor below Schroeder's")
{
    const auto lines = everyLine (80, 6000);
    const auto spectrum = forwardFourier (multisinePeriod (lines, 24000));
    const auto level = std::abs (spectrum[80]);

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
        REQUIRE (std::abs (spectrum[k]) == Approx (k >= 80 && k <= 6000 ? level : 0).margin (1e-9 * level));

    const auto crest = testExcitation (shortSettings (ExcitationSignal::multisine, 1)).crestFactor;
    CHECK (crest < 1.65);
    CHECK (crest > 1);
}

TEST_CASE ("An odd random grid leaves out the even lines and one odd line of four")
{
    const auto lines = oddRandomLines (100, 1700, 3);
    CHECK (lines.size() == 600);

    for (const auto line : lines)
        REQUIRE (line % 2 == 1);

    CHECK (lines != oddRandomLines (100, 1700, 4));
    CHECK (lines == oddRandomLines (100, 1700, 3));
}

TEST_CASE ("Excitations begin and end at rest and never exceed a ceramic's level")
{
    const auto signal = GENERATE (ExcitationSignal::multisine, ExcitationSignal::sweep, ExcitationSignal::noise);
    auto settings = shortSettings (signal, 3);
    settings.levels = Eigen::Vector3d (20, 150, 1);
    const auto excitation = testExcitation (settings);
    CHECK (std::abs (excitation.signal[0]) < 1e-3);
    CHECK (std::abs (excitation.signal[excitation.signal.size() - 1]) < 1e-3);

    for (Eigen::Index ceramic = 0; ceramic < 3; ++ceramic)
    {
        const auto played = playedRun (excitation, ceramic, 150);
        REQUIRE (played.rows() == 4);
        REQUIRE (played.cols() == excitation.runLength);
        const Eigen::VectorXd voltage = played.row (ceramic) * 150;
        CHECK (peakBetweenSamples (voltage) <= settings.levels[ceramic] * (1 + 1e-6));
        CHECK (peakBetweenSamples (voltage) > 0.9 * settings.levels[ceramic]);
        CHECK (voltage.tail (1000).isZero());

        for (Eigen::Index other = 0; other < 3; ++other)
            CHECK ((other == ceramic || played.row (other).isZero()));
    }
}

TEST_CASE ("The lines of an excitation lie within its band, no farther apart than asked for")
{
    const auto signal = GENERATE (ExcitationSignal::multisine, ExcitationSignal::sweep, ExcitationSignal::noise);
    auto settings = shortSettings (signal, 1);
    settings.resolution = 1.7;
    const auto frequencies = measuredFrequencies (testExcitation (settings));
    CHECK (frequencies[0] >= 80);
    CHECK (frequencies[frequencies.size() - 1] <= 6000);
    CHECK (frequencies[1] - frequencies[0] <= 1.7);
    CHECK (frequencies[1] - frequencies[0] > 1.5);
}

TEST_CASE ("Impossible excitations are refused with the allowed range")
{
    auto settings = shortSettings (ExcitationSignal::multisine, 2);

    SECTION ("above a ceramic's limit")
    {
        settings.levels[1] = 151;
        CHECK (errorText ([&] { testExcitation (settings); })
               == "excitation: level of ceramic 2: is 151 V; allowed: above 0 to its limit, 150 V");
    }

    SECTION ("beyond what converters leave alone")
    {
        settings.highestFrequency = 11000;
        CHECK_THAT (errorText ([&] { testExcitation (settings); }), Catch::Contains ("allowed: above 0 to 10800 Hz"));
    }

    SECTION ("no band")
    {
        settings.lowestFrequency = 7000;
        CHECK_THAT (errorText ([&] { testExcitation (settings); }),
                    Catch::Contains ("below the highest frequency, 6000 Hz"));
    }

    SECTION ("not a number")
    {
        settings.resolution = std::numeric_limits<double>::quiet_NaN();
        CHECK_THAT (errorText ([&] { testExcitation (settings); }), Catch::Contains ("resolution: is nan Hz"));
    }

    SECTION ("longer than memory")
    {
        settings.periods = 10000;
        CHECK_THAT (errorText ([&] { testExcitation (settings); }), Catch::Contains ("choose fewer periods"));
    }

    SECTION ("levels of other ceramics")
    {
        settings.levels.resize (0);
        CHECK_THAT (errorText ([&] { testExcitation (settings); }), Catch::Contains ("one for each of the 0 ceramics"));
    }
}
