# SPDX-License-Identifier: MIT
import math
import os
import subprocess
import sys
from pathlib import Path

import camlaw as cl
import numpy as np
import pytest
from conftest import program_json, same


def test_the_cycloidal_has_the_peaks_that_its_formula_has():
    law = cl.law("cycloidal")
    assert law.C_v == pytest.approx(2, rel=1e-14)
    assert law.C_a == pytest.approx(2 * math.pi, rel=1e-14)
    assert law.C_j == pytest.approx(4 * math.pi**2, rel=1e-14)
    assert law.ends == "R-R"


def test_values_are_those_of_the_formula():
    x = np.linspace(0, 1, 101)
    s, v, a, j = cl.law("cycloidal")(x)
    turn = 2 * np.pi * x
    assert np.allclose(s, x - np.sin(turn) / (2 * np.pi), atol=1e-15)
    assert np.allclose(v, 1 - np.cos(turn), atol=1e-14)
    assert np.allclose(a, 2 * np.pi * np.sin(turn), atol=1e-13)
    assert np.allclose(j, 4 * np.pi**2 * np.cos(turn), atol=1e-12)


def test_arrays_share_their_numbers():
    motion = cl.law("cycloidal")(np.linspace(0, 1, 9))
    first, second = motion.s, motion.s
    assert np.shares_memory(first, second)
    del motion
    assert first[-1] == 1


def test_any_sequence_of_numbers_will_do():
    law = cl.law("cycloidal")
    assert law(0.5).s[0] == 0.5
    assert law([0, 1]).s.tolist() == [0, 1]
    assert law(np.arange(0, 10)[::5] / 10).s.tolist() == law([0, 0.5]).s.tolist()
    assert np.isnan(law([2.0]).s[0])
    with pytest.raises(cl.InputError, match="an array of one is accepted"):
        law(np.zeros((2, 2)))


def test_values_go_into_arrays_that_are_there():
    law, x = cl.law("modified-sine"), np.linspace(0, 1, 33)
    rows = np.empty((4, 33))
    law.into(x, *rows)
    assert all(np.array_equal(mine, its) for mine, its in zip(rows, law(x)))


def test_proved_peaks_hold_those_that_were_searched():
    for name in ("modified-sine", "polynomial-5", "modified-trapezoid"):
        law = cl.law(name)
        for searched, proved in zip(law.peaks(), law.peaks(proved=True)):
            for peak, (low, high) in zip(searched, proved):
                assert low - 1e-12 <= peak.value <= high + 1e-12
                assert high - low < 1e-8 or math.isinf(high)


def test_coefficients_are_keywords_with_or_without_units():
    assert cl.law("modified-sine", crossover=0.42).coefficients["crossover"] == 0.42
    assert cl.law("modified-sine crossover=0.42") == cl.law("modified-sine", crossover=0.42)
    assert cl.law("inclined-sinusoid", angle="75 deg") == cl.law("inclined-sinusoid", angle=75)
    assert cl.law("fourier", a=[0.1, -0.05]).coefficients["a"] == [0.1, -0.05]


def test_facts_are_those_of_the_program():
    for name in ("modified-sine", "elliptic", "fourier"):
        theirs = program_json("law", name)
        mine = cl.law(name).facts()
        assert same({key: theirs[key] for key in mine}, mine)


def test_every_law_has_a_name_that_makes_it():
    assert len(cl.laws()) > 30
    for name in cl.laws():
        assert cl.law(name).family == name


def test_wrong_names_and_values_are_input_errors_with_the_programs_sentence():
    with pytest.raises(cl.InputError, match="there is no law 'cosin'; did you mean cosine"):
        cl.law("cosin")
    with pytest.raises(ValueError, match="crossover"):
        cl.law("modified-sine", crossover=7)


def test_a_law_comes_back_from_its_file(tmp_path):
    law = cl.law("modified-sine", crossover=0.3)
    law.save(tmp_path / "mine.json")
    again = cl.law_file(tmp_path / "mine.json")
    x = np.linspace(0, 1, 64)
    assert all(np.array_equal(a, b) for a, b in zip(law(x), again(x)))
    assert again.C_a == law.C_a


def test_it_shows_itself():
    law = cl.law("modified-sine")
    assert "C_a" in law._repr_html_() and "<svg" in law._repr_html_()
    assert repr(law) == "camlaw.law('modified-sine')"
    pytest.importorskip("matplotlib").use("Agg")
    assert len(law.plot()) == 4


