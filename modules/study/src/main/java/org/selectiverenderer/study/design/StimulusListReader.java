package org.selectiverenderer.study.design;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.url.NetworkShare;

/**
 * Reads a stimulus list. Some columns determine what a trial shows: {@code condition}, {@code
 * scene}, {@code area}, {@code viewpoint}, {@code seconds}, {@code light} (on or off), {@code
 * choices} ({@code DEF=1 OTHER=-1}), {@code objects} (DEFs of the Switches that are present; those
 * that only other rows name are hidden). All columns may be used in texts as {@code {column}}. None
 * may have a name of {@link TrialColumns}.
 */
public final class StimulusListReader {
  private static final String UNUSED = "; the list is not used";

  /** A longer list is a mistake: a session of a second for each row would last a day. */
  private static final int MOST_ROWS = 100_000;

  private final Path file;
  private final ProblemCollector problems;

  private StimulusListReader(Path file, ProblemCollector problems) {
    this.file = file;
    this.problems = problems;
  }

  /**
   * Reads a list.
   *
   * @param problems receives the faults, each with line and column
   * @return empty if there are faults
   * @throws IOException if the file cannot be read
   */
  public static Optional<StimulusList> read(Path file, ProblemCollector problems)
      throws IOException {
    ProblemCollector own = new ProblemCollector(problems::add);
    Optional<CsvTable> table =
        CsvTable.parse(
            file.toString(),
            CsvTable.bytes(file),
            (at, message) -> own.error(at, message + UNUSED));
    Optional<StimulusList> list = table.map(new StimulusListReader(file, own)::list);
    return own.any() ? Optional.empty() : list;
  }

  private StimulusList list(CsvTable table) {
    List<String> columns = table.header();
    table.require(columns, String.join(",", columns));
    columns.stream()
        .filter(TrialColumns::reserved)
        .forEach(
            column ->
                problems.error(
                    table.location(column),
                    "the column '%s' cannot be told from that of the table of trials; give it another name%s"
                        .formatted(column, UNUSED)));
    if (table.rows().isEmpty()) {
      problems.error(SourceLocation.of(table.file()), "there are no stimuli" + UNUSED);
    } else if (table.rows().size() > MOST_ROWS) {
      problems.error(
          SourceLocation.of(table.file()),
          "there are %d stimuli, more than the %d of which a list can consist%s"
              .formatted(table.rows().size(), MOST_ROWS, UNUSED));
      return new StimulusList(file, columns, List.of());
    }
    Set<String> objects = new LinkedHashSet<>();
    table.rows().forEach(row -> objects.addAll(names(row.cellIfAny("objects"))));
    List<StimulusList.Stimulus> rows = new ArrayList<>();
    for (CsvRow row : table.rows()) {
      Map<String, String> cells = new LinkedHashMap<>();
      columns.forEach(column -> cells.put(column, row.cell(column)));
      rows.add(
          new StimulusList.Stimulus(
              row.location().line(), cells, settings(row, table.has("objects"), objects)));
    }
    return new StimulusList(file, columns, rows);
  }

  private TrialSettings settings(CsvRow row, boolean lists, Set<String> objects) {
    Map<String, Integer> choices = choices(row);
    if (lists) {
      List<String> present = names(row.cellIfAny("objects"));
      objects.stream()
          .filter(object -> !present.contains(object))
          .forEach(object -> choices.putIfAbsent(object, -1));
    }
    return new TrialSettings(
        condition(row),
        choices,
        scene(row),
        filled(row, "area"),
        filled(row, "viewpoint"),
        seconds(row),
        light(row),
        Optional.empty(),
        OptionalDouble.empty());
  }

  private static List<String> names(String cell) {
    return cell.isBlank() ? List.of() : List.of(cell.strip().split("\\s+"));
  }

  private static Optional<String> filled(CsvRow row, String column) {
    return Optional.of(row.cellIfAny(column)).filter(cell -> !cell.isEmpty());
  }

  private Map<String, Integer> choices(CsvRow row) {
    Map<String, Integer> choices = new LinkedHashMap<>();
    for (String choice : names(row.cellIfAny("choices"))) {
      int sign = choice.lastIndexOf('=');
      String number = choice.substring(sign + 1);
      if (sign < 1 || !number.matches("-?\\d{1,6}")) {
        problems.error(
            row.location("choices"),
            "'%s' is no choice of a Switch; write its DEF, an equals sign and a number, as in Vase=1%s"
                .formatted(choice, UNUSED));
      } else {
        choices.put(choice.substring(0, sign), Integer.parseInt(number));
      }
    }
    return choices;
  }

  private Optional<Condition> condition(CsvRow row) {
    Optional<String> named = filled(row, "condition");
    Optional<Condition> condition = named.flatMap(Condition::of);
    if (named.isPresent() && condition.isEmpty()) {
      problems.error(
          row.location("condition"),
          "'%s' is not a condition (high, high-low, selective or random)%s"
              .formatted(named.get(), UNUSED));
    }
    return condition;
  }

  private Optional<Path> scene(CsvRow row) {
    Optional<String> named = filled(row, "scene");
    if (named.isEmpty()) {
      return Optional.empty();
    }
    if (NetworkShare.is(named.get())) {
      problems.error(
          row.location("scene"),
          "'%s' is on another computer; name a file of this one%s".formatted(named.get(), UNUSED));
      return Optional.empty();
    }
    Path scene = file.toAbsolutePath().resolveSibling(named.get()).normalize();
    if (!Files.isRegularFile(scene)) {
      problems.error(
          row.location("scene"),
          "there is no file '%s' relative to the list%s".formatted(named.get(), UNUSED));
    }
    return Optional.of(scene);
  }

  private OptionalDouble seconds(CsvRow row) {
    if (filled(row, "seconds").isEmpty()) {
      return OptionalDouble.empty();
    }
    try {
      double seconds = Double.parseDouble(row.decimal("seconds"));
      if (seconds > 0 && seconds <= TrialPhase.LONGEST) {
        return OptionalDouble.of(seconds);
      }
    } catch (NumberFormatException e) {
      // The message below says what is needed.
    }
    problems.error(
        row.location("seconds"),
        "'%s' is no number of seconds above 0 and up to %.0f%s"
            .formatted(row.cell("seconds"), TrialPhase.LONGEST, UNUSED));
    return OptionalDouble.empty();
  }

  private Optional<Boolean> light(CsvRow row) {
    Optional<String> named = filled(row, "light").map(text -> text.toLowerCase(Locale.ROOT));
    if (named.isPresent() && !named.get().matches("on|off")) {
      problems.error(
          row.location("light"), "'%s' is not on or off%s".formatted(row.cell("light"), UNUSED));
    }
    return named.map("on"::equals);
  }
}
