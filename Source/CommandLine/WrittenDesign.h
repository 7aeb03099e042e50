#pragma once

#include "CommonOptions.h"

#include <string>

namespace antinode
{
/** Gives options what a design that was written before says where they leave it open: device, rate, reconstruction.
    @throws InputError  for a file that cannot be read, options that it cannot be played by, and overridden keys of a
                        focus, which is designed already
    [worker] */
void completeFrom (CommonOptions&, const std::string& designFile);

/** The design of a file, with the plate that it is played on.
    @throws InputError  as readDesign and for what cannot be solved
    [worker] */
WideDesign writtenDesign (const CommonOptions&, const std::string& designFile);
} // namespace antinode