def test_the_table_of_laws_has_the_constants_of_each() -> None:
    table = cl.law_table()
    assert list(table["C_v"].index if hasattr(table["C_v"], "index") else table["name"]) == cl.laws()
    for k in range(0, len(cl.laws()), 5):
        law = cl.law(cl.laws()[k])
        assert np.asarray(table["C_v"])[k] == law.C_v
        assert max(np.asarray(table["C_a_max"])[k], -np.asarray(table["C_a_min"])[k]) == law.C_a


def test_a_law_of_a_file_is_never_taken_for_its_namesake(tmp_path):
    cl.law("modified-sine", crossover=1 / 3).save(tmp_path / "ms.json")
    law = cl.law_file(tmp_path / "ms.json")
    assert cl.law(law) == law and cl.law(law).C_a == law.C_a
    for refused in (
        lambda: cl.law(law, crossover=0.4),
        lambda: cl.fit_constants("C_v=1.76, C_a=5.53", law=law),
        lambda: cl.Problem.example("cams/roller_least_base").set({"rise.law": law}),
        lambda: cl.Problem.example("cams/roller_least_base").sweep({"rise.law": [law]}),
    ):
        with pytest.raises(cl.InputError, match="is the law of a file"):
            refused()
    cl.law("cycloidal").save(tmp_path / "c.json")
    read = cl.law_file(tmp_path / "c.json")
    assert read == cl.law("cycloidal") and hash(read) == hash(cl.law("cycloidal"))
    assert read != cl.law("modified-sine")
    problem = cl.Problem.example("cams/roller_least_base").set({"rise.law": cl.law("cycloidal")})
    assert problem == cl.Problem.example("cams/roller_least_base").set({"rise.law": "cycloidal"})


def test_what_save_writes_can_be_read(tmp_path):
    with pytest.raises(cl.InputError, match="control characters"):
        cl.law("cycloidal").save(tmp_path / "l.json", title="a\nb")
    with pytest.raises(cl.InputError, match="is not a path"):
        cl.law("cycloidal").save(None)
    link = tmp_path / "link.json"
    link.symlink_to(tmp_path / "there.json")
    cl.law("cycloidal").save(link)
    assert link.is_symlink() and cl.law_file(tmp_path / "there.json") == cl.law("cycloidal")
    with pytest.raises(OSError):
        cl.law("cycloidal").save("/dev/full")
    assert not Path("/dev/full").is_file()
    long = tmp_path / ("n" * 250 + ".json")
    cl.law("cycloidal").save(long)
    assert long.exists()


def test_numbers_are_never_guessed():
    for wrong in ([None, 1.0], [True, 0.5], np.array(["0.5"], dtype=object)):
        with pytest.raises(cl.InputError, match="is not an array of real numbers"):
            cl.law("cycloidal")(wrong)
    view = np.frombuffer(b"\0" * 8 * 9, dtype=np.uint8)[1:-7].view(np.float64)
    assert not view.flags.aligned
    with pytest.raises(cl.Error, match="aligned"):
        cl.law("cycloidal")(view)


def test_writing_to_a_pipe_goes_through_it(tmp_path):
    code = "import camlaw as cl; print('before', flush=True); cl.law('cycloidal').save('/dev/stdout')"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    said = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment
    ).stdout
    assert said.startswith("before\n{")
    with open(tmp_path / "out.txt", "w") as out:
        subprocess.run([sys.executable, "-c", code], stdout=out, check=True, env=environment)
    assert (tmp_path / "out.txt").read_text() == said
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    with pytest.raises(OSError):
        cl.law("cycloidal").save(tmp_path / "loop")


def test_a_coefficient_is_given_once():
    with pytest.raises(cl.InputError, match="alpha is given twice"):
        cl.law("polynomial-5 alpha=-4", alpha=-3)
    assert cl.law("polynomial-5", alpha=-3) == cl.law("polynomial-5 alpha=-3")


@pytest.mark.parametrize("name", ["poly-3-4-5", "modified-sine", "scca a=0.3 b=0.2 c=0.5"])
def test_samples_are_the_programs_to_the_last_bit(name):
    table = program_json("law", name, "--samples", 1001)["samples"]
    motion = cl.law(name)([row["x"] for row in table])
    for letter, values in zip("svaj", motion):
        assert values.tolist() == [row[letter] for row in table]
    samples = cl.law(name).samples(1001)
    assert list(np.asarray(samples["x"])) == [row["x"] for row in table]
