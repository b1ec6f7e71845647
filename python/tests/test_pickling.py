# SPDX-License-Identifier: MIT
"""What a user holds goes to other processes, wherever these stand, and is copied."""

import copy
import multiprocessing
import os
import pickle
import re
import shutil

import camlaw as cl
import numpy as np
import pytest
from camlaw.native import native
from conftest import PROBLEMS, ROOT, same


def evaluated(problem):
    """In another process, which stands somewhere else."""
    os.chdir("/")
    return problem.evaluate()["pressure_angle"]


def told(thing):
    """What a process says of a thing that was sent to it."""
    os.chdir("/")
    return str(thing), thing._repr_html_(), pickle.dumps(thing)


def moved(law):
    return law.name, law.C_a, law(np.linspace(0, 1, 33))


@pytest.fixture(scope="module")
def elsewhere():
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        yield pool


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a problem whose law and table are files beside it, where the process stands."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def timeless(page):
    """A page without the time at which it was made, and without the checksum that covers this time."""
    page, seals = re.subn(r"<!-- camlaw page, SHA-256 of what is above: [0-9a-f]{64} -->", "", page)
    assert seals == 1
    return re.sub(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC", "", page)


def copies(thing):
    return [pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)]


def test_laws_of_all_kinds(elsewhere, folder):
    cl.law("modified-sine", crossover=0.42).save("own.json", title="Ours")
    program = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").law
    for law in (cl.law("modified-sine", crossover=0.42), cl.law_file("own.json"), program):
        x = np.linspace(0, 1, 33)
        name, peak, motion = elsewhere.apply(moved, (law,))
        assert name == law.name and peak == law.C_a
        assert all(np.array_equal(a, b) for a, b in zip(motion, law(x)))
        for again in copies(law):
            assert again == law and again.ends == law.ends and again.formula == law.formula
            assert again._repr_html_() == law._repr_html_()


def test_a_problem_that_was_loaded_by_a_relative_path(elsewhere, monkeypatch):
    monkeypatch.chdir(PROBLEMS / "cams")
    problem = cl.Problem.load("roller_least_base.toml").set(base_radius="55 mm")
    here = problem.evaluate()["pressure_angle"]
    assert elsewhere.apply(evaluated, (problem,)) == here
    monkeypatch.chdir("/")
    for again in copies(problem):
        assert again.text == problem.text and again.settings == problem.settings
        assert again.evaluate()["pressure_angle"] == here
        assert again.set(base_radius="60 mm").evaluate()["outer_radius"] == pytest.approx(90)


def test_a_problem_with_files_beside_it(elsewhere, folder, monkeypatch):
    for name in ("old_cam.toml", "old_cam.csv"):
        shutil.copy(PROBLEMS / "motions" / name, folder / name)
    cl.law("modified-sine", crossover=0.42).save(folder / "own.json")
    tabled = cl.Problem.load("old_cam.toml")
    lawful = cl.Problem(
        mechanism="disc-cam-roller",
        constants={"stroke": "30 mm"},
        program=[
            {"name": "rise", "angle": "120 deg", "law": "./own.json"},
            {"name": "return", "law": "cycloidal"},
        ],
    )
    for problem in (tabled, lawful):
        here = problem.evaluate()["pressure_angle"]
        sent = pickle.dumps(problem)
        assert elsewhere.apply(evaluated, (problem,)) == here
        monkeypatch.chdir("/")
        assert pickle.loads(sent).evaluate()["pressure_angle"] == here
        monkeypatch.chdir(folder)
    # The files may be gone by then.
    sent = [pickle.dumps(problem) for problem in (tabled, lawful)]
    for name in ("old_cam.csv", "own.json"):
        (folder / name).unlink()
    for again in map(pickle.loads, sent):
        assert again.evaluate()["pressure_angle"].proved
        assert again.check().text


