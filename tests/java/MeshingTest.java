import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.cleft.*;

/** The stages and what can be asked of their results. */
final class MeshingTest {
    private final Mesher mesher = new Mesher();

    public static void main(String[] arguments) throws Exception {
        Checks.runAll(MeshingTest.class);
    }

    void testMeshIsSound() {
        Mesh mesh = Checks.ballMesh(mesher);
        Validation found = mesher.validate(mesh, true);
        Checks.check(found.valid() && found.firstFault().isEmpty(), found.toString());
        Checks.equal(new int[] {0, 1, 7}, mesh.labels());
        Checks.near(12 * 13 * 14, mesher.quality(mesh).totalVolume(), 1e-12);
        Checks.equal(4L * mesh.tetCount(), (long) mesh.tets().length);
        Checks.equal(3L * mesh.pointCount(), (long) mesh.points().length);
        Checks.check(Arrays.stream(mesh.tets()).allMatch(point -> point >= 0 && point < mesh.pointCount()), "corners");
    }

    void testWords() {
        Volume volume = Checks.ballVolume(mesher);
        Mesh mesh = Checks.ballMesh(mesher);
        Checks.equal("Volume of 12 x 13 x 14 voxels, 3 labels", volume.toString());
        Checks.equal(
                "Mesh of " + mesh.pointCount() + " points, " + mesh.tetCount() + " tetrahedra, 3 labels",
                mesh.toString());
        Checks.equal("Mesher of 1 threads", mesher.toString());
        for (NativeObject thing : new NativeObject[] {mesher.sizing(volume, null), mesher.surface(mesh)})
            Checks.check(thing.toString().startsWith(thing.getClass().getSimpleName() + " of "), thing.toString());
        mesh.close();
        Checks.equal("Mesh (closed)", mesh.toString());
    }

    void testVoxelsOfAnyType() {
        byte[] labels = Checks.ballLabels();
        short[] shorts = new short[labels.length];
        int[] ints = new int[labels.length];
        ByteBuffer buffer = ByteBuffer.allocateDirect(2 * labels.length).order(ByteOrder.nativeOrder());
        for (int i = 0; i < labels.length; ++i) {
            ints[i] = shorts[i] = labels[i];
            buffer.putShort(2 * i, labels[i]);
        }
        Mesh wanted = Checks.ballMesh(mesher);
        for (Volume volume : List.of(mesher.labels(shorts, Checks.GRID, null), mesher.labels(ints, Checks.GRID, null),
                mesher.labels(buffer, VoxelType.UINT16, Checks.GRID, null)))
            Checks.check(Checks.same(wanted, mesher.mesh(volume, Checks.quick())), "another mesh");
        Arrays.fill(labels, (byte) 200);
        Checks.equal(new int[] {200}, mesher.labels(labels, Checks.GRID, null).labels());
        Arrays.setAll(ints, i -> i < 700 ? Integer.MIN_VALUE : Integer.MAX_VALUE);
        Checks.equal(new int[] {Integer.MIN_VALUE, Integer.MAX_VALUE}, mesher.labels(ints, Checks.GRID, null).labels());
    }

    void testWorld() {
        Grid grid = Checks.GRID.spacing(0.5, 1, 2).origin(10, 20, 30);
        Volume volume = mesher.labels(Checks.ballLabels(), grid, null);
        Checks.equal(grid, volume.grid());
        Checks.equal(new long[] {12, 13, 14}, volume.dims());
        Checks.equal(new int[] {7, 1}, volume.sample(10 + 0.5 * 11, 20, 30, 10 + 0.5 * 5, 26, 30 + 2 * 7));
        Checks.equal(new double[] {1, 0, 0, 0.5, 0, 1, 0, 0.5, 0, 0, 1, 0.5}, Checks.ballVolume(mesher).affine());
        double[] affine = {0, -2, 0, 5, 1, 0, 0, 6, 0, 0, 3, 7};
        Checks.equal(affine, mesher.labels(Checks.ballLabels(), Checks.GRID.affine(affine), null).affine());
    }

