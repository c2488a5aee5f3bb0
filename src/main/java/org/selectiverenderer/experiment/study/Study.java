package org.selectiverenderer.experiment.study;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.hmd.DisplayMode;
import org.selectiverenderer.runtime.walk.MouseMapping;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * A study. Files are resolved: relative ones are meant from the study file's folder.
 *
 * @param file the study file
 * @param scene that is explored; empty for a study of questionnaires alone
 * @param conditions one for each group
 * @param participants that are planned for, in all groups together
 * @param assignment how participants come to their conditions
 * @param block participants in a block of the assignment; in each all conditions are as frequent
 * @param seed of the assignment and of the order of questions
 * @param fade seconds in which the picture of an area comes and goes, beside its exposure
 * @param language of the questionnaires, a code such as {@code en}
 * @param quality what sessions must be like to count
 * @param course how a session goes on
 * @param streams what goes to, and comes from, the Lab Streaming Layer
 * @param access what the scenes may name besides their own files
 * @param mute whether the sounds of the scenes are left out
 */
public record Study(
    Path file,
    String name,
    Optional<Path> scene,
    List<Condition> conditions,
    int participants,
    Assignment assignment,
    int block,
    long seed,
    Optional<Practice> practice,
    List<Area> areas,
    double fade,
    Display display,
    TrackerSpec tracker,
    MouseMapping mouse,
    String language,
    StudyQuestionnaires questionnaires,
    StudyQuality quality,
    StudyCourse course,
    StudyStreams streams,
    ContentAccess access,
    boolean mute) {

  public Study {
    conditions = List.copyOf(conditions);
    areas = List.copyOf(areas);
  }

  /** Where the participants get to know display and mouse, until the experimenter goes on. */
  public record Practice(Path scene, String viewpoint) {}

  /**
   * A part of the scene that is seen for a while.
   *
   * @param viewpoint DEF name of the Viewpoint where the exposure begins
   * @param seconds of exposure
   * @param stay where the participant may go; empty for where the study says
   * @param within DEF of a ProximitySensor, whose box is the area, or of a room; empty for the room
   *     around the viewpoint
   */
  public record Area(
      String name,
      String viewpoint,
      double seconds,
      Optional<Stay> stay,
      Optional<String> within) {}

  /** Where the participant may go while an area is shown. */
  public Stay stay(Area area) {
    return area.stay().orElse(course.stay());
  }

  /**
   * On what it is shown.
   *
   * @param hmd a built-in display profile or the file of one
   * @param ipd distance of the pupils in millimetres
   * @param width of the window in pixels, where the mode has one; 0 for what the display has
   * @param height likewise
   * @param operator number or name of the operator's monitor; empty for one that no eye uses
   * @param pointer where the mouse pointer is meanwhile
   * @param worn how it is shown in a headset, where the mode is that
   */
  public record Display(
      DisplayMode mode,
      String hmd,
      double ipd,
      int width,
      int height,
      Optional<String> operator,
      PointerPlace pointer,
      Worn worn) {}

  /**
   * How a scene is shown in a headset.
   *
   * @param seated whether the participant sits, so that the eyes are at the scene's height
   * @param scale how large the participant is in the scene: 1 for as large as people are
   * @param turn degrees by which a controller's stick turns at once; 0 to turn smoothly
   * @param asked whether questions are asked inside the headset, where they can be
   */
  public record Worn(boolean seated, double scale, double turn, boolean asked) {
    /** Standing, as large as people are. */
    public static final Worn STANDING = new Worn(false, 1, 30, false);
  }

  /** The folder that the study file lies in; sessions go there. */
  public Path folder() {
    return file.toAbsolutePath().getParent();
  }
}
