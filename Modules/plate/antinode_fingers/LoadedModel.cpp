#include "LoadedModel.h"

#include "LoadedPoles.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussLegendre.h>

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
} // namespace antinode