    void testStagesByHand() {
        Volume volume = Checks.ballVolume(mesher);
        Options options = Checks.quick();
        Sizing sizing = mesher.sizing(volume, options);
        Mesh background = mesher.background(sizing, options);
        Checks.equal(new int[] {0}, background.labels());
        Mesh improved = mesher.improve(volume, mesher.cleave(volume, background, options), options);
        Checks.check(mesher.validate(improved, true).valid(), "not valid");
        Checks.equal(improved.tetCount(), mesher.mesh(volume, sizing, background, options).tetCount());
        Checks.equal(new int[] {1, 7}, mesher.strip(improved, new Options().strip(0)).labels());
        Checks.equal(new int[] {1}, mesher.strip(improved, new Options().only(1)).labels());
    }

    void testTheOneCallIsTheFiveCalls() {
        double[] affine = {0.7, 0.1, 0, -3.1, 0.2, -0.9, 0.3, 100.3, 0.1, 0, 1.3, 7.7};
        Volume volume = mesher.labels(Checks.ballLabels(), Checks.GRID.affine(affine), null);
        float[] values = new float[12 * 13 * 14];
        for (int i = 0; i < values.length; ++i)
            values[i] = 1.5f + 0.1f * (i % 12);
        Sizing own = mesher.sizing(volume, values, false, null);
        for (Background kind : Background.values()) {
            sameByStages(volume, null, new Options().background(kind));
            sameByStages(volume, null, new Options().background(kind).tets(3000).strip(0));
            sameByStages(volume, own, new Options().background(kind).strict(true).strip(0));
        }
    }

    private void sameByStages(Volume volume, Sizing given, Options options) {
        Mesh background = mesher.background(given != null ? given : mesher.sizing(volume, options), options);
        Mesh improved = mesher.improve(volume, mesher.cleave(volume, background, options), options);
        Mesh stages = mesher.strip(improved, options), whole = mesher.mesh(volume, given, null, options);
        Checks.equal(whole.points(), stages.points());
        Checks.equal(whole.tets(), stages.tets());
        Checks.equal(whole.tetLabels(), stages.tetLabels());
    }

    void testEstimate() {
        Volume volume = Checks.ballVolume(mesher);
        Options options = new Options().background(Background.OCTREE).size(1);
        Estimate estimate = mesher.estimate(volume, null, null, options);
        double tets = mesher.mesh(volume, options).tetCount();
        Checks.near(tets, estimate.tets(), 0.15);
        Checks.check(estimate.peakBytes() > 100 * tets, "memory");
        Mesh own = mesher.background(mesher.constantSizing(volume, 2), null);
        Checks.near(own.tetCount(), mesher.estimate(volume, null, own, null).backgroundTets(), 0);
    }

    void testSizing() {
        Volume volume = Checks.ballVolume(mesher);
        Checks.near(2.5, mesher.constantSizing(volume, 2.5).at(6, 6, 6), 1e-6);
        double[] wanted = new double[12 * 13 * 14];
        float[] floats = new float[wanted.length];
        for (int i = 0; i < wanted.length; ++i)
            floats[i] = (float) (wanted[i] = i < 1000 ? 1.5 : 3);
        Sizing sizing = mesher.sizing(volume, wanted, false, null);
        Checks.equal(floats, sizing.values());
        Checks.equal(floats, mesher.sizing(volume, floats, false, null).values());
        Checks.equal(volume.affine(), sizing.affine());
        Checks.equal(volume.dims(), sizing.dims());
        Checks.check(sizing.expectedTets() > 100, "expected");
        for (float value : mesher.sizing(volume, wanted, true, new Options().size(2)).values())
            Checks.check(value <= 2, "combined");
    }

