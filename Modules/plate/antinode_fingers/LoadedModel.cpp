#include "LoadedModel.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

constexpr double uncoupled = 1e-14; // shift of a pole, relative: rounding
constexpr double slowTurn = 1e-5;   // b / a of a motion that does not oscillate

/** Modes without fingers, turned so that of several with one frequency as many as possible are still under them. */
struct TurnedModes
{
    ModalModel model;
    Eigen::MatrixXd contacts; ///< N x F
};

Eigen::MatrixXd allContactShapes (const ModalModel& model, const std::vector<Finger>& fingers)
{
    Eigen::MatrixXd contacts (model.modes(), static_cast<Eigen::Index> (fingers.size()));

    for (std::size_t f = 0; f < fingers.size(); ++f)
        contacts.col (static_cast<Eigen::Index> (f)) = contactShapes (model, fingers[f]).transpose();

    return contacts;
}

/** The modes from the first on that have its frequency and damping. */
Eigen::Index equalModes (const ModalModel& model, Eigen::Index first)
{
    auto count = Eigen::Index { 1 };

    while (first + count < model.modes() && model.angularFrequencies[first + count] == model.angularFrequencies[first]
           && model.dampingRatios[first + count] == model.dampingRatios[first])
        ++count;

    return count;
}

/** Modes of one frequency are not unique: turned so that some do not move under the fingers, these stay as they are. */
TurnedModes turnedModes (ModalModel model, const std::vector<Finger>& fingers)
{
    auto contacts = allContactShapes (model, fingers);

    for (Eigen::Index first = 0, count = 0; first < model.modes(); first += count)
    {
        count = equalModes (model, first);

        if (count == 1)
            continue;

        const Eigen::MatrixXd under = contacts.middleRows (first, count);
        const Eigen::MatrixXd turn = symmetricEigen (under * under.transpose()).vectors;
        contacts.middleRows (first, count) = turn.transpose() * under;
        model.shapes.middleCols (first, count) = (model.shapes.middleCols (first, count) * turn).eval();
        model.participation.middleRows (first, count) =
            (turn.transpose() * model.participation.middleRows (first, count)).eval();

        if (model.slopes.size() > 0)
            model.slopes.middleCols (first, count) = (model.slopes.middleCols (first, count) * turn).eval();
    }

    return { std::move (model), std::move (contacts) };
}

/** One pole with what it moves, in coordinates of the modes without fingers. */
struct LoadedMode
{
    Complex pole;
    Eigen::VectorXcd vector; ///< Scaled: shape and participation are those of the bare modes times it.
};

/** The pole as modes have it, and the b that they compute from it. */
std::pair<Complex, double> representable (Complex pole)
{
    if (pole.imag() == 0)
        pole.imag (slowTurn * std::abs (pole.real()));

    const auto frequency = std::abs (pole);
    const auto ratio = -pole.real() / frequency;
    return { pole, frequency * std::sqrt (1 - ratio * ratio) };
}

/** A mode is Im [shape participation e^(st)] / b; a pole with its conjugate is 2 Re [x x' e^(st) / norm], one that is
   real the half of it. */
LoadedMode scaledMode (const LoadedModes& modes, Complex pole)
{
    auto vector = loadedVector (modes, pole);
    const auto norm = poleNorm (modes, pole, vector);
    const auto [turning, frequency] = representable (pole);
    const auto share = pole.imag() == 0 ? 1.0 : 2.0;
    vector *= std::sqrt (Complex (0, share * frequency) / norm);
    return { turning, std::move (vector) };
}

std::vector<LoadedMode> coupledModes (const LoadedModes& modes)
{
    std::vector<LoadedMode> found;

    for (const auto pole : loadedPoles (modes))
    {
        checkWatch();

        if (! (pole.real() < 0))
            throw std::runtime_error ("a surface with fingers has a motion that does not decay");

        if (pole.imag() >= 0)
            found.push_back (scaledMode (modes, pole));
    }

    return found;
}

/** Which modes fingers change, by what they shift their poles, to first order. */
std::pair<std::vector<int>, std::vector<int>> splitByContact (const ModalModel& model, const Eigen::MatrixXd& contacts,
                                                              const std::vector<Finger>& fingers)
{
    std::pair<std::vector<int>, std::vector<int>> coupledAndNot;

    for (int k = 0; k < model.modes(); ++k)
    {
        const auto omega = model.angularFrequencies[k];
        double force = 0;

        for (std::size_t f = 0; f < fingers.size(); ++f)
        {
            const auto& finger = fingers[f];
            const auto shape = contacts (k, static_cast<Eigen::Index> (f));
            force += shape * shape * (finger.mass * omega * omega + finger.damping * omega + finger.stiffness);
        }

        (force > uncoupled * omega * omega ? coupledAndNot.first : coupledAndNot.second).push_back (k);
    }

    return coupledAndNot;
}

