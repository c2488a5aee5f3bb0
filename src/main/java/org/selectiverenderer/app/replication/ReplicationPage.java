package org.selectiverenderer.app.replication;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.report.Provenance;

/** Writes the page of a replication, which loads nothing else. */
final class ReplicationPage {
  private static final String STYLE =
      """
      :root { color-scheme: light dark; --ink: #222; --faint: #555; --paper: #fff; --line: #ccc;
        --good: #00664a; --off: #a04000; }
      body { font: 15px/1.5 'DejaVu Sans', Verdana, sans-serif; color: var(--ink);
        background: var(--paper); max-width: 74rem; margin: 2rem auto; padding: 0 1rem; }
      p, ul { max-width: 62rem; }
      h1 { font-size: 1.6rem; } h2 { font-size: 1.3rem; margin-top: 2.2rem;
        border-bottom: 1px solid var(--line); } h3 { font-size: 1.05rem; }
      table { border-collapse: collapse; margin: .8rem 0; font-size: 13px; }
      th, td { padding: .22rem .5rem; text-align: right; vertical-align: top; }
      th:first-child, td:first-child, td.words, th.words { text-align: left; }
      thead th { border-top: 2px solid var(--ink); border-bottom: 1px solid var(--ink); }
      tbody tr:last-child td { border-bottom: 2px solid var(--ink); }
      td.off { color: var(--off); font-weight: bold; } td.good { color: var(--good); }
      .wide { overflow-x: auto; } .note { font-size: 13px; color: var(--faint); }
      figure { display: inline-block; margin: .4rem .8rem .4rem 0; } svg { max-width: 100%; height: auto; }
      @media (prefers-color-scheme: dark) {
        :root { --ink: #e6e6e6; --faint: #b4b4b4; --paper: #16181b; --line: #44484d; --good: #62d2ad;
          --off: #ffa366; }
        a { color: #8cc4ff; }
        svg [fill="#ffffff"] { fill: #16181b; } svg [fill="#222222"] { fill: #e6e6e6; }
        svg [fill="#5a5a5a"] { fill: #b4b4b4; } svg [fill="#dddddd"] { fill: #33373c; }
      }
      @media print { :root { --ink: #000; --paper: #fff; } body { max-width: none; font-size: 11px; }
        table { font-size: 9px; } .wide { overflow: visible; } figure, tr { break-inside: avoid; } }
      """;

  private final ReplicationFindings findings;
  private final ReplicationCharts charts = new ReplicationCharts();
  private final StringBuilder out = new StringBuilder();

  private ReplicationPage(ReplicationFindings findings) {
    this.findings = findings;
  }

  /**
   * Returns the page.
   *
   * @param held cells whose printed means no observer has at all three levels of confidence
   */
  static String html(
      Replication replication,
      ReplicationFindings findings,
      List<String> held,
      Provenance provenance) {
    ReplicationPage page = new ReplicationPage(findings);
    page.head(replication, provenance);
    page.summary();
    page.polygons();
    page.kitchen();
    page.scores(held);
    page.effects();
    page.limits();
    return page.out.append("</body>\n</html>\n").toString();
  }

  private void head(Replication replication, Provenance provenance) {
    String title = "The thesis's study, made anew";
    out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
        .append("<meta name=\"viewport\" content=\"width=device-width\">\n<title>")
        .append(title)
        .append("</title>\n<style>\n")
        .append(STYLE)
        .append("</style>\n</head>\n<body>\n<h1>")
        .append(title)
        .append("</h1>\n");
    paragraph(
        ("A. Zotos, A real time selective rendering algorithm based on spatial cognition, chapters 5"
                + " and 6: what the thesis prints, beside what %s %s computes and simulates."
                + " %d simulated participants, seed %d, %s%s.")
            .formatted(
                provenance.program(),
                provenance.version(),
                replication.participants(),
                replication.seed(),
                replication.scene().getFileName(),
                provenance.dated() ? ", " + provenance.date() : ""));
    out.append(
        """
        <p>In this folder: the <a href="study/study.json">study</a> with its sessions (go on with
        <code>experiment status study</code>), its <a href="plan.html">plan of groups</a>, all
        <a href="responses.csv">answers to the memory lists</a> and <a href="answers.csv">to the other
        questions</a>, and the <a href="report.html">report of the analysis</a>, as
        <code>experiment analyse responses.csv --guesses no</code> makes it.</p>
        """);
  }

