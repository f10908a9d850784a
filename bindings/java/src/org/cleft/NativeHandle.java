package org.cleft;

import java.util.function.LongConsumer;

/**
 * The address of an object of the library. It is counted who needs it: its owner until it is closed, each call while it
 * runs, each view until it is collected. The object is destroyed when the last has gone.
 */
final class NativeHandle {
    private final String kind;
    private final LongConsumer destroy;
    private final long address;
    private final long bytes;
    private int users = 1;
    private boolean closed;

    NativeHandle(String kind, long address, long bytes, LongConsumer destroy) {
        this.kind = kind;
        this.address = address;
        this.bytes = bytes;
        this.destroy = destroy;
        NativeMemory.add(bytes);
    }

    /** The address, which stays good until release(). */
    synchronized long lease() {
        if (closed)
            throw new IllegalStateException("this " + kind + " is closed");
        ++users;
        return address;
    }

    void release() {
        boolean last;
        synchronized (this) {
            last = --users == 0;
        }
        if (last) {
            destroy.accept(address);
            NativeMemory.remove(bytes);
        }
    }

    /** The owner's part: nobody gets a lease any more. Again and again is allowed. */
    void close() {
        synchronized (this) {
            if (closed)
                return;
            closed = true;
        }
        release();
    }

    String kind() {
        return kind;
    }

    synchronized boolean isClosed() {
        return closed;
    }
}