    void testMetric() {
        Volume volume = Checks.ballVolume(mesher);
        double[] tensors = new double[6 * 12 * 13 * 14];
        float[] floats = new float[tensors.length];
        for (int i = 0; i < tensors.length; ++i)
            floats[i] = (float) (tensors[i] = new double[] {0.2 + 1e-4 * i, 0.01, -0.02, 0.3, 0.03, 0.5}[i % 6]);
        for (Sizing sizing : new Sizing[] {
            mesher.metricSizing(volume, tensors, false, null), mesher.metricSizing(volume, floats, false, null)
        }) {
            Checks.check(sizing.hasMetric(), "it has a metric");
            float[] metric = sizing.metric();
            Checks.equal(tensors.length, metric.length);
            for (int i = 0; i < metric.length; ++i)
                Checks.check(Math.abs(metric[i] - tensors[i]) < 1e-5, "a tensor comes back");
        }
        float[] bounded = mesher.metricSizing(volume, tensors, true, new Options().sizeMax(0.5)).metric();
        Checks.near(4, bounded[0], 1e-5);
        Sizing flat = mesher.constantMetricSizing(volume, new double[] {1.0 / 9, 0, 0, 1.0 / 9, 0, 1});
        Checks.near(1, flat.metric()[5], 1e-6);
        Mesh mesh = mesher.mesh(volume, flat, null, Checks.quick());
        MetricQuality quality = mesher.metricQuality(mesh, flat);
        Checks.equal(mesh.tetCount(), quality.tetCount());
        Checks.equal(6 * mesh.tetCount(), quality.dihedralHistogram().stream().mapToLong(Long::longValue).sum());
        Checks.check(quality.edgesInRange() > 0 && quality.edgesInRange() <= quality.edgeCount(), "edges in range");
        Checks.check(0 < quality.edgeLeast() && quality.edgeLeast() < 1 && quality.edgeGreatest() > 1, "lengths");
        Sizing plain = mesher.constantSizing(volume, 2);
        Checks.check(!plain.hasMetric(), "sizes alone");
        Checks.thrown(CleftException.InvalidArgument.class, plain::metric);
        Checks.thrown(CleftException.InvalidArgument.class, () -> mesher.metricQuality(mesh, plain));
    }

    void testIndicators() {
        double[] inside = new double[12 * 13 * 14];
        for (int i = 0; i < inside.length; ++i)
            inside[i] = 5.5 - i % 12;
        double[] outside = Arrays.stream(inside).map(value -> -value).toArray();
        float[] single = new float[inside.length];
        for (int i = 0; i < inside.length; ++i)
            single[i] = (float) inside[i];
        Checks.equal(new int[] {0, 1}, mesher.indicators(new float[][] {single}, Checks.GRID, null).labels());
        Volume volume = mesher.indicators(new double[][] {inside, outside}, Checks.GRID, new int[] {40, -3});
        Checks.equal(new int[] {-3, 40}, mesher.mesh(volume, Checks.quick()).labels());
    }

    void testReport() {
        Volume volume = Checks.ballVolume(mesher);
        List<LabelReport> rows = mesher.report(volume, mesher.mesh(volume, Checks.quick()));
        Checks.equal(List.of(0, 1, 7), rows.stream().map(LabelReport::label).toList());
        Map<Integer, Long> counts = volume.voxelCounts();
        for (LabelReport row : rows)
            Checks.check(!row.lost() && counts.get(row.label()) == row.voxels(), row.toString());
        Checks.near(12 * 13 * 14, rows.stream().mapToDouble(LabelReport::meshVolume).sum(), 1e-12);
    }

    void testQuality() {
        Mesh mesh = Checks.ballMesh(mesher);
        Quality quality = mesher.quality(mesh);
        Checks.equal(mesh.tetCount(), quality.tetCount());
        Checks.equal(6 * mesh.tetCount(), quality.dihedralHistogram().stream().mapToLong(Long::longValue).sum());
        Checks.check(0 < quality.minDihedral() && quality.minDihedral() < 60 && quality.maxDihedral() < 180, "angles");
    }

    void testSurface() {
        Mesh mesh = Checks.ballMesh(mesher);
        Surface surface = mesher.surface(mesh);
        mesh.close();
        Checks.equal(surface.interfaceTriangles().length / 3, surface.interfaceLabels().length / 2);
        Checks.equal(surface.hullTriangles().length / 3, surface.hullLabels().length);
        Checks.equal(6L, Arrays.stream(surface.hullSides()).mapToObj(side -> Side.values()[side]).distinct().count());
    }

