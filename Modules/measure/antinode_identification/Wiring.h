#pragma once

#include "FrequencyResponses.h"

#include <antinode_model/ModalModel.h>

#include <string>
#include <vector>

namespace antinode
{
/** What the answers of a few points say of the wire of one output. */
struct WireFinding
{
    enum class Kind
    {
        dead,      ///< Hardly anything answers.
        reversed,  ///< It answers as its ceramic with the other sign.
        exchanged, ///< It answers as another ceramic.
        foreign    ///< It answers as no ceramic.
    };

    Kind kind = Kind::dead;
    Eigen::Index output = 0;  ///< From 0.
    Eigen::Index ceramic = 0; ///< As which it answers, from 0; its own unless exchanged.
    double level = 0;         ///< dB: its answer over that of the drawing, against the median of all.
};

/** Compares each output's responses with those that a drawn device has at the points, in the time that ringing needs to
    depend on single modes: which wire is dead, reversed or exchanged with another. Bears drawings whose frequencies are
    wrong by 15 %, all together, and a few per cent each. Where the sensor's own sign is reversed, most outputs are:
   then the others are named.
    @param drawn      its ceramics are the references, in their order
    @param responses  points that were not measured are left out
    @return           none where all is right, or nothing can be said
    [worker] Docs/Theory.md, section 8.9. */
std::vector<WireFinding> checkWiring (const ModalModel& drawn, const FrequencyResponses& responses);

/** "Output 3 answers as ceramic 5, not 3: its wire is exchanged." and what to do. [any] */
std::string wireInWords (const WireFinding&);
} // namespace antinode
