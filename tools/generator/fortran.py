"""The Fortran modules that are the C headers one to one: cleft_c.f90 and cleft_io_c.f90."""
import re

from . import c_header, headers, text

FOLDER = "bindings/fortran"
WIDTH = text.WIDTH
SCALARS = {
    "int": "integer(c_int)",
    "int32_t": "integer(c_int32_t)",
    "uint32_t": "integer(c_int32_t)",
    "int64_t": "integer(c_int64_t)",
    "double": "real(c_double)",
    "float": "real(c_float)",
    "char": "character(kind=c_char)",
}

# What a type of C does not say. These may be NULL, which Fortran passes as a type(c_ptr); a "*" stands for any
# function.
MAY_BE_NULL = {
    "cleft_version.major",
    "cleft_version.minor",
    "cleft_version.patch",
    "cleft_volume_set_label_name.name",
    "cleft_mesh_set_label_name.name",
    "cleft_volume_create_labels.affine",
    "cleft_volume_create_indicators.affine",
    "cleft_volume_create_indicators.labels",
    "cleft_mesh_create.labels",
    "cleft_mesh_copy_quadratic.points",
    "cleft_mesh_copy_quadratic.tets",
    "cleft_io_read_volume.reading",
    "cleft_io_read_field.reading",
    "cleft_io_read_sizing.reading",
    "cleft_io_read_metric.reading",
    "cleft_io_read_field.dims",
    "cleft_io_read_field.affine",
    "cleft_io_write_picture.strip",
    "cleft_io_write_picture.whole",
    "cleft_io_write_picture.picture",
    "cleft_io_write_view.view",
}
# These pointers are to one number, not to an array.
ONE_NUMBER = {"value", "size", "point_count"}

HEADS = {
    "cleft_c": """\
! {made_by} from include/cleft/cleft.h, which is its manual: the C interface of libcleft, one to one.
!
! - Handles are type(c_ptr). What may be NULL in C is a type(c_ptr) here, too: pass c_null_ptr or c_loc(array).
! - Texts that go in end with c_null_char. Texts and arrays that come out are type(c_ptr), borrowed: see c_f_pointer.
! - Numbers that come out are intent(inout), for they are left untouched on failure.
! - Points are numbered from 0, as in C. The module `cleft` numbers them from 1 and needs no pointers.
module cleft_c
  use, intrinsic :: iso_c_binding
  implicit none
  public
""",
    "cleft_io_c": """\
! {made_by} from include/cleft/cleft_io.h, which is its manual: the C interface of the file
! component, one to one. Conventions: see cleft_c.
module cleft_io_c
  use, intrinsic :: iso_c_binding
  use cleft_c
  implicit none
  public
""",
}


def _scalar(c_type, structs):
    base = re.sub(r"\bconst\b|\s", "", c_type)
    if base in SCALARS:
        return SCALARS[base]
    return f"type({base})" if base in structs else "integer(c_int32_t)"  # the typedefs of int32_t


def _field(field, structs):
    kind = "type(c_ptr)" if field.type.endswith("*") else _scalar(field.type, structs)
    return f"    {kind} :: {field.name}" + (f"({field.length})" if field.length else "")


def _argument(function, argument, structs):
    """How an argument is declared: its type with attributes, and its shape."""
    is_constant = argument.type.startswith("const ")
    stars = argument.type.count("*") + bool(argument.length)
    base = re.sub(r"\bconst\b|\*|\s", "", argument.type)
    if base.endswith("_callback"):
        return "type(c_funptr), value", ""
    if isinstance(function, c_header.Callback) and stars:
        return "type(c_ptr), value", ""
    if stars == 0:
        return _scalar(base, structs) + ", value", ""
    is_handle = base == "void" or base.startswith("cleft_") and base not in structs and not _is_number(base)
    if stars == 2:
        return (
            ("type(c_ptr), intent(in)", "(*)") if argument.type.endswith("const*") else ("type(c_ptr), intent(out)", "")
        )
    if is_handle or f"{function.name}.{argument.name}" in MAY_BE_NULL:
        return "type(c_ptr), value", ""
    shape = (
        f"({argument.length})" if argument.length else "" if base in structs or argument.name in ONE_NUMBER else "(*)"
    )
    return f"{_scalar(base, structs)}, intent({'in' if is_constant else 'inout'})", shape


def _is_number(c_type):
    return c_type in (
        "cleft_status",
        "cleft_option",
        "cleft_type",
        "cleft_io_format",
        "cleft_io_world",
        "cleft_io_kind",
    )


