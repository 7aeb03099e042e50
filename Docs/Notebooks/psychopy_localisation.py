"""At which of four places of a glass plate was it? PsychoPy shows the places and asks, Antinode makes the stimulus.

    python3 psychopy_localisation.py FOLDER

Keys 1 to 4 answer, Escape ends; the same call resumes. Docs/Manual/trials.md.
"""

import sys

from psychopy import core, event, visual

import antinode as an

CLICK = {"kind": "click", "frequency_Hz": 250}
PLACES = {
    "1": {"x_mm": 60, "y_mm": 105, "signal": CLICK},
    "2": {"x_mm": 150, "y_mm": 105, "signal": CLICK},
    "3": {"x_mm": 60, "y_mm": 45, "signal": CLICK},
    "4": {"x_mm": 150, "y_mm": 45, "signal": CLICK},
}
LEVELS_DB = range(36)  # 100 V make 35 dB SL


class Screen:
    """A cross while the stimulus may come, then the places and a question."""

    def __init__(self, places):
        self.window = visual.Window(units="height", color="black", fullscr=True)
        self.cross = visual.TextStim(self.window, text="+", height=0.1)
        self.question = visual.TextStim(self.window, pos=(0, 0.45), height=0.04)
        self.places = []
        for name, place in places.items():
            position = (place["x_mm"] - 105) / 220, (place["y_mm"] - 74) / 220
            self.places.append(visual.Circle(self.window, radius=0.05, pos=position, lineColor="white"))
            self.places.append(visual.TextStim(self.window, text=name, pos=position, height=0.05))

    def cue(self, trial, interval):
        self.cross.draw()
        self.window.flip()

    def answer(self, trial):
        self.question.text = trial.question
        for each in (self.question, *self.places):
            each.draw()
        self.window.flip()
        key = event.waitKeys(keyList=[*trial.choices, "escape"])[0]
        if key == "escape":
            raise KeyboardInterrupt
        self.window.flip()
        return key

    def close(self):
        self.window.close()


def main(player, folder, trials=80):
    procedure = an.experiment.QuestPlus(trials, levels_dB=LEVELS_DB)
    task = an.experiment.Localisation(places=PLACES, procedure=procedure, catch=0.05)
    screen = Screen(PLACES)
    try:
        an.experiment.run(player, task, folder, answer=screen.answer, cue=screen.cue, wait=core.wait)
    finally:
        screen.close()
    fitted = an.experiment.fit(folder)
    fitted.save(folder)
    print(fitted)


if __name__ == "__main__":
    main(an.Player("glass-148x210"), sys.argv[1])
