#pragma once

#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>
#include <vector>

namespace antinode
{
/** The velocity of the surface at instants around the focus, ready to be drawn. */
struct FieldFrames
{
    static constexpr double span = 3e-3; ///< s before and after the focus
    static constexpr int count = 121, atFocus = 60;

    std::vector<Eigen::MatrixXd> maps; ///< Of a plate: rows from below, m/s; one per frame, or only that of the focus.
    Eigen::MatrixXd lines;             ///< Of a line: points x frames, m/s; or one column alone: of the focus.
    Eigen::VectorXd focusVelocities;   ///< N_c: modal velocities at the focus, m/s kg^1/2.
    Eigen::VectorXd focusField;        ///< N_p: at the focus, m/s.
    double largest = 0;                ///< The largest magnitude at the focus, m/s.

    /** The number of frames: all, or 1 for the focus only. [any] */
    int available() const
    {
        return static_cast<int> (maps.empty() ? lines.cols() : static_cast<Eigen::Index> (maps.size()));
    }

    /** s from the focus. [any] */
    static double frameTime (int frame) { return span * (frame - atFocus) / atFocus; }
};

/** The frame of the focus alone: the quick first answer. [worker] Docs/Theory.md, section 3.1. */
FieldFrames predictFocus (const ModalModel&, const FocusDesign&);

/** Frames of any motion. @param velocities  N_m x frames: modal velocities, m/s kg^1/2. What is said of the focus is of
   the frame with the largest velocity anywhere; it gives the range of colours [worker] */
FieldFrames makeFrames (const ModalModel&, const Eigen::MatrixXd& velocities);

/** A surface at rest. [worker] */
FieldFrames stillFrames (const ModalModel&);

/** All frames. @throws Cancelled  as checkWatch() [worker] */
std::shared_ptr<const FieldFrames> predictFrames (const ModalModel&, const FocusDesign&);

/** The displayed instant around the focus: a slider over the frames, and a button that plays them in slow motion.
    [message thread] */
class Timeline final : public juce::Component
{
public:
    Timeline();

    /** Of FieldFrames. */
    int frame() const;

    bool isPlaying() const { return play.getToggleState(); }
    void setPlaying (bool shouldPlay) { play.setToggleState (shouldPlay, juce::sendNotificationSync); }

    void showFocus() { focus.triggerClick(); }

    /** Advances while playing. @param seconds  since the last call */
    void advance (double seconds);

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    juce::TextButton play, focus;
    juce::Slider place;
    double position = 0; ///< In frames, while it plays.
};
} // namespace antinode
