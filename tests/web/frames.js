// Put before the page's own scripts by the test. A browser without a screen makes animation frames when it pleases, and
// under a virtual clock perhaps never: here frames come with the clock, and sizes are looked at in each of them, so that
// what is drawn does not hang on how busy the machine is.
(() => {
  const frame = 16;
  window.requestAnimationFrame = (call) => setTimeout(() => call(performance.now()), frame);
  window.cancelAnimationFrame = clearTimeout;
  window.ResizeObserver = class {
    #watched = new Map();
    #call;
    constructor(call) {
      this.#call = call;
      setInterval(() => this.#look(), 2 * frame);
    }
    #look() {
      const changed = [];
      for (const [target, before] of this.#watched) {
        const style = getComputedStyle(target);
        const room = (a, b) => parseFloat(style[a]) + parseFloat(style[b]);
        const width = Math.max(0, target.clientWidth - room("paddingLeft", "paddingRight"));
        const height = Math.max(0, target.clientHeight - room("paddingTop", "paddingBottom"));
        if (before && before.width === width && before.height === height) continue;
        this.#watched.set(target, { width, height });
        changed.push({ target, contentRect: { width, height } });
      }
      if (changed.length) this.#call(changed, this);
    }
    observe(target) {
      this.#watched.set(target, null);
    }
    unobserve(target) {
      this.#watched.delete(target);
    }
    disconnect() {
      this.#watched.clear();
    }
  };
})();
