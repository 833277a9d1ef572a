// One map of a quantity over two abscissae, with a read-out under the pointer.
import { h, markup } from "../dom";
import { plain, withError } from "../numbers";
import { HEIGHT, Panel, type Cut, type HeatMap } from "./panel";

export function heatMap(map: HeatMap): { element: HTMLElement; show: (cut: Cut) => void } {
  const panel = new Panel(map);
  const canvas = h("canvas");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `map of ${map.title.replace(/<[^>]*>/g, "")}`);
  const box = h("div", "tooltip");
  box.hidden = true;
  const plot = h("div", "plot", canvas, box);
  let pointed: [number, number] | null = null;

  const point = (cell: [number, number] | null) => {
    if (String(cell) === String(pointed)) return;
    pointed = cell;
    panel.draw(canvas, cell);
    box.hidden = cell === null;
    if (!cell) return map.pointed(null);
    const [i, j] = cell;
    const value = map.mean[i * map.y.length + j];
    map.pointed(value);
    const count = map.unrelaxed?.[i];
    box.innerHTML =
      `<b>${map.xName} = ${plain(map.x[i])}, ${map.yName} = ${plain(map.y[j], 3)}</b><br>` +
      (value === null ? "no value" : withError(value, map.se[i * map.y.length + j])) +
      (count ? `<br><span class="what">${count} not relaxed</span>` : "");
    const right = panel.px(map.x[i]) > panel.width / 2;
    box.style.left = right ? "" : `${panel.px(map.x[i]) + 16}px`;
    box.style.right = right ? `${panel.width - panel.px(map.x[i]) + 16}px` : "";
    box.style.top = `${Math.min(Math.max(panel.py(map.y[j]) - 24, 4), HEIGHT - 80)}px`;
  };
  canvas.addEventListener("pointermove", (event) => {
    const at = canvas.getBoundingClientRect();
    point(panel.cellAt(event.clientX - at.left, event.clientY - at.top));
  });
  canvas.addEventListener("click", () => {
    if (pointed) map.clicked(map.x[pointed[0]], map.y[pointed[1]]);
  });
  canvas.addEventListener("pointerleave", () => point(null));

  new ResizeObserver(([entry]) => {
    const width = Math.floor(entry.contentRect.width);
    if (width < 60 || width === panel.width) return;
    panel.width = width;
    requestAnimationFrame(() => panel.draw(canvas, pointed));
  }).observe(plot);
  const element = h(
    "div",
    "heat",
    markup(map.title, "div", "chart-title"),
    h("div", "heat-body", markup(map.yLabel, "div", "heat-y"), plot),
    markup(map.xLabel, "div", "chart-x"),
  );
  return {
    element,
    show(cut) {
      panel.cut = cut;
      if (panel.width) panel.draw(canvas, pointed);
    },
  };
}
