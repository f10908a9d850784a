package org.cleft;

/** A failure of the library, with one sentence on the cause. Each status of the library has a subclass. */
public class CleftException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** The library's number for the kind of failure. */
    private final int status;

    private CleftException(int status, String sentence) {
        super(sentence);
        this.status = status;
    }

    /**
     * The library's number for the kind of failure.
     *
     * @return a negative number, as in C
     */
    public int status() {
        return status;
    }

    // <classes> made by tools/generate.py from include/cleft/cleft_status.h

    /** The progress function answered false, the thread was interrupted, or {@link Mesher#cancel} was called. */
    public static final class Cancelled extends CleftException {
        private static final long serialVersionUID = 1L;

        private Cancelled(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** There is not enough memory outside the heap of Java. */
    public static final class OutOfMemory extends CleftException {
        private static final long serialVersionUID = 1L;

        private OutOfMemory(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** An argument is out of its range. */
    public static sealed class InvalidArgument extends CleftException permits NotFinite, InvalidOption {
        private static final long serialVersionUID = 1L;

        private InvalidArgument(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** A number is NaN or infinite. */
    public static final class NotFinite extends InvalidArgument {
        private static final long serialVersionUID = 1L;

        private NotFinite(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** The value of an option is out of its range. */
    public static final class InvalidOption extends InvalidArgument {
        private static final long serialVersionUID = 1L;

        private InvalidOption(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** Too large for numbers of 32 bits. */
    public static final class TooLarge extends CleftException {
        private static final long serialVersionUID = 1L;

        private TooLarge(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** Not supported by this build or format. */
    public static final class Unsupported extends CleftException {
        private static final long serialVersionUID = 1L;

        private Unsupported(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** A mesh is not valid. */
    public static final class InvalidMesh extends CleftException {
        private static final long serialVersionUID = 1L;

        private InvalidMesh(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** A label of the volume is not in the mesh, and {@link Options#strict(boolean)} is on. */
    public static final class LabelLost extends CleftException {
        private static final long serialVersionUID = 1L;

        private LabelLost(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** A file cannot be read or written. */
    public static final class FileFailure extends CleftException {
        private static final long serialVersionUID = 1L;

        private FileFailure(int status, String sentence) {
            super(status, sentence);
        }
    }

    /** The contents of a file break the rules of its format. */
    public static final class InvalidFormat extends CleftException {
        private static final long serialVersionUID = 1L;

        private InvalidFormat(int status, String sentence) {
            super(status, sentence);
        }
    }

    // </classes>

    /** The exception of a status that is not success. */
    static CleftException of(int status, String sentence) {
        return switch (status) {
            // <choice> made by tools/generate.py from include/cleft/cleft_status.h
            case CleftNative.CLEFT_ERROR_CANCELLED -> new Cancelled(status, sentence);
            case CleftNative.CLEFT_ERROR_OUT_OF_MEMORY -> new OutOfMemory(status, sentence);
            case CleftNative.CLEFT_ERROR_ARGUMENT, CleftNative.CLEFT_ERROR_NULL, CleftNative.CLEFT_ERROR_BUFFER ->
                new InvalidArgument(status, sentence);
            case CleftNative.CLEFT_ERROR_NOT_FINITE -> new NotFinite(status, sentence);
            case CleftNative.CLEFT_ERROR_OPTION -> new InvalidOption(status, sentence);
            case CleftNative.CLEFT_ERROR_TOO_LARGE -> new TooLarge(status, sentence);
            case CleftNative.CLEFT_ERROR_UNSUPPORTED -> new Unsupported(status, sentence);
            case CleftNative.CLEFT_ERROR_INVALID_MESH -> new InvalidMesh(status, sentence);
            case CleftNative.CLEFT_ERROR_LABEL_LOST -> new LabelLost(status, sentence);
            case CleftNative.CLEFT_ERROR_FILE -> new FileFailure(status, sentence);
            case CleftNative.CLEFT_ERROR_FORMAT -> new InvalidFormat(status, sentence);
            // </choice>
            default -> new CleftException(status, sentence);
        };
    }

    /** Throws the exception of a status, unless it is success. */
    static void check(int status, String sentence) {
        if (status != CleftNative.CLEFT_OK)
            throw of(status, sentence);
    }

    /** The same, with the text that the library has for the status. */
    static void check(int status) {
        if (status != CleftNative.CLEFT_OK)
            throw of(status, CleftNative.cleft_status_string(status));
    }
}
