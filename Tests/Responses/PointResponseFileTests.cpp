#include "Support/ErrorText.h"

#include <antinode_responses/PointResponseFile.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
SurfaceMeasurement empty (int resolution)
{
    ExcitationSettings settings;
    settings.sampleRate = 8000;
    settings.highestFrequency = 1000;
    settings.resolution = resolution;
    settings.levels = Eigen::Vector2d (10, 10);
    Eigen::MatrixX2d points (3, 2);
    points << 0.01, 0.02, 0.03, 0.04, 0.05, 0.06;
    return unmeasured (makeExcitation (settings, settings.levels), { "left", "right" }, points);
}
} // namespace

TEST_CASE ("Responses of a point are the same to the bit when they are restored")
{
    auto measurement = empty (10);
    const auto lines = measurement.responses.frequencies.size();
    std::srand (1);

    for (Eigen::Index ceramic = 0; ceramic < 2; ++ceramic)
    {
        RunResponses run;
        run.responses.values = Eigen::MatrixXcd::Random (lines, 1) * 1e-4;
        run.responses.variances = Eigen::MatrixXd::Random (lines, 1).cwiseAbs();
        run.responses.coherence = Eigen::MatrixXd::Random (lines, 1).cwiseAbs();
        place (measurement, ceramic, 1, run);
    }

    auto restored = empty (10);
    restorePoint (restored, 1, encodePoint (measurement, 1), "point.uff");

    for (std::size_t i = 0; i < 2; ++i)
    {
        CHECK (restored.responses.values[i].col (1) == measurement.responses.values[i].col (1));
        CHECK (restored.coherence[i].col (1).isApprox (measurement.coherence[i].col (1), 1e-7));
        CHECK_FALSE (restored.responses.values[i].col (0).allFinite());
    }

    auto other = empty (20);
    CHECK_THAT (errorText ([&] { restorePoint (other, 1, encodePoint (measurement, 1), "point.uff"); }),
                Catch::Contains ("belongs to another measurement"));
}
