import os
import signal
import statistics
import threading
import time

import numpy as np
import pytest
from conftest import refused, run

import espalier


def by_program(plant, tmp_path, *arguments):
    run("reconstruct", plant.file, "-o", tmp_path / "found.mtg", *arguments)
    return (tmp_path / "found.mtg").read_text()


def test_an_array_gives_what_the_program_gives_bit_for_bit(plant, found, tmp_path):
    assert found.skeleton.mtg() == by_program(plant, tmp_path)
    assert len(found.skeleton) > 100


def test_options_do_what_those_of_the_program_do(plant, found, tmp_path):
    options = espalier.Options("thesis", root=plant.points[0])
    options.skeleton.reach = 2.5
    options.contract.least_radius = "10 spacings"
    place = ",".join(repr(float(x)) for x in plant.points[0])
    text = espalier.reconstruct(espalier.Scan(plant.points), options).skeleton.mtg()
    assert text == by_program(
        plant, tmp_path, "--preset", "thesis", f"--root={place}", "--set", "skeleton.reach=2.5",
        "--set", "contract.least_radius=10 spacings",
    )
    assert text != found.skeleton.mtg()


def test_threads_do_not_change_the_result(plant, found):
    again = espalier.reconstruct(espalier.Scan(plant.points), threads=1)
    assert again.skeleton.mtg() == found.skeleton.mtg()


def test_contracted_points_are_views(plant, found):
    assert found.contracted.shape == (len(plant.points), 3)
    assert np.shares_memory(found.contracted, found.contracted)
    assert not found.contracted.flags.owndata and not found.contracted.flags.writeable
    assert not np.array_equal(found.contracted, found.scan.positions)


def test_steps_say_what_was_used(found):
    used = {record.step: record for record in found.steps}
    assert used["contract"].method == espalier.Options().contract.method
    assert used["contract"].values["radius"] > found.scale["spacing"]
    assert found.scale["height"] == pytest.approx(np.ptp(found.scan.positions[:, 2]), rel=0.05)


def test_steps_note_what_is_to_be_said_of_their_results(plant):
    options = espalier.Options()
    options.values.method = "greenness"
    steps = espalier.reconstruct(espalier.Scan(plant.points), options).steps
    assert {record.step: record.notes for record in steps}["values"] == [
        "the points have no colors, so all of them are kept"
    ]


def test_progress_rises_to_the_end_on_the_thread_that_called(plant):
    said = []
    espalier.reconstruct(
        espalier.Scan(plant.points),
        progress=lambda fraction, stage: said.append((fraction, stage, threading.get_ident())),
    )
    fractions = [fraction for fraction, _, _ in said]
    assert fractions == sorted(fractions) and fractions[-1] == 1
    assert len({stage for _, stage, _ in said}) > 3
    assert {thread for _, _, thread in said} == {threading.get_ident()}


def test_what_progress_raises_stops_the_work(plant):
    class Enough(Exception):
        pass

    def stop(fraction, stage):
        raise Enough

    with pytest.raises(Enough):
        espalier.reconstruct(espalier.Scan(plant.points), progress=stop)


@pytest.fixture(scope="module")
def large():
    return espalier.simulate(seed=5, points=60_000)[0]


def interrupted(scan, options, fraction):
    """Seconds from a signal, a little after `fraction` of the work, to KeyboardInterrupt."""
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.01, interrupt)

    def begin(done, stage):
        if done >= fraction and not timer.is_alive() and not sent:
            timer.start()

    with pytest.raises(KeyboardInterrupt):
        espalier.reconstruct(scan, options, progress=begin)
    return time.monotonic() - sent[0]


def test_ctrl_c_stops_within_a_tenth_of_a_second(large):
    options = espalier.Options()
    before = repr(options)
    delays = [interrupted(large, options, share) for share in (0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7)]
    assert statistics.median(delays) < 0.1, delays
    assert repr(options) == before


def test_after_ctrl_c_the_same_scan_gives_the_same_plant(plant, found):
    scan = espalier.Scan(plant.points)

    def interrupt(fraction, stage):
        if fraction > 0.3:
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        espalier.reconstruct(scan, progress=interrupt)
    assert espalier.reconstruct(scan).skeleton.mtg() == found.skeleton.mtg()


def test_other_threads_go_on(large):
    turns = 0
    isDone = threading.Event()

    def count():
        nonlocal turns
        while not isDone.wait(0.005):
            turns += 1

    other = threading.Thread(target=count)
    other.start()
    start = time.monotonic()
    espalier.reconstruct(large)
    seconds = time.monotonic() - start
    isDone.set()
    other.join()
    assert turns > 20 * seconds, (turns, seconds)  # of up to 200 in each


@pytest.mark.parametrize(
    "points", [np.zeros((5, 3)), np.zeros((1, 3))], ids=["at one place", "one point"]
)
def test_errors_are_the_lines_of_the_program(points, tmp_path):
    file = tmp_path / "points.xyz"
    np.savetxt(file, points)
    line = refused("reconstruct", file, "-o", tmp_path / "a.mtg")
    with pytest.raises(espalier.Error) as refusal:
        espalier.reconstruct(espalier.Scan(points))
    assert f"{file}: {refusal.value}" == line


def test_a_count_that_is_no_whole_number_is_refused(plant, tmp_path):
    line = refused("reconstruct", plant.file, "-o", tmp_path / "a.mtg", "--set", "contract.neighbors=9.5")
    options = espalier.Options()
    options.contract.neighbors = 9.5
    assert options.contract.neighbors == 9.5
    with pytest.raises(espalier.Error) as refusal:
        espalier.reconstruct(espalier.Scan(plant.points), options)
    assert f"{plant.file}: {refusal.value}" == line


def test_an_array_is_no_scan_yet(plant):
    with pytest.raises(TypeError, match=r"scan is a ndarray: make a Scan of the points"):
        espalier.reconstruct(plant.points)


def test_an_option_that_the_chosen_method_has_not_is_refused(plant, tmp_path):
    line = refused("reconstruct", plant.file, "-o", tmp_path / "a.mtg", "--set", "contract.least_radius=3")
    options = espalier.Options()
    options.contract.least_radius = 3
    with pytest.raises(espalier.Error) as refusal:
        espalier.reconstruct(espalier.Scan(plant.points), options)
    assert str(refusal.value) == line
