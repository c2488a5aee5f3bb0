package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

/** The polygons over a walk: a table with known counts, and a curve. */
class SimulatePolygonCurveTest {
  @TempDir private Path folder;

  private CommandTestCase simulate(int status, String... arguments) {
    CommandTestCase command = new CommandTestCase();
    assertThat(command.execute(arguments)).as(command.messages()).isEqualTo(status);
    return command;
  }

  /** The trash can of Figs 52 and 78: 93 polygons in the office, 1064 at the desk. */
  @Test
  void theTableHasARowForEachChange() throws Exception {
    Path table = folder.resolve("polygons.csv");
    Path chart = folder.resolve("polygons.svg");

    simulate(
        0,
        "simulate",
        "scenes/trashcan.x3d",
        "--path",
        "scenes/paths/desk-visit.csv",
        "--polygons",
        table.toString(),
        "--chart",
        chart.toString());

    assertThat(Files.readAllLines(table)).first().isEqualTo("scene,t,polygons");
    long[] counts =
        Files.readAllLines(table).stream()
            .skip(1)
            .mapToLong(row -> Long.parseLong(row.substring(row.lastIndexOf(',') + 1)))
            .toArray();
    assertThat(counts).hasSize(4);
    assertThat(counts[1] - counts[0]).isEqualTo(1064 - 93);
    assertThat(counts[2]).isEqualTo(counts[0]);
    assertThat(counts[3]).isEqualTo(counts[2]);
    assertThat(chart).content().contains("<svg", "Polygons along desk-visit.csv", "trashcan.x3d");
  }

  @Test
  void severalScenesAreCurvesOfOneChart() {
    Path chart = folder.resolve("both.png");

    simulate(
        0,
        "simulate",
        "scenes/trashcan.x3d",
        "scenes/overlap.x3d",
        "--path",
        "scenes/paths/desk-visit.csv",
        "--chart",
        chart.toString());

    assertThat(chart).isNotEmptyFile();
  }

  @Test
  void aChartOfAnotherKindIsRefusedBeforeTheWalk() {
    CommandTestCase command =
        simulate(
            2,
            "simulate",
            "scenes/trashcan.x3d",
            "--path",
            "scenes/paths/desk-visit.csv",
            "--chart",
            folder.resolve("polygons.pdf").toString());

    assertThat(command.messages()).contains("--chart needs a file that ends in .svg or .png");
    assertThat(command.printed()).isEmpty();
  }
}
