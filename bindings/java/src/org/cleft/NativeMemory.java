package org.cleft;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The bytes that objects hold outside the heap. The collector does not see them: a mesh is a few bytes to it. So
 * objects that nobody closes would pile up long before the heap fills. When what is held has grown by more than a
 * budget, the collector is asked to find the objects that nobody reaches any more, as the JDK does for direct buffers.
 */
final class NativeMemory {
    /** The property with the budget in bytes. */
    static final String PROPERTY = "org.cleft.memory.budget";

    private static final long BUDGET = Math.max(0, Long.getLong(PROPERTY, 128L << 20));
    private static final long PATIENCE_NANOSECONDS = 500_000_000;

    private static final Object COLLECTING = new Object();
    private static final AtomicLong HELD = new AtomicLong();
    /** The least that was held since the last collection: most likely all in use. */
    private static final AtomicLong LEAST = new AtomicLong();

    private NativeMemory() {}

    static void add(long bytes) {
        HELD.addAndGet(bytes);
    }

    static void remove(long bytes) {
        LEAST.accumulateAndGet(HELD.addAndGet(-bytes), Math::min);
    }

    /** Makes room if more than the budget may be garbage; with much in use, if it may be a third of all. */
    static void makeRoom() {
        if (isOverBudget())
            synchronized (COLLECTING) {
                if (isOverBudget())
                    collect();
            }
    }

    private static boolean isOverBudget() {
        long least = LEAST.get();
        return HELD.get() - least > Math.max(BUDGET, least / 2);
    }

    /** First lets the cleaner end what it is about to free; only then asks for a collection, which costs more. */
    private static void collect() {
        boolean interrupted = Thread.interrupted();
        long deadline = System.nanoTime() + PATIENCE_NANOSECONDS;
        interrupted |= waitWhileFreeing(new AtomicBoolean(true), deadline);
        if (isOverBudget()) {
            AtomicBoolean cleaned = new AtomicBoolean();
            registerGarbage(cleaned);
            System.gc();
            interrupted |= waitWhileFreeing(cleaned, deadline);
            LEAST.set(HELD.get());
        }
        if (interrupted)
            Thread.currentThread().interrupt();
    }

    /** An object that the next collection finds: when its turn has come, the cleaner is at work. */
    private static void registerGarbage(AtomicBoolean cleaned) {
        NativeObject.CLEANER.register(new Object(), () -> cleaned.set(true));
    }

    /** Waits until the cleaner is at work and then frees nothing for a while. Was this thread interrupted? */
    private static boolean waitWhileFreeing(AtomicBoolean cleanerIsAtWork, long deadline) {
        boolean interrupted = false;
        long before;
        do {
            before = HELD.get();
            try {
                Thread.sleep(1);
            } catch (InterruptedException interrupt) {
                interrupted = true;
            }
        } while ((!cleanerIsAtWork.get() || HELD.get() < before) && System.nanoTime() < deadline);
        return interrupted;
    }
}
