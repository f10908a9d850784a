// Names are texts: none of them runs, and none changes the page. Ten thousand labels are no trouble.
import assert from "node:assert/strict";
import { test } from "node:test";
import { about, changes, closed, opened, pictureOf } from "./support.mjs";

test("names are shown as they are", async () => {
    const page = await opened(about.page);
    assert.equal(await page.title(), "<b>&.vtk");
    assert.equal(await page.textContent("#title"), "<b>&.vtk");
    const shown = await page.$$eval(".label-name", (all) => all.map((one) => one.textContent));
    assert.equal(shown.length, about.labels);
    assert.deepEqual(shown.slice(0, about.names.length), about.names);
    assert.equal(await page.locator("script").count(), 1);
    assert.equal(await page.locator("main img, main b, main script").count(), 0);
    await closed(page);
});

test("ten thousand labels can be searched, hidden and shown", async () => {
    const page = await opened(about.page);
    assert.ok((await pictureOf(page)).colours > 20);
    await page.fill("#material-search", "<img");
    assert.equal(await page.locator(".material:visible").count(), 1);
    await page.fill("#material-search", "");
    assert.ok(await changes(page, () => page.click("#hide-all")));
    assert.equal((await pictureOf(page)).colours, 1);
    assert.ok(await changes(page, () => page.click("#show-all")));
    await page.keyboard.press("w");
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("w");
    assert.ok(await page.isVisible(".card"));
    await closed(page);
});

test("a script that gets in all the same does not run", async () => {
    const page = await opened(about.page);
    const ran = await page.evaluate(() => {
        const script = document.createElement("script");
        script.textContent = "globalThis.wasRun = true";
        document.body.append(script);
        return globalThis.wasRun === true;
    });
    assert.equal(ran, false);
    page.complaints.length = 0; // the browser told of it
    await closed(page);
});
