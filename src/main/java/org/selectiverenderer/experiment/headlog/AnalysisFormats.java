package org.selectiverenderer.experiment.headlog;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.selectiverenderer.base.decimal.Counted;
import org.selectiverenderer.base.decimal.Rounded;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.base.json.JsonTree;

/** An analysis as text for people and as JSON. */
public final class AnalysisFormats {
  private AnalysisFormats() {}

  /** Several lines, the last one ended. */
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
    line(text, "");
    line(text, "%-32s %8s %6s %8s %8s", "in the middle of the view", "s", "looks", "first", "long");
    SceneMap map = analysis.log().description().map();
    views(text, analysis.objects().stream().filter(view -> !map.surrounds(view.object())));
    Set<String> notEntered =
        analysis.rooms().stream()
            .filter(room -> room.seconds() == 0)
            .map(RoomView::room)
            .collect(Collectors.toSet());
    analysis
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
    if (analysis.objects().stream().anyMatch(view -> map.surrounds(view.object()))) {
      line(text, "");
      line(text, "walls, floors, ceilings");
      views(text, analysis.objects().stream().filter(view -> map.surrounds(view.object())));
    }
    line(text, "");
    for (RoomView room : analysis.rooms()) {
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

  private static void views(StringBuilder text, Stream<HeadLogAnalysis.ObjectView> views) {
    views.forEach(
        view ->
            line(
                text,
                "%-32s %8.2f %6d %8.2f %8.2f",
                view.object(),
                view.seconds(),
                view.looks(),
                view.first(),
                view.longest()));
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
          Counted.of(unshown.pauses(), "time"),
          unshown.paused());
    }
  }

  private static void line(StringBuilder text, String format, Object... arguments) {
    text.append(String.format(Locale.ROOT, format, arguments)).append('\n');
  }

  /** One JSON object, several lines, the last one ended. */
  public static String json(HeadLogAnalysis analysis) {
    ObjectNode root = JsonTree.object();
    HeadLogDescription shown = analysis.log().description();
    root.put("scene", shown.scene()).put("condition", shown.condition());
    root.put("seconds", Rounded.to(3, analysis.seconds()));
    root.put("samples", analysis.log().samples().size() - analysis.unshown().samples());
    root.putObject("left_out")
        .put("seconds", Rounded.to(3, analysis.unshown().seconds()))
        .put("samples", analysis.unshown().samples())
        .put("pauses", analysis.unshown().pauses())
        .put("paused_seconds", Rounded.to(3, analysis.unshown().paused()));
    root.put("idle", Rounded.to(3, analysis.idle()));
    ArrayNode objects = root.putArray("objects");
    for (HeadLogAnalysis.ObjectView view : analysis.objects()) {
      objects
          .addObject()
          .put("object", view.object())
          .put("seconds", Rounded.to(3, view.seconds()))
          .put("looks", view.looks())
          .put("first", Rounded.to(3, view.first()))
          .put("longest", Rounded.to(3, view.longest()))
          .put("surroundings", shown.map().surrounds(view.object()));
    }
    ArrayNode unseen = root.putArray("unseen");
    analysis.unseen().values().stream().flatMap(List::stream).sorted().forEach(unseen::add);
    ArrayNode rooms = root.putArray("rooms");
    for (RoomView room : analysis.rooms()) {
      ArrayNode sides =
          rooms
              .addObject()
              .put("room", room.room())
              .put("seconds", Rounded.to(3, room.seconds()))
              .put("seen", Rounded.to(3, room.seen()))
              .putArray("unseen_sides");
      room.unseen().forEach(sides::add);
    }
    ArrayNode looks = root.putArray("looks");
    for (Dwell look : analysis.looks()) {
      ObjectNode node =
          looks
              .addObject()
              .put("object", look.object())
              .put("start", Rounded.to(3, look.start()))
              .put("end", Rounded.to(3, look.end()));
      if (look.version() >= 0) {
        node.put("version", look.version());
      }
    }
    return JsonText.of(root);
  }
}
