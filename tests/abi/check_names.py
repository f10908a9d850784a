"""No two headers may define a class of the same name: where they are not inlined, the linker takes the functions of the
one for those of the other, and says nothing.

check_names.py FOLDER
"""
import collections
import pathlib
import re
import sys

DEFINITION = re.compile(r"^(?:struct|class|enum|enum class) (\w+)(?: final)?(?: : [^;]+)?(?: \{|$)", re.MULTILINE)

places = collections.defaultdict(list)
for header in sorted(pathlib.Path(sys.argv[1]).rglob("*.hpp")):
    for name in DEFINITION.findall(header.read_text()):
        places[name].append(header.relative_to(sys.argv[1]))
twice = {name: sorted(set(map(str, where))) for name, where in places.items() if len(set(where)) > 1}
if len(places) < 50:
    sys.exit(f"only {len(places)} classes were found; the test does not see what it should")
if twice:
    sys.exit("\n".join(f"{name} is defined in {' and '.join(where)}" for name, where in sorted(twice.items())))
