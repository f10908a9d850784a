// One mesh: what is drawn, and what the panel tells.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { about, changes, closed, drawn, opened, pictureOf, trianglesOf } from "./support.mjs";

const { report } = about;
const labels = report.mesh.labels.map((row) => row.label);

test("a picture is there, and the surrounding label can be shown", async () => {
    const page = await opened(about.page);
    assert.ok((await pictureOf(page)).colours > 20);
    assert.equal(await page.title(), "balls.vtu");
    assert.match(await page.textContent("#surrounding"), /Label 0 surrounds all others/);
    assert.ok(await changes(page, () => page.click("#surrounding button")));
    await closed(page);
});

test("the triangles drawn are those of the mesh", async () => {
    const page = await opened(about.page);
    await page.click("#surrounding button");
    await page.selectOption("#cut-choice", "none");
    assert.deepEqual(await trianglesOf(page), [report.mesh.hull_triangles]);
    await page.check("#interfaces"); // each from both of its sides
    assert.deepEqual(await trianglesOf(page), [2 * report.mesh.interface_triangles]);
    await closed(page);
});

test("cuts change the picture", async () => {
    const page = await opened(about.page);
    const at = (value) => page.locator("#cut-at").fill(String(value));
    for (const kind of ["x", "y", "z", "free"]) {
        await page.selectOption("#cut-choice", kind);
        for (const flat of [false, true]) {
            await page.setChecked("#cut-flat", flat);
            await at(0.3);
            assert.ok(await changes(page, () => at(0.45)), `${kind} ${flat}`);
        }
        assert.ok(await changes(page, () => page.setChecked("#cut-flat", false)), kind);
        assert.ok(await changes(page, () => page.locator("#cut-flip").click()), kind);
    }
    assert.ok(await changes(page, () => page.locator("#cut-yaw").fill("80")));
    assert.ok(await changes(page, () => page.click("#cut-face")));
    await closed(page);
});

test("a flat cut at a place has the area of the box", async () => {
    const page = await opened(about.page);
    await page.click("#surrounding button");
    await page.selectOption("#cut-choice", "z");
    await page.check("#cut-flat");
    await page.locator("#cut-at").fill("0.37");
    const area = await page.evaluate(() => {
        const { places, triangles } = cleftPage.views[0].slice;
        let sum = 0;
        for (let i = 0; i < triangles; ++i) {
            const [a, b, c] = [0, 4, 8].map((at) => places.subarray(12 * i + at, 12 * i + at + 3));
            sum +=
                Math.hypot(
                    ...[0, 1, 2].map((k) => {
                        const [m, n] = [(k + 1) % 3, (k + 2) % 3];
                        return (b[m] - a[m]) * (c[n] - a[n]) - (b[n] - a[n]) * (c[m] - a[m]);
                    }),
                ) / 2;
        }
        return sum * cleftPage.frame.unit ** 2;
    });
    const [width, height] = [0, 1].map((axis) => report.mesh.high[axis] - report.mesh.low[axis]);
    assert.ok(Math.abs(area / (width * height) - 1) < 1e-4, `${area}`);
    await closed(page);
});

test("materials can be hidden, found and shown alone", async () => {
    const page = await opened(about.page);
    const box = (label) => page.locator(`.material[data-label="${label}"] input`);
    assert.equal(await page.locator(".material").count(), labels.length);
    for (const label of labels) assert.ok(await changes(page, () => box(label).click()), `${label}`);
    await page.click("#hide-all");
    assert.deepEqual(await trianglesOf(page), [0]);
    assert.equal((await pictureOf(page)).colours, 1);
    await page.fill("#material-search", "7");
    await page.click("#show-all");
    assert.ok((await trianglesOf(page))[0] > 0);
    assert.deepEqual(await page.evaluate(() => [...cleftPage.state.hidden].sort()), [0, 3]);
    await closed(page);
});

test("colours and edges change the picture, and measures have a legend", async () => {
    const page = await opened(about.page);
    for (const by of ["angle", "ratio", "size"]) {
        assert.ok(await changes(page, () => page.selectOption("#by-choice", by)), by);
        assert.ok(await page.isVisible(".legend"));
    }
    assert.ok(await changes(page, () => page.selectOption("#by-choice", "material")));
    assert.ok(await page.isHidden(".legend"));
    assert.ok(await changes(page, () => page.uncheck("#edges")));
    await closed(page);
});

