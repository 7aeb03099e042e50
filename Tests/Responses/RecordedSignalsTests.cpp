#include <antinode_responses/HammerMeasurement.h>
#include <antinode_responses/MeasurementReader.h>
#include <antinode_responses/RecordedSignals.h>

#include <Support/ErrorText.h>

#include <antinode_responses/UniversalFile.h>
#include <antinode_text/WaveFile.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double rate = 4096;

Eigen::VectorXd hitAt (double time, Eigen::Index samples)
{
    return Eigen::VectorXd::NullaryExpr (samples,
                                         [time] (Eigen::Index n)
                                         {
                                             const auto within = static_cast<double> (n) / rate - time;
                                             return within > 0 && within < 2e-3
                                                        ? std::sin (std::numbers::pi * within / 2e-3)
                                                        : 0.0;
                                         });
}

RecordedSignal motion (const std::string& point, int direction, double factor)
{
    RecordedSignal signal;
    signal.point = point;
    signal.direction = direction;
    signal.unit = { ResponseQuantity::velocity, 1, {} };
    signal.samples = factor * hitAt (0.05, 4096);
    return signal;
}

RecordedSignal hammerAt (const std::string& point)
{
    RecordedSignal force;
    force.isForce = true;
    force.point = point;
    force.unit = { {}, 1, DriveQuantity::force };
    force.samples = hitAt (0.05, 4096);
    return force;
}

/** Sensors whose motion is the force itself, times a factor each: so are the responses. */
RecordingFile factors (const std::string& hit, const std::vector<RecordedSignal>& motions)
{
    RecordedSignals recording { "r", rate, { hammerAt (hit) }, {} };
    recording.signals.insert (recording.signals.end(), motions.begin(), motions.end());
    return { { recording }, {} };
}

double meanOf (const Eigen::MatrixXcd& values, Eigen::Index column)
{
    return values.col (column).real().mean();
}
} // namespace

TEST_CASE ("a text's headings name force, points, directions and units", "[hammer]")
{
    std::string text = "time (s), force (N), P3 x (m/s^2), P3 -z [g], acc 12 (mm/s)\n";

    for (int n = 0; n < 8; ++n)
        text += std::to_string (n * 0.001) + "," + std::to_string (n) + ",1,2,3\n";

    const auto file = decodeRecordings (text, "a.csv", {});
    REQUIRE (file.recordings.size() == 1);
    const auto& recording = file.recordings[0];
    CHECK (recording.sampleRate == Approx (1000));
    REQUIRE (recording.signals.size() == 4);
    CHECK (recording.signals[0].isForce);
    CHECK (recording.signals[0].samples[5] == 5);
    CHECK (recording.signals[1].point == "3");
    CHECK (recording.signals[1].direction == 1);
    CHECK (recording.signals[1].unit.quantity == ResponseQuantity::acceleration);
    CHECK (recording.signals[2].direction == -3);
    CHECK (recording.signals[2].unit.factor == Approx (9.80665));
    CHECK (recording.signals[3].point == "12");
    CHECK (recording.signals[3].unit.quantity == ResponseQuantity::velocity);
    CHECK (recording.signals[3].unit.factor == Approx (1e-3));
}

TEST_CASE ("channels of a WAV file have the names that they are given, and the names of the file's words", "[hammer]")
{
    const auto bytes = encodeWave (Eigen::MatrixXd::Random (4, 100), 1, 48000);
    const auto named = decodeRecordings (bytes, "hits.wav", { "1:x", "force:7", "1:-y", "1:z" }).recordings[0].signals;
    CHECK (named[1].isForce);
    CHECK (named[1].point == "7");
    CHECK (named[2].direction == -2);
    CHECK (named[3].point == "1");
    const auto two = encodeWave (Eigen::MatrixXd::Random (2, 100), 1, 48000);
    const auto byName = decodeRecordings (two, "point3_driver5.wav", {}).recordings[0].signals;
    CHECK (byName[0].point == "5");
    CHECK (byName[1].point == "3");
    CHECK (byName[1].fullScale == 1);

    CHECK (errorText (
               [&] {
                   decodeRecordings (bytes, "hits.wav", { "force", "1" });
               })
               .find ("has 4 channels")
           == 9 + 1);
    CHECK (errorText (
               [&] {
                   decodeRecordings (two, "hits.wav", { "1", "2" });
               })
               .find ("0 channels of a force")
           != std::string::npos);
    CHECK (errorText ([] { namedChannel ("3:q", "--channels"); }).find ("is not a channel") != std::string::npos);
}

