import java.lang.reflect.Method;
import org.cleft.*;

/** Options: their names, defaults and ranges are those of the library. */
final class OptionsTest {
    public static void main(String[] arguments) throws Exception {
        Checks.runAll(OptionsTest.class);
    }

    private static String camel(String name) {
        StringBuilder camel = new StringBuilder();
        for (String part : name.split("_"))
            camel.append(camel.isEmpty() ? part : Character.toUpperCase(part.charAt(0)) + part.substring(1));
        return camel.toString();
    }

    private static double number(Object value) {
        if (value instanceof Enum<?> choice)
            return choice.ordinal();
        if (value instanceof Boolean flag)
            return flag ? 1 : 0;
        return ((Number) value).doubleValue();
    }

    void testEveryOptionHasItsMethods() throws Exception {
        Options options = new Options();
        Checks.check(OptionDescription.table().size() > 10, "no table");
        for (OptionDescription row : OptionDescription.table()) {
            Method get = Options.class.getMethod(camel(row.name()));
            Checks.equal(row.defaultValue(), number(get.invoke(options)));
            Method set = Options.class.getMethod(camel(row.name()), get.getReturnType());
            set.invoke(options, get.invoke(options));
            if (row.type() == OptionDescription.Type.CHOICE) {
                Object[] choices = get.getReturnType().getEnumConstants();
                Checks.equal(row.choices().size(), choices.length);
                for (Object choice : choices) {
                    Checks.equal(row.choices().get(((Enum<?>) choice).ordinal()), choice.toString().toLowerCase());
                    if (choice == DelaunayEngine.TETGEN && !Cleft.hasTetgen()) {
                        continue;
                    }
                    set.invoke(options, choice);
                    Checks.equal(choice, get.invoke(options));
                }
            }
        }
    }

    void testValuesAreKept() {
        Options options = new Options().size(2).sizeMin(1).sizeMax(3).tets(1_000_000_000L).smooth(3).strict(true)
                .background(Background.OCTREE).seed(1L << 40).labelSize(3, 0.5).strip(0, 5).only();
        Checks.equal(2.0, options.size());
        Checks.equal(1_000_000_000L, options.tets());
        Checks.equal(1L << 40, options.seed());
        Checks.equal(3, options.smooth());
        Checks.equal(true, options.strict());
        Checks.equal(Background.OCTREE, options.background());
        Checks.equal(Snap.SAFE, options.set("snap", "safe").snap());
    }

    void testWrongValues() {
        Options options = new Options().size(2);
        Checks.thrown(CleftException.InvalidArgument.class, () -> options.size(Double.NaN));
        Checks.thrown(CleftException.InvalidArgument.class, () -> options.size(Double.POSITIVE_INFINITY));
        Checks.thrown(CleftException.InvalidOption.class, () -> options.size(-1));
        Checks.thrown(CleftException.InvalidOption.class, () -> options.smooth(99));
        Checks.thrown(CleftException.InvalidOption.class, () -> options.set("size", "two"));
        Checks.thrown(CleftException.InvalidOption.class, () -> options.set("colour", "red"));
        Checks.thrown(CleftException.class, () -> options.labelSize(1, -1));
        Checks.thrown(CleftException.class, () -> options.labelSize(1, Double.NaN));
        Checks.thrown(NullPointerException.class, () -> options.background(null));
        Checks.thrown(NullPointerException.class, () -> options.strip((int[]) null));
        Checks.thrown(NullPointerException.class, () -> options.set(null, "1"));
        Checks.thrown(NullPointerException.class, () -> options.set("size", null));
        Checks.equal(2.0, options.size());
        options.close();
        Checks.thrown(IllegalStateException.class, () -> options.size(1));
        Checks.thrown(IllegalStateException.class, options::size);
    }
}
