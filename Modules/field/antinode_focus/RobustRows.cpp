#include "RobustRows.h"

#include "StateRows.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::size_t maximumRows = 4000;
constexpr double weakest = 1; // what costs less than the energy that moves it does not shape the answer

/** A guard row, and what its penalty is to the energy of the drives that move it most. */
struct RobustRow
{
    double strength = 0;
    Eigen::RowVectorXd participation, response;
};

/** Coordinates in which the drives' energy is a sum of squares: a row r becomes r L^-T, with G = L L'. */
class DriveMetric
{
public:
    explicit DriveMetric (const Eigen::MatrixXd& waveforms)
    {
        constexpr auto rounding = 1e-12; // close drives are nearly dependent
        factor = Eigen::MatrixXd::Zero (waveforms.rows(), waveforms.rows());
        addGram (factor, 1, waveforms);
        factor.diagonal() *= 1 + rounding;
        factorLower (factor);
    }

    Eigen::MatrixXd whiten (Eigen::MatrixXd rows) const
    {
        solveLowerTransposedFromRight (factor, rows);
        return rows;
    }

    Eigen::MatrixXd restore (const Eigen::MatrixXd& rows) const
    {
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero (rows.rows(), factor.cols());
        addTransposedRight (result, 1, rows, factor);
        return result;
    }

private:
    Eigen::MatrixXd factor; ///< L; above its diagonal 0.
};

/** As few whitened rows as have the same Gram matrix up to a part that does not matter. */
Eigen::MatrixXd compressed (const Eigen::MatrixXd& rows)
{
    constexpr auto negligible = 1e-8; // of the squared length
    const auto eigen = symmetricEigen (rows * rows.transpose());
    const auto count = (eigen.values.array() > negligible * eigen.values.maxCoeff()).count();
    return eigen.vectors.rightCols (count).transpose() * rows;
}

/** Frequency and damping of each mode. */
void addModeRows (std::vector<RobustRow>& found, const DetunedResponses& responses, const ModalModel& model,
                  const DriveMetric& metric, double price)
{
    for (std::size_t k = 0; k < responses.modes.size(); ++k)
    {
        const Eigen::RowVectorXd participation = model.participation.row (responses.modes[k]);
        const auto rows = compressed (metric.whiten (responses.errors[k]));

        for (Eigen::Index c = 0; c < rows.rows(); ++c)
            found.push_back ({ price * rows.row (c).squaredNorm() * participation.squaredNorm(), participation,
                               metric.restore (rows.row (c)) });
    }
}

/** Whitened responses of all modes under each other, and the mode of each. */
std::pair<Eigen::MatrixXd, std::vector<int>> stacked (const DetunedResponses& responses, const DriveMetric& metric)
{
    std::pair<Eigen::MatrixXd, std::vector<int>> stack;

    for (std::size_t k = 0; k < responses.modes.size(); ++k)
    {
        const auto rows = compressed (metric.whiten (responses.values[k]));
        stack.first.conservativeResize (stack.first.rows() + rows.rows(), rows.cols());
        stack.first.bottomRows (rows.rows()) = rows;
        stack.second.insert (stack.second.end(), static_cast<std::size_t> (rows.rows()), responses.modes[k]);
    }

    return stack;
}

/** The participations of each ceramic: errors of different ceramics do not cancel, so that each has rows of its own, of
   which pivoted elimination leaves as few as there are drives. */
void addCeramicRows (std::vector<RobustRow>& found, const DetunedResponses& responses, const ModalModel& model,
                     const DriveMetric& metric, double spread, double price)
{
    const auto [rows, modes] = stacked (responses, metric);

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
    {
        const Eigen::VectorXd errors = spread * model.participation (modes, i);
        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (rows.cols(), rows.cols());
        addGram (gram, price, rows.transpose() * errors.asDiagonal());
        const auto [strengths, columns] = pivotedFactor (gram);

        for (Eigen::Index c = 0; c < strengths.size(); ++c)
            if (strengths[c] > weakest)
                found.push_back ({ strengths[c], Eigen::RowVectorXd::Unit (model.actuators(), i),
                                   std::sqrt (strengths[c] / price) * metric.restore (columns.col (c).transpose()) });
    }
}

