package org.selectiverenderer.tracker.live;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.tracker.Axis;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;

/**
 * Exchanges and inverts angles, for devices that are mounted in another way or name their angles
 * differently.
 */
final class AxisFilter implements PoseFilter {
  private final Axis yawFrom;
  private final Axis pitchFrom;
  private final Axis rollFrom;
  private final int yawSign;
  private final int pitchSign;
  private final int rollSign;

  AxisFilter(Optional<TrackerOptions.Swap> swapped, Set<Axis> inverted) {
    List<Axis> order =
        swapped.map(TrackerOptions.Swap::order).orElseGet(() -> List.of(Axis.values()));
    yawFrom = order.get(0);
    pitchFrom = order.get(1);
    rollFrom = order.get(2);
    yawSign = inverted.contains(Axis.YAW) ? -1 : 1;
    pitchSign = inverted.contains(Axis.PITCH) ? -1 : 1;
    rollSign = inverted.contains(Axis.ROLL) ? -1 : 1;
  }

  @Override
  public void apply(PoseSample sample) {
    sample.turn(
        yawSign * angle(sample, yawFrom),
        pitchSign * angle(sample, pitchFrom),
        rollSign * angle(sample, rollFrom));
  }

  private static double angle(PoseSample sample, Axis axis) {
    return switch (axis) {
      case YAW -> sample.yaw();
      case PITCH -> sample.pitch();
      case ROLL -> sample.roll();
    };
  }
}
