// The buttons above the picture.

const kThemes = ["", "light", "dark"];

function savePicture(page) {
    const { canvas, mesh } = page.views[0];
    page.draw(performance.now());
    canvas.toBlob((blob) => {
        const link = make("a", {
            href: URL.createObjectURL(blob),
            download: `${mesh.title.replace(/[^\w.-]+/g, "_")}.png`,
        });
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
