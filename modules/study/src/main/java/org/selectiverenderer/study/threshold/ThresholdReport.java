package org.selectiverenderer.study.threshold;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.threshold.ThresholdEstimate.Kind;

/** Formats the results of a threshold pilot as text and as JSON. */
public final class ThresholdReport {
  private ThresholdReport() {}

  /**
   * Returns a table with a legend, and the commands that make the versions.
   *
   * @param program the program's name on the command line
   * @param scene the scene's path in the commands
   */
  public static String text(ThresholdResults results, String program, String scene) {
    ThresholdStudy study = results.study();
    StringBuilder text = new StringBuilder();
    text.append(ControlCharacterEscaper.line(study.name()))
        .append(": ")
        .append(Pluralizer.of(results.participants(), "participant"))
        .append(
            study.task() == ThresholdTask.TELL_APART
                ? String.format(
                    Locale.ROOT,
                    "; polygons at which %.1f %% of the answers told the version from the original\n",
                    100 * study.rule().target())
                : "; fewest polygons with which the object was recognised\n");
    int width =
        results.objects().stream().mapToInt(object -> object.object().length()).max().orElse(6);
    text.append(
        String.format(
            Locale.ROOT,
            "%-" + Math.max(6, width) + "s %9s %6s %6s %6s %10s  %s\n",
            "object",
            "original",
            "found",
            "below",
            "above",
            "polygons",
            "95 % interval"));
    for (ObjectThreshold object : results.objects()) {
      text.append(
          String.format(
              Locale.ROOT,
              "%-" + Math.max(6, width) + "s %9s %6d %6d %6d %10s  %s\n",
              ControlCharacterEscaper.line(object.object()),
              object.original() == 0 ? "-" : object.original(),
              object.count(Kind.FOUND),
              object.count(Kind.BELOW),
              object.count(Kind.ABOVE),
              number(object.mean()),
              Double.isFinite(object.low())
                  ? number(object.low()) + " to " + number(object.high())
                  : "-"));
    }
    text.append(
        String.format(
            "below: even the fewest polygons shown were enough; above: even the most were not\n\n"));
    return text.toString() + results.commands(program, scene);
  }

  private static String number(double polygons) {
    return Double.isFinite(polygons) ? String.format(Locale.ROOT, "%.0f", polygons) : "-";
  }

  /** Returns the results as JSON; an unknown number is null. */
  public static String json(ThresholdResults results) {
    ObjectNode tree = JsonTree.object();
    tree.put("pilot", results.study().name());
    tree.put("task", results.study().task().spelling());
    tree.put("participants", results.participants());
    if (results.study().task() == ThresholdTask.TELL_APART) {
      tree.put("target", results.study().rule().target());
    }
    ArrayNode objects = tree.putArray("objects");
    for (ObjectThreshold object : results.objects()) {
      ObjectNode node = objects.addObject();
      node.put("object", object.object());
      node.put("original", object.original());
      node.put("found", object.count(Kind.FOUND));
      node.put("below", object.count(Kind.BELOW));
      node.put("above", object.count(Kind.ABOVE));
      node.put("open", object.count(Kind.OPEN));
      put(node, "mean", object.mean());
      put(node, "low", object.low());
      put(node, "high", object.high());
      object
          .wanted()
          .ifPresentOrElse(
              polygons -> node.put("polygons", polygons), () -> node.putNull("polygons"));
    }
    return JsonWriter.of(tree);
  }

  private static void put(ObjectNode node, String key, double number) {
    if (Double.isFinite(number)) {
      node.put(key, number);
    } else {
      node.putNull(key);
    }
  }
}
