package org.selectiverenderer.tracker.pipeline;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.tracker.EulerAngle;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;

/**
 * Exchanges and inverts angles, for devices that are mounted in another way or name their angles
 * differently.
 */
final class AxisRemapFilter implements PoseFilter {
  private final EulerAngle yawFrom;
  private final EulerAngle pitchFrom;
  private final EulerAngle rollFrom;
  private final int yawSign;
  private final int pitchSign;
  private final int rollSign;

  AxisRemapFilter(Optional<TrackerOptions.Swap> swapped, Set<EulerAngle> inverted) {
    List<EulerAngle> order =
        swapped.map(TrackerOptions.Swap::order).orElseGet(() -> List.of(EulerAngle.values()));
    yawFrom = order.get(0);
    pitchFrom = order.get(1);
    rollFrom = order.get(2);
    yawSign = inverted.contains(EulerAngle.YAW) ? -1 : 1;
    pitchSign = inverted.contains(EulerAngle.PITCH) ? -1 : 1;
    rollSign = inverted.contains(EulerAngle.ROLL) ? -1 : 1;
  }

  @Override
  public void apply(PoseSample sample) {
    sample.turn(
        yawSign * angle(sample, yawFrom),
        pitchSign * angle(sample, pitchFrom),
        rollSign * angle(sample, rollFrom));
  }

  private static double angle(PoseSample sample, EulerAngle axis) {
    return switch (axis) {
      case YAW -> sample.yaw();
      case PITCH -> sample.pitch();
      case ROLL -> sample.roll();
    };
  }
}