    void testArraysThereAndBack() {
        Mesh mesh = Checks.ballMesh(mesher);
        Checks.check(
                Checks.same(mesh, mesher.meshOf(mesh.points(), mesh.tets(1), mesh.tetLabels(), 1)), "another mesh");
        Checks.equal(new int[] {0}, mesher.meshOf(mesh.points(), mesh.tets(), null, 0).labels());
        Validation found = mesher.validate(
                mesher.meshOf(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, new int[] {1, 0, 2, 3}, null, 0),
                false);
        Checks.check(!found.valid() && found.negativeTets() == 1 && !found.firstFault().isEmpty(), found.toString());
    }

    void testQuadratic() {
        Mesh mesh = Checks.ballMesh(mesher);
        Mesh.Quadratic ten = mesh.quadratic(0);
        Checks.equal(10 * mesh.tetCount(), (long) ten.tets().length);
        int[] t = ten.tets();
        Checks.near((ten.points()[3 * t[0]] + ten.points()[3 * t[1]]) / 2 + 1, ten.points()[3 * t[4]] + 1, 1e-12);
        Checks.equal(t[0] + 1, mesh.quadratic(1).tets()[0]);
    }

    void testThreads() throws Exception {
        Volume volume = Checks.ballVolume(mesher);
        Mesh one = mesher.mesh(volume, Checks.quick());
        Checks.equal(2, mesher.threads(2).threads());
        Checks.check(Checks.same(one, mesher.mesh(volume, Checks.quick())), "another mesh");
        Thread[] threads = new Thread[4];
        boolean[] same = new boolean[threads.length];
        for (int n = 0; n < threads.length; ++n) {
            int mine = n;
            threads[n] = new Thread(() -> same[mine] = Checks.same(one, new Mesher().mesh(volume, Checks.quick())));
            threads[n].start();
        }
        for (Thread thread : threads)
            thread.join();
        Checks.equal(new boolean[] {true, true, true, true}, same);
    }

    void testMetrics() {
        Checks.ballMesh(mesher).close();
        Checks.check(mesher.metrics().size() > 3, "no figures");
        mesher.clearMetrics();
        Checks.equal(Map.of(), mesher.metrics());
    }

    void testVersion() {
        Checks.check(Cleft.version().matches("\\d+\\.\\d+\\.\\d+"), Cleft.version());
        Checks.check(Cleft.hasTetgen() || !Cleft.hasTetgen(), "no answer");
    }

    void testNamesOfLabels() {
        Volume volume = Checks.ballVolume(mesher).labelName(1, "Herz \u2764 \ud83d\ude00").labelName(7, "slab");
        Checks.equal("", volume.labelName(0));
        Checks.equal("", volume.labelName(99));
        Checks.equal(Map.of(1, "Herz \u2764 \ud83d\ude00", 7, "slab"), volume.labelNames());
        Mesh mesh = mesher.mesh(volume, Checks.quick());
        Checks.equal(volume.labelNames(), mesh.labelNames());
        Checks.equal(Map.of(7, "slab"), mesher.strip(mesh, new Options().only(7)).labelNames());
        mesh.labelName(1, "").labelName(0, "outside");
        Checks.equal(Map.of(0, "outside", 7, "slab"), mesh.labelNames());
        Checks.equal("slab", volume.labelName(7));
    }

    /** The labels 0, 1, 7 of the ball under other names. */
    private static int[] renamed(int... names) {
        byte[] labels = Checks.ballLabels();
        int[] others = new int[labels.length];
        for (int i = 0; i < others.length; ++i)
            others[i] = names[labels[i] == 7 ? 2 : labels[i]];
        return others;
    }

