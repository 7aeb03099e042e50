#pragma once

#include "DesignWorker.h"
#include "DevicePath.h"
#include "PlaySettings.h"
#include "ProbeTrace.h"
#include "SensorTap.h"

#include <antinode_graph/StandardGraph.h>

#include <cstdint>
#include <memory>
#include <span>

namespace antinode
{
/** Whether the nodes of a path are fused or stand apart, and what stands between them. */
struct GraphChoice
{
    bool isOpen = false;
    InsertNodes insert; ///< Of the open graph; none: nothing.
};

/** Foci of one device: its graph, and the worker that designs them. */
class AudioPath : public DevicePath
{
public:
    static constexpr int probes = 2;

    /** @param probeShapes  2 x N_m, kg^-1/2
        @throws InputError  when the device or the format cannot be played
        [worker] */
    AudioPath (std::shared_ptr<const ModalModel>, double sampleRate, const Eigen::MatrixXd& probeShapes,
               const GraphChoice& = {}, Listening = {});

    DesignWorker& worker() { return *designs; }
    PlateNode& plate() { return standard.plateNode(); }

    /** Plays a block. Blocks of any length: long ones are played in parts.
        @param events  in place of the block's, whose notes are places of the bank here
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>&, std::span<const FocusEvent> events, const PlayControls&, LevelMeters&,
                  ProbeTrace&);

private:
    template <typename Sample>
    void writeMonitor (const AudioBlock<Sample>&, int offset, int count, Outputs velocities) const;
    void noteProbes (int count, Outputs velocities, LevelMeters&, ProbeTrace&) const;

    StandardGraph standard;
    std::unique_ptr<DesignWorker> designs;
    Listening listening;
    double monitorGain = 1;
    std::int64_t countedTriggers = 0; ///< Of its voices, by the meters.
};
} // namespace antinode
