#pragma once

#include "Documents.h"

#include <antinode_focus/FocusDesign.h>

namespace antinode
{
/** The design that was written for a document, as long as it is the one that is wanted: fingers do not count, all else
    does. None: the focus is to be designed.
    @param wanted  the focus of the document as parameters changed it
    [worker] */
std::shared_ptr<const DesignDocument> writtenFor (const FocusDocument&, const FocusDescription& wanted);

/** What each ceramic may get while a focus plays, however many of it add up, N_b, V: the lowest of the limits of the
    ceramics, their outputs, the focus and the design that was written for it.
    @param written  none: the focus is designed [worker] */
Eigen::VectorXd limitsInPlay (const ModalModel&, const FocusDescription&, const DesignDocument* written);

/** A design as it was written, for a model with the modes that it knew.
    @throws InputError  as readDesign [worker] */
FocusDesign designAsWritten (const DesignDocument&, const ModalModel&);

/** Whether a written design, if there is one, can be played on a device, as far as can be said before it plays.
    @param model     of that device without fingers; none: not known yet
    @param playback  of the host; a rate of 0: not known yet
    @throws InputError  with the reason why it cannot [worker] */
void requireFit (const FocusDocument&, const DeviceDocument&, const ModalModel*, Playback);
} // namespace antinode
