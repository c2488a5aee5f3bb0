package org.selectiverenderer.study.rehearsal;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import java.util.stream.IntStream;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.study.session.StudyPlan;

/** Writes a plan as text for people, as a table with a row for each trial, and as HTML. */
public final class PlanReport {
  /** Number of trials of a block that the text names. */
  private static final int MOST_TRIALS = 12;

  private static final String STYLE =
      "body{font:11pt/1.4 sans-serif;margin:1.5cm;color:#222;max-width:75em}"
          + "table{border-collapse:collapse;margin:.6em 0}"
          + "th,td{border:1px solid #bbb;padding:2px 8px;text-align:right}"
          + "th:first-child,td:first-child{text-align:left}"
          + ".next{background:#fff3c4}svg{max-width:100%;height:auto}"
          + ".error{color:#a00000}.warning{color:#8a5a00}";

  private PlanReport() {}

  /** Returns the plan as text: who comes next, a line for each block of each place, the balance. */
  public static String text(StudyPlan plan) {
    StringBuilder text = new StringBuilder(ControlCharacterEscaper.line(plan.study().name()));
    text.append(": place ").append(plan.next()).append(" is next\n\n");
    for (StudyPlan.Place place : plan.places()) {
      text.append(
          String.format(
              Locale.ROOT,
              "%s%-5d %-14s %s\n",
              place.number() == plan.next() ? ">" : " ",
              place.number(),
              place.group().name(),
              place.participant().map(id -> "sub-" + id).orElse("-")));
      for (StudyPlan.Block block : place.blocks()) {
        text.append("        ").append(line(block)).append('\n');
      }
    }
    text.append('\n');
    PlanBalance.of(plan).forEach(each -> text.append(each.sentence()).append('\n'));
    return text.toString();
  }

  private static String line(StudyPlan.Block block) {
    if (block.trials().isEmpty()) {
      return block.name() + ": " + block.open().orElse("no order");
    }
    StringJoiner names = new StringJoiner(", ");
    block.trials().stream()
        .limit(MOST_TRIALS)
        .forEach(
            trial ->
                names.add(
                    ControlCharacterEscaper.line(trial.combination())
                        + (trial.line() > 0 && !trial.levels().isEmpty()
                            ? " (line " + trial.line() + ")"
                            : "")));
    int more = block.trials().size() - MOST_TRIALS;
    return block.name() + ": " + names + (more > 0 ? " and " + more + " more" : "");
  }

  /** Returns a table: place, participant, group, block, trial, combination, line, levels. */
  public static String csv(StudyPlan plan) {
    CsvWriter csv = new CsvWriter();
    csv.row(
        "place",
        "participant",
        "next",
        "group",
        "block",
        "trial",
        "combination",
        "line",
        "levels",
        "stimulus");
    for (StudyPlan.Place place : plan.places()) {
      for (StudyPlan.Block block : place.blocks()) {
        for (StudyPlan.PlannedTrial trial : block.trials()) {
          csv.row(
              place.number(),
              place.participant().orElse(""),
              place.number() == plan.next() ? "yes" : "no",
              place.group().name(),
              block.name(),
              trial.number(),
              trial.combination(),
              trial.line() == 0 ? "" : trial.line(),
              joined(trial.levels()),
              joined(trial.stimulus()));
        }
        if (block.trials().isEmpty()) {
          csv.row(
              place.number(),
              place.participant().orElse(""),
              place.number() == plan.next() ? "yes" : "no",
              place.group().name(),
              block.name(),
              "",
              block.open().orElse("no order"),
              "",
              "",
              "");
        }
      }
    }
    return csv.toString();
  }

  private static String joined(Map<String, String> values) {
    StringJoiner all = new StringJoiner("; ");
    values.forEach((name, value) -> all.add(name + "=" + value));
    return all.toString();
  }

  /** Returns the plan as a page of its own. */
  public static String html(StudyPlan plan) {
    return page("Plan of " + plan.study().name(), section(plan));
  }

  /** Returns a page with a heading. */
  public static String page(String title, String content) {
    String heading = MarkupEscaper.attribute(title);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>"
        + heading
        + "</title>\n<style>"
        + STYLE
        + "</style></head>\n<body>\n<h1>"
        + heading
        + "</h1>\n"
        + content
        + "</body>\n</html>\n";
  }

  /** Returns the picture of the plan and the tables of its balance, for a page. */
  public static String section(StudyPlan plan) {
    StringBuilder html = new StringBuilder();
    html.append("<p class=\"next\">Place ").append(plan.next()).append(" is next.</p>\n");
    html.append("<h2>Plan</h2>\n").append(new PlanPicture(plan).svg()).append('\n');
    if (plan.places().size() > PlanPicture.MOST_PLACES) {
      html.append(
          "<p>The first %d of %d places are drawn.</p>\n"
              .formatted(PlanPicture.MOST_PLACES, plan.places().size()));
    }
    List<PlanBalance> balances = PlanBalance.of(plan);
    if (!balances.isEmpty()) {
      html.append("<h2>Balance</h2>\n");
    }
    for (PlanBalance balance : balances) {
      html.append("<p>").append(MarkupEscaper.attribute(balance.sentence())).append(".</p>\n");
      html.append(table(balance, "at place", numbers(balance), balance.atPlace()));
      html.append(table(balance, "directly after", balance.combinations(), balance.after()));
    }
    return html.toString();
  }

  private static List<String> numbers(PlanBalance balance) {
    return IntStream.rangeClosed(1, balance.atPlace().get(0).size())
        .mapToObj(Integer::toString)
        .toList();
  }

  private static String table(
      PlanBalance balance, String corner, List<String> columns, List<List<Integer>> counts) {
    StringBuilder html = new StringBuilder("<table><tr><th>").append(corner).append("</th>");
    columns.forEach(
        name -> html.append("<th>").append(MarkupEscaper.attribute(name)).append("</th>"));
    html.append("</tr>\n");
    for (int row = 0; row < counts.size(); row++) {
      html.append("<tr><td>")
          .append(MarkupEscaper.attribute(balance.combinations().get(row)))
          .append("</td>");
      counts.get(row).forEach(count -> html.append("<td>").append(count).append("</td>"));
      html.append("</tr>\n");
    }
    return html.append("</table>\n").toString();
  }
}
