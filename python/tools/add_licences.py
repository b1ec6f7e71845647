# SPDX-License-Identifier: MIT
"""Puts the licences of the libraries that a repaired wheel brings along into it.

python add_licences.py WHEEL [ROOT ...]

The libraries are those in camlaw.libs; each is of a package of Debian, whose copyright file says under
which licence it is. ROOT: folders where packages were unpacked that are not installed.
"""

import base64
import hashlib
import re
import subprocess
import sys
import zipfile
from pathlib import Path

# auditwheel puts eight digits into the names: libClp-5499d025.so.1.14.6, libmetis-7-6c75d6e1.0.3.so.
_MARKED = re.compile(r"-[0-9a-f]{8}(?=\.)")


def package_of(library: str) -> str:
    """The package of Debian that has a library."""
    said = subprocess.run(
        ["dpkg", "-S", f"*/{library}"], capture_output=True, text=True, check=False
    ).stdout
    owners = {line.split(":")[0] for line in said.splitlines()}
    return min(owners) if owners else ""


def copyright_of(library: str, roots: list[Path]) -> tuple[str, Path]:
    """The package of a library, and its copyright file."""
    for root in roots:
        if any(root.rglob(library)):
            texts = sorted(root.glob("usr/share/doc/*/copyright"))
            if texts:
                return texts[0].parent.name, texts[0]
    package = package_of(library)
    text = Path("/usr/share/doc") / package / "copyright"
    if not package or not text.exists():
        sys.exit(f"no licence is found for {library}")
    return package, text


def record_line(name: str, data: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}"


def main() -> None:
    wheel, roots = Path(sys.argv[1]), [Path(root) for root in sys.argv[2:]]
    with zipfile.ZipFile(wheel) as archive:
        entries = [(info, archive.read(info)) for info in archive.infolist()]
    names = [info.filename for info, _ in entries]
    about = next(name for name in names if name.endswith(".dist-info/METADATA")).rpartition("/")[0]
    libraries = [name.rpartition("/")[2] for name in names if ".libs/" in name]
    texts = dict(copyright_of(_MARKED.sub("", library), roots) for library in libraries)
    added = {f"libraries/{package}.txt": text.read_bytes() for package, text in texts.items()}
    lines, kept = [], []
    for info, data in entries:
        if info.filename == f"{about}/METADATA":
            files = "".join(f"License-File: {name}\n" for name in sorted(added))
            metadata = data.decode()
            metadata = metadata.replace(
                "License-Expression: MIT\n",
                f"License-Expression: MIT AND LicenseRef-Bundled-Libraries\n{files}",
            )
            if files not in metadata:
                sys.exit(f"{wheel}: its METADATA has no 'License-Expression: MIT'")
            data = metadata.encode()
        if info.filename != f"{about}/RECORD":
            kept.append((info, data))
            lines.append(record_line(info.filename, data))
    licences = [(f"{about}/licenses/{name}", data) for name, data in sorted(added.items())]
    lines += [record_line(name, data) for name, data in licences]
    record = "\n".join([*lines, f"{about}/RECORD,,"]) + "\n"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for info, data in kept:
            archive.writestr(info, data)
        for name, data in [*licences, (f"{about}/RECORD", record.encode())]:
            archive.writestr(name, data)
    print(f"{wheel.name}: licences of {', '.join(sorted(texts))}")


if __name__ == "__main__":
    main()
