#include "Wiring.h"

#include "Comparison.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>
#include <antinode_model/Surface.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double pi = std::numbers::pi;
constexpr Eigen::Index modesSeen = 25; ///< The lowest; a drawing knows the others too badly.
constexpr double blur = 0.04;          ///< Of the band: the rate at which answers are faded out, over 2 pi.
constexpr int linesSeen = 160;         ///< Frequencies that are compared.
constexpr double furthestStretch = 0.15;
constexpr int stretchSteps = 15;      // each way
constexpr double deadLevel = -26;     ///< dB
constexpr double clear = 0.5;         ///< Correlation of an answer that is that of a ceramic.
constexpr double foreignBelow = 0.15; ///< Correlation of one that is that of none.

/** Answers of all points, faded out in time: at complex frequencies alpha + j omega. */
struct Band
{
    Eigen::VectorXd frequencies; ///< Hz
    double alpha = 0;            ///< 1/s
};

Band bandOf (const ModalModel& drawn, const FrequencyResponses& responses)
{
    const auto last = std::min<Eigen::Index> (drawn.modes(), modesSeen) - 1;
    const auto lowest = responses.frequencies[0];
    const auto highest = std::min (responses.frequencies[responses.frequencies.size() - 1], drawn.frequencyHz (last));
    return { Eigen::VectorXd::LinSpaced (linesSeen, lowest, std::max (highest, 2 * lowest)),
             2 * pi * blur * std::max (highest, 2 * lowest) };
}

std::vector<Eigen::Index> measuredPoints (const ModalModel& drawn, const FrequencyResponses& responses)
{
    std::vector<Eigen::Index> points;

    for (Eigen::Index p = 0; p < responses.points.rows(); ++p)
        if (liesOn (drawn.surface, responses.points (p, 0), responses.points (p, 1))
            && std::all_of (responses.values.begin(), responses.values.end(),
                            [&] (const auto& values) { return values.col (p).array().isFinite().all(); }))
            points.push_back (p);

    return points;
}

/** One column per output: the answers of all points, one below the other. Fading out by exp (-alpha t) is a convolution
    with 1 / (alpha + j omega). */
Eigen::MatrixXcd measuredAnswers (const FrequencyResponses& responses, const std::vector<Eigen::Index>& points,
                                  const Band& band)
{
    const auto lines = responses.frequencies.size();
    Eigen::MatrixXcd kernel (linesSeen, lines);

    for (Eigen::Index l = 0; l < lines; ++l)
    {
        const auto before = responses.frequencies[std::max<Eigen::Index> (l - 1, 0)];
        const auto after = responses.frequencies[std::min (l + 1, lines - 1)];
        const auto width = (after - before) / (l == 0 || l == lines - 1 ? 1 : 2);

        for (Eigen::Index i = 0; i < linesSeen; ++i)
            kernel (i, l) =
                width / std::complex (band.alpha, 2 * pi * (band.frequencies[i] - responses.frequencies[l]));
    }

    Eigen::MatrixXcd answers (linesSeen * std::ssize (points), std::ssize (responses.values));

    for (Eigen::Index output = 0; output < answers.cols(); ++output)
    {
        checkWatch();

        for (std::size_t p = 0; p < points.size(); ++p)
            answers.col (output).segment (linesSeen * static_cast<Eigen::Index> (p), linesSeen) =
                kernel * responses.values[static_cast<std::size_t> (output)].col (points[p]);
    }

    return answers;
}

/** The same of the drawing with all its frequencies times a stretch: one column per ceramic. */
Eigen::MatrixXcd drawnAnswers (const ModalModel& drawn, const Eigen::MatrixXd& shapes, const Band& band, double stretch)
{
    const auto modes = drawn.modes();
    Eigen::MatrixXcd gains (linesSeen, modes);

    for (Eigen::Index i = 0; i < linesSeen; ++i)
    {
        const std::complex s (band.alpha, 2 * pi * band.frequencies[i]);

        for (Eigen::Index k = 0; k < modes; ++k)
        {
            const auto w = stretch * drawn.angularFrequencies[k];
            gains (i, k) = s / (w * w + 2 * drawn.dampingRatios[k] * w * s + s * s);
        }
    }

    Eigen::MatrixXcd answers (linesSeen * shapes.rows(), drawn.actuators());

    for (Eigen::Index p = 0; p < shapes.rows(); ++p)
        answers.middleRows (linesSeen * p, linesSeen) =
            gains * (shapes.row (p).transpose().asDiagonal() * drawn.participation);

    return answers;
}

/** What each output's answers have in common with each ceramic's: outputs x ceramics, -1 to 1. */
Eigen::MatrixXd correlations (const Eigen::MatrixXcd& measured, const Eigen::MatrixXcd& drawn)
{
    const Eigen::VectorXd sizes = measured.colwise().norm(), drawnSizes = drawn.colwise().norm();
    Eigen::MatrixXd result = (measured.adjoint() * drawn).real();

    for (Eigen::Index i = 0; i < result.rows(); ++i)
        for (Eigen::Index k = 0; k < result.cols(); ++k)
            result (i, k) = sizes[i] > 0 && drawnSizes[k] > 0 ? result (i, k) / (sizes[i] * drawnSizes[k]) : 0.0;

    return result;
}

