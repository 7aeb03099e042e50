#include "Support/ModelOfStructure.h"

#include <antinode_identification/KnownModeFit.h>
#include <antinode_model/ShapesAtPlaces.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Responses of every fourteenth point of a structure up to 24 kHz, 40 dB. */
FrequencyResponses atFewPoints (KnownStructure structure)
{
    const auto points = Eigen::seq (1, structure.points.rows() - 1, 14);
    structure.points = structure.points (points, Eigen::all).eval();
    structure.shapes = structure.shapes (points, Eigen::all).eval();
    auto responses = idealResponses (structure, lines (200, 24000, 2));
    addNoise (responses, 40, 6);
    return responses;
}
} // namespace

TEST_CASE ("Poles that begin several half widths off do not keep the others from the most probable ones",
           "[identification]")
{
    const auto device = knownPlate (3, 150);
    const auto model = makeModel (device);
    const auto responses = atFewPoints (device);
    const KnownModes exact { model.angularFrequencies, model.dampingRatios, shapesAtPlaces (model, responses.points),
                             model.participation };
    const KnownModePrior prior { exact.angularFrequencies,
                                 Eigen::VectorXd::Constant (exact.modes(), 0.02),
                                 exact.dampingRatios,
                                 0.3,
                                 exact.participation,
                                 Eigen::MatrixXd::Constant (exact.modes(), exact.participation.cols(),
                                                            0.05 * exact.participation.cwiseAbs().maxCoeff()) };
    const auto fitFrom = [&] (const KnownModes& start)
    {
        auto data = prepare (responses, 0, 24000);
        return fitKnownModes (data, start, prior, device.delay);
    };
    auto off = exact;

    for (Eigen::Index k = 5; k < exact.modes(); k += 10)
        off.angularFrequencies[k] *= 1 + (k % 20 == 5 ? 3 : -3) * exact.dampingRatios[k];

    const auto fit = fitFrom (off), best = fitFrom (exact);

    for (Eigen::Index k = 0; k < exact.modes(); ++k)
        if (device.frequencies[k] < 23500)
        {
            CAPTURE (k);
            CHECK (std::abs (fit.modes.angularFrequencies[k] / best.modes.angularFrequencies[k] - 1)
                   < 0.2 * best.frequencyDeviations[k]);
        }
}
