#include "MeasuredQuantity.h"

#include "Channels.h"
#include "ComplexModes.h"
#include "Identification.h"
#include "ModeSelection.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
using Fits = std::array<QuantityFit, 3>;
using Powers = std::vector<int>;

constexpr double fair = -15; // dB: what explains less contradicts nothing

/** dB: by how much the better of two quantities must be better to count. Small differences of phase, between
   acceleration and displacement, mean something only where little else is left. */
double marginBetween (const QuantityFit& better, const QuantityFit& other)
{
    constexpr double little = -40;
    const auto isQuarterTurn = better.integrations * other.integrations == 0;
    return isQuarterTurn ? 4 : better.error < little ? 2 : 6;
}

bool areAlike (const QuantityFit& better, const QuantityFit& other)
{
    return other.error < better.error + marginBetween (better, other);
}

const char* nameOf (int integrations)
{
    return integrations > 0 ? "acceleration" : integrations < 0 ? "displacement" : "velocity";
}

/** What of a basis' functions real modes use: those of each mode that turn its residue by an angle, and some powers.
   Functions x (N_m + powers). */
Eigen::MatrixXd usedFunctions (const ModalBasis& basis, const Eigen::VectorXd& angles, const Powers& powers)
{
    const auto modes = basis.modes();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (basis.size(), modes + std::ssize (powers));

    // As complexResidues makes residues of the coefficients of both functions.
    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto resonance = basis.angularFrequencies[k], damping = basis.dampingRatios[k];
        const auto ofDelay = -std::sin (angles[k]) / (resonance * std::sqrt (1 - damping * damping));
        result (basis.column (k, ModalFunction::delay), k) = ofDelay;
        result (basis.column (k, ModalFunction::velocity), k) = std::cos (angles[k]) / resonance - damping * ofDelay;
    }

    auto column = modes;

    for (const auto power : powers)
    {
        const auto found = std::find (basis.powers.begin(), basis.powers.end(), power) - basis.powers.begin();
        result (basis.modalColumns() + found, column++) = 1;
    }

    return result;
}

/** Coefficients of these functions by least squares, and what they leave, dB. */
struct LinearFit
{
    Eigen::MatrixXd coefficients;
    double error = 0;
};

LinearFit fitted (const Eigen::MatrixXd& functions, const ModalProducts& products, const Eigen::VectorXd& columnWeights)
{
    constexpr double ridge = 1e-13;
    checkWatch();
    const Eigen::MatrixXd data = functions.transpose() * products.data;
    LinearFit fit { solveEven (functions.transpose() * products.gram * functions, data, ridge) };
    const Eigen::VectorXd left = products.energies - data.cwiseProduct (fit.coefficients).colwise().sum().transpose();
    const auto share = left.dot (columnWeights) / std::max (products.energies.dot (columnWeights), 1e-300);
    fit.error = 10 * std::log10 (std::max (share, 1e-12));
    return fit;
}

QuantityFit fitOf (int integrations, const ModalBasis& basis, const ModalProducts& products,
                   const Eigen::MatrixXcd& residues, const PreparedResponses& data, bool delayIsKnown)
{
    const auto turns = integrations - data.responses->integrations;
    const auto& omega = basis.angularFrequencies;
    // The angles of the poles, once for each integration.
    Eigen::VectorXd angles = turns * (std::numbers::pi / 2 + basis.dampingRatios.array().asin());
    const Eigen::MatrixXcd turned =
        (angles.array() * std::complex<double> (0, -1)).exp().matrix().asDiagonal() * residues;
    QuantityFit fit;
    fit.integrations = integrations;
    fit.delay = delayIsKnown ? 0 : estimateDelay (omega, turned, data.columnWeights);
    angles -= omega * fit.delay;
    auto all = fitted (usedFunctions (basis, angles, basis.powers), products, data.columnWeights);
    fit.error = all.error;
    fit.residues = all.coefficients.topRows (basis.modes());
    fit.physicalError =
        fitted (usedFunctions (basis, angles, { turns - 1, turns + 1 }), products, data.columnWeights).error;
    fit.modalError = fitted (usedFunctions (basis, angles, {}), products, data.columnWeights).error;
    return fit;
}

