// Draws packings of spheres and clusters with WebGL2. One context, out of sight, serves all pictures: each is copied into its own
// canvas, where it can be printed and read like any other figure.
import { channels, HEAT_STOPS } from "../theme";
import { PER_ARM } from "../clusters";
import { fineLine, outline } from "./box";
import { PER_CONTACT, PER_GRAIN, type Scene } from "./scene";
import { ROD_FRAGMENT, ROD_VERTEX, SPHERE_FRAGMENT, SPHERE_VERTEX } from "./shaders";
import { lensOf, type Look, type View } from "./view";

/** Radius of a grain where forces are drawn too, in units of its own. */
export const SHRINK = 0.36;
/** And of an arm of a cluster: its skeleton. */
export const SHRINK_ARM = 0.3;

interface Buffers {
  spheres: WebGLVertexArrayObject;
  rods: WebGLVertexArrayObject;
  box: WebGLVertexArrayObject;
  /** lines in `box` */
  edges: number;
  arms: WebGLVertexArrayObject | null;
}

class Renderer {
  private readonly gl: WebGL2RenderingContext;
  private readonly sphere: WebGLProgram;
  private readonly rod: WebGLProgram;
  private readonly corners: WebGLBuffer;
  private readonly known = new WeakMap<Scene, Buffers>();

  constructor(private readonly canvas: HTMLCanvasElement) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!gl) throw new Error("no WebGL2");
    this.gl = gl;
    this.sphere = this.program(SPHERE_VERTEX, SPHERE_FRAGMENT);
    this.rod = this.program(ROD_VERTEX, ROD_FRAGMENT);
    this.corners = this.buffer(new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]));
  }

  get lost(): boolean {
    return this.gl.isContextLost();
  }

  /** False when the graphics card took too large a picture or lost it. */
  draw(target: CanvasRenderingContext2D, scene: Scene, view: View, look: Look): void {
    const { gl, canvas } = this;
    const { width, height } = target.canvas;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    gl.viewport(0, 0, width, height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const buffers = this.buffersOf(scene);

    this.use(this.rod, scene, view, look);
    gl.bindVertexArray(buffers.box);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, buffers.edges);
    if (look.what !== "grains") {
      gl.bindVertexArray(buffers.rods);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, scene.contacts.length / PER_CONTACT);
    }
    if (look.what !== "forces" && buffers.arms) {
      gl.uniform1f(gl.getUniformLocation(this.rod, "body"), 1);
      gl.bindVertexArray(buffers.arms);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, scene.arms.length / PER_ARM);
    } else if (look.what !== "forces") {
      this.use(this.sphere, scene, view, look);
      gl.bindVertexArray(buffers.spheres);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, scene.grains.length / PER_GRAIN);
    }
    gl.bindVertexArray(null);
    target.drawImage(canvas, 0, 0);
  }

  private use(program: WebGLProgram, scene: Scene, view: View, look: Look): void {
    const { gl } = this;
    const lens = lensOf(scene, view, look);
    const at = (name: string) => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    gl.uniformMatrix3fv(at("turn"), true, view.rotation);
    const { width, height } = this.canvas;
    const side = Math.max(width, height);
    gl.uniform1f(at("eye"), lens.eye);
    gl.uniform2f(at("scale"), (lens.scale * side) / width, (lens.scale * side) / height);
    gl.uniform1f(at("shrink"), look.what !== "both" ? 1 : program === this.sphere ? SHRINK : SHRINK_ARM);
    gl.uniform1f(at("plain"), look.what === "both" ? 1 : 0);
    gl.uniform1f(at("body"), 0);
    gl.uniform1f(at("unit"), scene.unit);
    gl.uniform1f(at("fine"), fineLine(scene));
    gl.uniform1f(at("front"), lens.front);
    gl.uniform1f(at("reach"), scene.reach);
    gl.uniform1f(at("least"), look.least);
    const ramp = scene.tint ? HEAT_STOPS.map(() => channels(scene.tint!)) : HEAT_STOPS;
    gl.uniform3fv(at("ramp"), ramp.flat().map((c) => c / 255));
  }

  private buffersOf(scene: Scene): Buffers {
    let buffers = this.known.get(scene);
    if (!buffers) {
      const edges = outlineRods(scene);
      const rods: [string, number, number][] = [["start", 3, 0], ["end", 3, 3], ["strength", 1, 6]];
      buffers = {
        spheres: this.instances(this.sphere, [
          { data: scene.grains, stride: PER_GRAIN, parts: [["grain", 4, 0]] },
          { data: scene.strongest, stride: 1, parts: [["strongest", 1, 0]] },
        ]),
        rods: this.instances(this.rod, [{ data: scene.contacts, stride: PER_CONTACT, parts: rods }]),
        box: this.instances(this.rod, [{ data: edges, stride: PER_CONTACT, parts: rods }]),
        edges: edges.length / PER_CONTACT,
        arms: scene.arms.length
          ? this.instances(this.rod, [
              {
                data: scene.arms,
                stride: PER_ARM,
                parts: [["start", 3, 0], ["end", 3, 3], ["thick", 1, 6], ["strength", 1, 7]],
              },
            ])
          : null,
      };
      this.known.set(scene, buffers);
    }
    return buffers;
  }

  private instances(
    program: WebGLProgram,
    sources: { data: Float32Array; stride: number; parts: [string, number, number][] }[],
  ): WebGLVertexArrayObject {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const attribute = (name: string, size: number, stride: number, offset: number, every: number) => {
      const place = gl.getAttribLocation(program, name);
      if (place < 0) return;
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 4 * stride, 4 * offset);
      gl.vertexAttribDivisor(place, every);
    };
    gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
    attribute("corner", 2, 2, 0, 0);
    for (const { data, stride, parts } of sources) {
      this.buffer(data);
      for (const [name, size, offset] of parts) attribute(name, size, stride, offset, 1);
    }
    gl.bindVertexArray(null);
    return array;
  }

  /** Left bound. */
  private buffer(data: Float32Array): WebGLBuffer {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    return buffer;
  }

  private program(vertex: string, fragment: string): WebGLProgram {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`shader: ${gl.getProgramInfoLog(program)}`);
    return program;
  }
}

/** The outline as rods of no force. */
function outlineRods(scene: Scene): Float32Array {
  const tone = scene.cylinder ? -2 : -1; // before and behind the grains: light
  return new Float32Array(outline(scene).flatMap(([a, b]) => [...a, ...b, tone]));
}

let renderer: Renderer | null | undefined;

/** False where there is no WebGL2 (then plain.ts draws). */
export function drawWithGl(
  target: CanvasRenderingContext2D,
  scene: Scene,
  view: View,
  look: Look,
): boolean {
  if (renderer === undefined) {
    try {
      renderer = new Renderer(document.createElement("canvas"));
    } catch (problem) {
      if ((problem as Error).message !== "no WebGL2") console.warn((problem as Error).message);
      renderer = null;
    }
  }
  if (!renderer || renderer.lost) return false;
  renderer.draw(target, scene, view, look);
  return true;
}
