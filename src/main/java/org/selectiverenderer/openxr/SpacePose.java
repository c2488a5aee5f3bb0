package org.selectiverenderer.openxr;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Where something is in a space.
 *
 * @param position metres
 * @param orientation takes its own frame to that of the space
 */
public record SpacePose(Vector3d position, Quaterniond orientation) {
  /** This pose as something at another pose of the same space sees it. */
  SpacePose seenFrom(SpacePose other) {
    Quaterniond back = other.orientation.conjugate(new Quaterniond());
    return new SpacePose(
        back.transform(position.sub(other.position, new Vector3d())),
        back.mul(orientation, new Quaterniond()));
  }
}
