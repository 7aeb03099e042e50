"""Long work leaves Python free, shows its progress and can be ended."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import antinode as an


def long_work():
    """A minute of designs on a plate of 300 modes."""
    return an.tradeoff("glass-two", "glass-148x210")


def test_ctrl_c_ends_long_work():
    signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        long_work()
    # And nothing is left of it.
    assert an.design().peak_voltage_V > 0


def test_the_exception_of_a_handler_of_signals_ends_long_work():
    class TimeIsUp(Exception):
        pass

    def alarm(number, frame):
        raise TimeIsUp

    before = signal.signal(signal.SIGALRM, alarm)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(TimeIsUp):
            long_work()
    finally:
        signal.signal(signal.SIGALRM, before)


def test_other_threads_of_python_run_while_it_works():
    """With the GIL held, the loop would stand still from the begin of the work to its end."""
    begun, ended = threading.Event(), threading.Event()

    def work():
        begun.set()
        an.device("glass-148x210").modes(120, cache=False)
        ended.set()

    thread = threading.Thread(target=work)
    thread.start()
    begun.wait()
    rounds = 0
    while not ended.is_set():
        rounds += 1
        time.sleep(0.001)
    thread.join()
    assert rounds > 20


def test_designs_of_several_threads_are_those_of_one():
    focuses = [an.focus(x_mm=x) for x in (-24, 0, 24)]
    wanted = [an.design(focus).peak_voltage_V for focus in focuses]
    made = {}
    threads = [
        threading.Thread(target=lambda i=i, focus=focus: made.update({i: an.design(focus).peak_voltage_V}))
        for i, focus in enumerate(focuses)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [made[i] for i in range(3)] == wanted


def test_progress_rises_to_all_of_it():
    heard = []
    an.render(progress=lambda what, share: heard.append((what, share)))
    shares = [share for _, share in heard]
    assert shares == sorted(shares) and shares[-1] == 1 and all(0 <= share <= 1 for share in shares)
    assert {what for what, _ in heard} == {"Rendering"}


def test_an_exception_of_progress_ends_the_work():
    def stop(what, share):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        an.render(progress=stop)


def test_a_bar_of_tqdm_is_shown_where_it_is_installed(capsys):
    pytest.importorskip("tqdm")
    an.render(progress=True)
    assert "Rendering" in capsys.readouterr().err


def test_neither_numpy_nor_matplotlib_is_loaded_by_import():
    program = "import sys, antinode; print('numpy' in sys.modules, 'matplotlib' in sys.modules)"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert run.stdout == "False False\n"
