// One mesh: mouse, touch, keys and buttons reach all of it, and bring it back.
import assert from "node:assert/strict";
import { test } from "node:test";
import { about, changes, closed, drawn, opened, pictureOf, pressed } from "./support.mjs";

test("a cut goes to the chosen one, wherever it was", async () => {
    const page = await opened(about.page);
    const cutHere = page.locator(".card .tools button").first();
    const isKept = () =>
        page.evaluate(() => {
            const plane = cutPlane(cleftPage.state.cut, cleftPage.box);
            return dot(plane.normal, cleftPage.centreOf(cleftPage.state.chosen.tet)) - plane.offset;
        });
    await page.locator("#panel td button").first().click();
    assert.ok(await cutHere.isDisabled()); // flying there took the cut along
    for (const act of [
        () => page.locator("#cut-at").fill("0.9"),
        () => page.selectOption("#cut-choice", "x"),
        () => page.selectOption("#cut-choice", "none"),
        () => page.locator("#cut-flip").click(),
    ]) {
        await act();
        assert.ok(await cutHere.isEnabled());
        await cutHere.click();
        assert.ok(await cutHere.isDisabled());
        const far = await isKept();
        assert.ok(far >= 0 && far < 1e-5, `${far}`);
    }
    await closed(page);
});

test("reset brings back all that the page opened with", async () => {
    const page = await opened(about.page);
    const state = () =>
        page.evaluate(() => JSON.stringify({ ...cleftPage.state, hidden: [...cleftPage.state.hidden] }));
    const [first, picture] = [await state(), (await pictureOf(page)).hash];
    await page.click("#surrounding button");
    assert.ok(await page.isHidden("#surrounding"));
    await page.selectOption("#cut-choice", "z");
    await page.selectOption("#by-choice", "angle");
    await page.check("#interfaces");
    await page.uncheck("#edges");
    await page.check("#marks");
    await page.locator("#panel td button").first().click();
    await page.mouse.wheel(0, -300);
    await page.click("#reset");
    assert.equal((await pictureOf(page)).hash, picture);
    assert.equal(await state(), first);
    assert.ok(await page.isVisible("#surrounding"));
    assert.equal(await page.inputValue("#by-choice"), "material");
    assert.ok(await page.isHidden(".card"));
    await closed(page);
});

test("mouse and wheel turn, move and zoom", async () => {
    const page = await opened(about.page);
    const drag = async (button) => {
        await page.mouse.move(200, 300);
        await page.mouse.down({ button });
        await page.mouse.move(260, 330, { steps: 3 });
        await page.mouse.up({ button });
    };
    assert.ok(await changes(page, () => drag("left")));
    assert.ok(await changes(page, () => drag("right")));
    assert.ok(await changes(page, () => page.mouse.wheel(0, -300)));
    assert.ok(await changes(page, () => page.click("#directions button >> nth=5")));
    assert.equal(await page.getAttribute("#directions button >> nth=5", "aria-pressed"), "true");
    await closed(page);
});

test("a finger turns, two zoom, and a tap picks", async () => {
    const page = await opened(about.page, { hasTouch: true });
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) =>
        session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const move = async (...fingers) => {
        await touch("touchStart", ...fingers.map(([from]) => from));
        await touch("touchMove", ...fingers.map(([, to]) => to));
        await touch("touchEnd");
    };
    assert.ok(
        await changes(page, () =>
            move([
                [200, 300],
                [260, 330],
            ]),
        ),
    );
    const far = await page.evaluate(() => cleftPage.state.camera.distance);
    await move(
        [
            [200, 300],
            [150, 300],
        ],
        [
            [300, 300],
            [350, 300],
        ],
    );
    assert.ok((await page.evaluate(() => cleftPage.state.camera.distance)) < far);
    await page.click("#reset");
    await drawn(page);
    await page.touchscreen.tap(300, 330);
    assert.ok(await page.isVisible(".card"));
    await closed(page);
});

test("keys do what the page says, and Tab reaches every control", async () => {
    const page = await opened(about.page);
    const keys = "ArrowLeft ArrowUp Shift+ArrowLeft + i i x ] c r f [ n e b w".split(" ");
    for (const key of keys) assert.ok(await changes(page, () => pressed(page, key)), key);
    assert.ok(await page.isVisible(".card"));
    await page.keyboard.press("Escape");
    assert.ok(await page.isHidden(".card"));
    await page.keyboard.press("?");
    assert.ok(await page.isVisible("#keys"));
    await page.keyboard.press("Escape");
    assert.ok(await page.isHidden("#keys"));
    const reachable = "button, input, select, summary, canvas.mesh";
    const wanted = await page.$$eval(
        reachable,
        (all) => all.filter((one) => one.checkVisibility() && !one.disabled).length,
    );
    const reached = new Set();
    for (let step = 0; step < wanted + 30; ++step) {
        await page.keyboard.press("Tab");
        const place = await page.evaluate(
            (selector) => [...document.querySelectorAll(selector)].indexOf(document.activeElement),
            reachable,
        );
        if (place >= 0) reached.add(place);
    }
    assert.equal(reached.size, wanted);
    await closed(page);
});

test("letters work wherever the focus is, and controls keep their arrows", async () => {
    const page = await opened(about.page);
    const state = () => page.evaluate(() => ({ yaw: cleftPage.state.camera.yaw, at: cleftPage.state.cut.at }));
    for (const control of ["#edges", "#cut-at", "#by-choice", "#reset", "#panel summary >> nth=0"]) {
        await page.focus(control);
        assert.ok(await changes(page, () => page.keyboard.press("e")), control);
        const { yaw } = await state();
        await page.keyboard.press("ArrowRight");
        assert.equal((await state()).yaw, yaw, control);
        await page.keyboard.press("Home");
        assert.equal((await state()).yaw, yaw, control);
    }
    assert.equal((await state()).at, 0); // by Home on the slider
    await page.fill("#material-search", "");
    const edges = await page.isChecked("#edges");
    await page.keyboard.type("ei");
    assert.equal(await page.inputValue("#material-search"), "ei");
    assert.equal(await page.isChecked("#edges"), edges);
    await closed(page);
});

test("every control has a name", async () => {
    const page = await opened(about.page);
    const nameless = await page.$$eval("button, input, select", (all) =>
        all
            .filter((one) => !(one.textContent || one.ariaLabel || one.labels?.[0]?.textContent))
            .map((one) => one.outerHTML),
    );
    assert.deepEqual(nameless, []);
    await closed(page);
});
