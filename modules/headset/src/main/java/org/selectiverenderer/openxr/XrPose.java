package org.selectiverenderer.openxr;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * A pose in a space.
 *
 * @param position in metres
 * @param orientation rotation from the pose's own frame to that of the space
 */
public record XrPose(Vector3d position, Quaterniond orientation) {
  /** Returns this pose relative to another pose of the same space. */
  XrPose seenFrom(XrPose other) {
    Quaterniond back = other.orientation.conjugate(new Quaterniond());
    return new XrPose(
        back.transform(position.sub(other.position, new Vector3d())),
        back.mul(orientation, new Quaterniond()));
  }
}
