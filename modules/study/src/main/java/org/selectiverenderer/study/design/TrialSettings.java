package org.selectiverenderer.study.design;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.selectiverenderer.schema.SwitchTransition;

/**
 * What a trial shows, as far as a level, a block or a stimulus determines it. An empty component is
 * left to a more general one: the stimulus's settings replace those of the levels, these those of
 * the block, these those of the study.
 *
 * @param condition which versions of the objects are shown
 * @param choices the {@code whichChoice} of Switches by DEF, which nothing else changes during the
 *     trial; -1 hides what a Switch holds
 * @param scene file of the scene
 * @param area name of an area of the study, whose viewpoint, duration and bounds are those of the
 *     trial
 * @param viewpoint DEF of the Viewpoint at which the trial begins
 * @param seconds duration of exposures that have none of their own
 * @param headlight whether the viewer's headlight is on
 * @param mode the display mode
 * @param ipd interpupillary distance in millimetres; 0 shows both eyes the same picture
 * @param transition how objects change their versions
 * @param qualities what decides the levels of qualities, where the condition does not
 */
public record TrialSettings(
    Optional<Condition> condition,
    Map<String, Integer> choices,
    Optional<Path> scene,
    Optional<String> area,
    Optional<String> viewpoint,
    OptionalDouble seconds,
    Optional<Boolean> headlight,
    Optional<DisplayMode> mode,
    OptionalDouble ipd,
    Optional<SwitchTransition> transition,
    Map<Quality, QualityRule> qualities) {
  /** Settings that determine nothing. */
  public static final TrialSettings NONE =
      new TrialSettings(
          Optional.empty(),
          Map.of(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          OptionalDouble.empty(),
          Optional.empty(),
          Optional.empty(),
          OptionalDouble.empty());

  public TrialSettings {
    choices = Map.copyOf(choices);
    qualities = Map.copyOf(qualities);
  }

  /** Creates settings that leave changes of versions open, and all qualities to the condition. */
  public TrialSettings(
      Optional<Condition> condition,
      Map<String, Integer> choices,
      Optional<Path> scene,
      Optional<String> area,
      Optional<String> viewpoint,
      OptionalDouble seconds,
      Optional<Boolean> headlight,
      Optional<DisplayMode> mode,
      OptionalDouble ipd) {
    this(
        condition,
        choices,
        scene,
        area,
        viewpoint,
        seconds,
        headlight,
        mode,
        ipd,
        Optional.empty(),
        Map.of());
  }

  /** Returns settings that determine the condition alone. */
  public static TrialSettings of(Condition condition) {
    return new TrialSettings(
        Optional.of(condition),
        Map.of(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        OptionalDouble.empty(),
        Optional.empty(),
        Optional.empty(),
        OptionalDouble.empty());
  }

  /** Returns these settings, and those of {@code general} where these determine nothing. */
  public TrialSettings over(TrialSettings general) {
    Map<String, Integer> all = new LinkedHashMap<>(general.choices);
    all.putAll(choices);
    Map<Quality, QualityRule> rules = new LinkedHashMap<>(general.qualities);
    rules.putAll(qualities);
    return new TrialSettings(
        condition.or(() -> general.condition),
        all,
        scene.or(() -> general.scene),
        area.or(() -> general.area),
        // An area has a viewpoint of its own, which a more general one must not replace.
        viewpoint.or(() -> area.isPresent() ? Optional.empty() : general.viewpoint),
        seconds.isPresent() || area.isPresent() ? seconds : general.seconds,
        headlight.or(() -> general.headlight),
        mode.or(() -> general.mode),
        ipd.isPresent() ? ipd : general.ipd,
        transition.or(() -> general.transition),
        rules);
  }
}
