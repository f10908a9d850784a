// How a page opens: all of the mesh is in the picture, and what would cover the rest is hidden and told.
import assert from "node:assert/strict";
import { test } from "node:test";
import { about, closed, opened, trianglesOf } from "./support.mjs";

// How far out in the picture the outermost point that is shown lies: 1 is the edge.
function farthest(page) {
    return page.evaluate(() => {
        const { state, views } = cleftPage;
        let most = 0;
        for (const view of views) {
            const { mesh } = view;
            for (let t = 0; t < mesh.tetCount; ++t) {
                if (state.hidden.has(mesh.labels[mesh.materials[t]].label)) continue;
                for (const corner of cleftPage.cornersOf(mesh, t))
                    most = Math.max(most, ...cleftPage.projected(state.camera, view.aspect(), corner).map(Math.abs));
            }
        }
        return most;
    });
}

const hidden = (page) => page.evaluate(() => [...cleftPage.state.hidden]);

test("a long mesh fits the picture, from every side", async () => {
    for (const file of about.long)
        for (const viewport of [
            { width: 1200, height: 700 },
            { width: 390, height: 800 },
        ]) {
            const page = await opened(file, { viewport });
            const fits = async (from) => {
                const far = await farthest(page);
                assert.ok(far > 0.8 && far < 0.95, `${file} ${from}: ${far}`);
            };
            await fits("at first");
            for (const button of await page.locator("#directions button").all()) {
                await button.click();
                await fits(await button.textContent());
            }
            await page.mouse.wheel(0, -300);
            await page.click("#reset");
            await fits("after reset");
            await page.setViewportSize({ width: viewport.height, height: viewport.width });
            await fits("in a window of another shape");
            await closed(page);
        }
});

test("who looks closer keeps the distance", async () => {
    const page = await opened(about.long[0]);
    const distance = () => page.evaluate(() => cleftPage.state.camera.distance);
    await page.locator("canvas.mesh").focus();
    for (let times = 0; times < 5; ++times) await page.keyboard.press("+");
    const near = await distance();
    await page.locator("#directions button").first().click();
    assert.equal(await distance(), near);
    await page.setViewportSize({ width: 600, height: 900 });
    assert.equal(await distance(), near);
    await closed(page);
});

test("a background that leaves a side of the box is hidden, too", async () => {
    const page = await opened(about.standing);
    assert.deepEqual(await hidden(page), [0]);
    assert.match(await page.textContent("#surrounding"), /^Label 0 has most of the sides of the box .*It is hidden/);
    await page.click("#surrounding button");
    assert.deepEqual(await hidden(page), []);
    assert.ok(await page.isHidden("#surrounding"));
    await closed(page);
});

test("other labels at the sides are shown", async () => {
    const page = await opened(about.halves);
    assert.deepEqual(await hidden(page), []);
    assert.equal(await page.locator("#surrounding").count(), 0);
    await closed(page);
});

test("it is hidden beside a mesh without it", async () => {
    const page = await opened(about.stripped);
    assert.deepEqual(await hidden(page), [0]);
    assert.ok(await page.isVisible("#surrounding"));
    await closed(page);
});

test("meshes in different places are both seen, and told", async () => {
    const page = await opened(about.apart);
    assert.match(await page.textContent("#notices"), /'standing.vtu' and 'far.vtu' lie in different places/);
    assert.ok((await trianglesOf(page)).every((count) => count > 0));
    await page.click("#reset");
    assert.ok((await trianglesOf(page)).every((count) => count > 0));
    await closed(page);
});

test("sizes that differ by rounding have one colour", async () => {
    const page = await opened(about.uniform);
    await page.uncheck("#edges");
    await page.selectOption("#by-choice", "size");
    assert.match(await page.textContent(".legend"), /all tetrahedra have one size/);
    assert.equal(await page.evaluate(() => new Set(cleftPage.views[0].coloursNow).size), 1);
    await closed(page);
});