test("the figures are those of the command", async () => {
    const page = await opened(about.page);
    const counts = await page.$$eval(".histogram .bar", (bars) => bars.map((bar) => Number(bar.dataset.count)));
    assert.deepEqual(counts, report.quality.dihedral_histogram);
    assert.match(await page.textContent(".histogram .goal-text"), /25/);
    const measured = await page.evaluate(() => {
        const { mesh } = cleftPage.views[0];
        const bins = new Array(36).fill(0);
        for (let t = 0; t < mesh.tetCount; ++t)
            for (const angle of cleftPage.anglesOf(cleftPage.cornersOf(mesh, t)))
                ++bins[Math.min(35, Math.floor(angle / 5))];
        return {
            bins,
            least: Math.min(...cleftPage.measured(mesh, "angle")),
            worst: Math.max(...cleftPage.measured(mesh, "ratio")),
        };
    });
    // Coordinates of 32 bits move an angle over the end of a bin now and then.
    const off = measured.bins.reduce((sum, count, i) => sum + Math.abs(count - counts[i]), 0);
    assert.ok(off <= 20, `${measured.bins}`);
    assert.ok(Math.abs(measured.least - report.quality.min_dihedral) < 0.01);
    assert.ok(Math.abs(measured.worst - report.quality.radius_ratio_max) < 0.01);
    const text = await page.textContent("#panel");
    for (const part of ["Voxels and mesh", "Options", "Times", "--min-angle"]) assert.ok(text.includes(part), part);
    const times = await page.$$eval(".time span:first-child", (all) => all.map((one) => one.textContent));
    const names = report.stages.map(({ name }) => name);
    assert.deepEqual(times.toSorted(), names.toSorted());
    for (const { name, part_of: whole } of report.stages)
        if (whole) assert.ok(times.indexOf(whole) < times.indexOf(name), `${times}`);
    const angles = await page.$$eval(".worst td:nth-child(3)", (all) => all.map((one) => one.textContent));
    assert.ok(angles.length > 10 && angles.every((text) => /^\d+\.\d° to \d+\.\d°$/.test(text)), `${angles}`);
    await closed(page);
});

test("the worst ones can be flown to, and others picked", async () => {
    const page = await opened(about.page);
    const first = page.locator("#panel td button").first();
    const number = await first.textContent();
    assert.ok(await changes(page, () => first.click()));
    const card = await page.textContent(".card");
    assert.ok(
        card.includes(`Tetrahedron ${number}`) && card.includes("Dihedral angles") && card.includes("Centre"),
        card,
    );
    assert.equal(await page.locator("tr.chosen").count(), 1);
    assert.ok(
        (await changes(page, () => page.check("#marks"))) || (await page.locator("svg.marks circle").count()) > 5,
    );
    await page.click(".card .close");
    assert.ok(await page.isHidden(".card"));
    await page.click("#reset");
    await drawn(page);
    await page.mouse.click(300, 330);
    assert.match(await page.textContent(".card"), /Tetrahedron [\d,]+.*Material[37] /);
    await closed(page);
});

test("dark, printed and narrow", async () => {
    const page = await opened(about.page, { colorScheme: "dark" });
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const dark = await paper();
    const light = async () => (await paper()) !== dark;
    const seen = [];
    for (let step = 0; step < 3; ++step) {
        await page.click("#theme");
        seen.push([await page.textContent("#theme"), await light()]);
    }
    assert.deepEqual(seen, [
        ["Theme: light", true],
        ["Theme: dark", false],
        ["Theme: system", false],
    ]);
    await page.emulateMedia({ colorScheme: "light" });
    await page.waitForFunction(() => document.documentElement.dataset.theme === "light");
    await page.setViewportSize({ width: 390, height: 800 });
    assert.ok((await pictureOf(page)).colours > 20);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.emulateMedia({ media: "print" });
    assert.ok(await page.isHidden("header .bar"));
    // No heading without what it is above.
    const closedOnes = page.locator("details:not([open])");
    assert.ok((await closedOnes.count()) > 2);
    for (const section of await closedOnes.all()) assert.ok(await section.isHidden());
    assert.ok((await page.pdf()).length > 10000);
    await closed(page);
});

