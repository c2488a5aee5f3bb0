package org.selectiverenderer.study.gaze;

/**
 * A part of a scene in which viewers were while they looked.
 *
 * @param name the schema that was active there; without one the DEF of the ProximitySensor's area,
 *     else that of the room, else {@code scene}
 * @param schema whether the name is that of a schema
 */
public record GazeArea(String name, boolean schema) {
  /** The area of a log that knows neither schemas nor areas nor rooms. */
  static final GazeArea SCENE = new GazeArea("scene", false);
}
