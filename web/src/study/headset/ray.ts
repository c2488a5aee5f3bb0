import type { Pose } from '../../scene/pose.js';
import type { XrTransform } from '../../scene/webxr.js';

/** A point of a panel: 0 to 1 from its left and from its top. */
export interface PanelPoint {
  readonly u: number;
  readonly v: number;
}

type Vector = readonly [x: number, y: number, z: number];

/**
 * Returns where a ray meets an upright panel; undefined where it does not.
 *
 * @param ray where it comes from; it goes along its own -Z
 * @param panel its middle; its picture is seen by who looks in the direction of its yaw
 * @param width metres
 * @param height metres
 */
export function meets(ray: XrTransform, panel: Pose, width: number, height: number): PanelPoint | undefined {
  const { x, y, z } = ray.position;
  const from = turned([x - panel.x, y - panel.y, z - panel.z], -panel.yaw);
  const along = turned(forward(ray.orientation), -panel.yaw);
  if (along[2] >= -1e-6 || from[2] <= 0) {
    return undefined; // from behind, or beside
  }
  const way = -from[2] / along[2];
  const u = (from[0] + way * along[0]) / width + 0.5;
  const v = 0.5 - (from[1] + way * along[1]) / height;
  return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? { u, v } : undefined;
}

/** Returns the direction in which an orientation takes -Z. */
function forward({ x, y, z, w }: XrTransform['orientation']): Vector {
  return [-2 * (x * z + w * y), -2 * (y * z - w * x), -(1 - 2 * (x * x + y * y))];
}

/** Turns a vector about +Y by degrees to the left. */
function turned([x, y, z]: Vector, degrees: number): Vector {
  const [sine, cosine] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  return [x * cosine + z * sine, y, -x * sine + z * cosine];
}