def test_a_result(elsewhere, folder):
    result = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").optimize()
    text, html, back = elsewhere.apply(told, (result,))
    assert text == str(result) and html == result._repr_html_()
    for again in (*copies(result), pickle.loads(back)):
        assert same(again.facts, result.facts) and again.review == []
        assert str(again) == str(result) and again._repr_html_() == result._repr_html_()
        assert again.design.evaluate()["pressure_angle"] == (
            result.design.evaluate()["pressure_angle"]
        )
        assert again.verify().holds
        assert again._cycle_figure()["panels"][0]["lines"][0]["y"].tolist() == (
            result._cycle_figure()["panels"][0]["lines"][0]["y"].tolist()
        )
        again.save(folder / "again.json")
        result.save(folder / "result.json")
        assert (folder / "again.json").read_text() == (folder / "result.json").read_text()


def test_a_design_keeps_the_row_that_was_chosen_from_a_catalogue(elsewhere, folder):
    problem = cl.Problem.load(PROBLEMS / "cams/roller_from_catalogue.toml")
    result = problem.optimize()
    rows = [name for name in ("roller_radius", "face_width", "dynamic_rating") if result[name]]
    for found in (result, pickle.loads(pickle.dumps(result))):
        for again in (found.design, *copies(found.design)):
            assert again == result.design and again != problem
            assert again.check().text == result.design.check().text
            assert again.evaluate() == result.design.evaluate()
            assert again.constants == result.design.constants
    once_more = again.optimize()  # the last of the copies
    assert [once_more[name] for name in rows] == [result[name] for name in rows]
    assert len(result.table) == 6 and result.table["from_best"][0] == 0
    assert str(pickle.loads(pickle.dumps(result)).table) == str(result.table)
    assert copies(problem)[0] == problem
    assert copies(problem)[0].optimize()["roller"] == result["roller"]
    # What goes on from the design begins at its row.
    swept = result.design.sweep({"stroke": [29, 30]}, evaluate=True, workers=1)
    assert swept[1].constants == result.design.constants
    with pytest.raises(cl.InputError, match="roller="):
        result.design.save(folder / "design.toml")


def test_a_problem_at_a_design_stays_there(folder):
    result = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").optimize()
    several = cl.Problem.load(PROBLEMS / "motions/in_step.toml").optimize()
    for found in (result, several):
        for again in copies(found.design):
            assert again.constants == found.design.constants
            assert again.law == found.law and len(again._native.laws()) == 1
            assert again.check().text == found.design.check().text
            assert str(again.evaluate().responses) == str(found.design.evaluate().responses)


def test_a_result_without_a_design_and_one_of_a_file(folder):
    result = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").optimize()
    result.save("result.json")
    for again in copies(cl.Result.load("result.json")):
        assert same(again.facts, result.facts) and again.review == []
        assert "certified optimum" in again._repr_html_()
    text = result.problem.text.replace('upper = "120 mm"', 'upper = "30 mm"')
    none = cl.Problem.from_text(text.replace('start = "60 mm"', 'start = "20 mm"')).optimize()
    for again in copies(none):
        assert again.verdict == none.verdict == "infeasible"
        assert same(again.facts, none.facts)


def test_a_front(elsewhere, folder):
    problem = cl.Problem.load(PROBLEMS / "spine_cutter/front.toml")
    recorded = problem.pareto(points=6, workers=1, record="study.db")
    for front in (problem.pareto(points=6, workers=1), cl.Front.load("study.db"), recorded):
        text, html, back = elsewhere.apply(told, (front,))
        assert text == str(front) and html == front._repr_html_()
        for again in (*copies(front), pickle.loads(back)):
            assert same(again.facts, front.facts) and again.csv() == front.csv()
            assert again.knee_index == front.knee_index and again.notes == front.notes
            assert same(again[0].facts, front[0].facts)
            assert str(again.sensitivity(1)) == str(front.sensitivity(1))
            assert timeless(again.report()) == timeless(front.report())


def test_a_table_computed_again_is_not_computed_once_more(elsewhere, monkeypatch):
    found = cl.reproduce("sheet-delivery")
    text, html, back = elsewhere.apply(told, (found,))
    assert text == str(found) and html == found._repr_html_()
    monkeypatch.delattr(native, "reproduce")
    for again in (*copies(found), pickle.loads(back)):
        assert same(again.facts, found.facts) and str(again) == str(found)
        assert again.system == found.system and again.counts == found.counts
        assert again.worsened == found.worsened == []
        assert timeless(again.report()) == timeless(found.report())