/** What a squared error of 1 costs, in the unit of the drives' energy. */
double computePrice (AllocationProblem problem, double weight)
{
    problem.guardRows.resize (0, problem.rows.cols());
    problem.guardParticipation.resize (0, problem.participation.cols());
    const auto minimumEnergy = (minimumNormAllocation (problem) * problem.waveforms).squaredNorm();
    return weight * minimumEnergy / problem.wanted.squaredNorm();
}

/** The strongest rows below the guards that are there. All guards share one weight: those that are there are scaled to
    keep theirs. */
void append (AllocationProblem& problem, std::vector<RobustRow> found, double weight)
{
    std::erase_if (found, [] (const RobustRow& row) { return ! (row.strength > weakest); });
    std::stable_sort (found.begin(), found.end(),
                      [] (const RobustRow& a, const RobustRow& b) { return a.strength > b.strength; });
    found.resize (std::min (found.size(), maximumRows));
    const auto guards = problem.guardRows.rows();
    const auto count = guards + static_cast<Eigen::Index> (found.size());
    problem.guardRows *= std::sqrt (problem.guardWeight / weight);
    problem.guardWeight = weight;
    problem.guardRows.conservativeResize (count, problem.rows.cols());
    problem.guardParticipation.conservativeResize (count, problem.participation.cols());

    for (std::size_t r = 0; r < found.size(); ++r)
    {
        const auto at = guards + static_cast<Eigen::Index> (r);
        problem.guardRows.row (at) = found[r].response;
        problem.guardParticipation.row (at) = found[r].participation;
    }
}
} // namespace

AllocationProblem withRobustRows (AllocationProblem problem, const ModalModel& model, const RowOrigin& origin,
                                  const Robustness& robustness)
{
    if (! (robustness.weight > 0) || problem.wanted.isZero (0))
        return problem;

    const auto price = computePrice (problem, robustness.weight);
    const auto responses = detunedResponses (model, origin, robustness.spread);
    const DriveMetric metric (problem.waveforms);
    std::vector<RobustRow> found;
    addModeRows (found, responses, model, metric, price);
    addCeramicRows (found, responses, model, metric, robustness.spread.participation, price);
    append (problem, std::move (found), robustness.weight);
    return problem;
}

namespace
{
/** A normally distributed error as three places, in standard deviations, with their shares. */
struct Node
{
    double place, share;
};

constexpr std::array<Node, 3> gaussHermite {
    { { 0, 2.0 / 3 }, { 1.7320508075688772, 1.0 / 6 }, { -1.7320508075688772, 1.0 / 6 } }
};

ModalModel modesWith (const ModalModel& model, double frequencyFactor, double dampingFactor)
{
    ModalModel modes;
    modes.angularFrequencies = model.angularFrequencies * frequencyFactor;
    modes.dampingRatios = (model.dampingRatios * dampingFactor).cwiseMin (0.999);
    return modes;
}
} // namespace

DetunedResponses detunedResponses (const ModalModel& model, const RowOrigin& origin, const DetuningSpread& spread)
{
    constexpr auto count = static_cast<Eigen::Index> (gaussHermite.size() * gaussHermite.size());
    const auto drives = static_cast<Eigen::Index> (origin.drives.size());
    const auto frequency = std::hypot (spread.frequency, spread.drift);
    DetunedResponses responses;
    responses.modes = origin.controlled;
    responses.modes.insert (responses.modes.end(), origin.guards.begin(), origin.guards.end());
    responses.values.assign (responses.modes.size(), Eigen::MatrixXd (count, drives));
    responses.errors = responses.values;
    const auto stateRows = rowsAt (origin.time, responses.modes, ModalQuantity::velocity);
    const auto known = rowResponses (modesWith (model, 1, 1), stateRows, origin.drives, origin.playback);
    Eigen::Index row = 0;

    for (const auto& f : gaussHermite)
        for (const auto& d : gaussHermite)
        {
            const auto off = rowResponses (modesWith (model, 1 + f.place * frequency, 1 + d.place * spread.damping),
                                           stateRows, origin.drives, origin.playback);
            const auto root = std::sqrt (f.share * d.share);

            for (std::size_t k = 0; k < responses.modes.size(); ++k)
            {
                checkWatch();
                const auto at = static_cast<Eigen::Index> (k);
                responses.values[k].row (row) = root * off.row (at);
                responses.errors[k].row (row) = responses.values[k].row (row);

                if (k < origin.controlled.size())
                    responses.errors[k].row (row) -= root * known.row (at);
            }

            ++row;
        }

    return responses;
}
} // namespace antinode
