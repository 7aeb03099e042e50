#pragma once

#include "AudioPath.h"

#include <atomic>
#include <memory>

namespace antinode
{
/** Paths on their way from the session to the audio thread and back: one atomic exchange each way. A path that plays ramps to
    0 V before the next one takes its place. */
class PathExchange
{
public:
    PathExchange() = default;

    /** Frees everything; nothing may be playing. [worker] */
    ~PathExchange();
    PathExchange (const PathExchange&) = delete;
    PathExchange& operator= (const PathExchange&) = delete;

    /** Hands a path over and frees what came back. One that was not taken yet is replaced. [worker] */
    void give (std::unique_ptr<AudioPath>);

    /** Frees what came back. [worker] */
    void collect();

    /** The path for a block of the given number of samples, or none if there is none for this rate. [audio thread] */
    AudioPath* current (double sampleRate, int count);

    /** Whether the current path has to ramp to 0 V, since another one waits. [audio thread] */
    bool isLeaving() const { return leavingSamples >= 0; }

    /** All voices of the path that plays end at once; one that waits takes its place with the next block, without a ramp. [audio thread, or while nothing plays] */
    void reset();

private:
    std::atomic<AudioPath*> next { nullptr }, retired { nullptr };
    AudioPath* playing = nullptr; ///< Of the audio thread, as the next line.
    std::int64_t leavingSamples = -1;
    bool isResting = false; ///< Whether nothing has played since the reset.
};
} // namespace antinode