def _function(function, structs):
    names = ", ".join(argument.name for argument in function.arguments)
    word = "subroutine" if function.result == "void" else "function"
    head = f"    {word} {function.name}({names}) bind(C)" + ("" if function.result == "void" else " result(answer)")
    if len(head) > WIDTH:
        head = text.lines(head.strip(), WIDTH - 2, "    ", "      ").rstrip().replace("\n", " &\n")
    declared = []  # [type, names]: neighbours of one type share a line
    for argument in function.arguments:
        kind, shape = _argument(function, argument, structs)
        if declared and declared[-1][0] == kind:
            declared[-1][1].append(argument.name + shape)
        else:
            declared.append((kind, [argument.name + shape]))
    if function.result != "void":
        declared.append(
            ("type(c_ptr)" if function.result.endswith("*") else _scalar(function.result, structs), ["answer"])
        )
    body = "".join(f"      {kind} :: {', '.join(names)}\n" for kind, names in declared)
    return f"{head}\n      import\n{body}    end {word}\n"


def _constants(constants):
    rows = ", &\n".join(f"    {constant.name} = {constant.number}" for constant in constants)
    return f"\n  integer(c_int32_t), parameter :: &\n{rows}\n"


def _module(name, header, known):
    structs = known | {struct.name for struct in header.structs}
    out = HEADS[name].format(made_by=text.MADE_BY)
    for constants in (header.versions, header.statuses, *(e.constants for e in header.enumerations)):
        if constants:
            out += _constants(constants)
    for struct in header.structs:
        fields = "\n".join(_field(field, structs) for field in struct.fields)
        out += f"\n  type, bind(C) :: {struct.name}\n{fields}\n  end type\n"
    if header.callbacks:
        out += "\n  abstract interface\n"
        out += "".join("\n" + _function(callback, structs) for callback in header.callbacks)
        out += "\n  end interface\n"
    out += "\n  interface\n"
    for section in header.sections:
        functions = [item for item in section.items if item in header.functions]
        if functions:
            out += "\n    ! " + f" {section.name}".rjust(113, "-") + "\n"
            out += "".join("\n" + _function(function, structs) for function in functions)
    return out + f"\n  end interface\n\nend module {name}\n"


# The constants that the public modules hand on, by their beginnings: all else has names there.
_PUBLIC = {
    "cleft": ("CLEFT_OK", "CLEFT_ERROR_", "CLEFT_LOG_", "CLEFT_SIDE_"),
    "cleft_io": (
        "CLEFT_FORMAT_",
        "CLEFT_IO_WORLD_",
        "CLEFT_IO_KIND_",
        "CLEFT_IO_ORDER_",
        "CLEFT_IO_BY_",
        "CLEFT_IO_BACKDROP_",
        "CLEFT_TYPE_",
        "CLEFT_IO_UNKNOWN",
        "CLEFT_IO_VOLUME",
        "CLEFT_IO_MESH",
    ),
}


def _numbers(module, statement, names):
    listed = ", ".join(name for name in names if name.startswith(_PUBLIC[module]))
    return text.lines(f"{statement} {listed}", WIDTH - 2, "  ", "    ").rstrip().replace("\n", " &\n") + "\n"


def _public(tree, core, io):
    """The public modules, with the numbers that they hand on."""
    names = [c.name for h in (core, io) for part in (h.statuses, *(e.constants for e in h.enumerations)) for c in part]
    for module, statement in (("cleft", "use cleft_c, only:"), ("cleft_io", "public ::")):
        path = f"{FOLDER}/{module}.f90"
        yield path, text.region(tree.read(path), path, "numbers", _numbers(module, statement, names), ("!", ""))


def files(tree, _):
    core, io = headers.read(tree, headers.CORE), headers.read(tree, headers.FILES)
    arguments = {f"{f.name}.{a.name}" for f in core.functions + io.functions for a in f.arguments}
    if not arguments >= MAY_BE_NULL:
        raise ValueError(f"there are no arguments {sorted(MAY_BE_NULL - arguments)}")
    core_structs = {struct.name for struct in core.structs}
    return {
        f"{FOLDER}/cleft_c.f90": _module("cleft_c", core, set()),
        f"{FOLDER}/cleft_io_c.f90": _module("cleft_io_c", io, core_structs),
        **dict(_public(tree, core, io)),
    }