LoadedModes coupledPart (const ModalModel& model, const Eigen::MatrixXd& contacts, const std::vector<int>& coupled,
                         const std::vector<Finger>& fingers)
{
    LoadedModes modes {
        decayRates (model) (coupled), dampedFrequencies (model) (coupled), contacts (coupled, Eigen::all), {}, {}, {}
    };
    const auto property = [&] (double Finger::*which)
    {
        return Eigen::VectorXd::NullaryExpr (static_cast<Eigen::Index> (fingers.size()),
                                             [&fingers, which] (Eigen::Index f)
                                             { return fingers[static_cast<std::size_t> (f)].*which; });
    };
    modes.mass = property (&Finger::mass);
    modes.damping = property (&Finger::damping);
    modes.stiffness = property (&Finger::stiffness);
    return modes;
}

/** Real parts, and behind them imaginary ones. */
Eigen::MatrixXd turnedColumns (const Eigen::MatrixXd& shapes, const Eigen::MatrixXcd& vectors)
{
    Eigen::MatrixXd parts (vectors.rows(), 2 * vectors.cols());
    parts << vectors.real(), vectors.imag();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (shapes.rows(), parts.cols());
    addProduct (result, 1, shapes, parts);
    return result;
}

/** The loaded modes in place of those that they were made of. */
ModalModel modelOf (const ModalModel& bare, std::vector<LoadedMode> modes)
{
    std::sort (modes.begin(), modes.end(),
               [] (const auto& a, const auto& b) { return std::abs (a.pole) < std::abs (b.pole); });
    const auto count = static_cast<Eigen::Index> (modes.size());
    Eigen::MatrixXcd vectors (bare.modes(), count);
    auto loaded = bare;
    loaded.angularFrequencies.resize (count);
    loaded.dampingRatios.resize (count);

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto& mode = modes[static_cast<std::size_t> (i)];
        vectors.col (i) = mode.vector;
        loaded.angularFrequencies[i] = std::abs (mode.pole);
        loaded.dampingRatios[i] = -mode.pole.real() / std::abs (mode.pole);
    }

    loaded.shapes = turnedColumns (bare.shapes, vectors);
    loaded.participation = turnedColumns (bare.participation.transpose(), vectors).transpose();
    loaded.coversWholeBody = false; // Complex shapes are not orthogonal.
    loaded.frequencyErrors.resize (0);

    if (bare.slopes.size() > 0)
        loaded.slopes = turnedColumns (bare.slopes, vectors);

    return loaded;
}
} // namespace

Eigen::RowVectorXd contactShapes (const ModalModel& model, const Finger& finger)
{
    constexpr auto rings = 4, spokes = 12; // exact for polynomials of degree 7
    const auto& surface = model.surface;

    if (! (finger.radius > 0))
        return shapesAt (model, finger.x, finger.y);

    const auto rule = gaussLegendre (rings, 1);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero (model.coordinates());
    double area = 0;

    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j)
        {
            const auto radius = finger.radius * std::sqrt (rule.nodes[i]);
            const auto angle = 2 * std::numbers::pi * (j + 0.5) / spokes;
            const auto x = finger.x + radius * std::cos (angle);
            const auto y = surface.kind == SurfaceKind::line ? finger.y : finger.y + radius * std::sin (angle);

            if (! liesOn (surface, x, y))
                continue;

            sum += rule.weights[i] * shapesAt (model, x, y);
            area += rule.weights[i];
        }

    return area > 0 ? Eigen::RowVectorXd (sum / area) : shapesAt (model, finger.x, finger.y);
}

ModalModel loadedModel (const ModalModel& alone, const std::vector<Finger>& fingers)
{
    if (fingers.empty())
        return alone;

    requireRealModes (alone, "fingers");
    requireKnownScale (alone, "fingers");
    const auto model = withRigidMotion (alone);
    validate (fingers, model.surface);
    const auto [bare, contacts] = turnedModes (model, fingers);
    const auto [coupled, free] = splitByContact (bare, contacts, fingers);
    std::vector<LoadedMode> modes;

    if (! coupled.empty())
        for (auto& mode : coupledModes (coupledPart (bare, contacts, coupled, fingers)))
        {
            Eigen::VectorXcd all = Eigen::VectorXcd::Zero (bare.modes());
            all (coupled) = mode.vector;
            modes.push_back ({ mode.pole, std::move (all) });
        }

    const auto decay = decayRates (bare);
    const auto frequency = dampedFrequencies (bare);

    for (const auto k : free)
        modes.push_back ({ Complex (-decay[k], frequency[k]), Eigen::VectorXcd::Unit (bare.modes(), k) });

    return modelOf (bare, std::move (modes));
}

