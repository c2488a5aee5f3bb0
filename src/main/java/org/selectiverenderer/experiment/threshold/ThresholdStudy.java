package org.selectiverenderer.experiment.threshold;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * The settings of a threshold pilot.
 *
 * @param file that they are from
 * @param scene whose objects are judged
 * @param objects at least two
 * @param rungs reduced versions of each object
 * @param fewest share of the vertices that the lowest of them keeps
 * @param views from which an object is looked at, one drawn for each trial
 * @param picture width and height of each picture in pixels
 * @param catches share of trials with another object in the version's place
 * @param attention share of these that a participant must get right to count
 * @param language of what the participant reads
 * @param access what the scene may name besides its own files
 */
public record ThresholdStudy(
    Path file,
    String name,
    Path scene,
    ThresholdTask task,
    List<Judged> objects,
    int rungs,
    double fewest,
    List<View> views,
    int picture,
    StaircaseRule rule,
    double catches,
    double attention,
    long seed,
    String language,
    ContentAccess access) {

  /**
   * An object that is judged.
   *
   * @param object its DEF, as for {@code versions --object}
   * @param name what participants call it
   */
  public record Judged(String object, String name) {}

  /**
   * From where an object is seen, in degrees; 0, 0 is from before, along -Z.
   *
   * @param yaw how far the eye has gone round to its right
   * @param pitch how far it has gone up
   */
  public record View(double yaw, double pitch) {}

  public ThresholdStudy {
    objects = List.copyOf(objects);
    views = List.copyOf(views);
  }

  /** Where what the pilot makes and learns is kept. */
  public Path folder() {
    return file.toAbsolutePath().resolveSibling("threshold");
  }
}
