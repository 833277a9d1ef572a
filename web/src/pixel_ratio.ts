// Canvases are drawn at twice the screen's resolution at least, so that prints and zoomed pages stay sharp. uPlot reads
// this value instead of devicePixelRatio (a define in the build command), so this module must be imported first.
declare global {
  var chartPixelRatio: number;
}

globalThis.chartPixelRatio = Math.max(2, window.devicePixelRatio || 1);

export const pixelRatio = globalThis.chartPixelRatio;
