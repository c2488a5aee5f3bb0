package org.selectiverenderer.study.headlog;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;

/** Formats an analysis of a head log as text for people and as JSON. */
public final class HeadLogReport {
  private HeadLogReport() {}

  /** Returns the analysis as text: several lines, the last one ended. */
  public static String text(HeadLogAnalysis analysis) {
    StringBuilder text = new StringBuilder();
    line(
        text,
        "%s, %s: %.1f s in view, %d samples, head idle %.0f %% of the time",
        analysis.log().description().scene(),
        analysis.log().description().condition(),
        analysis.seconds(),
        analysis.log().samples().size() - analysis.unshown().samples(),
        100 * analysis.idle());
    leftOut(text, analysis.unshown());
    DwellSummary head = analysis.head();
    line(text, "");
    line(text, "%-32s %8s %6s %8s %8s", "in the middle of the view", "s", "looks", "first", "long");
    views(text, head, analysis, view -> "");
    analysis.eyes().ifPresent(eyes -> eyes(text, eyes, analysis));
    line(text, "");
    for (RoomCoverage room : analysis.rooms()) {
      line(
          text,
          "%-32s %8.1f s inside, at most %.0f %% of it seen%s",
          room.room(),
          room.seconds(),
          100 * room.seen(),
          room.seconds() == 0 || room.unseen().isEmpty()
              ? ""
              : "; not seen: " + String.join(", ", room.unseen()));
    }
    return text.toString();
  }

  private static void eyes(StringBuilder text, EyeTrackingAnalysis eyes, HeadLogAnalysis analysis) {
    line(text, "");
    line(
        text,
        "eyes: tracked %.0f %% of the time in view, %s, %.2f s long on average",
        100 * eyes.tracked(),
        Pluralizer.of(eyes.fixations().size(), "fixation"),
        eyes.meanFixation());
    line(
        text,
        "%-32s %8s %6s %8s %8s %9s",
        "looked at by the eyes",
        "s",
        "looks",
        "first",
        "long",
        "fixations");
    views(
        text,
        eyes.looks(),
        analysis,
        view -> String.format(Locale.ROOT, " %9d", eyes.fixations(view.object()).size()));
  }

  /**
   * Writes the objects, then those never looked at in rooms that were entered, then walls, floors
   * and ceilings.
   */
  private static void views(
      StringBuilder text,
      DwellSummary looks,
      HeadLogAnalysis analysis,
      Function<DwellSummary.ObjectView, String> more) {
    SceneMap map = analysis.log().description().map();
    rows(text, looks.objects().stream().filter(view -> !map.surrounds(view.object())), more);
    Set<String> notEntered =
        analysis.rooms().stream()
            .filter(room -> room.seconds() == 0)
            .map(RoomCoverage::room)
            .collect(Collectors.toSet());
    looks
        .unseen()
        .forEach(
            (room, names) -> {
              if (!notEntered.contains(room)) {
                line(
                    text,
                    "never%s: %s",
                    room.isEmpty() ? "" : ", " + room,
                    String.join(", ", names));
              }
            });
    if (looks.objects().stream().anyMatch(view -> map.surrounds(view.object()))) {
      line(text, "");
      line(text, "walls, floors, ceilings");
      rows(text, looks.objects().stream().filter(view -> map.surrounds(view.object())), more);
    }
  }

  private static void rows(
      StringBuilder text,
      Stream<DwellSummary.ObjectView> views,
      Function<DwellSummary.ObjectView, String> more) {
    views.forEach(
        view ->
            line(
                text,
                "%-32s %8.2f %6d %8.2f %8.2f%s",
                view.object(),
                view.seconds(),
                view.looks(),
                view.first(),
                view.longest(),
                more.apply(view)));
  }

  private static void leftOut(StringBuilder text, HeadLogAnalysis.Unshown unshown) {
    if (unshown.samples() > 0) {
      line(
          text,
          "left out: %.1f s, %d samples without a picture (black or fading)",
          unshown.seconds(),
          unshown.samples());
    }
    if (unshown.pauses() > 0) {
      line(
          text,
          "paused: %s, %.1f s together",
          Pluralizer.of(unshown.pauses(), "time"),
          unshown.paused());
    }
  }

