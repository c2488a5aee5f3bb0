package org.selectiverenderer.openxr;

import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;

/**
 * What hands and eyes do in a frame.
 *
 * @param forward -1 to 1: how fast the stick walks
 * @param side -1 to 1: likewise, to the right
 * @param turn -1 (left) to 1: the stick that turns
 * @param more -1 to 1: the same stick, away from the user; answers more or less
 * @param held buttons that are down
 * @param gaze where the eyes look, in the frame of the head: a unit vector; empty while unknown
 * @param left where the left hand is and points, along -Z, in the frame of the head; empty while
 *     unknown
 * @param right likewise the right hand
 */
public record XrInput(
    double forward,
    double side,
    double turn,
    double more,
    Set<HeadsetButton> held,
    Optional<Vector3d> gaze,
    Optional<SpacePose> left,
    Optional<SpacePose> right) {
  /** Nothing is done. */
  public static final XrInput NONE = new XrInput(0, 0, 0, 0, Set.of(), Optional.empty());

  /** Nobody points at anything. */
  public XrInput(
      double forward,
      double side,
      double turn,
      double more,
      Set<HeadsetButton> held,
      Optional<Vector3d> gaze) {
    this(forward, side, turn, more, held, gaze, Optional.empty(), Optional.empty());
  }

  public XrInput {
    held = Set.copyOf(held);
  }
}
