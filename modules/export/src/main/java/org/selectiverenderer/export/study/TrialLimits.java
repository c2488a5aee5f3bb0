package org.selectiverenderer.export.study;

import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.schema.SwitchTransition;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialSettings;

/** Refuses what blocks of trials ask for and the page cannot do, each with its line. */
final class TrialLimits {
  private static final String DISPLAY = "display";
  private static final String QUALITIES = "qualities";
  private static final String SWITCH = "switch";

  /** Refuses in the study's blocks, and in the levels of its factors. */
  void refuse(JsonObjectReader keys) {
    keys.objects("blocks", "a block", this::block);
    keys.objects(
        "factors",
        "a factor",
        factor -> {
          factor.names();
          factor.objects("levels", "a level", TrialLimits::shown);
          return true;
        });
  }

  /** Refuses what an object of keys says about changes of versions, and about qualities. */
  static void rendering(JsonObjectReader keys) {
    keys.value(SWITCH)
        .flatMap(LocatedJsonValue::text)
        .filter(way -> !way.equals(SwitchTransition.AT_ONCE.spelling()))
        .ifPresent(
            way -> keys.fault(SWITCH, "the page changes versions at once, and cannot do " + way));
    if (keys.has(QUALITIES)) {
      keys.fault(
          QUALITIES,
          "the page shows all qualities as the condition says, and cannot set one apart; write"
              + " factors with conditions, or export a scene for each level");
    }
  }

  /** Returns what the blocks, levels and stimuli of a design say that trials show. */
  static Stream<TrialSettings> settings(StudyDesign design) {
    return design.blocks().stream().flatMap(TrialLimits::settings);
  }

  private static Stream<TrialSettings> settings(TrialBlock block) {
    Stream<TrialSettings> levels =
        block.factors().stream()
            .flatMap(factor -> factor.levels().stream())
            .map(Factor.Level::settings);
    Stream<TrialSettings> stimuli =
        block.stimuli().stream()
            .flatMap(list -> list.rows().stream())
            .map(stimulus -> stimulus.settings());
    return Stream.concat(Stream.of(block.settings()), Stream.concat(levels, stimuli));
  }

  private boolean block(JsonObjectReader block) {
    shown(block);
    if (block.has("staircase")) {
      block.fault(
          "staircase",
          "the page shows trials whose order is known before, and cannot choose levels by the"
              + " responses yet");
    }
    block.objects("trial", "a phase", this::phase);
    return true;
  }

  private boolean phase(JsonObjectReader phase) {
    phase.names();
    if (phase.value("until").flatMap(LocatedJsonValue::text).equals(Optional.of("scene"))) {
      phase.fault("until", "the page cannot end exposures by events of the scene yet");
    }
    if (phase.has("phases")) {
      phase.objects("phases", "a phase", this::phase);
    }
    return true;
  }

  private static boolean shown(JsonObjectReader keys) {
    keys.names();
    rendering(keys);
    if (keys.has(DISPLAY)) {
      keys.fault(DISPLAY, "the page shows one picture, and cannot vary the display");
    }
    return true;
  }
}
