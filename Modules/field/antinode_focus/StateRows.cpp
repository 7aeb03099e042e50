#include "StateRows.h"

#include "Prediction.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <stdexcept>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

Complex stateAt (Complex pole, const Oscillation& oscillation, double time, Playback playback)
{
    if (playback.sampleRate > 0 && playback.reconstruction == Reconstruction::zeroOrderHold)
        return heldModalResponse (pole, oscillation, time, playback.sampleRate);

    return modalResponse (pole, oscillation, time);
}

double evaluateQuantity (Complex state, Complex pole, ModalQuantity quantity)
{
    switch (quantity)
    {
        case ModalQuantity::velocity:
            return state.real() + pole.real() / pole.imag() * state.imag();
        case ModalQuantity::displacement:
            return state.imag();
        case ModalQuantity::turnedVelocity:
            return pole.real() / pole.imag() * state.real() - state.imag();
    }

    throw std::logic_error ("a mode has no such quantity");
}
} // namespace

std::vector<StateRow> rowsAt (double time, const std::vector<int>& modes, ModalQuantity quantity)
{
    std::vector<StateRow> rows;
    rows.reserve (modes.size());

    for (const auto mode : modes)
        rows.push_back ({ mode, time, quantity });

    return rows;
}

Eigen::MatrixXd rowResponses (const ModalModel& model, const std::vector<StateRow>& rows,
                              const std::vector<std::vector<Oscillation>>& drives, Playback playback, ForceTurn turn)
{
    const auto poles = modalPoles (model);
    Eigen::MatrixXd responses (rows.size(), drives.size());

    for (Eigen::Index l = 0; l < responses.cols(); ++l)
    {
        checkWatch();

        for (Eigen::Index r = 0; r < responses.rows(); ++r)
        {
            const auto& row = rows[static_cast<std::size_t> (r)];
            const auto pole = poles[row.mode];
            Complex state = 0;

            for (const auto& oscillation : drives[static_cast<std::size_t> (l)])
                state += stateAt (pole, oscillation, row.time, playback);

            if (turn == ForceTurn::quarter)
                state = { -state.imag(), state.real() };

            responses (r, l) = evaluateQuantity (state, pole, row.quantity);
        }
    }

    return responses;
}

namespace
{
using Rows = std::vector<StateRow>;

/** N_r x N_b: the real parts of the participations of the rows' modes, or the imaginary ones. */
Eigen::MatrixXd participationOf (const ModalModel& model, const Rows& rows, ForceTurn turn)
{
    const auto first = turn == ForceTurn::none ? 0 : model.modes();
    Eigen::MatrixXd all (rows.size(), model.actuators());

    for (std::size_t r = 0; r < rows.size(); ++r)
        all.row (static_cast<Eigen::Index> (r)) = model.participation.row (first + rows[r].mode);

    return all;
}

/** How large the imaginary part of a mode's shape is beside the real one. */
double imaginaryShare (const ModalModel& model, int mode)
{
    const auto& masses = model.surface.masses;
    const auto real = masses.dot (model.shapes.col (mode).cwiseAbs2());
    const auto imaginary = masses.dot (model.shapes.col (model.modes() + mode).cwiseAbs2());
    return real > 0 ? std::sqrt (imaginary / real) : 1.0;
}

/** All coordinates, as the columns of the shapes. */
Rows coordinateRows (const ModalModel& model, double time)
{
    std::vector<int> modes (static_cast<std::size_t> (model.modes()));
    std::iota (modes.begin(), modes.end(), 0);
    auto rows = rowsAt (time, modes, ModalQuantity::velocity);
    const auto turned = rowsAt (time, modes, ModalQuantity::turnedVelocity);
    rows.insert (rows.end(), turned.begin(), turned.end());
    return rows;
}

Eigen::VectorXd guardWeights (const ModalModel& model, const ComplexRowSet& rows)
{
    const auto full = static_cast<Eigen::Index> (rows.guards.size());
    Eigen::VectorXd weights = Eigen::VectorXd::Ones (full + static_cast<Eigen::Index> (rows.turned.size()));

    for (std::size_t r = 0; r < rows.turned.size(); ++r)
        weights[full + static_cast<Eigen::Index> (r)] = imaginaryShare (model, rows.turned[r].mode);

    return weights;
}
} // namespace

void addComplexRows (AllocationProblem& problem, const ModalModel& model, const ComplexRowSet& rows,
                     const DriveList& drives, Playback playback)
{
    auto guards = rows.guards;
    guards.insert (guards.end(), rows.turned.begin(), rows.turned.end());
    const auto weights = guardWeights (model, rows);
    problem.secondParticipation = participationOf (model, rows.hard, ForceTurn::quarter);
    problem.secondRows = rowResponses (model, rows.hard, drives, playback, ForceTurn::quarter);
    problem.guardParticipation = participationOf (model, guards, ForceTurn::none);
    problem.guardRows = weights.asDiagonal() * rowResponses (model, guards, drives, playback);
    problem.secondGuardParticipation = participationOf (model, guards, ForceTurn::quarter);
    problem.secondGuardRows = weights.asDiagonal() * rowResponses (model, guards, drives, playback, ForceTurn::quarter);
}

Eigen::VectorXd complexRowValues (const ModalModel& model, const std::vector<StateRow>& rows, const DriveList& drives,
                                  const Eigen::MatrixXd& matrix, Playback playback)
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero (static_cast<Eigen::Index> (rows.size()));

    for (const auto turn : { ForceTurn::none, ForceTurn::quarter })
        values += (rowResponses (model, rows, drives, playback, turn) * matrix.transpose())
                      .cwiseProduct (participationOf (model, rows, turn))
                      .rowwise()
                      .sum();

    return values;
}

double correctWanted (std::vector<FocusMoment>& moments, const FocusDesign& design, const ModalModel& model,
                      const DriveList& drives, const Eigen::MatrixXd& matrix)
{
    const auto& modes = design.controlledModes;
    const Eigen::VectorXd root = model.surface.masses.cwiseSqrt();
    const Eigen::MatrixXd shapes = root.asDiagonal() * model.shapes (Eigen::all, modes);
    double change = 0, largest = 0;

    for (std::size_t i = 0; i < moments.size(); ++i)
    {
        auto motion =
            complexRowValues (model, coordinateRows (model, moments[i].time), drives, matrix, design.playback);
        motion (modes).setZero();
        const Eigen::VectorXd added = root.asDiagonal() * (model.shapes * motion);
        const Eigen::VectorXd corrected = design.moments[i].wanted - leastSquares (shapes, added);
        change = std::max (change, (corrected - moments[i].wanted).cwiseAbs().maxCoeff());
        largest = std::max (largest, corrected.cwiseAbs().maxCoeff());
        moments[i].wanted = corrected;
    }

    return largest > 0 ? change / largest : 0.0;
}

void requireComplexModesSuit (const ModalModel& model, const FocusDescription& description)
{
    const auto& choice = description.allocation;

    if (choice.method != AllocationMethod::exact)
        requireRealModes (model, "designs by the method '"
                                     + std::string (wordFor (allocationMethodWords, choice.method)) + "'");

    if (choice.robust)
        requireRealModes (model, "robust designs");

    if (choice.isUndisplaced)
        requireRealModes (model, "designs with displacement 'zero'");
}
} // namespace antinode
