"""The test of the layout: what programs that are compiled today rely on. It only ever gains lines."""
import re

from . import headers, text

PATH = "tests/abi/layout.c"
SIZES = {"double": 8, "float": 4, "int64_t": 8}  # of 64 bits; all others are numbers of 32 bits, or pointers

HEAD = f"""\
/* {text.MADE_BY}: what programs that are compiled today rely on, which are places, least sizes and
 * numbers. Compiling this file is the test, on machines of 64 bits. Structs grow at their end, so lines are added and
 * never changed: the generator refuses to take one away. Nothing pads the end of a struct, for a later field would lie
 * in what an older program left there. */
#include <stddef.h>

#include "cleft/cleft.h"
#include "cleft/cleft_io.h"

#define HOLDS(condition) _Static_assert(condition, #condition)
#define PLACE(type, field, offset) HOLDS(offsetof(type, field) == (offset))
#define ENDS_WITH(type, field) HOLDS(sizeof(type) == offsetof(type, field) + sizeof(((type*)0)->field))

"""


def _size(field):
    return 8 if field.type.endswith("*") else SIZES.get(field.type, 4)


def _struct(struct):
    """The lines of a struct, by the rules of alignment of 64 bits."""
    lines, end = [], 0
    for field in struct.fields:
        size = _size(field)
        end = (end + size - 1) // size * size
        lines.append(f"PLACE({struct.name}, {field.name}, {end});\n")
        end += size * (field.length or 1)
    return f"HOLDS(sizeof({struct.name}) >= {end});\nENDS_WITH({struct.name}, {struct.fields[-1].name});\n" + "".join(
        lines
    )


def _lost(before, after):
    """What the file pinned and would not any more."""
    for line in re.findall(r"^(?:PLACE|HOLDS)\(.*\);$", before, re.MULTILINE):
        size = re.fullmatch(r"HOLDS\(sizeof\((\w+)\) >= (\d+)\);", line)
        now = size and re.search(rf"^HOLDS\(sizeof\({size[1]}\) >= (\d+)\);$", after, re.MULTILINE)
        if not (now and int(now[1]) >= int(size[2]) if size else line + "\n" in after):
            yield line


def files(tree, _):
    both = [headers.read(tree, headers.CORE), headers.read(tree, headers.FILES)]
    made = HEAD + "#if UINTPTR_MAX == UINT64_MAX\n"
    made += "\n".join(_struct(struct) for header in both for struct in header.structs) + "#endif\n"
    typedefs = sorted(set(re.findall(r"^typedef int32_t (\w+);", "".join(h.text for h in both), re.MULTILINE)))
    made += "\n" + "".join(f"HOLDS(sizeof({name}) == 4);\n" for name in typedefs)
    for header in both:
        for constants in (header.statuses, *(e.constants for e in header.enumerations)):
            if constants:
                made += "\n" + "".join(f"HOLDS({constant.name} == {constant.number});\n" for constant in constants)
    lost = list(_lost(tree.read(PATH), made))
    if lost:
        raise ValueError(
            f"{PATH} pins what the headers do not keep; programs that are compiled break: {' '.join(lost)}"
        )
    return {PATH: made}
