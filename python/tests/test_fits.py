# SPDX-License-Identifier: MIT
import camlaw as cl
import numpy as np
import pytest
from conftest import program_json, same

WORN = "problems/cams/worn_cam.csv"


@pytest.fixture(scope="module")
def worn():
    return cl.fit(WORN, mechanism="disc-cam-roller", set={"roller_radius": "8 mm"})


def test_a_worn_cam_is_the_programs(worn):
    assert same(
        worn.facts,
        program_json("fit", WORN, "--mechanism", "disc-cam-roller", "--set", "roller_radius=8 mm"),
    )


def test_a_worn_cam_has_its_program(worn, tmp_path):
    assert "[[program.segments]]" in worn.program
    worn.save(tmp_path)
    problem = cl.Problem.load(tmp_path / "program.toml")
    assert problem.mechanism == "disc-cam-roller" and problem.evaluate()["pressure_angle"].proved
    assert {"value", "low", "high"} <= set(worn.intervals.columns)


def test_samples_of_a_dataframe_give_the_law_behind_them():
    pandas = pytest.importorskip("pandas")
    x = np.linspace(0, 90, 181)
    lift = np.round(20 * cl.law("cycloidal")(x / 90).s, 3)
    found = cl.fit(pandas.DataFrame({"angle [deg]": x, "lift [mm]": lift}))
    assert found.law.family == "cycloidal" and found.trusted, str(found)
    intervals = found.intervals
    assert intervals["low"].iloc[0] <= intervals["value"].iloc[0] <= intervals["high"].iloc[0]


def test_a_table_is_what_the_file_is(tmp_path):
    x = np.linspace(0, 60, 61)
    lift = np.round(10 * cl.law("modified-sine")(x / 60).s, 3)
    path = tmp_path / "lift.csv"
    path.write_text(
        "angle [deg],lift [mm]\n"
        + "".join(f"{a!r},{b!r}\n" for a, b in zip(x.tolist(), lift.tolist()))
    )
    from_file = cl.fit(path, law="modified-sine").facts
    from_arrays = cl.fit({"angle [deg]": x, "lift [mm]": lift}, law="modified-sine").facts
    assert same(from_file, from_arrays)


def test_a_recorded_curve_gives_the_machine_behind_it():
    data, machine = "problems/cams/recorded_torque.csv", "problems/cams/recorded_torque.toml"
    found = cl.fit(data, mechanism=machine)
    assert same(found.facts, program_json("fit", data, "--mechanism", machine))
    assert found.machine.evaluate()["drive_torque"].highest > 0


def test_printed_constants_give_the_law():
    found = cl.fit_constants("C_v=1.6125, C_a=4.66", law="polynomial-5")
    assert found.facts
    assert same(
        found.facts, program_json("fit", "--constants", "C_v=1.6125, C_a=4.66", "--law", "polynomial-5")
    )
    assert found.law.C_v == pytest.approx(1.6125, abs=5e-5)
    assert found.law.C_a == pytest.approx(4.66, abs=5e-3)


def test_wrong_tables_are_refused():
    with pytest.raises(cl.InputError, match="is not a table; a DataFrame"):
        cl.fit(7)
    with pytest.raises(cl.InputError, match="rows"):
        cl.fit({"angle [deg]": [0.0, 1, 2], "lift [mm]": [0.0, 1]})
    with pytest.raises(cl.InputError, match="loss"):
        cl.fit({"angle [deg]": [0.0, 1, 2], "lift [mm]": [0.0, 1, 2]}, loss="hard")
    with pytest.raises(cl.InputError, match="shift"):
        cl.fit({"angle [deg]": [0.0, 1, 2], "lift [mm]": [0.0, 1, 2]}, shift="sideways")


def test_it_shows_itself(worn):
    assert "<table>" in worn._repr_html_() and str(worn)
    pytest.importorskip("matplotlib").use("Agg")
    worn.plot()


def test_published_tables_come_out():
    assert "spine-cutter" in cl.reproducible()
    found = cl.reproduce("signature-feeder")
    assert found.counts["unexplained"] >= 0 and found.worsened == []
    assert same([found.facts], program_json("reproduce", "signature-feeder"))
    assert "signature feeder" in found._repr_html_()
    solved = cl.cam_shape(50)
    assert solved["verdict"] == "certified optimum" and solved["objective"] == pytest.approx(
        solved["true_optimum"], rel=1e-8
    )
    with pytest.raises(cl.InputError, match="is not a system"):
        cl.reproduce("perpetuum-mobile")


def test_a_study_compares_laws():
    found = cl.study("spine-cutter", table=True, set={"h": "1.0 mm"})
    assert same(found.facts, program_json("study", "spine-cutter", "--table", "--set", "h=1.0 mm"))
    with pytest.raises(cl.InputError, match="there is no study"):
        cl.study("loom")


def test_few_rows_are_fitted_or_refused_in_a_sentence():
    for rows in range(3, 9):
        angle = np.linspace(0, 80, rows)
        lift = 10 * cl.law("cycloidal")(angle / 80).s + 0.01 * np.cos(7 * angle)
        try:
            found = cl.fit({"angle [deg]": angle, "lift [mm]": lift})
            assert rows > 6 or not found.trusted
        except cl.InputError as refused:
            assert "rows of numbers are needed" in str(refused)
