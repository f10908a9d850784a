package org.cleft;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;

/** The calls on one context: one at a time, and nothing that a call needs goes away while it runs. */
final class Calls {
    private final NativeHandle context;
    private final AtomicBoolean busy = new AtomicBoolean();

    /** A function of the library: the context, the addresses of the arguments (0 for null), where a new handle goes. */
    @FunctionalInterface
    interface Call {
        int run(long context, long[] arguments, long[] out);
    }

    Calls(NativeHandle context) {
        this.context = context;
    }

    /** Runs a call, and answers what it wrote. */
    long[] run(Callbacks callbacks, Call call, NativeObject... arguments) {
        if (!busy.compareAndSet(false, true))
            throw new IllegalStateException("this Mesher is running another call; use one Mesher a thread");
        List<NativeHandle> leased = new ArrayList<>();
        try {
            long address = lease(context, leased);
            long[] addresses = new long[arguments.length];
            for (int i = 0; i < arguments.length; ++i)
                addresses[i] = arguments[i] == null ? 0 : lease(arguments[i].handle(), leased);
            return run(callbacks, call, address, addresses);
        } finally {
            leased.forEach(NativeHandle::release);
            busy.set(false);
        }
    }

    private static long[] run(Callbacks callbacks, Call call, long context, long[] arguments) {
        long[] out = NativeObject.out();
        int status;
        callbacks.begin();
        try {
            status = call.run(context, arguments, out);
        } finally {
            callbacks.end();
        }
        if (status != CleftNative.CLEFT_OK)
            throw CleftException.of(status, sentence(context, status));
        return out;
    }

    private static String sentence(long context, int status) {
        // A busy context leaves none: what is there is of the other call.
        String sentence = status == CleftNative.CLEFT_ERROR_BUSY ? "" : CleftNative.cleft_context_last_error(context);
        return sentence.isEmpty() ? CleftNative.cleft_status_string(status) : Wording.inJava(sentence);
    }

    private static long lease(NativeHandle handle, List<NativeHandle> leased) {
        long address = handle.lease();
        leased.add(handle);
        return address;
    }
}
