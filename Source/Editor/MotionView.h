#pragma once

#include "SurfaceView.h"

#include <antinode_reports/Chart.h>
#include <antinode_session/PlateSession.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace antinode
{
/** A captured window of a surface's motion: PlatePath::capturedFrames frames, or one at rest. Immutable. */
struct MotionPicture : SurfacePicture
{
    std::shared_ptr<const Chart> spectrum; ///< The largest velocity of every mode in the window.
    double step = 0;                       ///< s from one frame to the next; 0 where nothing has moved yet.
};

/** The chart of a surface that moves, or is at rest: a LineChart of a line, a HeatMap of a plate, with its ceramics.
    [worker] */
Chart motionChart (const ModalModel&, const FieldFrames&);

/** Makes pictures of captured windows on a thread that runs it. The editor may go before the thread: both share it. */
class MotionView
{
public:
    /** Makes pictures until it is stopped. [worker] */
    void run();

    /** Returns at once. [message thread, as all below] */
    void leave();

    /** What is looked at from now on. A new device is shown at rest at once. */
    void watch (std::shared_ptr<const PlateSnapshot>);

    /** Asks for the next window, which comes when there is one. */
    void askForNext();

    /** The newest picture, or none where no device is solved. */
    std::shared_ptr<const MotionPicture> picture() const;

private:
    bool isStoppedWithin (std::chrono::milliseconds);
    void step();
    void show (std::shared_ptr<const ModalModel>, FieldFrames, const Eigen::VectorXd& largest, double step);

    mutable std::mutex mutex; ///< For the next lines.
    std::condition_variable changed;
    std::shared_ptr<const PlateSnapshot> watched;
    std::shared_ptr<const MotionPicture> newest;
    bool wantsNext = true, isStopping = false;
};
} // namespace antinode
