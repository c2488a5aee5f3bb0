package org.selectiverenderer.control;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An event of the controller, in the order in which it happened. Times are the browser's time
 * stamps in seconds.
 */
public sealed interface ControlEvent {
  /** Returns when it happened. */
  double time();

  /**
   * The control of a scene has begun.
   *
   * @param time the time stamp; 0 before the browser's first one
   * @param switches the choice of each enriched Switch by name, in the order of the scene
   */
  record Start(double time, Map<String, Integer> switches) implements ControlEvent {}

  /**
   * The viewer entered an area.
   *
   * @param sensor the name of its ProximitySensor
   * @param schemas the schemas that this activates
   */
  record Enter(double time, String sensor, List<String> schemas) implements ControlEvent {}

  /**
   * The viewer left an area.
   *
   * @param sensor the name of its ProximitySensor
   * @param schemas the schemas that this activates
   */
  record Exit(double time, String sensor, List<String> schemas) implements ControlEvent {}

  /**
   * A Switch shows another choice.
   *
   * @param switchName the name of the Switch
   * @param schema the schema that caused the change; empty if the scene itself made it, in a run
   *     that only observes
   * @param seen what the viewer sees of the change; empty where that is not known
   */
  record SwitchChange(
      double time,
      String switchName,
      int from,
      int to,
      String schema,
      Optional<SwitchVisibility> seen)
      implements ControlEvent {
    /** Creates the event of a change of which it is not known whether it is seen. */
    public SwitchChange(double time, String switchName, int from, int to, String schema) {
      this(time, switchName, from, to, schema, Optional.empty());
    }
  }
}
