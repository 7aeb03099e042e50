#pragma once

#include <antinode_model/ModalModel.h>

#include <complex>
#include <numbers>

namespace antinode::test
{
/** The closed form of section 8.1 at one place, from one ceramic: lines. */
inline Eigen::VectorXcd closedForm (const ModalModel& model, const Eigen::RowVectorXd& shapes, Eigen::Index ceramic,
                                    const Eigen::VectorXd& frequencies)
{
    Eigen::VectorXcd values = Eigen::VectorXcd::Zero (frequencies.size());

    for (Eigen::Index f = 0; f < frequencies.size(); ++f)
        for (Eigen::Index k = 0; k < model.modes(); ++k)
        {
            const std::complex<double> s (0, 2 * std::numbers::pi * frequencies[f]);
            const auto own = model.angularFrequencies[k];
            values[f] += shapes[k] * model.participation (k, ceramic) * s
                         / (own * own + s * s + 2 * model.dampingRatios[k] * own * s);
        }

    return values;
}
} // namespace antinode::test
