// How soon a page is there, and how many frames a second it draws while it turns: for benchmarks/view_speed.py.
import { writeFile } from "node:fs/promises";
import { test } from "node:test";
import { about, closed, opened, trianglesOf } from "./support.mjs";

const kSeconds = 4;
const kFirst = 1.5; // seconds in which the page finds out how many pixels it can draw

function framesPerSecond(page) {
    return page.evaluate(
        async ({ kSeconds, kFirst }) => {
            const begin = performance.now();
            const passed = () => (performance.now() - begin) / 1000;
            let frames = 0;
            while (passed() < kSeconds) {
                cleftPage.state.camera.yaw += 0.02;
                cleftPage.moving();
                await new Promise(requestAnimationFrame);
                if (passed() > kFirst) ++frames;
            }
            return frames / (kSeconds - kFirst);
        },
        { kSeconds, kFirst },
    );
}

test("speed", async () => {
    const [width, height] = about.size;
    const page = await opened(about.page, { viewport: { width, height } });
    const ready = await page.evaluate(() => Number(document.documentElement.dataset.ready));
    const turning = [];
    const turn = async (what) =>
        turning.push({ what, triangles: (await trianglesOf(page))[0], rate: await framesPerSecond(page) });
    await turn("as it opens");
    await page.selectOption("#cut-choice", "none");
    await turn("without a cut");
    await page.check("#interfaces");
    await turn("interfaces alone");
    await writeFile(about.result, JSON.stringify({ ready, turning }));
    await closed(page);
});
