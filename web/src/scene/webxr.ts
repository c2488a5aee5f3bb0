/** What this program uses of the WebXR Device API, which TypeScript's own library does not declare. */

export interface XrTransform {
  readonly position: { readonly x: number; readonly y: number; readonly z: number };
  readonly orientation: { readonly x: number; readonly y: number; readonly z: number; readonly w: number };
}

export type XrSpace = EventTarget;

export interface XrFrame {
  getViewerPose(space: XrSpace): { readonly transform: XrTransform } | null;
  getPose(space: XrSpace, base: XrSpace): { readonly transform: XrTransform } | null;
}

export interface XrInputSource {
  readonly handedness: 'none' | 'left' | 'right';
  readonly targetRaySpace: XrSpace;
  readonly gamepad?: {
    readonly axes: readonly number[];
    readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
  } | null;
}

/** An event of a session that tells of a press, such as "select". */
export interface XrInputEvent extends Event {
  readonly frame: XrFrame;
  readonly inputSource: XrInputSource;
}

export interface XrSession extends EventTarget {
  readonly inputSources: Iterable<XrInputSource>;
  readonly visibilityState: 'visible' | 'visible-blurred' | 'hidden';
  requestReferenceSpace(type: 'local' | 'local-floor'): Promise<XrSpace>;
  end(): Promise<void>;
}

export interface XrSystem {
  isSessionSupported(mode: 'immersive-vr'): Promise<boolean>;
  requestSession(mode: 'immersive-vr', options?: { readonly optionalFeatures?: readonly string[] }): Promise<XrSession>;
}

/** Returns the headsets that the browser knows; undefined if it has no WebXR, as on addresses that begin with http. */
export function webxr(): XrSystem | undefined {
  return (navigator as Navigator & { readonly xr?: XrSystem }).xr;
}
