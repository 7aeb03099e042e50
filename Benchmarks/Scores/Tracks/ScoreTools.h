#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_render/PlayedTracks.h>
#include <antinode_tracks/TrackDesign.h>

#include <algorithm>
#include <string>
#include <vector>

namespace antinode::scores
{
inline constexpr double ringing = 0.3; // s that the surface is listened to

/** Numbers of many layouts: the median and the worst. */
struct Spread
{
    std::vector<double> values;

    double middle() const { return median (values); }
    double worst() const { return *std::max_element (values.begin(), values.end()); }
};

struct Device
{
    std::string name;
    ModalModel known, judge;
};

/** The same limit for all ceramics, without one of slew rates. */
void setLimit (ModalModel&, double volts);

/** An embedded device without limits, and a model to judge it by: half as many modes again. */
Device deviceNamed (const std::string& name);

/** "click", "Gabor", "AM" or "music". */
TrackSignal signalNamed (const std::string& name, int seed);

/** One track of 5 um and silence at other points, at least 25 mm apart. */
WaveformsDescription layout (const Surface&, int count, const std::string& signal, int seed);

TrackSettings usualSettings();

/** The suppression at the worst bystander, within the band or of all frequencies. */
double worstBystander (const TrackScores&, double (TrackScores::*suppression) (std::size_t) const);

TrackScores judged (const ModalModel& judge, const TrackDesign&);

/** Fingers that differ from a nominal one by +-50 % in each property and +-3 mm, evenly: designs without and with the
    nominal ones, with those that are there, and from responses that were measured with them. */
void fingersTable (const Device&, int layouts);

/** Bystanders after the first pass and after each of three corrections, of the pass that has recorded best so far.
    @param isBench  ceramics with 1 % of cubic distortion, latencies of 2 to 20 ms that nobody says, noise 40 dB below
   the loudest recording; otherwise noise of .1 % of the level alone */
void passesTable (const Device&, int layouts, bool isBench);

/** The layout of this seed with its target on a straight way of 50 mm at 100 mm/s, at least 25 mm from the others; its
    signal, "AM" or "music", lasts as long. */
WaveformsDescription movingLayout (const Surface&, int count, const std::string& signal, int seed);

/** A target that moves 50 mm at 100 mm/s, the others silent: volts, error of the target, the worst bystander within the
    band and of all frequencies, dB, iterations. */
void movingTable (const Device&, int layouts);

/** Filters of 20 ms of latency, for music of 10 and 5 too, with the least error, and those within milliseconds: volts,
   the worst bystander, error of the target, CPU of a design with a track for every point. */
void quickTable (const Device&, int layouts);

/** Music at one finger, the others silent, bare points and fingers that load the surface, for 20 and 10 ms of latency:
   as quickTable. */
void liveMusicTable (const Device&, int layouts);

/** A target as of movingTable played live, by banks of quick filters that fade into each other every 5 or 10 ms, of the
    place at the end of the fade, 20 ms before or 5 ms later. */
void movingLiveTable (const Device&, int layouts);
} // namespace antinode::scores
