import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.cleft.*;

/** Progress, log and cancelling. */
final class CallbacksTest {
    private final Mesher mesher = new Mesher();

    public static void main(String[] arguments) throws Exception {
        Checks.runAll(CallbacksTest.class);
    }

    void testProgress() {
        List<Double> fractions = new ArrayList<>();
        Thread caller = Thread.currentThread();
        mesher.threads(2).progress((fraction, stage) -> {
            fractions.add(fraction);
            Checks.check(Thread.currentThread() == caller && !stage.isEmpty(), "wrong thread or no stage");
            return true;
        });
        mesher.mesh(Checks.ballVolume(new Mesher()), Checks.quick());
        Checks.check(fractions.size() > 3, "no progress");
        Checks.equal(fractions.stream().sorted().toList(), fractions);
        fractions.clear();
        Checks.ballMesh(mesher.progress(null));
        Checks.equal(List.of(), fractions);
    }

    void testFalseCancels() {
        Checks.thrown(
                CleftException.Cancelled.class, () -> Checks.ballMesh(mesher.progress((fraction, stage) -> false)));
        Checks.check(Checks.ballMesh(mesher.progress((fraction, stage) -> true)).tetCount() > 0, "no mesh");
    }

    void testExceptionsComeOut() {
        RuntimeException own = new RuntimeException("own");
        Checks.check(Checks.thrown(RuntimeException.class, () -> Checks.ballMesh(mesher.progress((fraction, stage) -> {
            throw own;
        }))) == own, "another exception");
        Error error = new AssertionError("an error");
        Checks.check(Checks.thrown(Error.class, () -> Checks.ballMesh(mesher.progress((fraction, stage) -> {
            throw error;
        }))) == error, "another error");
        Exception checked = new java.io.IOException("as Kotlin throws it");
        Checks.check(Checks.thrown(Exception.class, () -> Checks.ballMesh(mesher.progress((fraction, stage) -> {
            throw CallbacksTest.<RuntimeException>asIfUnchecked(checked);
        }))) == checked, "another checked exception");
        Checks.ballMesh(mesher.progress(null));
    }

    @SuppressWarnings("unchecked")
    private static <T extends Exception> T asIfUnchecked(Exception exception) throws T {
        throw (T) exception;
    }

    void testLog() {
        List<Log.Level> levels = new ArrayList<>();
        Options tooFew = new Options().background(Background.LATTICE).tets(1);  // cannot be met, which is warned of
        Volume volume = Checks.ballVolume(mesher);
        mesher.log((level, sentence) -> levels.add(level)).mesh(volume, tooFew);
        Checks.check(levels.contains(Log.Level.WARNING), "no warning");
        mesher.log((level, sentence) -> {
            throw new IllegalStateException(sentence);
        });
        Checks.thrown(IllegalStateException.class, () -> mesher.mesh(volume, tooFew));
        mesher.log(null).mesh(volume, tooFew);
    }

    /** Smoothing is of the volume: given to a later call alone, it changes nothing, and that is reported. */
    void testSmoothWithoutEffect() {
        List<String> warnings = new ArrayList<>();
        mesher.log((level, sentence) -> {
            if (level == Log.Level.WARNING)
                warnings.add(sentence);
        });
        Volume volume = Checks.ballVolume(mesher);
        mesher.mesh(volume, Checks.quick().smooth(3));
        Checks.check(warnings.size() == 1 && warnings.get(0).startsWith("smooth is 3"), warnings.toString());
    }

    private static String standardErrorOf(Runnable body) {
        var old = System.err;
        var bytes = new java.io.ByteArrayOutputStream();
        System.setErr(new java.io.PrintStream(bytes, true));
        try {
            body.run();
        } finally {
            System.setErr(old);
        }
        return bytes.toString();
    }

    /** Who gives no function sees warnings all the same. */
    void testWarningsAreShown() {
        Options tooFew = new Options().background(Background.LATTICE).tets(1);
        Volume volume = Checks.ballVolume(mesher);
        String shown = standardErrorOf(() -> mesher.mesh(volume, tooFew));
        Checks.check(shown.startsWith("cleft: warning: "), shown);
        Checks.equal("", standardErrorOf(() -> mesher.log(null).mesh(volume, tooFew)));
        Checks.equal("", standardErrorOf(() -> Checks.ballMesh(mesher.log(Log::showWarnings))));
    }

    void testCancelFromAnotherThread() throws Exception {
        CountDownLatch started = new CountDownLatch(1);
        Volume volume = Checks.slowVolume(mesher);
        mesher.progress((fraction, stage) -> {
            started.countDown();
            return true;
        });
        Thread thread = new Thread(() -> {
            try {
                started.await();
            } catch (InterruptedException interrupted) {
                throw new AssertionError(interrupted);
            }
            mesher.cancel();
        });
        thread.start();
        Checks.thrown(CleftException.Cancelled.class, () -> mesher.mesh(volume, null));
        thread.join();
    }

    void testInterruptCancels() {
        Volume volume = Checks.slowVolume(mesher);
        Thread.currentThread().interrupt();
        Checks.thrown(CleftException.Cancelled.class, () -> mesher.mesh(volume, null));
        Checks.check(Thread.interrupted(), "the interrupt was swallowed");
    }

    void testOneCallAtATime() {
        mesher.progress((fraction, stage) -> {
            mesher.metrics();
            return true;
        });
        Checks.thrown(IllegalStateException.class, () -> Checks.ballMesh(mesher));
    }

    void testCallbacksMayMeshElsewhere() {
        long[] tets = new long[1];
        int[] calls = new int[1];
        mesher.progress((fraction, stage) -> {
            ++calls[0];
            if (tets[0] == 0)
                tets[0] = Checks.ballMesh(new Mesher()).tetCount();
            return true;
        });
        Checks.equal(Checks.ballMesh(mesher).tetCount(), tets[0]);
        Checks.check(calls[0] > 3, "the outer function was forgotten");
    }
}
