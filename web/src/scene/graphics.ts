import { WebGLRenderer } from "three";

const Software = /swiftshader|llvmpipe|softpipe|software|basic render/i;

export interface Graphics {
  readonly renderer: WebGLRenderer;
  /** True if there is no graphics card that WebGL can use: the processor draws. */
  readonly isSoftware: boolean;
}

/** Creates a canvas with its renderer. Edges are smooth only where a graphics card draws them. */
export function createGraphics(): Graphics {
  const isSoftware = isDrawnBySoftware();
  return { renderer: new WebGLRenderer({ alpha: false, antialias: !isSoftware, powerPreference: "high-performance" }), isSoftware };
}

/** Whether the name of a renderer is that of a program. */
export function isSoftwareName(name: string): boolean {
  return Software.test(name);
}

// Whether edges are smooth cannot be changed later, so another canvas answers first.
function isDrawnBySoftware(): boolean {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext("webgl2");
  if (!gl)
    return false;

  // Firefox warns of the extension, and does not need it.
  const name = String(gl.getParameter(gl.RENDERER));
  const details = name === "WebKit WebGL" ? gl.getExtension("WEBGL_debug_renderer_info") : null;
  return isSoftwareName(details ? String(gl.getParameter(details.UNMASKED_RENDERER_WEBGL)) : name);
}