TEST_CASE ("time records of a universal file belong together by their order, forces by their unit", "[hammer]")
{
    std::vector<UniversalSet> sets;

    for (int hit = 0; hit < 2; ++hit)
        for (const auto isForce : { true, false })
        {
            UniversalFunction function;
            function.functionType = 1;
            function.ordinateType = 4;
            function.response = { "NONE", isForce ? 7 : 3, isForce ? -3 : 1 };
            function.step = 1 / rate;
            function.ordinate =
                isForce ? UniversalAxis { 13, {}, "Force", "N" } : UniversalAxis { 12, {}, "Acceleration", "m/s^2" };
            function.values = (hit + 1) * hitAt (0.05, 64).cast<std::complex<double>>();
            sets.emplace_back (function);
        }

    const auto file = decodeRecordings (encodeUniversalFile (sets), "t.uff", {});
    REQUIRE (file.recordings.size() == 2);
    CHECK (file.recordings[1].sampleRate == Approx (rate));
    CHECK (file.recordings[1].signals[0].isForce);
    CHECK (file.recordings[1].signals[0].point == "7");
    CHECK (file.recordings[1].signals[0].direction == -3);
    CHECK (file.recordings[1].signals[1].unit.quantity == ResponseQuantity::acceleration);
}

TEST_CASE ("a MATLAB file has a rate, a force and an array of motions in either orientation", "[hammer]")
{
    MatlabVariable force { "data.force", { 4, 1 }, { 0, 5, 1, 0 }, {}, {}, {} };
    MatlabVariable rows { "data.Acceleration", { 2, 4 }, { 1, 10, 2, 20, 3, 30, 4, 40 }, {}, {}, {} };
    MatlabVariable columns { "velocity", { 4, 2 }, { 1, 2, 3, 4, 10, 20, 30, 40 }, {}, {}, {} };
    const MatlabVariable sampleRate { "fs", { 1, 1 }, { 5000 }, {}, {}, {} },
        times { "t", { 4, 1 }, { 0, 0.1, 0.2, 0.3 }, {}, {}, {} };
    const auto first = recordingsFromMatlab ({ sampleRate, force, rows }, "a.mat").recordings[0];
    const auto second = recordingsFromMatlab ({ times, force, columns }, "b.mat").recordings[0];
    CHECK (first.sampleRate == 5000);
    CHECK (second.sampleRate == Approx (10));
    CHECK (first.signals[1].unit.quantity == ResponseQuantity::acceleration);
    CHECK (second.signals[1].unit.quantity == ResponseQuantity::velocity);

    for (const auto& recording : { first, second })
    {
        REQUIRE (recording.signals.size() == 3);
        CHECK (recording.signals[0].isForce);
        CHECK (recording.signals[2].point == "2");
        CHECK (recording.signals[2].samples == Eigen::Vector4d (10, 20, 30, 40));
    }

    CHECK (errorText ([&] { recordingsFromMatlab ({ force, rows }, "c.mat"); }).find ("c.mat: has no times") == 0);
    CHECK (errorText (
               [&] {
                   recordingsFromMatlab ({ sampleRate, rows }, "d.mat");
               })
               .find ("d.mat: has no recording of a hammer")
           == 0);
}

