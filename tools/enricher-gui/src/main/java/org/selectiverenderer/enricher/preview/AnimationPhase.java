package org.selectiverenderer.enricher.preview;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.nodes.sensor.TimeSensorNode;

/**
 * Where a scene's animation stands: in the cycle of its slowest TimeSensor. A value.
 *
 * @param seconds since the beginning of the cycle, from 0 to below the period
 * @param period seconds of the cycle, above 0
 */
record AnimationPhase(double seconds, double period) {
  /** Longer cycles than an hour are clocks, not animations. */
  private static final double LONGEST = 3600;

  /**
   * Returns the phase of a scene.
   *
   * @param sensors all that the scene has
   * @param time seconds since the scene was loaded
   * @return empty for a scene without an enabled TimeSensor
   */
  static Optional<AnimationPhase> of(List<TimeSensorNode> sensors, double time) {
    return sensors.stream()
        .filter(sensor -> (Boolean) value(sensor, "enabled"))
        .filter(sensor -> period(sensor) > 0 && period(sensor) <= LONGEST)
        .max(Comparator.comparingDouble(AnimationPhase::period))
        .map(
            sensor -> {
              double since = World.EPOCH + time - (Double) value(sensor, "startTime");
              return new AnimationPhase(remainder(since, period(sensor)), period(sensor));
            });
  }

  private static double period(TimeSensorNode sensor) {
    return (Double) value(sensor, "cycleInterval");
  }

  private static Object value(TimeSensorNode sensor, String field) {
    return sensor.value(sensor.type().indexOf(field));
  }

  private static double remainder(double of, double by) {
    return of - Math.floor(of / by) * by;
  }

  /**
   * Returns the seconds until the phase is another one. They are not negative, as a scene's time
   * does not run back: to an earlier phase the animation goes on to the next cycle.
   */
  double until(double phase) {
    return remainder(phase - seconds, period);
  }
}