test("a part of a mesh is told to be one", async () => {
    const page = await opened(about.part);
    const tets = report.mesh.tets.toLocaleString("en-US");
    assert.match(
        await page.textContent("#notices"),
        new RegExp(`has ${tets} tetrahedra. The picture has \\d+ of them`),
    );
    assert.ok((await pictureOf(page)).colours > 20);
    const counts = await page.$$eval(".histogram .bar", (bars) => bars.map((bar) => Number(bar.dataset.count)));
    assert.deepEqual(counts, report.quality.dihedral_histogram);
    await page.keyboard.press("w");
    assert.ok(await page.isVisible(".card"));
    await closed(page);
});

test("a box of nanometres in metres is drawn as others are", async () => {
    const page = await opened(about.small);
    assert.ok((await pictureOf(page)).colours > 20);
    for (const by of ["angle", "size"]) assert.ok(await changes(page, () => page.selectOption("#by-choice", by)), by);
    await page.keyboard.press("Escape");
    await drawn(page);
    await page.mouse.click(300, 330);
    assert.match(await page.textContent(".card"), /Centre.*e-9/);
    await closed(page);
});

test("a report that is none leaves the rest", async () => {
    const text = await readFile(about.page, "utf8");
    const reports = ["{", "[]", '{"labels":5,"stages":[1],"options":"x","warnings":{}}', "7"];
    for (const bad of reports) {
        const edited = text.replace(/(id="report-0">)[^<]*/, (_, start) => start + bad);
        const page = await opened(about.page, {}, () => edited);
        assert.ok((await pictureOf(page)).colours > 20, bad);
        await closed(page);
    }
});

test("names in the table of voxels have room", async () => {
    const text = await readFile(about.page, "utf8");
    const edited = text.replace(/(id="report-0">)([^<]*)/, (_, start, json) => {
        const named = JSON.parse(json);
        for (const row of named.labels) row.name = "Cingulum_Post_L";
        return start + JSON.stringify(named);
    });
    const page = await opened(about.page, {}, () => edited);
    await page.locator("summary", { hasText: "Voxels and mesh" }).click();
    const cells = page.locator("td.text", { hasText: "Cingulum_Post_L" });
    assert.equal(await cells.count(), report.labels.length);
    const lines = await cells.evaluateAll((all) => all.map((cell) => cell.clientHeight / 20));
    assert.ok(Math.max(...lines) < 2, `${lines}`);
    await closed(page);
});

test("the report of another mesh is not shown, and warnings are above all", async () => {
    const text = await readFile(about.page, "utf8");
    const edited = (from, to) => () => {
        assert.ok(text.includes(from));
        return text.replace(from, to);
    };
    const { tets } = report.mesh;
    const other = await opened(about.page, {}, edited(`"tets": ${tets}`, `"tets": ${tets + 1}`));
    assert.match(await other.textContent("#notices"), /The report is of another mesh, which has [\d,]+ tetrahedra/);
    assert.doesNotMatch(await other.textContent("#panel"), /Voxels and mesh/);
    await closed(other);
    const warnings = ["There is doubt.", "A long sentence on labels that are too thin (--size-min, --label-size)"];
    const page = await opened(
        about.page,
        {},
        edited('"warnings": []', `"warnings": ${JSON.stringify(warnings)}`),
    );
    assert.match(await page.textContent("#panel details >> nth=0"), /Warnings.*There is doubt\..*--label-size\)/);
    assert.deepEqual(await page.locator(".hint .option").allTextContents(), ["--size-min", "--label-size"]);
    await closed(page);
});

test("a picture that is saved says what its colours mean", async () => {
    const page = await opened(about.page);
    await page.uncheck("#edges");
    const saved = async () => {
        const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
        const bytes = [...(await readFile(await download.path()))];
        return page.evaluate(async (bytes) => {
            const picture = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
            const canvas = new OffscreenCanvas(picture.width, picture.height);
            const context = canvas.getContext("2d");
            context.drawImage(picture, 0, 0);
            const corner = context.getImageData(0, picture.height - 60, 280, 60).data;
            return new Set(new Uint32Array(corner.buffer)).size;
        }, bytes);
    };
    assert.equal(await saved(), 1);
    await page.selectOption("#by-choice", "angle");
    await drawn(page);
    assert.ok((await saved()) > 50);
    await closed(page);
});
