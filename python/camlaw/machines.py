# SPDX-License-Identifier: MIT
"""The mechanisms that problems name: their parameters and responses."""

from __future__ import annotations

from html import escape
from typing import Any

from . import tables
from .arguments import text
from .native import native


class Mechanism:
    """A built-in mechanism: its title, its source, and tables of its parameters and responses."""

    def __init__(self, facts: dict[str, Any]) -> None:
        self._facts = facts

    @property
    def name(self) -> str:
        return str(self._facts["name"])

    @property
    def title(self) -> str:
        return str(self._facts["title"])

    @property
    def source(self) -> str:
        return str(self._facts["source"])

    @property
    def parameters(self) -> Any:
        """A table: parameter, symbol, default, lower, upper, unit, integer, meaning."""
        return tables.of_rows(self._facts["parameters"], index="parameter")

    @property
    def responses(self) -> Any:
        """A table: response, kind, unit, meaning."""
        return tables.of_rows(self._facts["responses"], index="response")

    def formula(self, response: str) -> str:
        """The formula of a response, in the grammar of docs/formulas.md."""
        return native.formula(self.name, text(response, "response"))

    def formulas(self) -> str:
        """The formulas of all responses in LaTeX, as a page in Markdown."""
        return native.formulas_page(self.name)

    def __repr__(self) -> str:
        return f"<camlaw mechanism {self.name}: {self.title}>"

    def _repr_html_(self) -> str:
        parts = [f"<p><b>{escape(self.name)}</b>: {escape(self.title)}</p>"]
        for table in (self.parameters, self.responses):
            parts.append(table._repr_html_())
        return "".join(parts)


def mechanism(name: str) -> Mechanism:
    """A mechanism by its name. Raises InputError for an unknown name, with those that are known."""
    return Mechanism(native.mechanism(text(name, "mechanism")))


def mechanisms() -> list[str]:
    """The names of all mechanisms."""
    return native.mechanism_names()
