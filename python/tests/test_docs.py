# SPDX-License-Identifier: MIT
"""What is shown is run: the blocks of docs/python.md, and the notebooks."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT, needs

NOTEBOOKS = sorted((ROOT / "examples/notebooks").glob("*.ipynb"))


def test_the_tutorials_blocks_run(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib").use("Agg")
    pytest.importorskip("pandas")
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs/python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.S | re.M)
    assert len(blocks) >= 6
    names = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    assert names["result"].verdict == "certified optimum" and names["fit"].trusted
    assert (tmp_path / "cam.dxf").exists() and (tmp_path / "axis.csv").exists()


@pytest.mark.full
def test_the_readmes_block_runs(monkeypatch):
    monkeypatch.chdir(ROOT)
    (block,) = re.findall(r"^```python\n(.*?)^```", (ROOT / "README.md").read_text(), re.S | re.M)
    names = {}
    exec(compile(block, "README.md", "exec"), names)
    assert names["result"].certified and len(names["front"]) >= 12


def test_the_reference_is_what_the_package_says():
    done = subprocess.run(
        [sys.executable, ROOT / "python/tools/reference.py"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout == (ROOT / "docs/python-api.md").read_text(), (
        "./run python python/tools/reference.py > docs/python-api.md"
    )


def test_there_are_four_notebooks_without_outputs():
    import json

    assert len(NOTEBOOKS) == 4
    for notebook in NOTEBOOKS:
        cells = json.loads(notebook.read_text())["cells"]
        assert all(not cell.get("outputs") for cell in cells), notebook.name


@pytest.mark.full
@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(notebook, tmp_path):
    needs("nbclient")
    import nbformat
    from nbclient import NotebookClient

    read = nbformat.read(notebook, as_version=4)
    NotebookClient(
        read, timeout=300, resources={"metadata": {"path": str(notebook.parent)}}
    ).execute()


@pytest.mark.full
def test_a_notebook_has_a_bar_of_its_own():
    needs("nbclient"), needs("ipywidgets")
    import nbformat
    from nbclient import NotebookClient

    code = (
        "import camlaw as cl\n"
        f"cl.Problem.load({str(ROOT / 'problems/cams/roller_front.toml')!r}).pareto(points=4, workers=2);"
    )
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
    NotebookClient(notebook, timeout=300).execute()
    shown = [output.get("data", {}) for output in notebook.cells[0].outputs]
    assert any("application/vnd.jupyter.widget-view+json" in data for data in shown), shown
    assert not [o for o in notebook.cells[0].outputs if o.output_type == "stream"]
