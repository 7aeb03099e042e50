#pragma once

#include "NewestQuestion.h"
#include "SurfaceView.h"

#include <antinode_model/VoltageProgram.h>
#include <antinode_session/Documents.h>
#include <antinode_session/FocusSettings.h>

#include <Eigen/Core>
#include <memory>
#include <mutex>
#include <optional>

namespace antinode
{
/** What is asked of a device that is drawn. */
struct DraftQuestion
{
    std::shared_ptr<const DeviceDocument> device;
    std::shared_ptr<const ModalModel> exact; ///< Its modes, where they are solved; none: they are solved coarsely.
    std::shared_ptr<const FocusDocument> focus;
    PlaySettings settings;
    Playback playback;       ///< With a rate of more than 0.
    int modes = 0;           ///< That the loaded device has: numbers of the focus are of as many.
    std::optional<int> mode; ///< Which mode is shown, from 0; none: the surface at rest.

    bool operator== (const DraftQuestion&) const;
};

/** A device that is drawn, with a mode of it. Immutable. Numbers of the focus come a little later. */
struct DraftPicture : SurfacePicture
{
    DraftQuestion question;
    bool isExact = false;
    Eigen::VectorXd shares;         ///< N_b: participation of each ceramic in the mode, of the largest; -1 to 1.
    std::optional<double> captured; ///< Of the present focus.
    std::optional<double> volts;    ///< V: what it needs, whatever the limits.
    double solveTime = 0;           ///< s that the coarse modes took.
};

/** Solves a device while it is drawn, on a thread that runs it: a few coarse modes as often as it changes, and as soon
   as it rests what the present focus is on as many as the device has. The editor may go before the thread: both share
   it. */
class DraftView
{
public:
    static constexpr int coarseModes = 30;

    /** Answers questions until it is stopped. [worker] */
    void run();

    /** Returns at once. [message thread, as all below] */
    void leave() { questions.leave(); }
    void ask (DraftQuestion question) { questions.ask (std::move (question)); }

    /** The latest picture, or none yet. */
    std::shared_ptr<const DraftPicture> picture() const;

    /** Whether nothing is worked on. */
    bool isDone() const { return questions.isDone(); }

private:
    void answer (const DraftQuestion&);
    void solve (const DraftQuestion&);
    void addNumbers (DraftPicture&);
    const ModalModel& judgeOf (const DraftQuestion&);
    void show (const DraftPicture&);

    std::shared_ptr<const DeviceDocument> solvedOf; ///< Of the thread only, as the next lines.
    std::shared_ptr<const ModalModel> solved;
    double solveTime = 0; ///< s
    std::shared_ptr<const DeviceDocument> judgedOf;
    std::shared_ptr<const ModalModel> judge; ///< Coarse too, with as many modes as the device has.
    NewestQuestion<DraftQuestion> questions;
    mutable std::mutex mutex;
    std::shared_ptr<const DraftPicture> newest; ///< Under the mutex.
};
} // namespace antinode
