#include "StateRows.h"

#include "Prediction.h"

#include <antinode_base/Watch.h>

#include <complex>
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
} // namespace antinode
