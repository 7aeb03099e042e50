#pragma once

#include <string>

namespace antinode
{
/** The number of this process; above 0. [any] */
int ownProcess();

/** Whether a process of this number runs, be it another user's. [any] */
bool isProcessRunning (int process);

/** The name of this computer in its network; empty where the system does not say it. [worker] */
std::string computerName();
} // namespace antinode