  private void summary() {
    heading("How close");
    table(
        List.of("results", "rest on", "reproduced"),
        ReplicationSummary.of(findings).stream()
            .map(line -> List.of(cell(line.about()), words(line.basis()), words(line.finding())))
            .toList());
    paragraph(
        "Computed results say that the thesis's numbers follow from what it says of its objects and"
            + " its scores. Simulated results say only that plan, sessions, files and analysis carry"
            + " known means to the end: the participants have the printed means because they were"
            + " made to have them.");
  }

  private void polygons() {
    heading("Tables 3 to 5: polygons of what is active");
    out.append("<figure>").append(charts.polygons(findings.polygons())).append("</figure>\n");
    table(
        List.of("Table", "state", "printed", "counted", "difference", "why"),
        findings.polygons().stream()
            .map(
                row -> {
                  ThesisTables.PolygonTotal total = row.total();
                  String counted =
                      row.counted().isPresent() ? grouped(row.counted().getAsLong()) : "none";
                  String difference =
                      row.counted().isPresent()
                          ? grouped(row.counted().getAsLong() - total.printed())
                          : "\u2013";
                  String why =
                      !row.asRecomputed()
                          ? "the scene is not the thesis's apartment"
                          : total.note();
                  return List.of(
                      cell(total.table()),
                      words(state(total)),
                      cell(grouped(total.printed())),
                      cell(counted),
                      row.asPrinted() ? good(difference) : off(difference),
                      words(why));
                })
            .toList());
  }

  private void kitchen() {
    heading("Figs 92 to 98: analyses of variance of the kitchen");
    paragraph(
        "F of balanced groups depends on the data by their means, standard deviations and covariance"
            + " only. Data built with those of Figs 92 and 96, and with the covariance that the error"
            + " terms imply, go through the analysis of experiment analyse. Where the computed number is"
            + " the printed one it stands once; where not, print stands first.");
    List<String> statistics = List.of("ss", "ms", "F", "p", "pillai", "wilks", "hotelling", "roy");
    Map<List<String>, Map<String, String>> effects = new LinkedHashMap<>();
    for (KitchenRecomputation.Row row : findings.kitchen()) {
      ThesisTables.KitchenFigure figure = row.figure();
      effects
          .computeIfAbsent(
              List.of(
                  cell("Fig " + figure.figure()),
                  words(figure.measure().equals("dprime") ? "d\u2032" : "log \u03b2"),
                  words(figure.effect())),
              key -> new LinkedHashMap<>())
          .put(
              figure.statistic(),
              row.same() ? good(row.computed()) : off(figure.printed() + " / " + row.computed()));
    }
    List<List<String>> rows = new ArrayList<>();
    effects.forEach(
        (names, values) -> {
          List<String> cells = new ArrayList<>(names);
          statistics.forEach(name -> cells.add(values.getOrDefault(name, cell(""))));
          rows.add(cells);
        });
    table(
        List.of(
            "figure",
            "measure",
            "effect",
            "SS",
            "MS",
            "F",
            "p",
            "Pillai",
            "Wilks",
            "Hotelling",
            "Roy"),
        rows);
    paragraph(
        String.format(
            Locale.ROOT,
            "The text to Fig 94 says F(2, 51) = 0.560. That is the mean square, %.3f; F is 2.317 in"
                + " the figure, and p = 0.109 in both belongs to it.",
            KitchenRecomputation.meanSquareOfGroups()));
  }

