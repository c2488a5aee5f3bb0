package org.selectiverenderer.statistics.data;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.csv.CsvColumns;
import org.selectiverenderer.base.csv.CsvNumbers;
import org.selectiverenderer.base.csv.CsvRow;
import org.selectiverenderer.base.csv.CsvTable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.statistics.anova.Design;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.Subject;

/**
 * Reads measurements in long form, one row for each subject and level of the within factor, into a
 * design. Levels are in the order of the file. A subject whose data are not complete is left out.
 */
public final class ObservationsReader {
  /**
   * The columns of a file.
   *
   * @param within empty for designs without a within factor
   * @param between empty for designs without a between factor
   */
  public record Columns(
      String measure, String subject, Optional<String> within, Optional<String> between) {}

  private static final String ONLY = "all";

  private static final class Gathered {
    final Location location;
    final String group;
    final Map<String, Double> values = new HashMap<>();
    boolean usable = true;

    Gathered(Location location, String group) {
      this.location = location;
      this.group = group;
    }
  }

  private final Columns columns;
  private final Exclusions exclusions;
  private final Map<String, Gathered> subjects = new LinkedHashMap<>();
  private final Set<String> levels = new LinkedHashSet<>();
  private final Set<String> groups = new LinkedHashSet<>();
  private final Lookalikes ids;
  private final Lookalikes levelNames;
  private final Lookalikes groupNames;

  private ObservationsReader(Columns columns, Problems problems) {
    this.columns = columns;
    exclusions = new Exclusions(problems, "the row");
    ids = new Lookalikes(columns.subject());
    levelNames = new Lookalikes(columns.within().orElse(ONLY));
    groupNames = new Lookalikes(columns.between().orElse(ONLY));
  }

  /**
   * Reads a file.
   *
   * @return empty when the file is no such table, which is then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<Observations> read(Path path, Columns columns, Problems problems)
      throws IOException {
    ObservationsReader reader = new ObservationsReader(columns, problems);
    byte[] content = CsvTable.bytes(path);
    DataFile source = DataFile.of(path.getFileName().toString(), content);
    return CsvTable.parse(path.toString(), content, reader.form(), reader.exclusions)
        .flatMap(table -> reader.observations(source, table));
  }

  /** Reads a text of that file name. */
  public static Optional<Observations> parse(
      String file, String text, Columns columns, Problems problems) {
    ObservationsReader reader = new ObservationsReader(columns, problems);
    return CsvTable.parse(file, text, reader.form(), reader.exclusions)
        .flatMap(table -> reader.observations(DataFile.of(file, text), table));
  }

  private List<String> wanted() {
    List<String> wanted = new ArrayList<>(List.of(columns.subject(), columns.measure()));
    columns.within().ifPresent(wanted::add);
    columns.between().ifPresent(wanted::add);
    return wanted;
  }

  private CsvColumns form() {
    return CsvColumns.of(wanted());
  }

  private Optional<Observations> observations(DataFile source, CsvTable table) {
    List<String> wanted = wanted();
    if (!table.require(wanted, "a table with the columns " + String.join(", ", wanted))) {
      return Optional.empty();
    }
    table.rows().forEach(this::row);
    lookAlike();
    Factor within = new Factor(columns.within().orElse("level"), list(levels));
    Factor between = new Factor(columns.between().orElse("group"), list(groups));
    columns.between().ifPresent(name -> single(table, name, between));
    columns.within().ifPresent(name -> single(table, name, within));
    List<Subject> complete = new ArrayList<>();
    subjects.forEach((id, gathered) -> complete(id, gathered, within, between, complete));
    Design design = new Design(columns.measure(), within, between, complete);
    return Optional.of(new Observations(source, design, exclusions.list()));
  }

  /** Names that are probably one name, spelled in two ways. */
  private void lookAlike() {
    ids.tell(exclusions, "they count as two participants");
    levelNames.tell(exclusions, "they are analysed as two levels");
    groupNames.tell(exclusions, "they are analysed as two groups");
    groupNames.tellLone(exclusions);
  }

  private void single(CsvTable table, String column, Factor factor) {
    if (!factor.varies()) {
      exclusions.warning(
          table.location(column),
          "",
          "%s has only one level, %s; its effect is not tested"
              .formatted(column, factor.levels().get(0)));
    }
  }

  private static List<String> list(Set<String> names) {
    return names.isEmpty() ? List.of(ONLY) : List.copyOf(names);
  }

  private void row(CsvRow row) {
    String id = row.cell(columns.subject());
    String level = columns.within().map(row::cell).orElse(ONLY);
    String group = columns.between().map(row::cell).orElse(ONLY);
    @Nullable String lacking =
        id.isEmpty()
            ? columns.subject()
            : level.isEmpty()
                ? columns.within().orElseThrow()
                : group.isEmpty() ? columns.between().orElseThrow() : null;
    if (lacking != null) {
      exclusions.error(
          row.location(lacking), id, "the " + lacking + " is missing; the row is left out");
      return;
    }
    levels.add(level);
    groups.add(group);
    ids.add(id, id, row.location(columns.subject()));
    columns.within().ifPresent(name -> levelNames.add(level, id, row.location(name)));
    columns.between().ifPresent(name -> groupNames.add(group, id, row.location(name)));
    Gathered gathered = subjects.computeIfAbsent(id, first -> new Gathered(row.location(), group));
    if (!gathered.group.equals(group)) {
      spoil(
          gathered,
          row.location(columns.between().orElseThrow()),
          id,
          "is in the group %s here and in %s before".formatted(group, gathered.group));
    }
    if (row.cell(columns.measure()).isEmpty()) {
      return; // told of when the subject turns out incomplete
    }
    OptionalDouble value =
        CsvNumbers.number(
            row, columns.measure(), (at, message) -> spoil(gathered, at, id, message));
    if (value.isPresent() && gathered.values.put(level, value.getAsDouble()) != null) {
      spoil(
          gathered,
          row.location(columns.measure()),
          id,
          "a second value" + columns.within().map(name -> " at " + name + " " + level).orElse(""));
    }
  }

  private void spoil(Gathered gathered, Location location, String id, String reason) {
    gathered.usable = false;
    exclusions.error(location, id, reason + "; the participant is left out");
  }

  private void complete(
      String id, Gathered gathered, Factor within, Factor between, List<Subject> complete) {
    if (!gathered.usable) {
      return;
    }
    List<String> wanting =
        within.levels().stream().filter(level -> !gathered.values.containsKey(level)).toList();
    if (!wanting.isEmpty()) {
      exclusions.warning(
          gathered.location,
          id,
          "has no "
              + columns.measure()
              + (within.varies() ? " at " + String.join(", ", wanting) : "")
              + "; the participant is left out");
      return;
    }
    complete.add(
        new Subject(
            id,
            between.levels().indexOf(gathered.group),
            within.levels().stream().map(gathered.values::get).toList()));
  }
}
