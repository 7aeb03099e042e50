#pragma once

#include "DesignRequest.h"
#include "PlayControls.h"

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace antinode
{
/** Middle C plays the focus at its own position, whatever the other notes play. */
inline constexpr int spotNote = 60;

/** The place of the bank that a note means. [any] */
int bankPlaceOf (int note, NoteMeaning);

/** The amplitude of a note, 0 to 1. With a level the softest note is at the threshold, the loudest at the level, and
    those in between at even steps of dB; without one amplitudes are in proportion to velocities.
    @param velocity  1/127 to 1
    @param level     dB SL, of the loudest; not above 0: none
    [any] */
double noteAmplitude (double velocity, double level);

/** The places of all notes: spread over the surface, middle C at the spot. @param spot  x, y in m
    @return  x, y in m, by note number [any] */
std::vector<std::pair<double, double>> spreadNotes (const Surface&, std::pair<double, double> spot);

/** What gives the modes beyond those of a model, for DesignRequest::widen.
    @param sampleRate  that the foci are played at, Hz [any]; what it returns: [worker] */
std::function<WideModel()> modesBeyond (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const ModalModel>,
                                        double sampleRate);

/** The places of a bank in the order in which they are designed: those that are wanted first, then the others outward
   from the first of them, by number. */
class BankOrder
{
public:
    /** A place, and whether it is urgent. */
    struct Next
    {
        int place = 0;
        bool isAwaited = false;
    };

    /** @param wantedFirst  of the places 0 to count - 1; others are skipped; none: 0 [any] */
    BankOrder (const std::vector<int>& wantedFirst, std::size_t count);

    /** Whether all were taken. [any] */
    bool isEmpty() const { return left.empty(); }

    /** Takes the next one: an urgent one before all others. Not where it is empty. [any] */
    Next take (std::span<const int> urgent);

private:
    std::vector<int> first, left; ///< Of the latter the next one in front.
};
} // namespace antinode
