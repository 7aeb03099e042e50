#include "ChainModel.h"

#include "DescribedModel.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace antinode
{
namespace
{
/** The places on an element where its motion is handed on. */
Eigen::Index pointCount (const ChainElement& element, int degree, double angularFrequency)
{
    // The rule's widest gap is about pi/2 times its mean one. A gap g interpolates a wave of wave number k with an
    // error of (k g)^4 / 384 of its amplitude, so k g < 0.0787 keeps it below 1e-7.
    constexpr double gapsPerPhase = 1.571 / 0.0787;
    const auto phase = bendingWaveNumber (element.section, angularFrequency) * element.length;
    return std::max<Eigen::Index> (degree + 2, 1 + static_cast<Eigen::Index> (std::ceil (gapsPerPhase * phase)));
}

/** A rule for every element: that of its points on the surface, and elsewhere just its last end. */
std::vector<QuadratureRule> surfaceRules (const ElementChain& chain, int degree, double angularFrequency)
{
    const QuadratureRule lastEnd { Eigen::VectorXd::Ones (1), Eigen::VectorXd::Zero (1) };
    std::vector<QuadratureRule> rules;
    std::transform (chain.elements.begin(), chain.elements.end(), std::back_inserter (rules),
                    [&] (const ChainElement& element) {
                        return element.onSurface ? gaussLobattoRule (pointCount (element, degree, angularFrequency))
                                                 : lastEnd;
                    });
    return rules;
}

/** Room for all points; neighbouring elements share one. */
void resize (ModalModel& model, const ElementChain& chain, const std::vector<QuadratureRule>& rules, Eigen::Index modes)
{
    Eigen::Index points = 1;

    for (std::size_t e = 0; e < rules.size(); ++e)
        if (chain.elements[e].onSurface)
            points += rules[e].places.size() - 1;

    model.surface.points = Eigen::MatrixX2d::Zero (points, 2);
    model.surface.masses = Eigen::VectorXd::Zero (points);
    model.surface.areas = Eigen::VectorXd::Zero (points);
    model.shapes.resize (points, modes);
    model.slopes.resize (points, modes);
}

/** Writes an element's points from the given row on; the first row is shared with the element before. */
void writeElement (ModalModel& model, Eigen::Index row, const ChainElement& element, const QuadratureRule& rule,
                   const ElementMotion& motion, double width)
{
    const auto count = rule.places.size();
    const Eigen::VectorXd lengths = rule.weights * (element.length / 2);
    model.surface.points.col (0).segment (row, count) =
        (element.start + element.length / 2 * (rule.places.array() + 1)).matrix();
    model.surface.masses.segment (row, count) += element.section.massPerLength * lengths;
    model.surface.areas.segment (row, count) += width * lengths;
    model.shapes.middleRows (row, count) = motion.transverse;
    model.slopes.middleRows (row, count) = motion.slope;
}
} // namespace

ModalModel makeModel (const ElementChain& chain, const ChainModes& modes, int degree, double angularFrequency,
                      double width, const Eigen::VectorXd& momentsPerVolt)
{
    const auto rules = surfaceRules (chain, degree, angularFrequency);
    std::vector<Eigen::VectorXd> places;
    std::transform (rules.begin(), rules.end(), std::back_inserter (places),
                    [] (const auto& rule) { return rule.places; });
    const auto motion = ChainBasis (chain, degree).motion (modes.coefficients, places);

    ModalModel model;
    model.angularFrequencies = modes.angularFrequencies;
    model.rigidBodyModes = modes.rigidBodyModes;
    model.unknowns = static_cast<int> (modes.coefficients.rows());
    model.participation = Eigen::MatrixXd::Zero (modes.angularFrequencies.size(), momentsPerVolt.size());
    resize (model, chain, rules, modes.angularFrequencies.size());
    Eigen::Index row = 0;

    for (std::size_t e = 0; e < rules.size(); ++e)
    {
        const auto& element = chain.elements[e];
        const auto& slope = motion.elements[e].slope;

        if (! element.onSurface)
            continue;

        writeElement (model, row, element, rules[e], motion.elements[e], width);
        row += rules[e].places.size() - 1;

        if (element.ceramic)
            model.participation.col (*element.ceramic) +=
                momentsPerVolt[*element.ceramic] * (slope.row (slope.rows() - 1) - slope.row (0)).transpose();
    }

    model.surface.xMinimum = model.surface.points (0, 0);
    model.surface.xMaximum = model.surface.points (row, 0);
    settleSigns (model);
    return model;
}
} // namespace antinode
