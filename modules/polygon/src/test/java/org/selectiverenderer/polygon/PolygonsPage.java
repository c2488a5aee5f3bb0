package org.selectiverenderer.polygon;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.selectiverenderer.chart.ChartFileWriter;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

/** Makes docs/polygons.md and its pictures: our counts beside the thesis's. */
final class PolygonsPage {
  private static final List<String> ROOMS = List.of("kitchen", "lounge", "office");
  private static final List<String> FIGURES = List.of("67 and 68", "69 and 70", "71 and 72");
  private static final List<String> TABLES =
      List.of("Table 3 and Fig 87", "Table 4 and Fig 88", "Table 5 and Fig 90");

  /** Percentages as Tables 3-5 print them, with a point for the comma. */
  private static final Map<String, String> PRINTED_PERCENT =
      Map.of(
          "KitchenSchema", "17.70",
          "LoungeSchema", "12.80",
          "SofaSchema", "23.90",
          "OfficeSchema", "23",
          "DeskSchema", "26.00",
          "BookcaseSchema", "54",
          "BookcaseSchema+DeskSchema", "56.80");

  private final SceneStatistics statistics;
  private final StringBuilder page = new StringBuilder();

  PolygonsPage(SceneStatistics statistics) {
    this.statistics = statistics;
  }

  /**
   * All files of the page, relative to docs.
   *
   * @param standIn whether the counts are of a scene that only has the thesis's numbers
   * @param scratch a folder for drawing in
   */
  Map<String, String> files(boolean standIn, Path scratch) throws IOException {
    Map<String, String> files = new LinkedHashMap<>();
    files.put("polygons.md", text(standIn));
    for (ScopeCount room : statistics.scopes()) {
      String name = "polygons-" + room.scope().toLowerCase(Locale.ROOT) + ".svg";
      Path file = scratch.resolve(name);
      ChartFileWriter.of(file)
          .orElseThrow()
          .write(
              "Polygons of " + Path.of(statistics.scene()).getFileName(),
              SceneStatisticsCharts.of(
                  new SceneStatistics(
                      statistics.scene(),
                      statistics.totalHigh(),
                      statistics.objectsOf(room),
                      List.of(room))));
      files.put("pictures/" + name, Files.readString(file));
    }
    return files;
  }

  private String text(boolean standIn) {
    paragraph("# Polygons of the apartment");
    paragraph(
        """
        What `./selective-renderer polygons scenes/apartment.x3d` counts, beside what the thesis lists (5.3, 6.2). A polygon is
        a triangle. Version 1 is an object as modelled, version 2 the reduced one.\
        """);
    if (standIn) {
      paragraph(
          "As long as that scene is missing, the counts are those of a stand-in with the thesis's"
              + " numbers.");
    }
    paragraph(
        """
        A test writes this page and its pictures, and fails when they are not what the program counts:

            mvn test -Dtest=PolygonsPageTest -Dpolygons.update=true\
        """);
    for (int i = 0; i < ROOMS.size(); i++) {
      room(ROOMS.get(i), FIGURES.get(i), TABLES.get(i));
    }
    misprints();
    method();
    return page.toString().stripTrailing() + "\n";
  }

  private void room(String room, String figures, String tables) {
    String title = title(room);
    ScopeCount scope =
        statistics.scopes().stream()
            .filter(candidate -> candidate.scope().equals(title))
            .findFirst()
            .orElseThrow();
    paragraph("## " + title);
    paragraph("![Bar charts of the %s's polygons](pictures/polygons-%1$s.svg)".formatted(room));
    paragraph("%s of the thesis, and ours:".formatted(tables));
    row("state", "printed", "sum of the objects", "ours", "printed %", "ours %");
    row("---", "---:", "---:", "---:", "---:", "---:");
    for (ThesisPolygonCounts.Total total : ThesisPolygonCounts.totals()) {
      if (total.area().equals(room)) {
        state(total, scope);
      }
    }
    page.append('\n');
    paragraph("Figs %s of the thesis, and ours:".formatted(figures));
    row("object", "v1 printed", "v1 ours", "v2 printed", "v2 ours", "v2 of v1");
    row("---", "---:", "---:", "---:", "---:", "---:");
    Map<String, ObjectCount> ours =
        statistics.objectsOf(scope).stream()
            .collect(Collectors.toMap(ObjectCount::switchName, object -> object));
    for (ThesisPolygonCounts.ThesisObject counted : ThesisPolygonCounts.objects()) {
      if (counted.area().equals(room)) {
        ObjectCount object = ours.get("Switch_" + title(counted.object()));
        row(
            counted.object(),
            number(counted.v1()),
            object == null ? "-" : number(object.versions().get(0)),
            number(counted.v2()),
            object == null ? "-" : number(object.versions().get(1)),
            object == null ? "-" : String.format(Locale.ROOT, "%.1f %%", object.percent(1)));
      }
    }
    page.append('\n');
  }

