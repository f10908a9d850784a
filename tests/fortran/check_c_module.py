"""Do a header of C and its Fortran module say the same? check_c_module.py HEADER... MODULE.f90

Compares every function (arguments in order: name, type, by value or by reference, direction; result), every enumerator
and every field of every structure.
"""
import re
import sys

SCALARS = {
    "int": "integer(c_int)", "int32_t": "integer(c_int32_t)", "uint32_t": "integer(c_int32_t)",
    "int64_t": "integer(c_int64_t)", "double": "real(c_double)", "float": "real(c_float)",
    "char": "character(kind=c_char)",
}


def scalar(c_type, structs):
    """The Fortran type of a C type that is no pointer."""
    if c_type in SCALARS:
        return SCALARS[c_type]
    return f"type({c_type})" if c_type in structs else "integer(c_int32_t)"  # the typedefs of int32_t


def allowed(c_type, is_array, structs):
    """The ways in which an argument of this C type may be declared in Fortran."""
    if c_type.endswith("_callback"):
        return {"type(c_funptr), value"}
    constant = c_type.startswith("const ")
    stars = c_type.count("*") + is_array
    base = re.sub(r"const|\*|\s", "", c_type)
    if stars == 0:
        return {scalar(base, structs) + ", value"}
    intents = ["in"] if constant else ["out", "inout"]
    if stars == 2:
        intents = ["in"] if constant and base != "char" or "const*" in c_type.replace(" ", "") else ["out"]
        return {f"type(c_ptr), intent({intent})" for intent in intents}
    if base == "void" or re.fullmatch(r"cleft_\w+", base) and base not in structs and "int32" not in base:
        return {"type(c_ptr), value"}
    by_reference = {f"{scalar(base, structs)}, intent({intent})" for intent in intents}
    return by_reference | {"type(c_ptr), value"}


def read_headers(paths):
    text = re.sub(r"/\*.*?\*/", "", "".join(open(path).read() for path in paths), flags=re.S)
    structs = {}
    for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\}", text, re.S):
        structs[name] = re.findall(r"(\w+)(?:\[\d+\])?;", body)
    constants = dict(re.findall(r"\b(CLEFT_\w+) = (-?\d+)", text))
    constants.pop("CLEFT_STATUS_RESERVED", None)  # keeps the enumeration 32 bits wide, and is no status
    constants.update(re.findall(r"#define (CLEFT_VERSION_\w+) (\d+)$", text, re.M))
    constants.update({"CLEFT_" + name: value for name, value in re.findall(r"X\((\w+), (-?\d+),", text)})
    functions = {}
    for result, name, arguments in re.findall(r"^(?:CLEFT_NODISCARD )?CLEFT(?:_IO)?_API ([^;()]*?)(\w+)\(([^;]*?)\) CLEFT_NOEXCEPT;", text, re.M):
        found = []
        for argument in re.sub(r"\s+", " ", arguments).split(","):
            if argument.strip() != "void":
                kind, argument_name, array = re.fullmatch(r"(.*?)(\w+)(\[\d+\])?", argument.strip()).groups()
                found.append((argument_name, allowed(kind.strip(), bool(array), structs)))
        result = result.strip()
        functions[name] = (found, None if result == "void" else
                           "type(c_ptr)" if result.endswith("*") else scalar(result, structs))
    return functions, constants, structs


def read_module(path):
    text = re.sub(r"!.*", "", open(path).read())
    text = re.sub(r"&\s*\n\s*", "", text)
    structs = {}
    for name, body in re.findall(r"type, bind\(C\) :: (\w+)\n(.*?)end type", text, re.S):
        structs[name] = re.findall(r":: (\w+)", body)
    constants = dict(re.findall(r"\b(CLEFT_\w+) = (-?\d+)", text))
    functions = {}
    interfaces = re.search(r"\n  interface\n(.*?)\n  end interface", text, re.S).group(1)
    for name, arguments, result, body in re.findall(
            r"(?:function|subroutine) (\w+)\((.*?)\) bind\(C\)(?: result\((\w+)\))?\n(.*?)end (?:function|subroutine)",
            interfaces, re.S):
        types = {}
        for declared, names in re.findall(r"^\s*(.*?) :: (.*)$", body, re.M):
            types.update({n: declared for n in re.findall(r"(\w+)(?:\([^)]*\))?", names)})
        functions[name] = ([(n.strip(), types[n.strip()]) for n in arguments.split(",") if n.strip()], types.get(result))
    return functions, constants, structs


def differences(header, module):
    for what, wanted, found in zip(("function", "constant", "structure"), header, module):
        for name in sorted(set(wanted) ^ set(found)):
            yield f"{what} {name} is in {'the header' if name in wanted else 'the module'} alone"
    for kind in (1, 2):
        for name in sorted(set(header[kind]) & set(module[kind])):
            if header[kind][name] != module[kind][name]:
                yield f"{name}: {header[kind][name]} in C, {module[kind][name]} in Fortran"
    for name in sorted(set(header[0]) & set(module[0])):
        (c_arguments, c_result), (arguments, result) = header[0][name], module[0][name]
        if [n for n, _ in c_arguments] != [n for n, _ in arguments]:
            yield f"{name}: arguments are {[n for n, _ in c_arguments]} in C, {[n for n, _ in arguments]} in Fortran"
            continue
        for (argument, ways), (_, declared) in zip(c_arguments, arguments):
            if declared not in ways:
                yield f"{name}: {argument} is declared as {declared}, not as one of {sorted(ways)}"
        if c_result != result:
            yield f"{name}: gives {result}, not {c_result}"


def main():
    *headers, module = sys.argv[1:]
    header = read_headers(headers)
    if not all(header):
        sys.exit("nothing was found in " + " ".join(headers))
    faults = list(differences(header, read_module(module)))
    print("\n".join(faults) or f"{len(header[0])} functions agree")
    sys.exit(bool(faults))


main()
