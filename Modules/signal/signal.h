#pragma once

// What runs on the audio thread and beside it: audio devices, a bench, the graph of nodes, sessions, touches from the
// network. Rooms and their headers: Docs/Architecture.md.

#include <antinode_audio/PlayAndRecord.h>
#include <antinode_bench/Bench.h>
#include <antinode_graph/NodeGraph.h>
#include <antinode_session/Session.h>
#include <antinode_touch/TouchReceiver.h>
