package org.selectiverenderer.app.settings;

import java.nio.file.Path;

/**
 * The settings of a head log.
 *
 * @param file file of the head log
 * @param coneDegrees width of the gaze cone in which the log lists objects
 * @param replace whether an existing log may be replaced
 */
public record HeadLogSettings(Path file, double coneDegrees, boolean replace) {
  /** The default width of the gaze cone in degrees, about the field that a resting eye surveys. */
  public static final double CONE = 10;

  /** Creates the settings of a log that must not exist yet, with the default cone. */
  public HeadLogSettings(Path file) {
    this(file, CONE, false);
  }
}
