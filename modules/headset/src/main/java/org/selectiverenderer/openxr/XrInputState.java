package org.selectiverenderer.openxr;

import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;

/**
 * The state of the controllers and the gaze in a frame.
 *
 * @param forward -1 (backward) to 1 (forward): the stick that walks
 * @param side -1 (left) to 1 (right): the same stick
 * @param turn -1 (left) to 1 (right): the stick that turns
 * @param more -1 (towards the user) to 1 (away): the same stick, which answers less or more
 * @param held actions whose buttons are pressed
 * @param gaze gaze direction in the frame of the head, a unit vector; empty while unknown
 * @param left aim pose of the left hand, which points along -Z, in the frame of the head; empty
 *     while unknown
 * @param right aim pose of the right hand
 */
public record XrInputState(
    double forward,
    double side,
    double turn,
    double more,
    Set<ControllerAction> held,
    Optional<Vector3d> gaze,
    Optional<XrPose> left,
    Optional<XrPose> right) {
  /** No input. */
  public static final XrInputState NONE = new XrInputState(0, 0, 0, 0, Set.of(), Optional.empty());

  /** Makes an input without aim poses. */
  public XrInputState(
      double forward,
      double side,
      double turn,
      double more,
      Set<ControllerAction> held,
      Optional<Vector3d> gaze) {
    this(forward, side, turn, more, held, gaze, Optional.empty(), Optional.empty());
  }

  public XrInputState {
    held = Set.copyOf(held);
  }
}