  private void state(ThesisPolygonCounts.Total total, ScopeCount scope) {
    String schemas = schemas(total.state());
    StateCount state =
        scope.states().stream()
            .filter(
                s -> s.schemas().stream().sorted().collect(Collectors.joining("+")).equals(schemas))
            .findFirst()
            .orElse(null);
    boolean high = total.state().equals("all objects high");
    long polygons = high ? scope.high() : state == null ? -1 : state.polygons();
    double percent = high ? 100 : state == null ? 0 : state.percent();
    row(
        total.state(),
        number(total.printed()) + (total.misprint() ? " (misprint)" : ""),
        number(total.recomputed()),
        polygons < 0 ? "-" : number(polygons),
        high ? "100" : PRINTED_PERCENT.get(schemas),
        String.format(Locale.ROOT, "%.2f", percent));
  }

  private void misprints() {
    paragraph("## Two misprints in the thesis");
    paragraph(
        """
        Eight of the ten printed totals are the sums of the listed objects and of one fixed number of polygons per room: that of
        the objects with a single version (walls, doors, lamps, inconsistent objects), 12,744 in the kitchen, 5,922 in the
        lounge and 5,184 in the office. The other two totals are misprints: the percentage printed beside them is that of the
        sum.\
        """);
    row("state", "printed", "is, of 291,489", "printed %", "sum", "is, of 291,489");
    row("---", "---:", "---:", "---:", "---:", "---:");
    for (ThesisPolygonCounts.Total total : ThesisPolygonCounts.totals()) {
      if (total.misprint()) {
        row(
            total.state(),
            number(total.printed()),
            String.format(Locale.ROOT, "%.2f %%", 100.0 * total.printed() / 291489),
            PRINTED_PERCENT.get(schemas(total.state())),
            number(total.recomputed()),
            String.format(Locale.ROOT, "%.2f %%", 100.0 * total.recomputed() / 291489));
      }
    }
    page.append('\n');
  }

  private void method() {
    paragraph("## How it is counted");
    paragraph(
        """
        - *All objects high*: every Switch with metadata of schemas shows its most detailed version.
        - A *state* has the versions that the controller shows, found by the same code: as loaded, after entering an area, and
          after entering overlapping areas one after the other.
        - A *scope* is an outermost named group that contains such Switches, here a room; `--scope` names others. An area
          belongs to the scope that contains its sensor, else to the scope around the centre of its box, else to those whose
          objects it changes.
        - Areas overlap if there is a point inside all of their boxes. A rotated box that is scaled unequally becomes slanted,
          and is treated so. Boxes that only touch do not overlap.
        - A LOD counts with its most detailed level. A Switch without metadata counts as the file says.
        - What Inlines contain counts like the scene itself: a file that is inlined twice is one object in two places.\
        """);
  }

  private static String schemas(String state) {
    return Stream.of(state.replaceFirst(" \\(.*", "").split(" and "))
        .sorted()
        .collect(Collectors.joining("+"));
  }

  private void paragraph(String text) {
    page.append(text).append("\n\n");
  }

  private void row(String... cells) {
    page.append("| ").append(String.join(" | ", cells)).append(" |\n");
  }

  private static String number(long value) {
    return String.format(Locale.ROOT, "%,d", value);
  }

  private static String title(String word) {
    return word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
  }
}
