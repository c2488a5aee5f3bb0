package org.selectiverenderer.study.definition;

import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.selectiverenderer.schema.SwitchTransition;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSettings;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * A study as the study file defines it. Paths of files are resolved against the study file's
 * folder.
 *
 * @param file the study file
 * @param scene the scene that is shown; empty for a study of questionnaires alone
 * @param design groups, factors and blocks of trials
 * @param participants number of planned participants, in all groups together
 * @param assignment how participants are assigned to groups
 * @param block number of participants in a block of the assignment, a multiple of the number of
 *     groups
 * @param seed random seed of the assignment and of the order of questions
 * @param fade seconds in which the picture of an area fades in and out, in addition to its exposure
 * @param language in which the study's texts were read, a code such as {@code en}
 * @param languages all languages of the study; the first is the default
 * @param quality quality criteria of sessions
 * @param course procedure of a session
 * @param streams streams to and from the Lab Streaming Layer
 * @param access which files other than their own the scenes may refer to
 * @param mute whether the scenes are shown without sound
 * @param triggers signals that sessions send by a serial port
 * @param transition how objects change their versions, where a trial does not say otherwise
 * @param qualities what decides the levels of qualities, where neither trial nor condition does
 */
public record Study(
    Path file,
    String name,
    Optional<Path> scene,
    StudyDesign design,
    int participants,
    ConditionAssignment assignment,
    int block,
    long seed,
    Optional<Practice> practice,
    List<Area> areas,
    double fade,
    Display display,
    TrackerSpec tracker,
    MouseButtonMapping mouse,
    String language,
    List<String> languages,
    StudyQuestionnaires questionnaires,
    QualityCriteria quality,
    StudyProcedure course,
    LslSettings streams,
    ContentAccessPolicy access,
    boolean mute,
    Optional<TriggerSettings> triggers,
    SwitchTransition transition,
    Map<Quality, QualityRule> qualities) {

  public Study {
    qualities = Map.copyOf(qualities);
    areas = List.copyOf(areas);
    languages = List.copyOf(languages);
  }

  /** The practice with display and controls, until the experimenter ends it. */
  public record Practice(Path scene, String viewpoint) {}

  /**
   * An area of the scene that is shown in an exposure.
   *
   * @param viewpoint DEF of the Viewpoint at which the exposure begins
   * @param seconds duration of the exposure
   * @param stay the movement constraint; empty for that of the study
   * @param within DEF of the ProximitySensor or the room that bounds the area; empty for the room
   *     around the viewpoint
   */
  public record Area(
      String name,
      String viewpoint,
      double seconds,
      Optional<MovementConstraint> stay,
      Optional<String> within) {}

  /** Returns the movement constraint of an area. */
  public MovementConstraint stay(Area area) {
    return area.stay().orElse(course.stay());
  }

  /**
   * The display of a study.
   *
   * @param hmd name of a built-in display profile, or the file of one
   * @param ipd interpupillary distance in millimetres
   * @param width of the window in pixels, if the mode has a window; 0 for the display's width
   * @param height of the window in pixels; 0 for the display's height
   * @param operator number or name of the operator's monitor; empty for a monitor that shows no
   *     eye's picture
   * @param pointer where the mouse pointer is confined
   * @param worn settings of a headset, if the mode is OpenXR
   */
  public record Display(
      DisplayMode mode,
      String hmd,
      double ipd,
      int width,
      int height,
      Optional<String> operator,
      PointerConfinement pointer,
      Worn worn) {}

  /**
   * The settings of a headset.
   *
   * @param seated whether the participant sits, so that the eyes are at the height of the scene's
   *     viewpoint
   * @param scale size of the participant in the scene: 1 for real size
   * @param turn degrees of a snap turn by a controller's stick; 0 for smooth turning
   * @param asked whether questions are asked inside the headset, where possible
   */
  public record Worn(boolean seated, double scale, double turn, boolean asked) {
    /** A standing participant of real size, with snap turns of 30 degrees. */
    public static final Worn STANDING = new Worn(false, 1, 30, false);
  }

  /** Returns the area with a name. */
  public Optional<Area> area(String wanted) {
    return areas.stream().filter(area -> area.name().equals(wanted)).findFirst();
  }

  /** Returns the scene of a trial; empty for a trial without one. */
  public Optional<Path> scene(Trial trial) {
    return trial.settings().scene().or(() -> scene);
  }

  /** Returns what decides the levels of qualities in a trial or group, apart from the condition. */
  public Map<Quality, QualityRule> qualities(TrialSettings settings) {
    Map<Quality, QualityRule> rules = new EnumMap<>(Quality.class);
    rules.putAll(qualities);
    rules.putAll(settings.qualities());
    return rules;
  }

  /** Returns the DEF of the viewpoint of a trial; empty for the first of the scene. */
  public Optional<String> viewpoint(Trial trial) {
    return trial
        .settings()
        .viewpoint()
        .or(() -> trial.settings().area().flatMap(this::area).map(Area::viewpoint));
  }

  /** Returns the duration of an exposure in seconds; empty where a key or the scene ends it. */
  public OptionalDouble seconds(Trial trial, TrialPhase.Exposure exposure) {
    if (exposure.seconds().isPresent()) {
      return exposure.seconds();
    }
    if (trial.settings().seconds().isPresent()) {
      return trial.settings().seconds();
    }
    return trial
        .settings()
        .area()
        .flatMap(this::area)
        .map(area -> OptionalDouble.of(area.seconds()))
        .orElse(OptionalDouble.empty());
  }

  /**
   * Returns this study with its sessions in another folder, such as that of another site.
   *
   * @param other path of the study file there; the file need not exist
   */
  public Study at(Path other) {
    return new Study(
        other,
        name,
        scene,
        design,
        participants,
        assignment,
        block,
        seed,
        practice,
        areas,
        fade,
        display,
        tracker,
        mouse,
        language,
        languages,
        questionnaires,
        quality,
        course,
        streams,
        access,
        mute,
        triggers,
        transition,
        qualities);
  }

  /** Returns the seed of a participant's condition {@code random}, always the same for them. */
  public long lot(String participant) {
    return seed * 31 + participant.hashCode();
  }

  /** Returns the study file's folder, which also contains the sessions. */
  public Path folder() {
    return file.toAbsolutePath().getParent();
  }
}
