// What the scripts share: a page in the browser, and what its pictures look like.
import assert from "node:assert/strict";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const about = JSON.parse(process.env.ABOUT);
const kPatience = 240000; // milliseconds until a page is taken to hang, on a machine that does much else
const kSoftware = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const kRoot = process.getuid() === 0 ? ["--no-sandbox"] : [];

let browser;
before(async () => {
    browser = await chromium.launch({
        executablePath: process.env.CHROMIUM,
        args: [...kSoftware, ...kRoot],
        timeout: kPatience,
    });
});
after(() => browser?.close());

// A page that is ready. What it complains of or asks the network for is in `complaints`.
export async function opened(file, options = {}, edit = null) {
    const context = await browser.newContext({
        viewport: { width: 900, height: 600 },
        reducedMotion: "reduce",
        ...options,
    });
    const page = await context.newPage();
    page.setDefaultTimeout(kPatience);
    page.complaints = [];
    page.on("console", (message) => page.complaints.push(message.text()));
    page.on("pageerror", (error) => page.complaints.push(error.message));
    page.on("dialog", (dialog) => page.complaints.push(dialog.message()) && dialog.dismiss());
    const url = pathToFileURL(file).href;
    page.on(
        "request",
        (request) =>
            /^(blob:|data:)/.test(request.url()) || request.url() === url || page.complaints.push(request.url()),
    );
    if (edit) await page.route(url, async (route) => route.fulfill({ contentType: "text/html", body: await edit() }));
    await page.goto(url);
    await page.waitForFunction(() => document.documentElement.dataset.ready);
    askWhenDrawn(page);
    return page;
}

// Until the page has drawn all that was asked of it: it does what an action asks for in the frames after it. Something
// that was asked for in a frame takes the next one.
export async function drawn(page) {
    await page.mainFrame().evaluate(async () => {
        for (let frame = 0; frame < 3 || cleftPage.pending || cleftPage.nextDraw; ++frame)
            await new Promise(requestAnimationFrame);
    });
}

const kQuestions = [
    ...["$$eval", "evaluate", "evaluateAll", "count", "title", "getAttribute", "inputValue"],
    ...["textContent", "allTextContents", "isVisible", "isHidden", "isEnabled", "isDisabled", "isChecked"],
];

// Makes all questions to a page wait until it has drawn. No script can forget it so.
function askWhenDrawn(page) {
    for (const prototype of [page, page.locator("body")].map(Object.getPrototypeOf))
        for (const name of kQuestions.filter((name) => prototype[name] && !prototype[name].waits)) {
            const ask = prototype[name];
            prototype[name] = async function (...values) {
                await drawn(this.page?.() ?? this);
                return ask.apply(this, values);
            };
            prototype[name].waits = true;
        }
}

export async function closed(page) {
    assert.deepEqual(page.complaints, []);
    await page.context().close();
}

// The bytes of the picture as one number, and how many colours it has.
export function pictureOf(page, number = 0) {
    return page.evaluate((number) => {
        cleftPage.isMoving = false;
        cleftPage.draw(performance.now());
        const { canvas } = cleftPage.views[number];
        const copy = document.createElement("canvas");
        [copy.width, copy.height] = [canvas.width, canvas.height];
        const context = copy.getContext("2d");
        context.drawImage(canvas, 0, 0);
        const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
        let hash = 0;
        for (const pixel of pixels) hash = (Math.imul(hash, 31) + pixel) | 0;
        return { hash, colours: new Set(pixels).size };
    }, number);
}

// What an action does to the picture.
export async function changes(page, action, number = 0) {
    const { hash } = await pictureOf(page, number);
    await action();
    return (await pictureOf(page, number)).hash !== hash;
}

// How many triangles are drawn.
export function trianglesOf(page) {
    return page.evaluate(() => cleftPage.views.map((view) => view.surface.triangles + view.slice.triangles));
}

// A cut that moves by a hundredth may meet the same large tetrahedra.
export async function pressed(page, key) {
    for (let times = "[]".includes(key) ? 15 : 1; times > 0; --times) await page.keyboard.press(key);
}
