package org.selectiverenderer.control;

import java.util.List;
import java.util.Map;

/**
 * Something that the controller did or noticed, in the order in which it happened. Times are time
 * stamps of the browser in seconds.
 */
public sealed interface ControlEvent {
  /** When it happened. */
  double time();

  /**
   * A scene is under control.
   *
   * @param time 0 where the browser has not told a time yet
   * @param switches the choice of each enriched Switch by name, in the order of the scene
   */
  record Start(double time, Map<String, Integer> switches) implements ControlEvent {}

  /**
   * The viewer entered an area.
   *
   * @param sensor the name of its ProximitySensor
   * @param schemas activated thereby
   */
  record Enter(double time, String sensor, List<String> schemas) implements ControlEvent {}

  /**
   * The viewer left an area.
   *
   * @param sensor the name of its ProximitySensor
   * @param schemas activated thereby
   */
  record Exit(double time, String sensor, List<String> schemas) implements ControlEvent {}

  /**
   * A Switch shows another choice.
   *
   * @param switchName the name of the Switch
   * @param schema which made it so
   */
  record SwitchChange(double time, String switchName, int from, int to, String schema)
      implements ControlEvent {}
}
