#pragma once

#include "Bench.h"

#include <antinode_audio/PlayAndRecord.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** The columns of a take, and what a sample of 1 stands for. */
struct TakeLayout
{
    std::vector<Eigen::Index> ceramics; ///< The played column of each.
    Eigen::Index syncOutput = -1;       ///< The played column of the sync channel; -1: it is not played.
    std::vector<Eigen::Index> sensors;  ///< The recorded column of each.
    Eigen::Index syncInput = -1;        ///< The recorded column of the sync channel; -1: it is not recorded.
    double fullScale = 1;               ///< V of a played sample.
    double velocity = 1;                ///< m/s of a recorded sample.
};

/** A bench whose runs are takes that an audio device plays. A run that lost samples is repeated, at most twice. Where
   the watch of the thread says no, the outputs ramp to 0 V, and the run is Cancelled. */
class TakeBench : public Bench
{
public:
    Eigen::Index sensors() const override { return std::ssize (layout.sensors); }
    double fullScaleVelocity() const override { return layout.velocity; }

    /** @throws Cancelled  as checkWatch(), when the outputs are at 0 V [worker] */
    RunRecording play (const Excitation&, Eigen::Index ceramic, Eigen::Index firstPoint, Eigen::Index points) override;

    /** The same of all ceramics at once. [worker] */
    RunRecording playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync, double sampleRate,
                               Eigen::Index points) override;

protected:
    explicit TakeBench (TakeLayout layoutToUse) : layout (std::move (layoutToUse)) {}

    const TakeLayout layout;

private:
    virtual double sampleRate() const = 0; ///< Hz
    virtual std::int64_t calls() const = 0;
    virtual int lostBlocks() const = 0;
    virtual void begin (std::shared_ptr<Take>) = 0;
    virtual void stop() = 0;

    /** Whether something else has stopped all since it was allowed. */
    virtual bool isVoid() const { return false; }

    /** The device does not call any more: it must not touch the take of now. */
    virtual void leave() = 0;

    /** Why a take has ended before its end, though nobody here has stopped it. */
    virtual std::string whyEnded() const = 0;

    void requireRate (double wanted) const;
    RunRecording playRun (const Eigen::MatrixXd& run, Eigen::Index points);
    void waitFor (const Take&);
    RunRecording toRecording (const Take&, Eigen::Index points) const;
};
} // namespace antinode
