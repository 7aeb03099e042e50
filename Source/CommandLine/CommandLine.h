#pragma once

#include <antinode_render/PowerFlow.h>

#include <CLI/CLI.hpp>

namespace antinode
{
/** The program `antinode`: one sub-command, its result on standard output or in files.
    @return  0 done, 1 bad input (one line on standard error), 2 wrong usage
    [worker] */
int runCommandLine (int argumentCount, const char* const* arguments);

// Each adds its sub-command with its options and what it does. [worker]
void addDevicesCommand (CLI::App&);
void addModesCommand (CLI::App&);
void addPlaceCommand (CLI::App&);
void addIdentifyCommand (CLI::App&);
void addDesignCommand (CLI::App&);
void addRenderCommand (CLI::App&);
void addPerformCommand (CLI::App&);
void addSweepCommand (CLI::App&);
void addCompareCommand (CLI::App&);
void addMapCommand (CLI::App&);
void addExciteCommand (CLI::App&);
void addMeasureCommand (CLI::App&);
void addFrfCommand (CLI::App&);
void addCalibrateCommand (CLI::App&);
void addHysteresisCommand (CLI::App&);
void addRetuneCommand (CLI::App&);
void addLearnCommand (CLI::App&);
void addFollowCommand (CLI::App&);
void addSensorsCommand (CLI::App&);
void addImportCommand (CLI::App&);
void addVersionCommand (CLI::App&);
void addManualPageCommand (CLI::App&); ///< Hidden: for the build.

/** The lines of a focus's electrical power, as wide as those of its scores. */
void printPower (const ModalModel&, const FocusPower&);
} // namespace antinode
