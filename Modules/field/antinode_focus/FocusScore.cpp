#include "FocusScore.h"

#include "FocusDesign.h"
#include "Prediction.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
FieldScore scoreField (const Surface& surface, const Eigen::VectorXd& reached, const Eigen::VectorXd& wanted)
{
    const Eigen::VectorXd share = surface.areas / surface.areas.sum();
    const Eigen::VectorXd r = (reached.array() - share.dot (reached)).matrix();
    const Eigen::VectorXd w = (wanted.array() - share.dot (wanted)).matrix();
    const auto inner = [&] (const Eigen::VectorXd& a, const Eigen::VectorXd& b)
    { return share.dot (a.cwiseProduct (b)); };
    const auto deviations = std::sqrt (inner (r, r) * inner (w, w));
    const Eigen::VectorXd difference = reached - wanted;

    FieldScore score;
    score.vScore = deviations > 0 ? inner (r, w) / deviations : 0.0;
    score.fieldError = std::sqrt (inner (difference, difference) / inner (wanted, wanted));
    return score;
}

FocusScore scoreFocus (const ModalModel& model, const Eigen::VectorXd& modalVelocities, const Eigen::VectorXd& wanted,
                       const FieldPeak& wantedPeak)
{
    return { scoreField (model.surface, model.shapes * modalVelocities, wanted),
             shapesAt (model, wantedPeak.x, wantedPeak.y).dot (modalVelocities) / wantedPeak.velocity };
}

double largestFieldError (const ModalModel& model, const FocusDesign& design)
{
    double largest = 0;

    for (const auto& moment : design.moments)
    {
        const auto velocities = modalVelocities (model, predictStates (model, design.program, moment.time));
        const auto score = scoreField (model.surface, model.shapes * velocities, moment.truncatedField);
        largest = std::max (largest, score.fieldError);
    }

    return largest;
}
} // namespace antinode
