// The buttons above the picture.

const kThemes = ["", "light", "dark"];

// Two meshes side by side, as the page has them.
function savePicture(page) {
    page.draw(performance.now());
    const canvases = page.views.map((view) => view.canvas);
    const whole = make("canvas", {
        width: canvases.reduce((sum, canvas) => sum + canvas.width, 0),
        height: Math.max(...canvases.map((canvas) => canvas.height)),
    });
    let left = 0;
    for (const canvas of canvases) {
        whole.getContext("2d").drawImage(canvas, left, 0);
        left += canvas.width;
    }
    const name = page.meshes.map((mesh) => mesh.title.replace(/[^\w.-]+/g, "_")).join("_");
    whole.toBlob((blob) => {
        const link = make("a", { href: URL.createObjectURL(blob), download: `${name}.png` });
        link.click();
        URL.revokeObjectURL(link.href);
    });
}

function isDark() {
    const chosen = document.documentElement.dataset.theme;
    return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

function addBar(page) {
    for (const [name, { yaw, pitch }] of Object.entries(kDirections)) {
        const button = make(
            "button",
            { type: "button", title: `Look from ${name}`, onclick: () => page.lookAlong(yaw, pitch) },
            name.replace("-", "−"),
        );
        button.dataset.name = name;
        byId("directions").append(button);
    }
    byId("reset").onclick = () => page.reset();
    byId("save").onclick = () => savePicture(page);
    byId("theme").onclick = () => setTheme(isDark() ? "light" : "dark");
    byId("help").onclick = () => page.toggleKeys();
    showKeys();
}

// The style has one set of dark colours, so the page says which holds.
function setTheme(name) {
    document.documentElement.dataset.theme = name;
    globalThis.cleftPage?.redraw();
}

function followSystem() {
    const dark = matchMedia("(prefers-color-scheme: dark)");
    const follow = () => setTheme(dark.matches ? "dark" : "light");
    dark.addEventListener("change", follow);
    follow();
}