  private void scores(List<String> held) {
    heading("Tables 6 to 11: d\u2032 and log \u03b2");
    paragraph(
        "Means by condition for all answers: a bar where the thesis has them, a dot with its standard"
            + " error where the simulated participants have them.");
    List<String> areas =
        findings.scores().stream().map(row -> row.row().area()).distinct().toList();
    for (String area : areas) {
      for (DetectionMeasure measure :
          List.of(DetectionMeasure.D_PRIME, DetectionMeasure.LOG_BETA)) {
        String title = area + ", " + measure.symbol();
        out.append("<figure>")
            .append(
                charts.means(
                    title,
                    findings.scores().stream()
                        .filter(row -> row.row().area().equals(area))
                        .filter(row -> !row.row().total() && row.measure() == measure)
                        .filter(row -> row.level() == ConfidenceThreshold.ALL)
                        .toList()))
            .append("</figure>\n");
      }
    }
    for (String area : areas) {
      area(area);
    }
    paragraph(
        "Mean (standard deviation): printed / simulated. A simulated mean more than 2 standard errors"
            + " from print is marked. The standard deviations of all answers were fitted too; those of"
            + " the other levels follow from the model. Where print has less than counts of so few"
            + " objects scatter by themselves (inconsistent objects beside the sofa: 0.36), no"
            + " independent answers that are scored like this have it.");
    if (!held.isEmpty()) {
      paragraph(
          "Nobody who says \u201cyes\u201d less often the more confidence is asked for has all printed means"
              + " of: "
              + String.join("; ", held)
              + ". There the rates stay what they are at the level before.");
    }
    if (!findings.totals().isEmpty()) {
      List<String> totals = new ArrayList<>();
      findings
          .totals()
          .forEach(
              total ->
                  totals.add(
                      String.format(
                          Locale.ROOT,
                          "Table %d, %s %s, %s at %s: printed %.2f, mean %.3f",
                          total.row().table(),
                          total.row().area(),
                          total.row().type(),
                          total.measure().symbol(),
                          total.level().title(),
                          total.printed(),
                          total.mean())));
      paragraph(
          "Misprints: the rows \u201ctotal\u201d are means of the three above them, cut off after two decimals,"
              + " but for: "
              + String.join("; ", totals)
              + ".");
    }
  }

