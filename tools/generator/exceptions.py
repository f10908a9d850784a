"""The exceptions of Java and C#, one a kind of status. Python has its own kinds among their bases: errors.py is by hand."""
from dataclasses import dataclass

from . import headers, text
from .csharp import summary
from .java import javadoc

JAVA = "bindings/java/src/org/cleft/CleftException.java"
CSHARP = "bindings/csharp/src/FailureKinds.cs"
CSHARP_CHOICE = "bindings/csharp/src/Exceptions.cs"


@dataclass(frozen=True)
class Kind:
    statuses: tuple[str, ...]  # without CLEFT_ERROR_
    java: str
    csharp: str
    text: str
    java_text: str = ""  # where Java has more to say
    csharp_text: str = ""
    base: str = ""  # in Java


KINDS = (
    Kind(("CANCELLED",), "Cancelled", "", "",  # in C# an OperationCanceledException, by hand
         "The progress function answered false, the thread was interrupted, or {@link Mesher#cancel} was called."),
    Kind(("OUT_OF_MEMORY",), "OutOfMemory", "NativeMemoryException", "",
         "There is not enough memory outside the heap of Java.", "Memory outside the managed heap is used up."),
    Kind(("NULL", "ARGUMENT", "BUFFER"), "InvalidArgument", "InvalidArgumentException", "An argument is out of its range."),
    Kind(("NOT_FINITE",), "NotFinite", "NotFiniteException", "A number is NaN or infinite.", base="InvalidArgument"),
    Kind(("OPTION",), "InvalidOption", "InvalidOptionException", "The value of an option is out of its range.",
         base="InvalidArgument"),
    Kind(("TOO_LARGE",), "TooLarge", "TooLargeException", "Too large for numbers of 32 bits."),
    Kind(("UNSUPPORTED",), "Unsupported", "UnsupportedException", "Not supported by this build or format."),
    Kind(("INVALID_MESH",), "InvalidMesh", "InvalidMeshException", "A mesh is not valid."),
    Kind(("LABEL_LOST",), "LabelLost", "LabelLostException", "",
         "A label of the volume is not in the mesh, and {@link Options#strict(boolean)} is on.",
         "A label of the volume is not in the mesh, and the option Strict is on."),
    Kind(("FILE",), "FileFailure", "FileFailureException", "A file cannot be read or written."),
    Kind(("FORMAT",), "InvalidFormat", "InvalidFormatException", "The contents of a file break the rules of its format."),
)
# These have no class of their own: the classes of objects refuse what would give them, with exceptions of the language.
PLAIN = {"INTERNAL", "HANDLE", "BUSY"}


def _derived(kind):
    return [other for other in KINDS if other.base == kind.java]


def _java_class(kind):
    derived = _derived(kind)
    modifiers = "sealed" if derived else "final"
    permits = f" permits {', '.join(other.java for other in derived)}" if derived else ""
    return (javadoc(kind.java_text or kind.text)
            + f"    public static {modifiers} class {kind.java} extends {kind.base or 'CleftException'}{permits} {{\n"
            "        private static final long serialVersionUID = 1L;\n\n"
            f"        private {kind.java}(int status, String sentence) {{\n            super(status, sentence);\n"
            "        }\n    }\n\n")


def _java_choice(kind):
    cases = ", ".join(f"CleftNative.CLEFT_ERROR_{status}" for status in kind.statuses)
    line = f"            case {cases} -> new {kind.java}(status, sentence);\n"
    return line if len(line) <= 120 else f"            case {cases} ->\n                new {kind.java}(status, sentence);\n"


def _csharp_class(kind):
    base = next((other.csharp for other in KINDS if other.java == kind.base), "CleftException")
    return (summary(kind.csharp_text or kind.text, 4)
            + f"    public {'' if _derived(kind) else 'sealed '}class {kind.csharp} : {base}\n    {{\n"
            f"        internal {kind.csharp}(int status, string sentence) : base(status, sentence) {{ }}\n    }}\n")


def _csharp_choice(kind):
    cases = "\n".join(f"            case CleftNative.CLEFT_ERROR_{status}:" for status in kind.statuses)
    return f"{cases} return new {kind.csharp}(status, sentence);\n"


def files(tree, _):
    statuses = {status.name.removeprefix("CLEFT_ERROR_") for status in headers.read(tree, headers.CORE).statuses}
    known = [status for kind in KINDS for status in kind.statuses] + sorted(PLAIN) + ["CLEFT_OK"]
    if sorted(known) != sorted(statuses):
        raise ValueError(f"these statuses have no exception, or are none: {set(known) ^ statuses}")
    java = text.region(tree.read(JAVA), JAVA, "classes", "\n" + "".join(map(_java_class, KINDS)), ("//", ""))
    java = text.region(java, JAVA, "choice", "".join(map(_java_choice, KINDS)), ("//", ""))
    in_csharp = [kind for kind in KINDS if kind.csharp]
    choice = text.region(tree.read(CSHARP_CHOICE), CSHARP_CHOICE, "choice", "".join(map(_csharp_choice, in_csharp)), ("//", ""))
    classes = "\n".join(map(_csharp_class, in_csharp))
    return {JAVA: java, CSHARP_CHOICE: choice,
            CSHARP: f"// {text.MADE_BY} from include/cleft/cleft_status.h.\nnamespace Cleft\n{{\n{classes}}}\n"}