/** Columns in which a force moves its own point. */
std::vector<Eigen::Index> drivingColumns (const FrequencyResponses& responses)
{
    std::vector<Eigen::Index> columns;

    for (std::size_t i = 0; i < responses.references.size(); ++i)
        if (const auto point = responses.references[i].point; point && responses.drive == DriveQuantity::force)
            columns.push_back (static_cast<Eigen::Index> (i) * responses.points.rows() + *point);

    return columns;
}

/** Of the modes that a column shows well, how many have a positive residue. */
struct Signs
{
    int positive = 0, negative = 0;
};

Signs signsIn (const Eigen::MatrixXd& residues, Eigen::Index column)
{
    constexpr double visible = 0.1; // of the largest
    Signs signs;

    for (Eigen::Index k = 0; k < residues.rows(); ++k)
        if (std::abs (residues (k, column)) > visible * residues.row (k).cwiseAbs().maxCoeff())
            ++(residues (k, column) > 0 ? signs.positive : signs.negative);

    return signs;
}

/** 1 where the signs at driving points are those of the quantity, -1 where they are the opposite, 0 if neither. */
int signOfDrivingPoints (const QuantityFit& fit, const FrequencyResponses& responses)
{
    constexpr double most = 0.75;
    double positive = 0, all = 0;

    for (const auto column : drivingColumns (responses))
    {
        const auto signs = signsIn (fit.residues, column);
        positive += signs.positive;
        all += signs.positive + signs.negative;
    }

    return all > 0 && positive > most * all ? 1 : all > 0 && positive < (1 - most) * all ? -1 : 0;
}

/** A column in which all modes have the same sign, as at a driving point: 1 or -1, where none has the other sign. */
int signOfLikelyDrivingPoint (const QuantityFit& fit)
{
    constexpr int fewest = 3;
    auto isPositive = false, isNegative = false;

    for (Eigen::Index c = 0; c < fit.residues.cols(); ++c)
    {
        const auto signs = signsIn (fit.residues, c);

        if (signs.positive + signs.negative >= fewest && std::min (signs.positive, signs.negative) == 0)
            (signs.positive > 0 ? isPositive : isNegative) = true;
    }

    return static_cast<int> (isPositive) - static_cast<int> (isNegative);
}

/** The one of several fits alike that is taken, and why: a subordinate clause. */
struct Preference
{
    const QuantityFit* fit = nullptr;
    std::string reason;
};

/** Accelerations and displacements differ by the sign of all residues, and hardly in their phases. */
Preference preferred (const QuantityFit& acceleration, const QuantityFit& displacement,
                      const FrequencyResponses& responses)
{
    constexpr double simpler = 3; // dB
    const auto bySign = [&] (int sign, const char* reason) {
        return Preference { sign > 0 ? &acceleration : &displacement, reason };
    };

    if (const auto sign = signOfDrivingPoints (acceleration, responses); sign != 0)
        return bySign (sign, "the response at the driving point has its sign");

    if (const auto sign = signOfLikelyDrivingPoint (acceleration); sign != 0)
        return bySign (sign, "all modes have the same sign at one point, which is then that of a driving point");

    for (const auto error : { &QuantityFit::physicalError, &QuantityFit::modalError })
        if (const auto gain = displacement.*error - acceleration.*error; std::abs (gain) > simpler)
            return { gain > 0 ? &acceleration : &displacement, "it needs fewer residual terms" };

    return { &acceleration, "it is measured more often" };
}

