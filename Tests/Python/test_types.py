"""The types that the package declares are those that it has."""

import ast
import inspect
import os
import pathlib
import subprocess
import sys

import antinode as an
from antinode import _antinode

package = pathlib.Path(an.__file__).parent

lab = """
import antinode as an
from typing import Any

def bright(x_mm: float) -> Any:
    rendered = an.render(an.focus(x_mm=x_mm), an.device("staple", thickness_mm=2.0), progress=lambda what, share: None)
    reveal: float = rendered.scores["v_score"] + rendered.voltages_V.max() + len(rendered.design.oscillations)
    return reveal
"""


def checked(*files, cache):
    """What `mypy --strict` says."""
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(cache), *map(str, files)]
    environment = {**os.environ, "MYPYPATH": str(package.parent)}
    return subprocess.run(command, capture_output=True, text=True, env=environment)


def test_the_package_and_a_program_that_uses_it_keep_their_types(tmp_path):
    (tmp_path / "lab.py").write_text(lab)
    right = checked(package, tmp_path / "lab.py", cache=tmp_path / "cache")
    assert right.returncode == 0, right.stdout
    (tmp_path / "wrong.py").write_text('import antinode as an\nan.render(sample_rate_Hz="fast")\n')
    wrong = checked(tmp_path / "wrong.py", cache=tmp_path / "cache")
    assert wrong.returncode == 1 and "sample_rate_Hz" in wrong.stdout


def test_the_stub_names_what_the_compiled_part_has():
    tree = ast.parse((package / "_antinode.pyi").read_text())
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}

    def members(name):
        node = classes[name]
        own = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
        own |= {item.target.id for item in node.body if isinstance(item, ast.AnnAssign)}
        return own.union(*(members(base.id) for base in node.bases if base.id in classes))

    compiled = {name: each for name, each in vars(_antinode).items() if inspect.isclass(each)}
    assert set(compiled) == {name for name in classes if not name.startswith("_")}
    for name, each in compiled.items():
        public = {member for member in vars(each) if not member.startswith("_")}
        assert public == {member for member in members(name) if not member.startswith("_")}, name


def test_everything_public_is_described():
    for name in an.__all__:
        each = getattr(an, name)
        assert each.__doc__, name
        for member, value in vars(each).items() if inspect.isclass(each) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{member}"


def declared():
    """Public names with their arguments and members: a line each; ends of lines are arguments with their defaults."""
    lines = set()
    for name in an.__all__:
        each = getattr(an, name)
        if not inspect.isclass(each):
            parameters = inspect.signature(each).parameters.values()
            lines |= {f"{name} {p.kind.name} {p.name} {default_of(p)}" for p in parameters}
        elif not issubclass(each, Exception):
            lines |= {f"{name}.{member}" for member in dir(each) if not member.startswith("_")}
    return lines


def default_of(parameter):
    """Numbers of one value are one text: 2 and 2.0."""
    value = parameter.default
    if value is parameter.empty:
        return "-"
    return repr(float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else value)


def test_what_the_package_promised_it_has():
    """Tests/Data/Python/public.txt: the package of version 0.1, frozen. What is new is not in it."""
    promised = set((pathlib.Path(__file__).parents[1] / "Data/Python/public.txt").read_text().splitlines())
    assert not promised - declared()
