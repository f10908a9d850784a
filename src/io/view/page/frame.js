// Places of the page and of the file. The page has its zero in the middle of the meshes, so that places far from that
// of the file keep their digits. Half of the longest side is about 1 long, as 32 bits have no squares of microns in
// metres.

class Frame {
    constructor(low, high) {
        this.origin = plus(times(0.5, low), times(0.5, high));
        const longest = Math.max(...minus(times(0.5, high), times(0.5, low)));
        // A power of two, which changes no digit.
        this.unit = longest > 0 && longest < Infinity ? 2 ** Math.round(Math.log2(longest)) : 1;
        // As many decimals as tell a ten-thousandth of the longest side.
        this.decimals = longest > 0 ? clamp(Math.ceil(4 - Math.log10(2 * longest)), 0, 12) : 4;
    }

    toPage(place) {
        return times(1 / this.unit, minus(place, this.origin));
    }

    toFile(place) {
        return plus(times(this.unit, place), this.origin);
    }

    // A coordinate of the file.
    text(coordinate) {
        if (Math.abs(coordinate) >= 1e12 || this.decimals === 12) return coordinate.toExponential(6);
        return coordinate.toLocaleString("en-US", { maximumFractionDigits: this.decimals });
    }
}
