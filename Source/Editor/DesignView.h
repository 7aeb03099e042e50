#pragma once

#include "DesignPicture.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/SpillOver.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

namespace antinode
{
/** Computes the picture for the editor on a thread that runs it: first the predicted field, then its frames, then a
   full render. A newer question replaces an older one, whose work is given up between two steps. The editor may go
   before the thread: both share it. */
class DesignView
{
public:
    /** Answers questions until it is stopped. [worker] */
    void run();

    /** Abandons unfinished work; returns at once. [any but the audio thread] */
    void leave();

    /** Returns at once. [any but the audio thread] */
    void ask (DesignQuestion);

    /** The latest picture, or none yet. [any but the audio thread] */
    std::shared_ptr<const DesignPicture> picture() const;

    /** Whether the picture of the latest request is complete. [any but the audio thread] */
    bool isDone() const;

private:
    void answer (const DesignQuestion&);
    void load (const DesignPicture&);
    FocusDesign playableDesign (const DesignPicture&) const;
    FocusDesign designOf (const DesignPicture&, DesignExtent) const;
    void answerWith (DesignPicture&, const FocusDesign& playable);
    void render (DesignPicture&);
    void compareMethods (DesignPicture&, const FocusDesign& designed) const;
    void show (const DesignPicture&);
    bool isOutdated() const { return asked != answered || isStopping; }
    Watch watch (std::chrono::milliseconds grace) const;
    bool isQuietFor (std::chrono::milliseconds);

    std::shared_ptr<const ModalModel> loadedModelOf; ///< Of the thread only, as the next lines.
    std::vector<Finger> fingers;
    WideModel loaded; ///< The device with the fingers on it.
    mutable std::mutex mutex;
    std::condition_variable changed;
    std::optional<DesignQuestion> next; ///< Under the mutex, as the next line.
    std::shared_ptr<const DesignPicture> newest;
    std::atomic<std::uint64_t> asked { 0 }, answered { 0 };
    std::atomic<bool> isStopping { false }, isWorking { false };
};
} // namespace antinode
