package org.selectiverenderer.app.replication;

import static org.selectiverenderer.app.replication.HtmlPage.cell;
import static org.selectiverenderer.app.replication.HtmlPage.good;
import static org.selectiverenderer.app.replication.HtmlPage.off;
import static org.selectiverenderer.app.replication.HtmlPage.words;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.report.Provenance;

/** Says on a page what the thesis prints, beside what a replication counts and simulates. */
final class ReplicationPage {
  private final ReplicationFindings findings;
  private final ReplicationCharts charts = new ReplicationCharts();
  private final HtmlPage html = new HtmlPage("The thesis's study, made anew");

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
    return page.html.close();
  }

  private void head(Replication replication, Provenance provenance) {
    html.paragraph(
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
    html.markup(
        """
        <p>In this folder: the <a href="study/study.json">study</a> with its sessions (go on with
        <code>experiment status study</code>), its <a href="plan.html">plan of groups</a>, all
        <a href="responses.csv">answers to the memory lists</a> and <a href="answers.csv">to the other
        questions</a>, and the <a href="report.html">report of the analysis</a>, as
        <code>experiment analyse responses.csv --guesses no</code> makes it.</p>
        """);
  }

  private void summary() {
    html.heading("How close");
    html.table(
        List.of("results", "rest on", "reproduced"),
        ReplicationSummary.of(findings).stream()
            .map(line -> List.of(cell(line.about()), words(line.basis()), words(line.finding())))
            .toList());
    html.paragraph(
        "Computed results say that the thesis's numbers follow from what it says of its objects and"
            + " its scores. Simulated results say only that plan, sessions, files and analysis carry"
            + " known means to the end: the participants have the printed means because they were"
            + " made to have them.");
  }

  private void polygons() {
    html.heading("Tables 3 to 5: polygons of what is active");
    html.figure(charts.polygons(findings.polygons()));
    html.table(
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
    html.heading("Figs 92 to 98: analyses of variance of the kitchen");
    html.paragraph(
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
    html.table(
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
    html.paragraph(
        String.format(
            Locale.ROOT,
            "The text to Fig 94 says F(2, 51) = 0.560. That is the mean square, %.3f; F is 2.317 in"
                + " the figure, and p = 0.109 in both belongs to it.",
            KitchenRecomputation.meanSquareOfGroups()));
  }

  private void scores(List<String> held) {
    html.heading("Tables 6 to 11: d\u2032 and log \u03b2");
    html.paragraph(
        "Means by condition for all answers: a bar where the thesis has them, a dot with its standard"
            + " error where the simulated participants have them.");
    List<String> areas =
        findings.scores().stream().map(row -> row.row().area()).distinct().toList();
    for (String area : areas) {
      for (DetectionMeasure measure :
          List.of(DetectionMeasure.D_PRIME, DetectionMeasure.LOG_BETA)) {
        String title = area + ", " + measure.symbol();
        html.figure(
            charts.means(
                title,
                findings.scores().stream()
                    .filter(row -> row.row().area().equals(area))
                    .filter(row -> !row.row().total() && row.measure() == measure)
                    .filter(row -> row.level() == ConfidenceThreshold.ALL)
                    .toList()));
      }
    }
    for (String area : areas) {
      area(area);
    }
    html.paragraph(
        "Mean (standard deviation): printed / simulated. A simulated mean more than 2 standard errors"
            + " from print is marked. The standard deviations of all answers were fitted too; those of"
            + " the other levels follow from the model. Where print has less than counts of so few"
            + " objects scatter by themselves (inconsistent objects beside the sofa: 0.36), no"
            + " independent answers that are scored like this have it.");
    if (!held.isEmpty()) {
      html.paragraph(
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
      html.paragraph(
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
    html.tableTitle("Table " + first.table() + ": " + area);
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
    html.table(header, rows);
    for (ThesisTables.ScoreRow row : printed) {
      long present =
          own.stream().filter(one -> one.row().equals(row)).findFirst().orElseThrow().present();
      if (row.total() && present != row.objects()) {
        html.note(
            "%s: the table has O = %d, our list %d present objects"
                .formatted(row.type(), row.objects(), present));
      }
    }
  }

  private void effects() {
    html.heading("Tests that the thesis tells");
    html.table(
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
    html.paragraph(
        "F of the simulated answers differs from print by chance, and because the tables print no"
            + " covariance between the types of objects: simulated participants answer about each type"
            + " independently, as the covariance near 0 in the kitchen suggests. The last column is"
            + " computed from print: where objects are of one type, F of conditions; else the"
            + " correlation between a participant\u2019s two scores that F implies.");
  }

  private void limits() {
    html.heading("What this cannot say");
    html.markup(
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