/** Those that fit nearly as well as the first, without those that need a much longer delay than others for it. */
std::vector<const QuantityFit*> fitsAlike (const Fits& fits, double highestFrequency)
{
    constexpr double longer = 0.1; // of the highest mode's period
    std::vector<const QuantityFit*> result;
    auto shortest = std::abs (fits.front().delay);

    for (const auto& fit : fits)
        if (areAlike (fits.front(), fit))
            shortest = std::min (shortest, std::abs (fit.delay));

    for (const auto& fit : fits)
        if (areAlike (fits.front(), fit) && std::abs (fit.delay) < shortest + longer / highestFrequency)
            result.push_back (&fit);

    return result;
}

/** "acceleration -49.8, displacement -37.1 and velocity -0.5 dB" */
std::string listed (const Fits& fits)
{
    std::string text;

    for (std::size_t n = 0; n < fits.size(); ++n)
        text += (n == 0                ? ""
                 : n + 1 < fits.size() ? ", "
                                       : " and ")
                + std::string (nameOf (fits[n].integrations)) + " " + fixedText (fits[n].error, 1);

    return text + " dB";
}
/** The data of a few points, as a fit takes them. */
PreparedResponses sampled (const FrequencyResponses& sample, double minimumFrequency, double maximumFrequency)
{
    auto data = prepare (sample, minimumFrequency, maximumFrequency);
    leaveOutDisturbed (data);
    return data;
}

/** The fits of all quantities, the best first. */
Fits compared (const ModalBasis& basis, const ModalProducts& products, const PreparedResponses& data, bool delayIsKnown)
{
    const auto residues = complexResidues (basis, products, 1e-12);
    const auto of = [&] (int integrations)
    { return fitOf (integrations, basis, products, residues, data, delayIsKnown); };
    Fits fits { of (1), of (0), of (-1) };
    std::stable_sort (fits.begin(), fits.end(), [] (const auto& a, const auto& b) { return a.error < b.error; });
    return fits;
}

/** Whether the stated quantity is better than others by more than poles can make up for. */
bool isFarBest (const Fits& fits, const FrequencyResponses& responses)
{
    constexpr double far = 6; // dB
    return fits[0].integrations == responses.integrations && fits[1].error > fits[0].error + far;
}

/** What the fits contradict, as a sentence. */
std::string contradiction (const Fits& fits, const FrequencyResponses& responses)
{
    const auto& best = fits.front();
    const auto stated =
        std::find_if (fits.begin(), fits.end(),
                      [&responses] (const auto& fit) { return fit.integrations == responses.integrations; });
    const auto name = std::string (nameOf (stated->integrations)), other = std::string (nameOf (best.integrations));

    if (best.error < fair && ! areAlike (best, *stated))
        return "as " + other + " the responses fit modes better than as " + name
               + " (errors of what was measured: " + fixedText (best.error, 1) + " and " + fixedText (stated->error, 1)
               + " dB): the quantity is probably stated wrongly; --quantity " + other;

    const auto opposite = std::find_if (
        fits.begin(), fits.end(),
        [&stated] (const auto& fit) { return stated->integrations != 0 && fit.integrations == -stated->integrations; });

    if (opposite != fits.end() && opposite->error < fair && areAlike (*stated, *opposite)
        && signOfDrivingPoints (*stated, responses) < 0)
        return "at the driving point the responses have the sign of " + std::string (nameOf (opposite->integrations))
               + ", not of " + name
               + ": the quantity is stated wrongly, or the sensor points against the force; --quantity "
               + nameOf (opposite->integrations);

    return {};
}

} // namespace

std::array<QuantityFit, 3> fitQuantities (const FrequencyResponses& responses, const IdentificationOptions& options,
                                          const std::vector<PoleCluster>& poles)
{
    const auto points = samplePoints (responses);
    const auto sample = atPoints (responses, points);
    const auto data = sampled (sample, options.minimumFrequency, options.maximumFrequency);
    const auto fitted = fitFreeResidues (data, polesOf (poles, options.delay.value_or (0)), options.ridge);
    return compared (fitted.basis, fitted.products, data, options.delay.has_value());
}