  private void area(String area) {
    List<ReplicationFindings.ScoreMean> own =
        findings.scores().stream().filter(row -> row.row().area().equals(area)).toList();
    ThesisTables.ScoreRow first = own.get(0).row();
    out.append("<h3>Table ").append(first.table()).append(": ").append(area).append("</h3>\n");
    List<String> header = new ArrayList<>(List.of("objects", "condition"));
    for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
      header.add("d\u2032, " + level.heading());
      header.add("log \u03b2, " + level.heading());
    }
    List<List<String>> rows = new ArrayList<>();
    List<ThesisTables.ScoreRow> printed =
        own.stream().map(ReplicationFindings.ScoreMean::row).distinct().toList();
    for (ThesisTables.ScoreRow row : printed) {
      List<String> cells = new ArrayList<>();
      cells.add(cell(row.type().equals("neutral") ? "all" : row.type()));
      cells.add(words(row.condition()));
      for (ReplicationFindings.ScoreMean mean : own) {
        if (mean.row().equals(row)) {
          String text =
              number(mean.printed())
                  + " ("
                  + number(mean.printedSd())
                  + ") / "
                  + number(mean.mean())
                  + " ("
                  + number(mean.sd())
                  + ")";
          cells.add(mean.near() || row.total() ? cell(text) : off(text));
        }
      }
      rows.add(cells);
    }
    table(header, rows);
    for (ThesisTables.ScoreRow row : printed) {
      long present =
          own.stream().filter(one -> one.row().equals(row)).findFirst().orElseThrow().present();
      if (row.total() && present != row.objects()) {
        out.append("<p class=\"note\">")
            .append(
                MarkupEscaper.attribute(
                    "%s: the table has O = %d, our list %d present objects"
                        .formatted(row.type(), row.objects(), present)))
            .append("</p>\n");
      }
    }
  }

  private void effects() {
    heading("Tests that the thesis tells");
    table(
        List.of(
            "source",
            "area",
            "confidence",
            "measure",
            "effect",
            "printed",
            "p",
            "simulated",
            "p",
            "from the tables"),
        findings.effects().stream()
            .map(
                row -> {
                  ThesisTables.PrintedEffect printed = row.printed();
                  String simulated =
                      row.simulated()
                          .map(effect -> f(effect.df1(), effect.df2(), effect.f()))
                          .orElse("\u2013");
                  String p =
                      row.simulated().map(Effect::p).map(ReplicationPage::p).orElse("\u2013");
                  return List.of(
                      cell(printed.source()),
                      words(printed.area()),
                      words(printed.level().title()),
                      words(printed.measure().symbol()),
                      words(printed.effect()),
                      cell(f(printed.df1(), printed.df2(), printed.f())),
                      cell(p(row.printedP())),
                      cell(simulated),
                      row.agrees() ? good(p) : off(p),
                      words(PrintedTests.remark(printed)));
                })
            .toList());
    paragraph(
        "F of the simulated answers differs from print by chance, and because the tables print no"
            + " covariance between the types of objects: simulated participants answer about each type"
            + " independently, as the covariance near 0 in the kitchen suggests. The last column is"
            + " computed from print: where objects are of one type, F of conditions; else the"
            + " correlation between a participant\u2019s two scores that F implies.");
  }

  private void limits() {
    heading("What this cannot say");
    out.append(
        """
        <ul>
        <li><b>Whether the thesis is right.</b> A simulation puts in what it gets out. Only people who see
        the apartment can replicate its result; docs/replication.md says what that takes.</li>
        <li><b>That the conditions do not differ.</b> The thesis argues from large p. With 18 in a group a
        large p is what one finds also when conditions do differ; the report has tests of equivalence and
        Bayes factors beside each.</li>
        <li><b>What the answers of single participants were.</b> Means and standard deviations are printed,
        scores are not. Covariances between areas and levels of confidence are assumed.</li>
        <li><b>How extreme rates were corrected.</b> The thesis does not say; here 0.5 is added to counts and
        1 to totals, and answers without confidence count as \u201cno\u201d, as its tables suggest.</li>
        </ul>
        """);
  }

  /** Returns the name of a state of the scene, such as {@code Office: DeskSchema}. */
  static String state(ThesisTables.PolygonTotal total) {
    return total.area()
        + ": "
        + (total.schemas().isEmpty() ? "all objects high" : total.schemas().replace("+", " + "));
  }

  private void heading(String text) {
    out.append("<h2>").append(text).append("</h2>\n");
  }

  private void paragraph(String text) {
    out.append("<p>").append(MarkupEscaper.attribute(text)).append("</p>\n");
  }

  private void table(List<String> header, List<List<String>> rows) {
    out.append("<div class=\"wide\"><table>\n<thead><tr>");
    for (int i = 0; i < header.size(); i++) {
      boolean words = rows.get(0).get(i).contains("\"words\"");
      out.append(words ? "<th class=\"words\">" : "<th>").append(header.get(i)).append("</th>");
    }
    out.append("</tr></thead>\n<tbody>\n");
    for (List<String> row : rows) {
      out.append("<tr>");
      row.forEach(out::append);
      out.append("</tr>\n");
    }
    out.append("</tbody>\n</table></div>\n");
  }

  private static String cell(String text) {
    return "<td>" + MarkupEscaper.attribute(text) + "</td>";
  }

  private static String words(String text) {
    return "<td class=\"words\">" + MarkupEscaper.attribute(text) + "</td>";
  }

  private static String good(String text) {
    return "<td class=\"good\">" + MarkupEscaper.attribute(text) + "</td>";
  }

  private static String off(String text) {
    return "<td class=\"off\">" + MarkupEscaper.attribute(text) + "</td>";
  }

  private static String grouped(long number) {
    return String.format(Locale.ROOT, "%,d", number).replace('-', '\u2212');
  }

  private static String number(double value) {
    String text = String.format(Locale.ROOT, "%.2f", value);
    return text.equals("-0.00") ? "0.00" : text.replace('-', '\u2212');
  }

  private static String f(double df1, double df2, double f) {
    return String.format(Locale.ROOT, "F(%.0f, %.0f) = %.3f", df1, df2, f);
  }

  private static String p(double p) {
    return p < 0.001 ? "< 0.001" : String.format(Locale.ROOT, "%.3f", p);
  }
}