namespace
{
using Complex = std::complex<double>;

constexpr int maximumSweeps = 200;
constexpr double converged = 4e-16;  // change of a pole, relative
constexpr double negligible = 1e-10; // imaginary part of a pole that is real, relative

/** What a finger answers to a unit of displacement, m s^2 + c s + k, and its derivative by s. */
struct FingerForces
{
    Eigen::VectorXcd value, slope;
};

FingerForces fingerForces (const LoadedModes& modes, Complex s)
{
    return { modes.mass * (s * s) + modes.damping * s + modes.stiffness.cast<Complex>(),
             modes.mass * (2.0 * s) + modes.damping.cast<Complex>() };
}

/** What the modes under the fingers answer to forces there, P' D (s) P, and its derivative by s. */
struct ContactResponse
{
    Eigen::MatrixXcd value, slope;
    Complex poles; ///< The sum of 1 / (s - pole) over all poles without fingers.
};

ContactResponse contactResponse (const LoadedModes& modes, Complex s)
{
    const auto fingers = modes.contacts.cols();
    ContactResponse response { Eigen::MatrixXcd::Zero (fingers, fingers), Eigen::MatrixXcd::Zero (fingers, fingers),
                               0 };

    for (Eigen::Index k = 0; k < modes.decay.size(); ++k)
    {
        const Complex pole (-modes.decay[k], modes.frequency[k]);
        const auto denominator = (s - pole) * (s - std::conj (pole));
        const auto slope = 2.0 * s + 2 * modes.decay[k];
        response.poles += slope / denominator;

        for (Eigen::Index f = 0; f < fingers; ++f)
            for (Eigen::Index g = 0; g < fingers; ++g)
            {
                const auto part = modes.contacts (k, f) * modes.contacts (k, g) / denominator;
                response.value (f, g) += part;
                response.slope (f, g) -= part * (slope / denominator);
            }
    }

    return response;
}

/** 1 + G P' D P. */
Eigen::MatrixXcd contactMatrix (const FingerForces& forces, const ContactResponse& response)
{
    return Eigen::MatrixXcd::Identity (forces.value.size(), forces.value.size())
           + forces.value.asDiagonal() * response.value;
}

/** The trace of a^-1 b, by elimination with pivots: a is as small as there are fingers. */
Complex traceOfQuotient (Eigen::MatrixXcd a, Eigen::MatrixXcd b)
{
    const auto size = a.rows();

    for (Eigen::Index c = 0; c < size; ++c)
    {
        Eigen::Index pivot = 0;
        a.col (c).tail (size - c).cwiseAbs().maxCoeff (&pivot);
        a.row (c).swap (a.row (c + pivot));
        b.row (c).swap (b.row (c + pivot));
        b.row (c) /= a (c, c);
        a.row (c) /= Complex (a (c, c));

        for (Eigen::Index r = 0; r < size; ++r)
            if (const Complex factor = a (r, c); r != c)
            {
                a.row (r) -= factor * a.row (c);
                b.row (r) -= factor * b.row (c);
            }
    }

    return b.trace();
}

/** p' / p of the polynomial whose zeros are the poles with fingers. */
Complex logarithmicSlope (const LoadedModes& modes, Complex s)
{
    const auto forces = fingerForces (modes, s);
    const auto response = contactResponse (modes, s);
    const Eigen::MatrixXcd slope =
        forces.slope.asDiagonal() * response.value + forces.value.asDiagonal() * response.slope;
    return response.poles + traceOfQuotient (contactMatrix (forces, response), slope);
}

/** The poles without fingers, a little beside themselves, so that no two are the same and none is an exact pole. */
Eigen::VectorXcd firstGuess (const LoadedModes& modes)
{
    constexpr auto beside = 1e-3, goldenTurn = 2.399963229728653;
    const auto count = modes.decay.size();
    Eigen::VectorXcd guess (2 * count);

    for (Eigen::Index i = 0; i < 2 * count; ++i)
    {
        const Complex pole (-modes.decay[i / 2], i % 2 == 0 ? modes.frequency[i / 2] : -modes.frequency[i / 2]);
        guess[i] = pole * (1.0 + std::polar (beside, goldenTurn * static_cast<double> (i)));
    }

    return guess;
}

/** One step of all poles, each away from the others. @return  the largest change, relative */
double sweep (const LoadedModes& modes, Eigen::VectorXcd& poles, Eigen::Array<bool, Eigen::Dynamic, 1>& isSettled)
{
    double largest = 0;

    for (Eigen::Index i = 0; i < poles.size(); ++i)
    {
        if (isSettled[i])
            continue;

        auto others = Complex (0);

        for (Eigen::Index j = 0; j < poles.size(); ++j)
            if (j != i)
                others += 1.0 / (poles[i] - poles[j]);

        const auto step = 1.0 / (logarithmicSlope (modes, poles[i]) - others);

        if (! std::isfinite (std::abs (step)))
        {
            isSettled[i] = true; // It is a pole to the last digit.
            continue;
        }

        poles[i] -= step;
        const auto change = std::abs (step) / std::abs (poles[i]);
        isSettled[i] = change <= converged;
        largest = std::max (largest, change);
    }

    return largest;
}

/** The vector that a singular matrix takes to 0, by elimination with complete pivoting: squares of it would lose half
   the digits. */
Eigen::VectorXcd nullVector (Eigen::MatrixXcd a)
{
    const auto size = a.rows();
    std::vector<Eigen::Index> order (static_cast<std::size_t> (size));
    std::iota (order.begin(), order.end(), Eigen::Index { 0 });

    for (Eigen::Index c = 0; c + 1 < size; ++c)
    {
        Eigen::Index row = 0, column = 0;
        a.bottomRightCorner (size - c, size - c).cwiseAbs().maxCoeff (&row, &column);
        a.row (c).swap (a.row (c + row));
        a.col (c).swap (a.col (c + column));
        std::swap (order[static_cast<std::size_t> (c)], order[static_cast<std::size_t> (c + column)]);

        for (auto r = c + 1; r < size; ++r)
            a.row (r).tail (size - c) -= Complex (a (r, c) / a (c, c)) * a.row (c).tail (size - c);
    }

    Eigen::VectorXcd vector = Eigen::VectorXcd::Zero (size), sorted = Eigen::VectorXcd::Zero (size);
    sorted[size - 1] = 1;

    for (auto c = size - 2; c >= 0; --c)
        sorted[c] = -(a.row (c).tail (size - 1 - c) * sorted.tail (size - 1 - c)).value() / a (c, c);

    for (Eigen::Index c = 0; c < size; ++c)
        vector[order[static_cast<std::size_t> (c)]] = sorted[c];

    return vector;
}
} // namespace

