#include "PlayedTracks.h"

#include <antinode_base/Watch.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_tracks/PathShapes.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
PlayedTracks playTracks (const ModalModel& model, const WaveformsDescription& description,
                         const SampledVoltages& voltages, double ringing)
{
    constexpr double enoughForSkin = 12000; // Hz
    const auto paths = pathShapes (model, description);
    auto pointShapes = touchedShapes (model, description);
    PlateModel plate (model, voltages.playback, pointShapes);
    const auto rate = voltages.playback.sampleRate;
    const auto count = voltages.values.cols() + static_cast<Eigen::Index> (std::ceil (ringing * rate));
    const auto stride = std::max<Eigen::Index> (1, static_cast<Eigen::Index> (rate / enoughForSkin));
    PlayedTracks played {
        rate, std::llround (-voltages.firstTime * rate), {}, rate / static_cast<double> (stride), {}
    };
    played.displacements.resize (pointShapes.rows(), count);
    played.modalVelocities.resize (model.coordinates(), (count - 1) / stride + 1);
    const Eigen::VectorXd silence = Eigen::VectorXd::Zero (voltages.values.rows());
    Eigen::VectorXd velocities (pointShapes.rows());

    for (Eigen::Index n = 0; n < count + plate.latencySamples(); ++n)
    {
        checkWatch();

        if (n < voltages.values.cols())
            plate.process (voltages.values.col (n), velocities);
        else
            plate.process (silence, velocities);

        if (const auto at = n - plate.latencySamples(); at >= 0)
        {
            for (std::size_t p = 0; p < paths.size(); ++p)
                if (paths[p].moves())
                    pointShapes.row (static_cast<Eigen::Index> (p)) =
                        paths[p].at (static_cast<double> (at) / rate + voltages.firstTime).transpose();

            played.displacements.col (at) = pointShapes * plate.modalDisplacements();

            if (at % stride == 0)
                played.modalVelocities.col (at / stride) = plate.modalVelocities();
        }
    }

    return played;
}
} // namespace antinode
