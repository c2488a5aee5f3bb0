package org.selectiverenderer.control;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.schema.Quality;

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
   * @param fields the level of each field that is a quality, by the field's name, for each object
   *     that has such fields, by the name of its Switch; -1 where the value is of no level
   */
  record Start(double time, Map<String, Integer> switches, Map<String, Map<String, Integer>> fields)
      implements ControlEvent {
    /** Makes the start of a scene without field qualities. */
    public Start(double time, Map<String, Integer> switches) {
      this(time, switches, Map.of());
    }
  }

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
   * @param cause what caused the change
   * @param seen what the viewer sees of the change; empty where that is not known
   */
  record SwitchChange(
      double time,
      String switchName,
      int from,
      int to,
      ChoiceCause cause,
      Optional<SwitchVisibility> seen)
      implements ControlEvent {
    /**
     * Creates the event of a change that a schema caused, of which it is not known whether it is
     * seen.
     *
     * @param schema empty if the scene itself made the change, in a run that only observes
     */
    public SwitchChange(double time, String switchName, int from, int to, String schema) {
      this(time, switchName, from, to, schema, Optional.empty());
    }

    /** Creates the event of a change that a schema caused. */
    public SwitchChange(
        double time,
        String switchName,
        int from,
        int to,
        String schema,
        Optional<SwitchVisibility> seen) {
      this(time, switchName, from, to, ChoiceCause.of(schema), seen);
    }

    /**
     * Returns the schema that caused the change; empty if a budget did, or the scene itself, in a
     * run that only observes.
     */
    public String schema() {
      return cause.schema();
    }
  }

  /**
   * A quality of an object that is the value of a field has another level.
   *
   * @param object the name of the object's Switch
   * @param field the DEF name of the node and the name of its field: {@code SofaTexture.url}
   * @param from the level before; -1 if the value was of no level
   * @param to the level now; -1 only if the scene itself has set another value
   * @param schema the schema that caused the change; empty if the scene itself made it
   * @param seen what the viewer sees of the object; empty where that is not known
   */
  record FieldChange(
      double time,
      String object,
      Quality quality,
      String field,
      int from,
      int to,
      String schema,
      Optional<SwitchVisibility> seen)
      implements ControlEvent {
    /** Creates the event of a change of which it is not known whether it is seen. */
    public FieldChange(
        double time,
        String object,
        Quality quality,
        String field,
        int from,
        int to,
        String schema) {
      this(time, object, quality, field, from, to, schema, Optional.empty());
    }
  }
}