TEST_CASE ("a triaxial sensor's directions are kept apart, with the place of its point, and identify takes the hit one",
           "[hammer]")
{
    HammerOptions options;
    options.stated.places = { { "1", { 0.01, 0.02 } }, { "2", { 0.03, 0.04 } } };
    const auto measurement =
        measureByHammer ({ factors ("2", { motion ("2", 1, 4), motion ("2", 2, 5), motion ("2", -3, 6) }),
                           factors ("2", { motion ("9", 1, 7), motion ("9", 2, 8), motion ("9", 3, 9) }) },
                         options);
    REQUIRE (measurement.points.size() == 6);
    CHECK (measurement.points[1] == HammerPoint { "2", 2 });
    REQUIRE (measurement.responses.values.size() == 1);
    CHECK (meanOf (measurement.responses.values[0], 0) == Approx (4));
    CHECK (meanOf (measurement.responses.values[0], 2) == Approx (-6)); // against z
    CHECK (meanOf (measurement.responses.values[0], 5) == Approx (9));
    CHECK (measurement.responses.references[0].point == 2);

    const auto bytes = encodeUniversalFile (hammerSets (measurement));
    const auto merged = mergedResponses ({ decodeMeasurement (bytes, "h.uff", CsvForm::byHeadings) }, {});
    CHECK (merged.pointNames == std::vector<std::string> { "2", "9" });
    CHECK (merged.hasPlaces);
    CHECK (merged.responses.drive == DriveQuantity::force);
    CHECK ((merged.responses.points.row (1).transpose() - Eigen::Vector2d (0.03, 0.04)).norm() < 1e-12);
    CHECK (meanOf (merged.responses.values[0], 0) == Approx (-6));
    CHECK (meanOf (merged.responses.values[0], 1) == Approx (9));
    CHECK (merged.responses.references[0].point == 0);
}

TEST_CASE ("hits of several files are averaged with a coherence, other hit points are further references", "[hammer]")
{
    const auto measurement =
        measureByHammer ({ factors ("1", { motion ("1", 0, 2) }), factors ("1", { motion ("1", 0, 2.2) }),
                           factors ("4", { motion ("1", 0, 3) }) },
                         {});
    REQUIRE (measurement.responses.values.size() == 2);
    CHECK (meanOf (measurement.responses.values[0], 0) == Approx (2.1));
    CHECK (meanOf (measurement.responses.values[1], 0) == Approx (3));
    // Two hits of 2 and 2.2: (2 + 2.2)^2 / 2 / (2^2 + 2.2^2).
    CHECK (measurement.coherence[0].mean() == Approx (4.2 * 4.2 / 2 / (4 + 4.84)));
    CHECK_FALSE (measurement.coherence[1].allFinite());

    const auto sets = readUniversalFile (encodeUniversalFile (hammerSets (measurement)), "h.uff");
    const auto coherences = std::count_if (sets.begin(), sets.end(),
                                           [] (const auto& set)
                                           {
                                               const auto* const function = std::get_if<UniversalFunction> (&set);
                                               return function != nullptr && function->functionType == 6;
                                           });
    CHECK (coherences == 1);
}

TEST_CASE ("accelerations under an exponential window become velocities at i omega plus its rate, which the file tells",
           "[hammer]")
{
    auto acceleration = motion ("1", 3, 2);
    acceleration.unit.quantity = ResponseQuantity::acceleration;
    HammerOptions options;
    options.hits.windowDecay = 12.5;
    const auto measurement = measureByHammer ({ factors ("1", { acceleration }) }, options);
    const auto& frequencies = measurement.responses.frequencies;

    for (Eigen::Index f = 0; f < frequencies.size(); f += 50)
        CHECK (std::abs (measurement.responses.values[0](f, 0)
                             * std::complex<double> (12.5, 2 * std::numbers::pi * frequencies[f])
                         - 2.0)
               < 1e-9);

    const auto read = mergedResponses (
        { decodeMeasurement (encodeUniversalFile (hammerSets (measurement)), "h.uff", CsvForm::byHeadings) }, {});
    CHECK (read.windowDecay == 12.5);
}
