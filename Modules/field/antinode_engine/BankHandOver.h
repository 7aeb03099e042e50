#pragma once

#include "FocusBank.h"

#include <antinode_base/HandOver.h>

namespace antinode
{
/** Banks of foci between the worker that designs them and the player. */
using BankHandOver = HandOver<FocusBank>;
} // namespace antinode