LikelyQuantity likelyQuantity (const std::array<QuantityFit, 3>& fits, const FrequencyResponses& responses)
{
    const auto highest = responses.frequencies[responses.frequencies.size() - 1];
    const auto candidates = fitsAlike (fits, highest);
    const auto find = [&candidates] (int integrations) -> const QuantityFit*
    {
        const auto found = std::find_if (candidates.begin(), candidates.end(),
                                         [=] (const auto* fit) { return fit->integrations == integrations; });
        return found != candidates.end() ? *found : nullptr;
    };
    const auto* const acceleration = find (1);
    const auto* const displacement = find (-1);
    const auto begin = std::string ("no file gives the measured quantity: ");

    if (candidates.size() == 1 || acceleration == nullptr || displacement == nullptr)
        return { candidates.front()->integrations, begin + nameOf (candidates.front()->integrations)
                                                       + " is taken, which explains the responses best (errors: "
                                                       + listed (fits) + "); --quantity sets another" };

    const auto [fit, reason] = preferred (*acceleration, *displacement, responses);
    return { fit->integrations,
             begin + "acceleration and displacement explain the responses alike (errors: " + listed (fits) + "); "
                 + nameOf (fit->integrations) + " is taken, since " + reason
                 + "; the sign at a driving point, a force at a measured point, decides, or --quantity" };
}

std::string quantityContradiction (const FrequencyResponses& responses, const IdentificationOptions& options,
                                   const IdentifiedModes& modes)
{
    constexpr double doubtful = -20, frequent = 0.4;

    if (! responses.isQuantityStated)
        return {};

    if (modes.measuredReconstructionError < doubtful)
    {
        const auto sample = atPoints (responses, samplePoints (responses));
        const auto data = sampled (sample, modes.minimumFrequency * (1 - 1e-9), modes.maximumFrequency * (1 + 1e-9));
        const auto basis = makeBasis (modes.angularFrequencies, modes.dampingRatios, data);
        const auto delayIsKnown = options.delay.has_value();

        if (isFarBest (compared (basis, modalProducts (basis, data, modes.delay), data, delayIsKnown), responses))
            return {};

        // The poles have become those that suit the stated quantity: free ones are fair.
        const NormalModes poles { modes.angularFrequencies, modes.dampingRatios, {}, {}, modes.delay };
        const auto fitted = fitFreeResidues (data, poles, options.ridge);
        return contradiction (compared (fitted.basis, fitted.products, data, delayIsKnown), responses);
    }

    // Of a wrong quantity not all poles become modes.
    std::vector<PoleCluster> poles;

    for (const auto& candidate : modes.candidates)
        if (candidate.presence >= frequent)
        {
            const auto omega = 2 * std::numbers::pi * candidate.frequency;
            poles.push_back (
                { std::polar (omega, std::numbers::pi / 2 + std::asin (candidate.dampingRatio)), candidate.presence });
        }

    return poles.empty() ? std::string() : contradiction (fitQuantities (responses, options, poles), responses);
}

FrequencyResponses asQuantity (FrequencyResponses responses, int integrations)
{
    const auto power = responses.integrations - integrations;

    if (power == 0)
        return responses;

    Eigen::VectorXcd factors (responses.frequencies.size());

    for (Eigen::Index f = 0; f < factors.size(); ++f)
    {
        const auto omega = 2 * std::numbers::pi * responses.frequencies[f];
        factors[f] = omega > 0 ? std::pow (std::complex<double> (0, omega), power) : 0;
    }

    for (auto& values : responses.values)
    {
        checkWatch();
        values.array().colwise() *= factors.array();
    }

    for (auto& variances : responses.variances)
        variances.array().colwise() *= factors.array().abs2();

    responses.integrations = integrations;
    return responses;
}
} // namespace antinode
