#pragma once

#include "TouchPath.h"

#include <antinode_fingers/Finger.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace antinode
{
/** The focus of a touch session, which notes play on top of the fingers' tracks: middle C at its own place, the others
    spread over the surface. A focus that was written before plays on every note. It is designed for the device without
    the session's fingers, and for those that its own document has. Docs/Decisions/0113-foci-in-touch.md */
class TouchFoci
{
public:
    /** Another focus; none: notes play nothing. [any but the audio thread] */
    void load (std::shared_ptr<const FocusDocument>);

    /** The loaded one. [any but the audio thread] */
    std::shared_ptr<const FocusDocument> focus() const;

    /** Of the designs, with the reason where the focus cannot be designed. [any but the audio thread] */
    DesignProgress progress() const;

    /** Which places of the bank notes mean, or that they mean none. [any] */
    NoteMeaning notes() const { return meaning; }

    /** Asks a path's worker for the bank where the focus or the path is another one.
        @param amplifiers  V, as withAmplifiers [session's thread] */
    void serve (TouchPath&, const std::shared_ptr<const DeviceDocument>&, const std::vector<double>& amplifiers,
                bool isPathNew);

private:
    void request (TouchPath&, const std::shared_ptr<const DeviceDocument>&, const std::vector<double>& amplifiers);

    mutable std::mutex mutex;                    ///< For the next lines.
    std::shared_ptr<const FocusDocument> wanted; ///< The newest one.
    DesignProgress designs;
    std::atomic<NoteMeaning> meaning { NoteMeaning::nothing };
    std::shared_ptr<const FocusDocument> served; ///< Of the session's thread, as the next lines.
    std::shared_ptr<const DeviceDocument> solvedDevice;
    std::shared_ptr<const ModalModel> solved; ///< Without amplifiers.
    std::string error;                        ///< Why nothing could be asked for.
};
} // namespace antinode
