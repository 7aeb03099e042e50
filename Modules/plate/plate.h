#pragma once

// What is played on: outlines and drawings, the words of modal models, plates and beams solved for their modes, fingers
// and what skin feels. Rooms and their headers: Docs/Architecture.md.

#include <antinode_fingers/Finger.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_model/ModalModel.h>
#include <antinode_outline/Outline.h>
#include <antinode_structure/DeviceDescription.h>
