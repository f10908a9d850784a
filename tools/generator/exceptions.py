"""The exceptions of Java, C# and Python, one a kind of status."""
from dataclasses import dataclass

from . import headers, text
from .csharp import summary
from .java import javadoc

JAVA = "bindings/java/src/org/cleft/CleftException.java"
CSHARP = "bindings/csharp/src/FailureKinds.cs"
CSHARP_CHOICE = "bindings/csharp/src/Exceptions.cs"
PYTHON = "bindings/python/cleft/errors.py"


@dataclass(frozen=True)
class Kind:
    statuses: tuple[str, ...]  # without CLEFT_ERROR_
    java: str
    csharp: str
    python: str
    text: str
    java_text: str = ""  # where a language has more to say
    csharp_text: str = ""
    python_text: str = ""
    base: str = ""  # the kind, by its name in Java, that this one is of
    python_base: str = ""  # of Python's own exceptions, where there is a natural one


KINDS = (
    Kind(
        ("CANCELLED",),
        "Cancelled",
        "",  # in C# an OperationCanceledException, by hand
        "Cancelled",
        "",
        "The progress function answered false, the thread was interrupted, or {@link Mesher#cancel} was called.",
        python_text="The progress function answered a false value, or Mesher.cancel() was called.",
    ),
    Kind(
        ("OUT_OF_MEMORY",),
        "OutOfMemory",
        "NativeMemoryException",
        "OutOfMemory",
        "",
        "There is not enough memory outside the heap of Java.",
        "Memory outside the managed heap is used up.",
        "There is not enough memory.",
        python_base="MemoryError",
    ),
    Kind(
        ("ARGUMENT", "NULL", "BUFFER"),
        "InvalidArgument",
        "InvalidArgumentException",
        "InvalidArgument",
        "An argument is out of its range.",
        python_text="An argument is out of its range, or missing.",
        python_base="ValueError",
    ),
    Kind(
        ("NOT_FINITE",),
        "NotFinite",
        "NotFiniteException",
        "NotFinite",
        "A number is NaN or infinite.",
        base="InvalidArgument",
    ),
    Kind(
        ("OPTION",),
        "InvalidOption",
        "InvalidOptionException",
        "OptionError",
        "The value of an option is out of its range.",
        base="InvalidArgument",
    ),
    Kind(
        ("TOO_LARGE",),
        "TooLarge",
        "TooLargeException",
        "TooLarge",
        "Too large for numbers of 32 bits.",
        python_base="OverflowError",
    ),
    Kind(
        ("UNSUPPORTED",),
        "Unsupported",
        "UnsupportedException",
        "Unsupported",
        "Not supported by this build or format.",
        python_base="NotImplementedError",
    ),
    Kind(
        ("INVALID_MESH",),
        "InvalidMesh",
        "InvalidMeshException",
        "InvalidMesh",
        "A mesh is not valid.",
        python_base="ValueError",
    ),
    Kind(
        ("LABEL_LOST",),
        "LabelLost",
        "LabelLostException",
        "LabelLost",
        "",
        "A label of the volume is not in the mesh, and {@link Options#strict(boolean)} is on.",
        "A label of the volume is not in the mesh, and the option Strict is on.",
        "A label of the volume is not in the mesh, and the option `strict` is on.",
    ),
    # In Python FileError, by hand: its classes are those of the system's numbers, too.
    Kind(("FILE",), "FileFailure", "FileFailureException", "", "A file cannot be read or written."),
    Kind(
        ("FORMAT",),
        "InvalidFormat",
        "InvalidFormatException",
        "FormatError",
        "The contents of a file break the rules of its format.",
        python_base="ValueError",
    ),
    # Of Python alone: the objects of Java and C# refuse what would give these, with exceptions of the language.
    # No binding makes meshes in parts, so that none sees EXCHANGE.
    Kind(("INTERNAL", "EXCHANGE"), "", "", "InternalError", "A defect of the library."),
    Kind(("HANDLE",), "", "", "Closed", "The object was closed before.", python_base="ValueError"),
    Kind(("BUSY",), "", "", "Busy", "The Mesher runs another call.", python_base="RuntimeError"),
)


