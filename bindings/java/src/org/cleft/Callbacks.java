package org.cleft;

/**
 * The functions of the user while a call runs. The library calls them on the thread that made the call, so they wait by
 * the thread. What they throw stops the call, and comes out of it.
 */
final class Callbacks {
    private static final ThreadLocal<Callbacks> CURRENT = new ThreadLocal<>();

    private final Progress progress;
    private final Log log;
    private Callbacks outer;
    private Throwable thrown;

    Callbacks(Progress progress, Log log) {
        this.progress = progress;
        this.log = log;
    }

    void begin() {
        outer = CURRENT.get();
        CURRENT.set(this);
    }

    /** Throws what a function of the user threw. */
    void end() {
        if (outer == null)
            CURRENT.remove();
        else
            CURRENT.set(outer);
        if (thrown != null)
            throw Callbacks.<RuntimeException>unchecked(thrown);
    }

    /** Also of the checked kind, which languages without checked exceptions throw from anywhere. */
    @SuppressWarnings("unchecked")
    private static <T extends Throwable> T unchecked(Throwable thrown) throws T {
        throw (T) thrown;
    }

    /** From the library: whether to cancel. */
    static boolean progress(double fraction, byte[] stage) {
        Callbacks current = CURRENT.get();
        if (current == null)
            return false;
        if (current.thrown != null || Thread.currentThread().isInterrupted())
            return true;
        if (current.progress == null)
            return false;
        try {
            return !current.progress.update(fraction, Text.of(stage));
        } catch (Throwable failure) {
            current.thrown = failure;
            return true;
        }
    }

    /** From the library. */
    static void log(int level, byte[] sentence) {
        Callbacks current = CURRENT.get();
        if (current == null || current.log == null || current.thrown != null)
            return;
        try {
            current.log.write(Log.Level.of(level), Wording.inJava(Text.of(sentence)));
        } catch (Throwable failure) {
            current.thrown = failure;
        }
    }
}
