import type { CameraRig } from "./cameraRig";

const TurnPerPicture = Math.PI * 1.1;

/** Mouse, touch and wheel on the canvas: one finger turns, two move and zoom. */
export function connectPointer(canvas: HTMLElement, rig: CameraRig, isMirrored: () => boolean, onTurn: () => void): void {
  const fingers = new Map<number, { x: number; y: number }>();

  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const)
    canvas.addEventListener(end, event => fingers.delete(event.pointerId));

  canvas.addEventListener("pointermove", event => {
    const finger = fingers.get(event.pointerId);
    if (!finger)
      return;

    const spread = spreadOf(fingers);
    const height = canvas.clientHeight;
    const x = (event.clientX - finger.x) / height * (isMirrored() ? -1 : 1);
    const y = (event.clientY - finger.y) / height;
    finger.x = event.clientX;
    finger.y = event.clientY;
    if (fingers.size >= 2) {
      rig.pan(-x / fingers.size, y / fingers.size);
      const after = spreadOf(fingers);
      if (spread > 0 && after > 0)
        rig.zoom(spread / after);
    } else if (event.buttons > 1 || event.shiftKey) {
      rig.pan(-x, y);
    } else {
      rig.turn(-x * TurnPerPicture, y * TurnPerPicture);
      onTurn();
    }
  });

  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
    rig.zoom(Math.exp(Math.max(-240, Math.min(240, event.deltaY * lines)) * (event.ctrlKey ? 0.01 : 0.0015)));
  }, { passive: false });
  canvas.addEventListener("contextmenu", event => event.preventDefault());
}

function spreadOf(fingers: ReadonlyMap<number, { x: number; y: number }>): number {
  if (fingers.size !== 2)
    return 0;

  const [a, b] = fingers.values();
  return Math.hypot(a.x - b.x, a.y - b.y);
}
