// Appended to a copy of the report by the test: waits until the page stands, then writes what it finds into the page as
// one line of JSON, for the test to read from the dumped document.
(() => {
  const problems = [];
  window.addEventListener("error", (event) => problems.push(String(event.message)));
  window.addEventListener("unhandledrejection", (event) => problems.push(String(event.reason)));
  document.addEventListener("securitypolicyviolation", (event) => problems.push(`blocked: ${event.blockedURI}`));

  const colours = (canvas) => {
    const { width, height } = canvas;
    if (!width || !height) return 0;
    const pixels = canvas.getContext("2d").getImageData(0, 0, width, height).data;
    const seen = new Set();
    for (let k = 0; k < pixels.length; k += 4)
      if (pixels[k + 3] > 0) seen.add((pixels[k] << 16) | (pixels[k + 1] << 8) | pixels[k + 2]);
    return seen.size;
  };

  const report = () => {
    const canvases = [...document.querySelectorAll("canvas")].filter((canvas) => canvas.offsetParent !== null);
    const result = {
      ready: document.documentElement.dataset.ready === "true",
      title: document.querySelector("h1")?.textContent ?? "",
      sections: [...document.querySelectorAll("section")].map((section) => section.id),
      figures: document.querySelectorAll("figure").length,
      charts: document.querySelectorAll(".uplot").length,
      heat_maps: document.querySelectorAll(".heat canvas").length,
      spheres: document.querySelectorAll("canvas.turnable").length,
      canvases: canvases.length,
      blank: canvases.filter((canvas) => colours(canvas) < 4).length,
      wider: document.documentElement.scrollWidth > window.innerWidth + 1,
      problems,
    };
    const line = document.createElement("script");
    line.type = "application/json";
    line.id = "probe";
    line.textContent = JSON.stringify(result).replace(/</g, "\\u003c");
    document.body.append(line);
  };

  // Charts draw themselves in animation frames: count until nothing more comes.
  const settle = (drawn, calm) => {
    const now = document.querySelectorAll(".uplot, canvas").length;
    if (now === drawn && calm > 4) report();
    else setTimeout(() => settle(now, now === drawn ? calm + 1 : 0), 200);
  };

  // Clicks through the legend and the packing fractions first: what they redraw must not fail either.
  setTimeout(() => {
    for (const button of document.querySelectorAll(".chip, .choice:not(.play)")) button.click();
    for (const chip of document.querySelectorAll('.chip[aria-pressed="false"]')) chip.click();
    const slider = document.querySelector(".slider input");
    if (slider) {
      slider.value = "0";
      slider.dispatchEvent(new Event("input"));
    }
    for (const input of document.querySelectorAll(".tools input")) {
      input.value = "0.4";
      input.dispatchEvent(new Event("input"));
    }
    const ball = document.querySelector("canvas.turnable");
    ball?.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
    const map = document.querySelector(".heat canvas");
    if (map) {
      const { left, top, width, height } = map.getBoundingClientRect();
      const at = { clientX: left + 0.6 * width, clientY: top + 0.5 * height };
      map.dispatchEvent(new PointerEvent("pointermove", at));
      if (document.querySelector(".heat .tooltip").hidden) problems.push("a map does not read out");
      const cuts = () => document.querySelectorAll("#surfaces figure .rho-key span").length;
      const before = cuts();
      map.click();
      if (cuts() === before) problems.push("a click on a map changes no cut");
    }
    settle(-1, 0);
  }, 600);
})();