def test_fits(elsewhere, folder):
    x = np.linspace(0, 80, 81)
    motion = cl.fit(
        {"angle [deg]": x, "lift [mm]": np.round(12 * cl.law("cycloidal")(x / 80).s, 3)},
        law="cycloidal",
    )
    machine = PROBLEMS / "cams/recorded_torque.toml"
    record = cl.fit(PROBLEMS / "cams/recorded_torque.csv", mechanism=str(machine))
    constants = cl.fit_constants("C_v=1.6125, C_a=4.66", law="polynomial-5")
    for fit in (motion, record, constants):
        text, html, back = elsewhere.apply(told, (fit,))
        assert text == str(fit) and html == fit._repr_html_()
        for again in (*copies(fit), pickle.loads(back)):
            assert same(again.facts, fit.facts) and again.trusted == fit.trusted
            assert str(again) == str(fit) and again.law == fit.law
            assert again.program == fit.program
            again.save(folder / "again")
            fit.save(folder / "fit")
            for file in (folder / "fit").iterdir():
                assert file.read_text() == (folder / "again" / file.name).read_text()
    again = pickle.loads(pickle.dumps(record))
    assert again.machine.evaluate()["drive_torque"] == record.machine.evaluate()["drive_torque"]
    with pytest.raises(cl.InputError, match="has no figure"):
        pickle.loads(pickle.dumps(constants)).plot()


def test_what_states_the_same_is_equal():
    roller = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml")
    again = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml")
    assert roller == again == cl.Problem.from_text(roller.text)
    assert roller == again and hash(roller) == hash(again)
    assert roller.set(stroke=31) != roller and roller.set(stroke=31) == again.set(stroke=31)
    assert roller != roller.text and roller.optimize() == again.optimize()
    assert roller.evaluate() == again.evaluate() != roller.set(stroke=31).evaluate()
    tolerances = {"base_radius": "0.02 mm"}
    assert roller.tolerance(tolerances, samples=64) == again.tolerance(tolerances, samples=64)
    assert roller.tolerance(tolerances, samples=64) != again.tolerance(tolerances, samples=128)
    assert cl.Response("s", "1") == cl.Response(lambda m: m.s) != cl.Response("v", "1")
    assert cl.Machine("press") == cl.Machine("press") != cl.Machine("pump")


def test_laws_of_one_name_are_two_laws(tmp_path):
    path = tmp_path / "own.json"
    cl.law("modified-sine").save(path)
    one = cl.law_file(path)
    cl.law("cycloidal").save(path)
    other = cl.law_file(path)
    assert one.name == other.name and one != other
    assert eval(repr(cl.law("fourier", a=[0.1, -0.05])), {"camlaw": cl}) == cl.law(
        "fourier", a=[0.1, -0.05]
    )
    assert repr(other) == "<camlaw law: own>"
    program = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").law
    assert repr(program).startswith("<camlaw law: program")


def test_cases_ranges_windows_and_variations_come_back():
    for name in ("load_cases", "speed_range", "tolerances", "robust_force"):
        problem = cl.Problem.load(PROBLEMS / f"cams/{name}.toml")
        checked, evaluated = problem.check(), problem.evaluate()
        for again in copies(problem):
            assert again == problem and again.check() == checked
            assert again.evaluate() == evaluated


def test_what_else_is_held():
    stopped = pickle.loads(pickle.dumps(cl.Interrupted(7)))
    assert stopped.result == 7 and isinstance(stopped, KeyboardInterrupt)
    motion = cl.law("cycloidal")([0, 0.5, 1])
    for again in copies(motion):
        assert all(np.array_equal(a, b) for a, b in zip(again, motion))
    evaluation = cl.Problem.load(ROOT / "problems/cams/roller_least_base.toml").evaluate()
    assert pickle.loads(pickle.dumps(evaluation))["outer_radius"] == evaluation["outer_radius"]
    study = cl.study("spine-cutter", table=True)
    again = pickle.loads(pickle.dumps(study))
    assert same(again.facts, study.facts) and str(again) == str(study)
    from camlaw.adapters.model import Model

    model = Model(cl.Problem.load(ROOT / "problems/cams/roller_least_base.toml"))
    again = pickle.loads(pickle.dumps(model))
    assert all(np.array_equal(a, b) for a, b in zip(again.values(again.start), model.values(model.start)))
