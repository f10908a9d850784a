package org.cleft;

import java.lang.ref.Cleaner;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.LongConsumer;
import java.util.function.LongFunction;
import java.util.function.LongToIntFunction;

/**
 * What owns memory of the library. It is freed by {@link #close}, or when the object is no longer reachable; but not
 * before the last view of it (a buffer that looks into that memory) is gone too, and the last call that uses it is
 * over.
 */
public abstract sealed class NativeObject implements AutoCloseable
        permits Mesher, Options, Volume, Sizing, Mesh, Surface {
    static final Cleaner CLEANER = Cleaner.create();

    private final NativeHandle handle;
    private final Cleaner.Cleanable cleanable;

    /** @param bytes about how many the object holds outside the heap, as {@link NativeSize} tells */
    NativeObject(String kind, long address, long bytes, LongConsumer destroy) {
        NativeHandle owned = new NativeHandle(kind, address, bytes, destroy);
        handle = owned;
        cleanable = CLEANER.register(this, owned::close);
        NativeMemory.makeRoom();
    }

    /** Gives the object up. Closing again does nothing; views that are still held stay good. */
    @Override
    public final void close() {
        cleanable.clean();
    }

    /**
     * Was {@link #close} called?
     *
     * @return whether it was
     */
    public final boolean isClosed() {
        return handle.isClosed();
    }

    /** What this is, in a few words. */
    @Override
    public final String toString() {
        return handle.kind() + (isClosed() ? " (closed)" : description());
    }

    /** What follows the kind in toString(). */
    String description() {
        return "";
    }

    final NativeHandle handle() {
        return handle;
    }

    /** What `read` makes of the address, which is good for the while. */
    final <T> T with(LongFunction<T> read) {
        long address = handle.lease();
        try {
            return read.apply(address);
        } finally {
            handle.release();
        }
    }

    /** Runs a function that answers a status. */
    final void checked(LongToIntFunction call) {
        CleftException.check(with(address -> call.applyAsInt(address)));
    }

    /** A read-only buffer over memory of this object, which it keeps alive with all buffers that are made of it. */
    final ByteBuffer view(LongFunction<Long> start, LongFunction<Long> size) {
        long address = handle.lease();
        boolean kept = false;
        try {
            long bytes = size.apply(address);
            if (bytes > Integer.MAX_VALUE)
                throw new UnsupportedOperationException("a view cannot have more than 2 GiB; this has " + bytes);
            if (bytes == 0)
                return ByteBuffer.allocateDirect(0).asReadOnlyBuffer().order(ByteOrder.nativeOrder());
            ByteBuffer memory = CleftNative.memory_at(start.apply(address), bytes);
            NativeHandle leased = handle;
            CLEANER.register(memory, leased::release);
            kept = true;
            return memory.asReadOnlyBuffer().order(ByteOrder.nativeOrder());
        } finally {
            if (!kept)
                handle.release();
        }
    }

    /** The length of an array of `count` times `width` elements, if Java can have one. */
    static int length(long count, int width) {
        if (count > Integer.MAX_VALUE / width)
            throw new UnsupportedOperationException(
                    "an array of Java cannot have " + count + " times " + width + " elements");
        return (int) count * width;
    }

    /** A handle to write an address of a new object to. */
    static long[] out() {
        return new long[1];
    }
}
