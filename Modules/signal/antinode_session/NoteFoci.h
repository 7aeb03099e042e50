#pragma once

#include "InstrumentPath.h"
#include "KnownDrift.h"

#include <antinode_base/Watch.h>
#include <antinode_fingers/Finger.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** What the foci of notes know of the fingers of a session. */
enum class FociUnderFingers
{
    unaffected, ///< There are no foci, they play as they were written, or no finger loads the surface.
    known,      ///< They are designed for the fingers where these rest.
    designing,  ///< They are being designed for these; those before play until then.
    outdated    ///< Fingers have moved: those for where they rested before play on.
};

/** What foci are designed for. */
struct FociSurface
{
    std::shared_ptr<const DeviceDocument> device;
    std::vector<double> amplifiers; ///< V, as withAmplifiers.
    std::vector<Finger> fingers;    ///< That rest on the surface and load it.
    bool areResting = false;        ///< Whether it is worth while to design for them.
    DriftedDevice drifted;          ///< What the device differs in from its document.
    FrequencyShift shift;           ///< Of this, all frequencies'.
};

/** The focus of a touch session, which notes play on top of the fingers' tracks: middle C at its own place, the others
    spread over the surface. A focus that was written before plays on every note. It is designed for the fingers of its
    own document, and for those of the session where these rest. Docs/Design/fingers.md */
class NoteFoci
{
public:
    /** Another focus; none: notes play nothing. [any but the audio thread] */
    void load (std::shared_ptr<const FocusDocument>);

    /** The loaded one. [any but the audio thread] */
    std::shared_ptr<const FocusDocument> focus() const;

    /** Of the designs, with the reason where the focus cannot be designed. [any but the audio thread] */
    DesignProgress progress() const;

    /** [any but the audio thread] */
    FociUnderFingers underFingers() const;

    /** Which places of the bank notes mean, or that they mean none. [session's thread] */
    NoteMeaning notes() const { return meaning; }

    /** The level of the loudest note, dB SL; 0: none. [session's thread] */
    double noteLevel() const { return served == nullptr ? 0 : served->description.targets.front().level.value_or (0); }

    /** Asks a path's worker for the bank where the focus or the path is another one, or other fingers rest; ends its
        work where fingers move on and there is a whole bank that can play.
        @param goesOn  whether to go on with loading the surface by fingers, which takes a part of a second
        [session's thread] */
    void serve (InstrumentPath&, const FociSurface&, bool isPathNew, const Watch& goesOn);

private:
    void begin (InstrumentPath&, const FociSurface&);
    void update (InstrumentPath&, const FociSurface&, const Watch& goesOn);
    void request (InstrumentPath&, const FociSurface&, const std::vector<Finger>&, const Watch& goesOn);
    FociUnderFingers knowledge (const FociSurface&, const DesignProgress&) const;

    mutable std::mutex mutex;                    ///< For the next lines.
    std::shared_ptr<const FocusDocument> wanted; ///< The newest one.
    DesignProgress designs;
    FociUnderFingers fociUnderFingers = FociUnderFingers::unaffected;
    NoteMeaning meaning = NoteMeaning::nothing; ///< Of the session's thread, as the next lines.
    std::shared_ptr<const FocusDocument> served;
    std::shared_ptr<const DeviceDocument> solvedDevice;
    std::shared_ptr<const ModalModel> solved;       ///< Without amplifiers.
    std::string error;                              ///< Why nothing could be asked for.
    std::optional<std::vector<Finger>> designedFor; ///< The session's, in the newest request; none: it was given up.
    DesignedDrift designedDrift;                    ///< In the newest request.
    bool isWhole = false;                           ///< Whether every note has had its focus once.
    bool isLoadingRefused = false;                  ///< Whether `designedFor` could not be loaded.
};
} // namespace antinode
