package org.selectiverenderer.app.settings;

import java.nio.file.Path;

/**
 * What is recorded of the head.
 *
 * @param file of the head log
 * @param coneDegrees width of the cone in which the log names objects
 * @param replace whether a log that is there already may be replaced
 */
public record HeadLogSettings(Path file, double coneDegrees, boolean replace) {
  /** Degrees: about what an eye that rests looks over without turning. */
  public static final double CONE = 10;

  /** A log that must not be there yet, with the usual cone. */
  public HeadLogSettings(Path file) {
    this(file, CONE, false);
  }
}
