package org.selectiverenderer.export.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.JsonSettingsReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.MovementConstraint;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PlannedSession;
import org.selectiverenderer.tracker.TrackerSpec;

/** Refuses what a study asks for and the page cannot do, each with its line in the study file. */
final class BrowserLimits {
  private static final JsonSettingsReader JSON =
      new JsonSettingsReader("a study", "the study is not exported");

  private final LoadedStudy material;
  private final Study study;
  private final ProblemCollector problems;

  BrowserLimits(LoadedStudy material, ProblemCollector problems) {
    this.material = material;
    this.problems = problems;
    study = material.study();
  }

  /**
   * Returns whether the page can run the study; else the reasons are reported as errors.
   *
   * @throws IOException if the study file cannot be read
   */
  boolean keep() throws IOException {
    Optional<Boolean> read =
        JSON.read(
            study.file(),
            problems,
            keys -> {
              keys.names();
              refuse(keys);
              return true;
            });
    return read.isPresent() & silent();
  }

  private void refuse(JsonObjectReader keys) {
    TrialLimits.rendering(keys);
    new TrialLimits().refuse(keys);
    if (study.triggers().isPresent()) {
      keys.fault("triggers", "a web browser cannot send triggers by a serial port");
    }
    if (study.streams().wanted()) {
      keys.fault("streams", "a web browser has no Lab Streaming Layer");
    }
    if (!(study.tracker() instanceof TrackerSpec.None)) {
      keys.fault(
          "tracker",
          "a web browser reads no head tracker; with \"none\" mouse, keys and fingers turn the view");
    }
    if (study.display().mode() == DisplayMode.OPENXR) {
      refuseIn(keys, "display", "mode", "the page cannot run a study inside a headset yet");
    }
    if (study.course().closed()) {
      keys.fault("closed", "the page cannot close rooms yet; \"stay\": \"turn\" keeps the place");
    }
    refuseWalks(keys);
    if (random()
        && PlannedSession.all(material).stream()
            .mapToLong(session -> study.lot(session.participant()))
            .anyMatch(lot -> lot != (int) lot)) {
      keys.fault(
          "seed",
          "with so large a seed the page could not draw the same objects for the condition random;"
              + " use one below 60 million");
    }
  }

  /** Returns whether areas or trials are shown in the condition random. */
  private boolean random() {
    return study.design().groups().stream().anyMatch(group -> group.condition() == Condition.RANDOM)
        || TrialLimits.settings(study.design())
            .anyMatch(settings -> settings.condition().equals(Optional.of(Condition.RANDOM)));
  }

  private void refuseWalks(JsonObjectReader keys) {
    String why = "the page cannot bound an area yet; write \"turn\" or \"free\"";
    if (study.course().stay() == MovementConstraint.WALK) {
      keys.fault("stay", why);
    }
    keys.objects(
        "areas",
        "an area",
        area -> {
          area.names();
          String stay = MovementConstraint.WALK.name().toLowerCase(Locale.ROOT);
          if (area.value("stay").flatMap(LocatedJsonValue::text).equals(Optional.of(stay))) {
            area.fault("stay", why);
          }
          return true;
        });
  }

  private static void refuseIn(JsonObjectReader keys, String object, String key, String why) {
    keys.object(
        object,
        "the " + object,
        inner -> {
          inner.names();
          inner.fault(key, why);
          return true;
        });
  }

  /** Returns whether no page is spoken; else says which file is. */
  private boolean silent() {
    for (Path audio : material.audio()) {
      problems.error(
          SourceLocation.of(audio.toString()),
          "the page cannot play the audio of questionnaires yet; the study is not exported");
    }
    return material.audio().isEmpty();
  }
}