double median (Eigen::VectorXd values)
{
    std::nth_element (values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

/** In dB, against the median. */
Eigen::VectorXd levels (const Eigen::MatrixXcd& measured, const Eigen::MatrixXcd& drawn)
{
    const Eigen::VectorXd ratios = (measured.colwise().norm().array() / drawn.colwise().norm().array()).transpose();
    const auto usual = median (ratios);
    return ratios.unaryExpr ([&] (double ratio)
                             { return usual > 0 ? 20 * std::log10 (std::max (ratio / usual, 1e-6)) : 0.0; });
}
/** How alike answers are, outputs x ceramics, and their levels in dB. */
struct ComparedAnswers
{
    Eigen::MatrixXd alike;
    Eigen::VectorXd levels;
};

/** With the drawing stretched to where the answers are most alike. */
ComparedAnswers compared (const ModalModel& drawn, const FrequencyResponses& responses,
                          const std::vector<Eigen::Index>& points)
{
    const auto band = bandOf (drawn, responses);
    const auto measured = measuredAnswers (responses, points, band);
    Eigen::MatrixXd shapes (std::ssize (points), drawn.modes());

    for (std::size_t p = 0; p < points.size(); ++p)
        shapes.row (static_cast<Eigen::Index> (p)) =
            shapesAt (drawn, responses.points (points[p], 0), responses.points (points[p], 1));

    ComparedAnswers best;
    double most = -1;

    for (int step = -stretchSteps; step <= stretchSteps; ++step)
    {
        checkWatch();
        const auto expected = drawnAnswers (drawn, shapes, band, 1 + furthestStretch * step / stretchSteps);
        auto alike = correlations (measured, expected);

        if (const auto all = alike.cwiseAbs().rowwise().maxCoeff().sum(); all > most)
        {
            most = all;
            best = { std::move (alike), levels (measured, expected) };
        }
    }

    return best;
}

/** -1 where most outputs answer with the other sign: it is the sensor's. */
double commonSign (const Eigen::MatrixXd& alike)
{
    const auto own = alike.diagonal().array();
    return (own < -clear).count() > (own > clear).count() ? -1 : 1;
}
} // namespace

std::vector<WireFinding> checkWiring (const ModalModel& drawn, const FrequencyResponses& responses)
{
    const auto outputs = std::ssize (responses.values);
    const auto points = measuredPoints (drawn, responses);

    if (points.empty() || outputs != drawn.actuators() || drawn.hasComplexModes() || responses.frequencies.size() < 8)
        return {};

    const auto [alike, size] = compared (drawn, responses, points);
    // Fewer points tell ceramics that lie alike apart less surely.
    const auto margin = 0.1 + 0.2 / static_cast<double> (points.size());
    const auto sign = commonSign (alike);
    // Each output drives one ceramic, its own unless others are clearly more alike.
    Eigen::MatrixXd worth = alike.cwiseAbs();

    // With the wrong sign it is as likely another one.
    for (Eigen::Index i = 0; i < std::min (worth.rows(), worth.cols()); ++i)
        worth (i, i) += sign * alike (i, i) > 0 ? margin : 0;

    const auto ceramics = assign (worth);
    std::vector<WireFinding> findings;

    for (Eigen::Index i = 0; i < outputs; ++i)
    {
        const auto best = ceramics[static_cast<std::size_t> (i)];
        const auto own = sign * alike (i, i);

        if (size[i] < deadLevel)
            findings.push_back ({ WireFinding::Kind::dead, i, i, size[i] });
        else if (best != i && std::abs (alike (i, best)) > clear)
            findings.push_back ({ WireFinding::Kind::exchanged, i, best, size[i] });
        else if (own < -clear)
            findings.push_back ({ WireFinding::Kind::reversed, i, i, size[i] });
        else if (alike.row (i).cwiseAbs().maxCoeff() < foreignBelow)
            findings.push_back ({ WireFinding::Kind::foreign, i, i, size[i] });
    }

    return findings;
}

std::string wireInWords (const WireFinding& found)
{
    const auto output = "Output " + std::to_string (found.output + 1);

    switch (found.kind)
    {
        case WireFinding::Kind::dead:
            return output + " answers " + fixedText (-found.level, 0)
                   + " dB weaker than the others: check its wire, its amplifier and its ceramic.";
        case WireFinding::Kind::reversed:
            return output + " answers with the other sign than the drawing: swap its two wires, or set the polarity of "
                   + "its ceramic.";
        case WireFinding::Kind::exchanged:
            return output + " answers as ceramic " + std::to_string (found.ceramic + 1)
                   + ": connect each output to the ceramic of its number.";
        case WireFinding::Kind::foreign:
            break;
    }

    return output + " answers as no ceramic of the drawing: check where the sensor is, and the drawing.";
}
} // namespace antinode