  private static void line(StringBuilder text, String format, Object... arguments) {
    text.append(String.format(Locale.ROOT, format, arguments)).append('\n');
  }

  /** Returns the analysis as one JSON object: several lines, the last one ended. */
  public static String json(HeadLogAnalysis analysis) {
    return JsonWriter.of(tree(analysis));
  }

  /** Returns the analysis and the changes of versions as JSON. */
  public static String json(HeadLogAnalysis analysis, SwitchSightings switches) {
    ObjectNode root = tree(analysis);
    switches.put(root);
    return JsonWriter.of(root);
  }

  private static ObjectNode tree(HeadLogAnalysis analysis) {
    ObjectNode root = JsonTree.object();
    HeadLogMetadata shown = analysis.log().description();
    root.put("scene", shown.scene()).put("condition", shown.condition());
    root.put("seconds", DecimalRounding.to(3, analysis.seconds()));
    root.put("samples", analysis.log().samples().size() - analysis.unshown().samples());
    root.putObject("left_out")
        .put("seconds", DecimalRounding.to(3, analysis.unshown().seconds()))
        .put("samples", analysis.unshown().samples())
        .put("pauses", analysis.unshown().pauses())
        .put("paused_seconds", DecimalRounding.to(3, analysis.unshown().paused()));
    root.put("idle", DecimalRounding.to(3, analysis.idle()));
    objects(root, analysis.head(), shown.map());
    ArrayNode rooms = root.putArray("rooms");
    for (RoomCoverage room : analysis.rooms()) {
      ArrayNode sides =
          rooms
              .addObject()
              .put("room", room.room())
              .put("seconds", DecimalRounding.to(3, room.seconds()))
              .put("seen", DecimalRounding.to(3, room.seen()))
              .putArray("unseen_sides");
      room.unseen().forEach(sides::add);
    }
    looks(root, analysis.head());
    analysis.eyes().ifPresent(eyes -> eyes(root.putObject("eyes"), eyes, shown.map()));
    return root;
  }

  private static void eyes(ObjectNode root, EyeTrackingAnalysis eyes, SceneMap map) {
    root.put("tracked", DecimalRounding.to(3, eyes.tracked()));
    objects(root, eyes.looks(), map);
    for (JsonNode object : root.path("objects")) {
      ((ObjectNode) object).put("fixations", eyes.fixations(object.path("object").asText()).size());
    }
    looks(root, eyes.looks());
    ArrayNode fixations = root.putArray("fixations");
    for (Fixation fixation : eyes.fixations()) {
      fixations
          .addObject()
          .put("object", fixation.object())
          .put("start", DecimalRounding.to(3, fixation.start()))
          .put("end", DecimalRounding.to(3, fixation.end()));
    }
  }

  private static void objects(ObjectNode root, DwellSummary looks, SceneMap map) {
    ArrayNode objects = root.putArray("objects");
    for (DwellSummary.ObjectView view : looks.objects()) {
      objects
          .addObject()
          .put("object", view.object())
          .put("seconds", DecimalRounding.to(3, view.seconds()))
          .put("looks", view.looks())
          .put("first", DecimalRounding.to(3, view.first()))
          .put("longest", DecimalRounding.to(3, view.longest()))
          .put("surroundings", map.surrounds(view.object()));
    }
    ArrayNode unseen = root.putArray("unseen");
    looks.unseen().values().stream().flatMap(List::stream).sorted().forEach(unseen::add);
  }

  private static void looks(ObjectNode root, DwellSummary seen) {
    ArrayNode looks = root.putArray("looks");
    for (Dwell look : seen.all()) {
      ObjectNode node =
          looks
              .addObject()
              .put("object", look.object())
              .put("start", DecimalRounding.to(3, look.start()))
              .put("end", DecimalRounding.to(3, look.end()));
      if (look.version() >= 0) {
        node.put("version", look.version());
      }
    }
  }
}