    /**
     * No label is special: not -1, nor the extremes of 32 bits, in any place where a label can be given or asked for.
     */
    void testAnyLabels() {
        Mesh wanted = Checks.ballMesh(mesher);
        int[] sides = mesher.surface(wanted).hullSides();
        for (int[] names : new int[][] {
                {-1, 5, 9}, {-3, -1, 0}, {-2, -1, 0x7fffffff}, {Integer.MIN_VALUE, -1, Integer.MAX_VALUE},
                {Integer.MIN_VALUE, Integer.MIN_VALUE + 1, -1}, {0, Integer.MAX_VALUE - 1, Integer.MAX_VALUE}}) {
            Volume volume = mesher.labels(renamed(names), Checks.GRID, null);
            Checks.equal(names, volume.labels());
            Checks.equal(new int[] {names[2], names[1]}, volume.sample(11.5, 0.5, 0.5, 5.5, 6.5, 7.5));
            Mesh mesh = mesher.mesh(volume, Checks.quick());
            Checks.equal(names, mesh.labels());
            Checks.equal(wanted.points(), mesh.points());
            Checks.equal(wanted.tets(), mesh.tets());
            Checks.equal(Arrays.stream(wanted.tetLabels()).map(label -> names[label == 7 ? 2 : label]).toArray(),
                    mesh.tetLabels());
            Checks.check(java.nio.IntBuffer.wrap(mesh.tetLabels()).equals(mesh.tetLabelsView()), "another view");
            Checks.equal("minus one", mesh.labelName(names[1], "minus one").labelNames().get(names[1]));
            Mesh again = mesher.meshOf(mesh.points(), mesh.tets(), mesh.tetLabels(), 0);
            Checks.equal(names, again.labels());
            Checks.check(mesher.validate(mesh, true).valid(), "not valid");
            Checks.equal(mesher.surface(wanted).interfaceTriangles(), mesher.surface(mesh).interfaceTriangles());
            Checks.equal(sides, mesher.surface(mesh).hullSides());
            Validation found = mesher.validate(mesh, true);
            Checks.equal(3 * found.interfaceTriangles(), (long) mesher.surface(mesh).interfaceTriangles().length);
            Checks.equal(3 * found.hullTriangles(), (long) mesher.surface(mesh).hullTriangles().length);
            for (int m = 0; m < 3; ++m) {
                Checks.equal(new int[] {names[m]}, mesher.strip(mesh, new Options().only(names[m])).labels());
                Checks.equal(2, mesher.strip(mesh, new Options().strip(names[m])).labels().length);
                LabelReport row = mesher.report(volume, mesh).get(m);
                Checks.check(
                        row.label() == names[m] && row.voxels() == volume.voxelCounts().get(names[m]), row.toString());
                Options fine = new Options().background(Background.LATTICE).sizeMax(4).labelSize(names[m], 0.7);
                Options same = new Options().background(Background.LATTICE).sizeMax(4)
                        .labelSize(new int[] {0, 1, 7}[m], 0.7);
                Checks.equal(
                        mesher.sizing(Checks.ballVolume(mesher), same).values(), mesher.sizing(volume, fine).values());
            }
        }
    }

    /** Two labels with a gap of one voxel of a third between them. */
    private static int[] gapped(int first, int gap, int second) {
        int[] labels = new int[20 * 20 * 20];
        for (int v = 0; v < labels.length; ++v)
            labels[v] = v % 20 < 10 ? first : v % 20 == 10 ? gap : second;
        return labels;
    }

    void testContacts() {
        for (int[] names : new int[][] {{1, 0, 2}, {-2, 5, Integer.MAX_VALUE}, {Integer.MIN_VALUE, 0, 9},
                {-1, 0, 3}, {-9, -1, 4}, {-9, 2, -1}}) {
            Volume volume = mesher.log(null).labels(gapped(names[0], names[1], names[2]), new Grid(20, 20, 20), null);
            Mesh coarse = mesher.mesh(volume, new Options().background(Background.LATTICE).size(6));
            int[] pairs = mesher.surface(coarse).interfaceLabels();
            long triangles = 0;
            for (int i = 0; i < pairs.length; i += 2)
                triangles += pairs[i] == names[0] && pairs[i + 1] == names[2] ? 1 : 0;
            Checks.check(triangles > 0, "the gap is still there");
            Report report = mesher.report(volume, coarse);
            Checks.equal(List.of(new Contact(names[0], names[2], triangles)), report.contacts());
            Checks.equal(3, report.size());
            Checks.equal(List.of(), report.distances());
            List<Distance> distances = mesher.reportWithDistances(volume, coarse).distances();
            Checks.check(distances.stream().anyMatch(d -> d.first() == names[0] && d.second() == names[2]
                    && !d.isLine() && d.elements() > 0 && d.meshGreatest() > 0), "a distance of the two labels");
            Mesh fine = mesher.mesh(volume, new Options().background(Background.LATTICE).size(1));
            Checks.equal(List.of(), mesher.report(volume, fine).contacts());
        }
    }
}
