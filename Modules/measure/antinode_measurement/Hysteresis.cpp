#include "Hysteresis.h"

#include <antinode_base/InputError.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

namespace antinode
{
namespace
{
constexpr double mostChange = 1; // of the response, at full level
constexpr double mostAngle = std::numbers::pi / 4;

void require (bool isRight, const std::string& what)
{
    if (! isRight)
        throw InputError ("hysteresis", what);
}
} // namespace

MeasuredHysteresis fitHysteresis (const Eigen::VectorXcd& high, const Eigen::VectorXcd& low, double highLevel,
                                  double lowLevel)
{
    require (high.size() == low.size() && high.allFinite() && low.allFinite() && low.squaredNorm() > 0,
             "needs finite responses of the same lines at two levels, not all 0");
    require (highLevel > lowLevel && lowLevel > 0, "needs two levels, the higher one above the lower, both above 0");
    const auto ratio = low.dot (high) / low.squaredNorm();
    // ratio = (1 + change high) / (1 + change low)
    const auto change = (ratio - 1.0) / (highLevel - ratio * lowLevel);
    require (std::abs (change) < mostChange, "would change the response by more than itself from nothing to the full "
                                             "level; allowed: responses per volt, and the levels that they were "
                                             "measured at");
    return { { change.real(), -change.imag() }, (high - ratio * low).norm() / high.norm() };
}

ModalModel withHysteresis (ModalModel model, const std::vector<Hysteresis>& hysteresis, const Eigen::VectorXd& levels)
{
    require (std::ssize (hysteresis) == model.actuators() && levels.size() == model.actuators(),
             "is needed for each of the " + std::to_string (model.actuators()) + " ceramics");

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
    {
        const auto place = static_cast<std::size_t> (i);
        const auto factor = 1 + hysteresis[place].gain * levels[i];
        require (factor > 0, "of ceramic " + std::to_string (i + 1) + " leaves nothing at this level");
        const auto lagging = hysteresis[place].phase * levels[i];
        auto& angle = model.ceramics[place].lag.angle;
        require (angle == 0, "of ceramic " + std::to_string (i + 1)
                                 + " is in this device already; allowed: the device as it answers at low voltages");
        angle = std::atan2 (lagging, factor);
        require (std::abs (angle) < mostAngle, "of ceramic " + std::to_string (i + 1) + " lags by "
                                                   + std::to_string (std::lround (angle * 180 / std::numbers::pi))
                                                   + " degrees; allowed: -45 to 45 degrees");
        model.participation.col (i) *= std::hypot (factor, lagging);
    }

    return model;
}
} // namespace antinode
