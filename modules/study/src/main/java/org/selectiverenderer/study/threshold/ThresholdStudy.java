package org.selectiverenderer.study.threshold;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.OutsideRequests;

/**
 * The settings of a threshold pilot.
 *
 * @param file the file of the settings
 * @param scene the scene with the objects
 * @param objects the objects that are judged, at least two
 * @param rungs number of reduced versions of each object
 * @param fewest share of the vertices that the lowest version keeps
 * @param views views of an object, one of them at random for each trial
 * @param picture width and height of each picture in pixels
 * @param catches share of catch trials, which show another object instead of the version
 * @param attention share of the catch trials that a participant must answer right to count
 * @param language of the participant's texts
 * @param access which files other than its own the scene may refer to
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
    ContentAccessPolicy access) {

  /**
   * An object that is judged.
   *
   * @param object DEF of the object, as for {@code versions --object}
   * @param name the name that participants read
   */
  public record Judged(String object, String name) {}

  /**
   * A view of an object, in degrees; at 0, 0 the camera is in front and looks along -Z.
   *
   * @param yaw angle by which the camera is moved around the object to the camera's right
   * @param pitch angle by which the camera is moved up
   */
  public record View(double yaw, double pitch) {}

  public ThresholdStudy {
    objects = List.copyOf(objects);
    views = List.copyOf(views);
  }

  /** Returns what the pilot asks for beyond its own folder. */
  public PermissionRequests permissions() {
    return new OutsideRequests(file)
        .scene("scene", scene)
        .file(
            "language",
            ParticipantMessages.file(language, file.toAbsolutePath().resolveSibling("")))
        .access(access)
        .requests();
  }

  /** Returns the folder of the pilot's files. */
  public Path folder() {
    return file.toAbsolutePath().resolveSibling("threshold");
  }
}
