#pragma once

#include "PlayedRecording.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
struct WideModel;

/** What of a recording lies below a frequency, voltages and signals alike, at the lowest rate that holds it: a linear
   device answers to the filtered voltages by the filtered signals, without what modes above add.
    @param highest  Hz, passed; above it all falls to 0 within a quarter of it
    @return         the same recording where its rate is at most twice that
    @throws InputError  where the frequency is not above 0
    [worker] Docs/Theory.md, section 7.7. */
PlayedRecording atLowerRate (const PlayedRecording&, double highest);

/** What of a recording lies where a model has modes: all that its known ones do and, as far as the lower rate holds it,
   what those beyond them do. Modes beyond the model, which every plate has, are not heard then; where it has none up to
   1.31 of the highest known frequency, they are heard up to there.
    @return  begins with silence, as much before voltages and signals, since filtered voltages begin to ring early; has
             at least 6400 samples where it had; the same recording where its rate is below 2.6 times the highest known
             frequency
    [worker] Docs/Theory.md, section 7.6. */
PlayedRecording withinModel (PlayedRecording, const WideModel&);

/** Up to which frequency a model has all modes, Hz: a little below its highest. [any] */
double highestModelled (const ModalModel&);

/** The modes that move at a sample rate: below 0.45 of it. Those above answer as springs, which is feedthrough.
    @throws InputError  where there are none [any] */
ModalModel modesWithin (const ModalModel&, double sampleRate);

/** About how much of each voltage's slope a sensor hears of modes beyond a model: the largest static share that the
   upper half of its own modes has, in the sensor's unit per V/s. [any] Docs/Theory.md, section 7.7. */
double usualFeedthrough (const ModalModel&, const std::vector<Sensor>&);
} // namespace antinode
