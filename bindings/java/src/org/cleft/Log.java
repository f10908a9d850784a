package org.cleft;

/** Receives warnings and remarks. A mesher has {@link #showWarnings} unless it is given another. */
@FunctionalInterface
public interface Log {
    /** How much a sentence matters. */
    enum Level {
        // <constants> made by tools/generate.py from include/cleft/cleft.h
        /** A result may not be what the user intends. */
        WARNING,
        /** Useful information. */
        INFO,
        /** Details for finding a fault. */
        DEBUG;
        // </constants>

        static Level of(int number) {
            return switch (number) {
                case CleftNative.CLEFT_LOG_WARNING -> WARNING;
                case CleftNative.CLEFT_LOG_DEBUG -> DEBUG;
                default -> INFO;
            };
        }
    }

    /**
     * Called on the thread that made the call. What it throws stops the call and comes out of it.
     *
     * @param level how much it matters
     * @param sentence what there is to say
     */
    void write(Level level, String sentence);

    /**
     * Prints warnings on the standard error, and nothing else.
     *
     * @param level how much it matters
     * @param sentence what there is to say
     */
    static void showWarnings(Level level, String sentence) {
        if (level == Level.WARNING)
            System.err.println("cleft: warning: " + sentence);
    }
}
