#pragma once

#include "LimitUse.h"

#include <string>

namespace antinode
{
/** Whether the voltages touch a limit: it shapes them, or cuts them. [any] */
bool isReached (const LimitUse&);

/** A limit by its name: "full scale". [any] */
std::string limitName (LimitKind);

/** Where a limit is set, as errors name it: "device: full scale". [any] */
std::string limitField (LimitKind);

/** An amount in the unit of a limit: "1.5 V", "0.2 V/us", "2 mA". [any] */
std::string limitAmount (LimitKind, double amount);

/** The ceramic and the time of a use: "ceramic 3 (C3)", "0.31 ms before the focus". [any] */
std::string limitedCeramic (const ModalModel&, const LimitUse&);
std::string limitTime (const LimitUse&);

/** One sentence: which limit binds, or is the nearest; where, when, and how much of it is used. [any] */
std::string limitSentence (const ModalModel&, const LimitUse&);
} // namespace antinode
