#pragma once

#include <antinode_focus/FocusDesign.h>
#include <antinode_render/FocusOutcome.h>

#include <string>
#include <vector>

namespace antinode
{
/** What is wrong with the places of a focus, in the words of the window's controls: they lie on an edge. [any] */
std::vector<std::string> placeFaults (const Surface&, const FocusDescription&);

/** The same, and what is wrong with what is designed: its modes represent too little of it. [any] */
std::vector<std::string> designFaults (const ModalModel&, const FocusDesign&);

/** What is wrong with what is reached: too slow, or not felt. [any] */
std::vector<std::string> outcomeFaults (const RenderedFocus&, const FocusOutcome&);
} // namespace antinode
