// What the colours of a measure mean.

function makeLegend() {
    const root = make("div.legend", { hidden: true });
    return {
        root,
        show(scale) {
            root.hidden = !scale;
            if (!scale) return;
            const ramp = make("div.ramp");
            ramp.style.background = `linear-gradient(90deg, ${scale.ramp.map(cssColour).join(", ")})`;
            root.replaceChildren(
                make("div", {}, scale.title),
                ramp,
                make("div.ticks", {}, ...scale.ticks.map((tick) => make("span", {}, short(tick)))),
            );
        },
    };
}
