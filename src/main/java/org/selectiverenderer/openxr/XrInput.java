package org.selectiverenderer.openxr;

import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;

/**
 * What hands and eyes do in a frame.
 *
 * @param forward -1 to 1: how fast the stick walks
 * @param right -1 to 1: likewise, to the side
 * @param turn -1 (left) to 1: the stick that turns
 * @param more -1 to 1: the same stick, away from the user; answers more or less
 * @param held buttons that are down
 * @param gaze where the eyes look, in the frame of the head: a unit vector; empty while unknown
 */
public record XrInput(
    double forward,
    double right,
    double turn,
    double more,
    Set<HeadsetButton> held,
    Optional<Vector3d> gaze) {
  /** Nothing is done. */
  public static final XrInput NONE = new XrInput(0, 0, 0, 0, Set.of(), Optional.empty());

  public XrInput {
    held = Set.copyOf(held);
  }
}
