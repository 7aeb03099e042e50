#pragma once

#include "AudioEntry.h"
#include "DeviceFollowing.h"
#include "SessionOwner.h"
#include "SessionRequests.h"

#include <antinode_fingers/Finger.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** The work of a session's thread: takes documents, solves devices, builds paths, asks their workers for designs. It
   shares what it needs, so it may go on after the session: then it frees all and ends as soon as its work looks at the
   watch. Docs/Architecture.md, Session. */
class SessionWorker
{
public:
    using Owner = SessionOwner<PlaySettings>;

    SessionWorker (std::shared_ptr<SessionRequests>, std::shared_ptr<FollowingRequests>, std::shared_ptr<AudioEntry>,
                   std::shared_ptr<Owner>, TakeFocus);

    /** Works until it is stopped; then no path is left. Nothing may be processing by then. [session's thread] */
    void run();

private:
    void step (const SessionRound&);
    void takeDocuments (const SessionRound&);
    bool solve (const DeviceDocument&);
    void chooseFocus();
    void takeAmplifiers (const SessionRound&);
    void takeFingers();
    void buildPath();
    bool hasDrifted() const;
    void takeGraphChoice (const SessionRound&);
    void requestDesigns (const std::vector<int>& firstNotes);
    std::function<WideModel()> widen() const;
    void forwardTouches (const std::vector<SessionTouch>&);
    void publish();
    DesignProgress designs() const;
    std::shared_ptr<const DesignDocument> written() const;
    std::vector<std::pair<double, double>> notePlaces() const;
    Eigen::MatrixXd probeShapes() const;

    std::shared_ptr<SessionRequests> requests;
    std::shared_ptr<AudioEntry> entry;
    std::shared_ptr<Owner> owner;
    TakeFocus takeFocus;
    std::shared_ptr<const DeviceDocument> device;
    std::shared_ptr<const FocusDocument> focus;
    std::shared_ptr<const ModalModel> solved, model;    ///< Without and with the amplifiers.
    std::shared_ptr<const ModalModel> played, designed; ///< Loaded by all fingers, and by those that designs know.
    std::shared_ptr<const ModalModel> loadedModelOf;    ///< What these were made of, with the next two lines.
    std::vector<Finger> fingers;
    std::vector<int> idle; ///< Ceramics that listen.
    DeviceFollowing following;
    std::vector<double> amplifiers; ///< V of a full-scale sample of each ceramic.
    PlaySettings settings;
    double rate = 0;           ///< Hz, of the path.
    AudioPath* path = nullptr; ///< The newest one, which `entry` owns; none where it could not be built.
    GraphChoice graph;
    double toldEnd = 0; ///< s, of the foci: the tail that the owner knows.
    bool isSolving = false, isModelNew = false, isFocusNew = false, isGraphNew = false;
    std::string deviceError, fingerError;
};
} // namespace antinode
