#pragma once

// What is read and written: text, tables and recordings, responses and finite elements of others, the project's own
// documents. Rooms and their headers: Docs/Architecture.md.

#include <antinode_documents/Inputs.h>
#include <antinode_import/ImportedDevice.h>
#include <antinode_responses/MeasuredResponse.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/WaveFile.h>
