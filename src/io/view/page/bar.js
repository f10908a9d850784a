// The buttons above the picture.

// Two meshes side by side, as the page has them, with what the colours mean.
function savePicture(page) {
    page.draw(performance.now());
    const canvases = page.views.map((view) => view.canvas);
    const whole = make("canvas", {
        width: canvases.reduce((sum, canvas) => sum + canvas.width, 0),
        height: Math.max(...canvases.map((canvas) => canvas.height)),
    });
    const context = whole.getContext("2d");
    let left = 0;
    for (const canvas of canvases) {
        context.drawImage(canvas, left, 0);
        left += canvas.width;
    }
    const scale = page.scales[page.state.by];
    if (scale) drawLegend(scale, context, canvases[0].width / canvases[0].clientWidth);
    const name = page.meshes.map((mesh) => mesh.title.replace(/[^\w.-]+/g, "_")).join("_");
    whole.toBlob((blob) => {
        const link = make("a", { href: URL.createObjectURL(blob), download: `${name}.png` });
        link.click();
        URL.revokeObjectURL(link.href);
    });
}

const kSystemDark = matchMedia("(prefers-color-scheme: dark)");
let chosenTheme = ""; // that of the system

function isDark() {
    return document.documentElement.dataset.theme === "dark";
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
    byId("theme").onclick = nextTheme;
    byId("help").onclick = () => page.toggleKeys();
    showKeys();
}

// The style has one set of dark colours, so the page says which holds.
function useTheme() {
    document.documentElement.dataset.theme = chosenTheme || (kSystemDark.matches ? "dark" : "light");
    byId("theme").textContent = `Theme: ${chosenTheme || "system"}`;
    globalThis.cleftPage?.redraw();
}

// The one that the system has not comes first, so that each step but the last is seen.
function nextTheme() {
    const themes = kSystemDark.matches ? ["", "light", "dark"] : ["", "dark", "light"];
    chosenTheme = themes[(themes.indexOf(chosenTheme) + 1) % 3];
    useTheme();
}

function followSystem() {
    kSystemDark.addEventListener("change", useTheme);
    useTheme();
}
