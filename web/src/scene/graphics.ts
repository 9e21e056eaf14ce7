import { WebGLRenderer } from "three";

const Power = "high-performance";
const Software = /swiftshader|llvmpipe|softpipe|software|basic render/i;

export interface Graphics {
  readonly renderer: WebGLRenderer;
  /** True if there is no graphics card that WebGL can use: the processor draws. */
  readonly isSoftware: boolean;
}

/** Creates a canvas with its renderer. Edges are smooth only where a graphics card draws them. */
export function createGraphics(): Graphics {
  // Whether edges are smooth cannot be changed later. The first canvas tells who draws, and stays if that is the processor.
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2", { alpha: false, antialias: false, powerPreference: Power });
  if (context && isDrawnBySoftware(context))
    return { renderer: new WebGLRenderer({ canvas, context }), isSoftware: true };

  return { renderer: new WebGLRenderer({ alpha: false, antialias: true, powerPreference: Power }), isSoftware: false };
}

/** Whether the name of a renderer is that of a program. */
export function isSoftwareName(name: string): boolean {
  return Software.test(name);
}

function isDrawnBySoftware(gl: WebGL2RenderingContext): boolean {
  // Firefox warns of the extension, and does not need it.
  const name = String(gl.getParameter(gl.RENDERER));
  const details = name === "WebKit WebGL" ? gl.getExtension("WEBGL_debug_renderer_info") : null;
  return isSoftwareName(details ? String(gl.getParameter(details.UNMASKED_RENDERER_WEBGL)) : name);
}