def _derived(kind):
    return [other for other in KINDS if kind.java and other.base == kind.java]


def _base(kind):
    return next((other for other in KINDS if kind.base and other.java == kind.base), None)


def _java_class(kind):
    derived = _derived(kind)
    modifiers = "sealed" if derived else "final"
    permits = f" permits {', '.join(other.java for other in derived)}" if derived else ""
    return (
        javadoc(kind.java_text or kind.text)
        + f"    public static {modifiers} class {kind.java} extends {kind.base or 'CleftException'}{permits} {{\n"
        "        private static final long serialVersionUID = 1L;\n\n"
        f"        private {kind.java}(int status, String sentence) {{\n            super(status, sentence);\n"
        "        }\n    }\n\n"
    )


def _java_choice(kind):
    cases = ", ".join(f"CleftNative.CLEFT_ERROR_{status}" for status in kind.statuses)
    line = f"            case {cases} -> new {kind.java}(status, sentence);\n"
    return (
        line
        if len(line) <= 120
        else f"            case {cases} ->\n                new {kind.java}(status, sentence);\n"
    )


def _csharp_class(kind):
    base = _base(kind).csharp if kind.base else "CleftException"
    return (
        summary(kind.csharp_text or kind.text, 4)
        + f"    public {'' if _derived(kind) else 'sealed '}class {kind.csharp} : {base}\n    {{\n"
        f"        internal {kind.csharp}(int status, string sentence) : base(status, sentence) {{ }}\n    }}\n"
    )


def _csharp_choice(kind):
    cases = "\n".join(f"            case CleftNative.CLEFT_ERROR_{status}:" for status in kind.statuses)
    return f"{cases} return new {kind.csharp}(status, sentence);\n"


def _python_class(kind):
    bases = [_base(kind).python if kind.base else "CleftError"] + ([kind.python_base] if kind.python_base else [])
    return (
        f'class {kind.python}({", ".join(bases)}):\n    """{kind.python_text or kind.text}"""\n\n'
        f"    status = native.CLEFT_ERROR_{kind.statuses[0]}\n\n\n"
    )


def _python_choice(kind):
    return "".join(f"    native.CLEFT_ERROR_{status}: {kind.python or 'FileError'},\n" for status in kind.statuses)


def files(tree, _):
    statuses = {status.name.removeprefix("CLEFT_ERROR_") for status in headers.read(tree, headers.CORE).statuses}
    known = [status for kind in KINDS for status in kind.statuses] + ["CLEFT_OK"]
    if sorted(known) != sorted(statuses):
        raise ValueError(f"these statuses have no exception, or are none: {set(known) ^ statuses}")
    in_java, in_csharp = [kind for kind in KINDS if kind.java], [kind for kind in KINDS if kind.csharp]
    java = text.region(tree.read(JAVA), JAVA, "classes", "\n" + "".join(map(_java_class, in_java)), ("//", ""))
    java = text.region(java, JAVA, "choice", "".join(map(_java_choice, in_java)), ("//", ""))
    choice = text.region(
        tree.read(CSHARP_CHOICE), CSHARP_CHOICE, "choice", "".join(map(_csharp_choice, in_csharp)), ("//", "")
    )
    classes = "\n".join(map(_csharp_class, in_csharp))
    python = text.region(
        tree.read(PYTHON), PYTHON, "classes", "".join(_python_class(kind) for kind in KINDS if kind.python), ("#", "")
    )
    python = text.region(python, PYTHON, "choice", "".join(map(_python_choice, KINDS)), ("#", ""))
    return {
        JAVA: java,
        CSHARP_CHOICE: choice,
        PYTHON: python,
        CSHARP: f"// {text.MADE_BY} from include/cleft/cleft_status.h.\nnamespace Cleft\n{{\n{classes}}}\n",
    }
