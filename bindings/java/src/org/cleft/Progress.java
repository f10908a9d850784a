package org.cleft;

/** Receives how far a call has come. */
@FunctionalInterface
public interface Progress {
    /**
     * Called now and then, on the thread that made the call. What it throws stops the call and comes out of it.
     *
     * @param fraction what is done, 0 to 1
     * @param stage what is being done, in words
     * @return true to go on, false to stop with {@link CleftException.Cancelled}
     */
    boolean update(double fraction, String stage);
}
