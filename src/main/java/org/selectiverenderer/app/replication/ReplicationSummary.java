package org.selectiverenderer.app.replication;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Says how close a replication comes to what the thesis prints, a sentence for each kind. */
final class ReplicationSummary {
  private ReplicationSummary() {}

  /** A sentence, what it is about, and on what it rests. */
  record Line(String about, String basis, String finding) {}

  static List<Line> of(ReplicationFindings findings) {
    List<Line> lines = new ArrayList<>();
    List<ReplicationFindings.PolygonRow> polygons = findings.polygons();
    long exact = polygons.stream().filter(ReplicationFindings.PolygonRow::asRecomputed).count();
    long printed = polygons.stream().filter(ReplicationFindings.PolygonRow::asPrinted).count();
    lines.add(
        new Line(
            "Tables 3 to 5, polygons",
            "computed from the scene",
            ("%d of %d counts are the sums of the objects that the thesis lists; %d are as printed"
                    + " (two are misprints)")
                .formatted(exact, polygons.size(), printed)));
    List<KitchenRecomputation.Row> kitchen = findings.kitchen();
    lines.add(
        new Line(
            "Figs 93, 94, 97, 98, analyses of variance",
            "computed from the means of Figs 92 and 96",
            "%d of %d printed numbers come out, to the last digit"
                .formatted(
                    kitchen.stream().filter(KitchenRecomputation.Row::same).count(),
                    kitchen.size())));
    List<ReplicationFindings.ScoreMean> means =
        findings.scores().stream().filter(row -> !row.row().total()).toList();
    long near = means.stream().filter(ReplicationFindings.ScoreMean::near).count();
    lines.add(
        new Line(
            "Tables 6 to 11, means",
            "simulated",
            String.format(
                Locale.ROOT,
                "%d of %d means are within 2 standard errors of print (%.0f %%; chance alone"
                    + " leaves one in twenty outside)",
                near,
                means.size(),
                100.0 * near / Math.max(1, means.size()))));
    List<ReplicationFindings.EffectRow> effects = findings.effects();
    lines.add(
        new Line(
            "Tests of Figs 93 to 98 and of 6.5",
            "simulated",
            "%d of %d are decided alike at p < 0.05"
                .formatted(
                    effects.stream().filter(ReplicationFindings.EffectRow::agrees).count(),
                    effects.size())));
    return lines;
  }
}
