// Two meshes: one camera and one cut for both, and their histograms over each other.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { about, changes, closed, opened, pictureOf, pressed } from "./support.mjs";

test("both are there and move together", async () => {
    const page = await opened(about.page);
    assert.equal(await page.locator("canvas.mesh").count(), 2);
    assert.match(await page.textContent("#title"), /coarse\.vtu.*fine\.vtu/);
    const pictures = [await pictureOf(page, 0), await pictureOf(page, 1)];
    assert.ok(pictures.every(({ colours }) => colours > 20));
    assert.notEqual(pictures[0].hash, pictures[1].hash);
    for (const number of [0, 1]) {
        await page.locator("canvas.mesh").nth(number).focus();
        assert.ok(await changes(page, () => pressed(page, "ArrowLeft"), number));
        assert.ok(await changes(page, () => pressed(page, number ? "[" : "]"), number));
        assert.ok(await changes(page, () => page.locator(".material input").last().click(), number));
    }
    await closed(page);
});

test("histograms, worst tetrahedra and figures are of both", async () => {
    const page = await opened(about.page);
    assert.equal(await page.locator(".histogram .other").count(), 1);
    const tables = page.locator("#panel table");
    assert.equal(await tables.count(), 2);
    await tables.nth(1).locator("button").first().click();
    assert.ok(await page.locator(".view").nth(1).locator(".card").isVisible());
    assert.ok(await page.locator(".view").nth(0).locator(".card").isHidden());
    assert.match(await page.textContent(".material >> nth=0"), /\|/);
    await closed(page);
});

test("the picture that is saved has both", async () => {
    const page = await opened(about.page);
    const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
    assert.match(download.suggestedFilename(), /coarse.*fine.*\.png$/);
    const widths = await page.locator("canvas.mesh").evaluateAll((all) => all.map((canvas) => canvas.width));
    const png = await readFile(await download.path());
    assert.equal(png.readUInt32BE(16), widths[0] + widths[1]);
    await closed(page);
});
