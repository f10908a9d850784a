// What the colours of a measure mean.

function makeLegend() {
    const root = make("div.legend", { hidden: true });
    return {
        root,
        show(scale) {
            root.hidden = !scale;
            if (!scale) return;
            const stops = Array.from({ length: 9 }, (_, i) => {
                const value = scaleValue(scale, i / 8);
                return cssColour(viridis(clamp(scale.share(value), 0, 1)));
            });
            const ramp = make("div.ramp");
            ramp.style.background = `linear-gradient(90deg, ${stops.join(", ")})`;
            root.replaceChildren(
                make("div", {}, scale.title),
                ramp,
                make("div.ticks", {}, ...scale.ticks.map((tick) => make("span", {}, short(tick)))),
            );
        },
    };
}

// The value at a place of the legend, from left to right. Sizes are on a logarithmic scale.
function scaleValue(scale, at) {
    const isLogarithmic = scale.title.startsWith("Size");
    return isLogarithmic ? scale.low * (scale.high / scale.low) ** at : scale.low + at * (scale.high - scale.low);
}