Eigen::VectorXcd loadedPoles (const LoadedModes& modes)
{
    constexpr auto asGoodAsRounding = 1e-13;
    auto poles = firstGuess (modes);
    Eigen::Array<bool, Eigen::Dynamic, 1> isSettled =
        Eigen::Array<bool, Eigen::Dynamic, 1>::Constant (poles.size(), false);
    double change = 1;

    for (int i = 0; i < maximumSweeps && ! isSettled.all() && (i < maximumSweeps / 4 || change > asGoodAsRounding); ++i)
    {
        checkWatch();
        change = sweep (modes, poles, isSettled);
    }

    if (! poles.allFinite() || change > asGoodAsRounding)
        throw std::runtime_error ("the modes of a surface with fingers were not found");

    for (auto& pole : poles)
        if (std::abs (pole.imag()) <= negligible * std::abs (pole))
            pole = pole.real();

    return poles;
}

Eigen::VectorXcd loadedVector (const LoadedModes& modes, Complex s)
{
    const auto forces = fingerForces (modes, s);
    const Eigen::MatrixXcd matrix = contactMatrix (forces, contactResponse (modes, s));

    // The forces of the fingers: those that the matrix takes to 0.
    const auto pull = nullVector (matrix);
    Eigen::VectorXcd vector (modes.decay.size());

    for (Eigen::Index k = 0; k < vector.size(); ++k)
    {
        const Complex pole (-modes.decay[k], modes.frequency[k]);
        vector[k] = (modes.contacts.row (k).cast<Complex>() * pull).value() / ((s - pole) * (s - std::conj (pole)));
    }

    Eigen::Index strongest = 0;
    vector.cwiseAbs().maxCoeff (&strongest);
    return vector / vector[strongest];
}

Complex poleNorm (const LoadedModes& modes, Complex s, const Eigen::VectorXcd& vector)
{
    const Eigen::VectorXcd under = modes.contacts.transpose() * vector;
    const Eigen::VectorXcd bare = 2.0 * s + 2.0 * modes.decay.cast<Complex>().array();
    return (vector.array().square() * bare.array()).sum()
           + (under.array().square() * (modes.mass * (2.0 * s) + modes.damping.cast<Complex>()).array()).sum();
}
} // namespace antinode
