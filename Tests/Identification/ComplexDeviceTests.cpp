#include "Support/ViscousChain.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_identification/Identification.h>
#include <antinode_identification/IdentifiedModel.h>

#include <catch2/catch.hpp>

#include <numbers>
#include <random>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** What a scanning vibrometer sees of a chain, from its equations of motion, with noise so far below the RMS. */
FrequencyResponses measured (const ViscousChain& chain, double decibels)
{
    using namespace std::complex_literals;
    FrequencyResponses responses;
    responses.frequencies = Eigen::VectorXd::LinSpaced (4201, 300, 4500);
    responses.points = complexModel (chain).surface.points;
    std::mt19937 generator (7);
    std::normal_distribution<double> normal;

    for (Eigen::Index i = 0; i < chain.forces.cols(); ++i)
    {
        responses.references.push_back ({ "C" + std::to_string (i + 1), {} });
        Eigen::MatrixXcd values (responses.frequencies.size(), chain.size());

        for (Eigen::Index f = 0; f < values.rows(); ++f)
        {
            const auto omega = 2 * std::numbers::pi * responses.frequencies[f];
            const Eigen::MatrixXcd impedance =
                chain.stiffness - omega * omega * chain.mass + 1i * omega * chain.damping;
            values.row (f) =
                (1i * omega * impedance.partialPivLu().solve (chain.forces.col (i).cast<std::complex<double>>()))
                    .transpose();
        }

        const auto noise =
            values.norm() / std::sqrt (static_cast<double> (2 * values.size())) * std::pow (10, -decibels / 20);
        values += values.unaryExpr ([&] (const auto&)
                                    { return noise * std::complex<double> (normal (generator), normal (generator)); });
        responses.values.push_back (std::move (values));
    }

    return responses;
}

FocusDescription identifiedFocus()
{
    FocusDescription focus;
    focus.targets = { { TargetShape::gaussian, 0.03, 0, 0.025, 0.02, 1 } };
    focus.focusTime = 0.025;
    return focus;
}

/** What the chain itself does with voltages that were designed on a model. */
FieldScore playedOnChain (const ViscousChain& chain, const ModalModel& model)
{
    const auto design = designFocus (model, identifiedFocus(), {});
    const Eigen::VectorXd velocity = chainMotion (chain, design.program, 0.025).tail (chain.size());
    return scoreField (model.surface, velocity, design.truncatedField);
}
} // namespace

TEST_CASE ("A device identified with complex modes does on the true one what it promises", "[identification][complex]")
{
    const auto chain = viscousChain (8, 4, 10);
    const auto responses = measured (chain, 60);
    const auto truth = complexModel (chain);
    const auto modes = identify (responses, {});
    REQUIRE (modes.modes() == 8);
    CHECK ((modes.angularFrequencies - truth.angularFrequencies)
               .cwiseQuotient (truth.angularFrequencies)
               .cwiseAbs()
               .maxCoeff()
           < 1e-5);
    CHECK ((modes.dampingRatios - truth.dampingRatios).cwiseQuotient (truth.dampingRatios).cwiseAbs().maxCoeff()
           < 3e-3);

    MappedSurface surface;
    surface.name = "identified";
    const auto model = toModalModel (modes, surface);
    CHECK (model.hasComplexModes());
    CHECK ((phaseCollinearities (model) - phaseCollinearities (truth)).cwiseAbs().maxCoeff() < 0.01);
    const auto score = playedOnChain (chain, model);
    CHECK (score.vScore > 0.9999);
    CHECK (score.fieldError < 0.01);
}
