package org.selectiverenderer.app.rehearsal;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.rehearsal.PlanBalance;
import org.selectiverenderer.study.rehearsal.PlanReport;

/** Writes what a check has found as text, JSON and HTML. */
public final class StudyCheckReport {
  private StudyCheckReport() {}

  private static long count(List<Problem> found) {
    return found.stream().filter(problem -> problem.severity() != Problem.Severity.INFO).count();
  }

  private static String verdict(StudyCheck check, List<Problem> found) {
    String name = ControlCharacterEscaper.line(check.material().study().name());
    return count(found) == 0
        ? name + ": the study is sound"
        : name + ": " + Pluralizer.of((int) count(found), "finding");
  }

  private static String duration(StudyCheck check) {
    int participants = check.material().study().participants();
    return String.format(
        Locale.ROOT,
        "a session takes about %d min, the study with its %s about %.1f h (assumed: %s)",
        check.duration().minutes(),
        Pluralizer.of(participants, "participant"),
        check.duration().seconds() * participants / 3600,
        check.duration().assumed().sentence());
  }

  /** Returns the report as text; the findings themselves are told as they are found. */
  public static String text(StudyCheck check, List<Problem> found) {
    StringBuilder text = new StringBuilder(verdict(check, found)).append('\n');
    text.append(duration(check)).append('\n');
    PlanBalance.of(check.plan()).forEach(balance -> text.append(balance.sentence()).append('\n'));
    text.append(languages(check)).append('\n');
    text.append("place ").append(check.plan().next()).append(" is next\n");
    text.append(free(check)).append('\n');
    if (!check.polygons().isEmpty()) {
      text.append("\npolygons at the begin\n");
    }
    check
        .polygons()
        .forEach(
            (view, polygons) ->
                text.append(
                    String.format(
                        Locale.ROOT, "%10d  %s\n", polygons, ControlCharacterEscaper.line(view))));
    if (check.left() > 0) {
      text.append(more(check)).append('\n');
    }
    return text.toString();
  }

  private static String languages(StudyCheck check) {
    List<String> languages = check.material().study().languages();
    return (languages.size() == 1 ? "language: " : "languages, the first unless --language: ")
        + String.join(", ", languages);
  }

  private static String free(StudyCheck check) {
    return String.format(Locale.ROOT, "%.1f GB of the disk are free", check.free() / 1e9);
  }

  private static String more(StudyCheck check) {
    return "%s more of what participants see: their names are checked, their polygons are not counted"
        .formatted(check.left());
  }

  /** Returns the findings as JSON. */
  public static String json(List<Problem> found) {
    return JsonWriter.of(tree(found));
  }

  private static ObjectNode tree(List<Problem> found) {
    ObjectNode root = JsonTree.object();
    root.put("sound", count(found) == 0);
    ArrayNode all = root.putArray("findings");
    for (Problem problem : found) {
      all.addObject()
          .put("severity", problem.severity().name().toLowerCase(Locale.ROOT))
          .put("file", problem.location().file())
          .put("line", problem.location().line())
          .put("column", problem.location().column())
          .put("message", problem.message());
    }
    return root;
  }

  /** Returns the findings and figures as JSON. */
  public static String json(StudyCheck check, List<Problem> found) {
    ObjectNode root = tree(found);
    root.put("study", check.material().study().name());
    root.put("participants", check.material().study().participants());
    root.put("next_place", check.plan().next());
    root.put("session_s", Math.round(check.duration().seconds()));
    check.material().study().languages().forEach(root.putArray("languages")::add);
    root.put("free_bytes", check.free());
    ArrayNode balances = root.putArray("balance");
    for (PlanBalance balance : PlanBalance.of(check.plan())) {
      ObjectNode node = balances.addObject().put("block", balance.block());
      balance.combinations().forEach(node.putArray("combinations")::add);
      ArrayNode places = node.putArray("at_place");
      balance.atPlace().forEach(row -> row.forEach(places.addArray()::add));
      ArrayNode after = node.putArray("after");
      balance.after().forEach(row -> row.forEach(after.addArray()::add));
      node.put("places_balanced", balance.placesBalanced());
      node.put("neighbours_balanced", balance.neighboursBalanced());
    }
    ArrayNode views = root.putArray("views");
    check
        .polygons()
        .forEach((view, polygons) -> views.addObject().put("view", view).put("polygons", polygons));
    return JsonWriter.of(root);
  }

  /** Returns a page with the findings of a study that cannot be read. */
  public static String html(List<Problem> found) {
    return PlanReport.page("Check of a study", findings(found));
  }

  /** Returns a page with findings, figures and the picture of the plan. */
  public static String html(StudyCheck check, List<Problem> found) {
    StringBuilder html = new StringBuilder();
    paragraph(html, verdict(check, found) + ".");
    html.append(findings(found));
    paragraph(html, duration(check) + ".");
    paragraph(html, languages(check) + ".");
    paragraph(html, free(check) + ".");
    if (!check.polygons().isEmpty()) {
      html.append("<h2>Polygons at the begin</h2>\n<table>\n");
      check
          .polygons()
          .forEach(
              (view, polygons) ->
                  html.append("<tr><td>")
                      .append(MarkupEscaper.attribute(view))
                      .append("</td><td>")
                      .append(polygons)
                      .append("</td></tr>\n"));
      html.append("</table>\n");
    }
    if (check.left() > 0) {
      paragraph(html, more(check) + ".");
    }
    html.append(PlanReport.section(check.plan()));
    return PlanReport.page("Check of " + check.material().study().name(), html.toString());
  }

  private static void paragraph(StringBuilder html, String text) {
    html.append("<p>").append(MarkupEscaper.attribute(text)).append("</p>\n");
  }

  private static String findings(List<Problem> found) {
    StringBuilder html = new StringBuilder("<ul>\n");
    for (Problem problem : found) {
      html.append("<li class=\"")
          .append(problem.severity().name().toLowerCase(Locale.ROOT))
          .append("\">")
          .append(MarkupEscaper.attribute(problem.toString()))
          .append("</li>\n");
    }
    return html.append("</ul>\n").toString();
  }
}
