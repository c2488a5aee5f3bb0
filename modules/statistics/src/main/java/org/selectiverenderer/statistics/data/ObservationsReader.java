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
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvNumberParser;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Subject;

/**
 * Reads measurements in long format (one row for each subject and combination of within levels)
 * into a design. Levels are in the order of the file. A subject whose data are not complete is left
 * out.
 */
public final class ObservationsReader {
  /**
   * The names of the columns of a file.
   *
   * @param within columns of the within factors
   * @param between columns of the between factors
   * @param covariates columns of variables measured once on each subject
   */
  public record Columns(
      String measure,
      String subject,
      List<String> within,
      List<String> between,
      List<String> covariates) {
    /** Makes defensive copies, so that the record is immutable. */
    public Columns {
      within = List.copyOf(within);
      between = List.copyOf(between);
      covariates = List.copyOf(covariates);
    }

    /** Creates the columns of a design with at most one within and one between factor. */
    public Columns(
        String measure, String subject, Optional<String> within, Optional<String> between) {
      this(
          measure,
          subject,
          within.map(List::of).orElse(List.of()),
          between.map(List::of).orElse(List.of()),
          List.of());
    }
  }

  /**
   * Which rows of a table count, and how.
   *
   * @param where the cell that a row must have in each of these columns
   * @param mean whether several values of a subject at the same levels are averaged, as those of
   *     trials; otherwise they are an error
   */
  public record Rows(Map<String, String> where, boolean mean) {
    /** All rows, with one value of a subject at each combination of levels. */
    public static final Rows SINGLE = new Rows(Map.of(), false);

    /** Copies the cells. */
    public Rows {
      where = Map.copyOf(where);
    }
  }

  private static final String ONLY = "all";

  private static final class SubjectRows {
    final SourceLocation location;
    final List<String> group;
    final Map<List<String>, Double> values = new HashMap<>();
    final Map<List<String>, Integer> counts = new HashMap<>();
    final Map<String, Double> covariates = new HashMap<>();
    boolean usable = true;

    SubjectRows(SourceLocation location, List<String> group) {
      this.location = location;
      this.group = group;
    }
  }

  private final Columns columns;
  private final Rows rows;
  private final ExclusionLog exclusions;
  private final Map<String, SubjectRows> subjects = new LinkedHashMap<>();
  private final Map<String, Set<String>> levels = new LinkedHashMap<>();
  private final SimilarNameDetector ids;
  private final Map<String, SimilarNameDetector> names = new LinkedHashMap<>();

  private ObservationsReader(Columns columns, Rows rows, ProblemCollector problems) {
    this.columns = columns;
    this.rows = rows;
    exclusions = new ExclusionLog(problems, "the row");
    ids = new SimilarNameDetector(columns.subject());
  }

  /**
   * Reads a file.
   *
   * @return empty when the file is not such a table, which is reported to {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<Observations> read(Path path, Columns columns, ProblemCollector problems)
      throws IOException {
    return read(path, columns, Rows.SINGLE, problems);
  }

  /**
   * Reads some rows of a file.
   *
   * @return empty when the file is not such a table, which is reported to {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<Observations> read(
      Path path, Columns columns, Rows rows, ProblemCollector problems) throws IOException {
    ObservationsReader reader = new ObservationsReader(columns, rows, problems);
    byte[] content = CsvTable.bytes(path);
    DataSource source = DataSource.of(path.getFileName().toString(), content);
    return CsvTable.parse(path.toString(), content, reader.form(), reader.exclusions)
        .flatMap(table -> reader.observations(source, table));
  }

  /** Reads a text as if it were a file of that name. */
  public static Optional<Observations> parse(
      String file, String text, Columns columns, ProblemCollector problems) {
    ObservationsReader reader = new ObservationsReader(columns, Rows.SINGLE, problems);
    return CsvTable.parse(file, text, reader.form(), reader.exclusions)
        .flatMap(table -> reader.observations(DataSource.of(file, text), table));
  }

  private List<String> wanted() {
    List<String> wanted = new ArrayList<>(List.of(columns.subject(), columns.measure()));
    wanted.addAll(columns.within());
    wanted.addAll(columns.between());
    wanted.addAll(columns.covariates());
    rows.where().keySet().stream()
        .sorted()
        .filter(name -> !wanted.contains(name))
        .forEach(wanted::add);
    return wanted;
  }

  private CsvColumnSpec form() {
    return CsvColumnSpec.of(wanted());
  }

  private Optional<Observations> observations(DataSource source, CsvTable table) {
    List<String> wanted = wanted();
    if (!table.require(wanted, "a table with the columns " + String.join(", ", wanted))) {
      return Optional.empty();
    }
    table.rows().forEach(this::row);
    lookAlike();
    List<Factor> within = factors(columns.within(), "level");
    List<Factor> between = factors(columns.between(), "group");
    columns.between().forEach(name -> single(table, name, levels(name)));
    columns.within().forEach(name -> single(table, name, levels(name)));
    List<Subject> complete = new ArrayList<>();
    subjects.forEach((id, gathered) -> complete(id, gathered, within, between, complete));
    FactorialDesign design =
        new FactorialDesign(columns.measure(), within, between, columns.covariates(), complete);
    return Optional.of(new Observations(source, design, exclusions.list()));
  }

  /** Reports names that are probably two spellings of one name. */
  private void lookAlike() {
    ids.tell(exclusions, "they count as two participants");
    names.forEach(
        (column, found) -> {
          boolean group = columns.between().contains(column);
          found.tell(exclusions, "they are analysed as two " + (group ? "groups" : "levels"));
          if (group) {
            found.tellLone(exclusions);
          }
        });
  }

  private List<String> levels(String column) {
    return List.copyOf(levels.getOrDefault(column, Set.of()));
  }

  private List<Factor> factors(List<String> names, String none) {
    return names.isEmpty()
        ? List.of(new Factor(none, List.of(ONLY)))
        : names.stream()
            .map(name -> new Factor(name, levels(name).isEmpty() ? List.of(ONLY) : levels(name)))
            .toList();
  }

  private void single(CsvTable table, String column, List<String> found) {
    if (found.size() == 1) {
      exclusions.warning(
          table.location(column),
          "",
          "%s has only one level, %s; its effect is not tested".formatted(column, found.get(0)));
    }
  }

  private void row(CsvRow row) {
    if (!rows.where().entrySet().stream()
        .allMatch(cell -> row.cell(cell.getKey()).equals(cell.getValue()))) {
      return;
    }
    String id = row.cell(columns.subject());
    List<String> wanted = new ArrayList<>(List.of(columns.subject()));
    wanted.addAll(columns.within());
    wanted.addAll(columns.between());
    Optional<String> lacking =
        wanted.stream().filter(column -> row.cell(column).isEmpty()).findFirst();
    if (lacking.isPresent()) {
      exclusions.error(
          row.location(lacking.get()),
          id,
          "the " + lacking.get() + " is missing; the row is left out");
      return;
    }
    ids.add(id, id, row.location(columns.subject()));
    for (String column : wanted.subList(1, wanted.size())) {
      levels.computeIfAbsent(column, first -> new LinkedHashSet<>()).add(row.cell(column));
      names
          .computeIfAbsent(column, SimilarNameDetector::new)
          .add(row.cell(column), id, row.location(column));
    }
    List<String> level = columns.within().stream().map(row::cell).toList();
    List<String> group = columns.between().stream().map(row::cell).toList();
    SubjectRows gathered =
        subjects.computeIfAbsent(id, first -> new SubjectRows(row.location(), group));
    for (int i = 0; i < group.size(); i++) {
      if (!gathered.group.get(i).equals(group.get(i))) {
        spoil(
            gathered,
            row.location(columns.between().get(i)),
            id,
            "is in the group %s here and in %s before"
                .formatted(group.get(i), gathered.group.get(i)));
      }
    }
    columns.covariates().forEach(name -> covariate(row, id, gathered, name));
    if (row.cell(columns.measure()).isEmpty()) {
      return; // reported when the subject turns out incomplete
    }
    OptionalDouble value =
        CsvNumberParser.number(
            row, columns.measure(), (at, message) -> spoil(gathered, at, id, message));
    if (value.isEmpty()) {
      return;
    }
    int count = gathered.counts.merge(level, 1, Integer::sum);
    double before = gathered.values.getOrDefault(level, 0.0);
    // The running mean; of a single value it is the value.
    gathered.values.put(level, before + (value.getAsDouble() - before) / count);
    if (count > 1 && !rows.mean()) {
      spoil(
          gathered,
          row.location(columns.measure()),
          id,
          "a second value" + (level.isEmpty() ? "" : " at " + named(level)));
    }
  }

  private void covariate(CsvRow row, String id, SubjectRows gathered, String name) {
    if (row.cell(name).isEmpty()) {
      return; // in one of the subject's rows is enough
    }
    OptionalDouble value =
        CsvNumberParser.number(row, name, (at, message) -> spoil(gathered, at, id, message));
    if (value.isPresent()) {
      Double before = gathered.covariates.putIfAbsent(name, value.getAsDouble());
      if (before != null && before != value.getAsDouble()) {
        spoil(
            gathered,
            row.location(name),
            id,
            "another %s than in a row before; a covariate is one number for each participant"
                .formatted(name));
      }
    }
  }

  /** Returns a combination of levels with their factors, such as {@code type one, size small}. */
  private String named(List<String> level) {
    List<String> words = new ArrayList<>();
    for (int i = 0; i < level.size(); i++) {
      words.add(columns.within().get(i) + " " + level.get(i));
    }
    return String.join(", ", words);
  }

  private void spoil(SubjectRows gathered, SourceLocation location, String id, String reason) {
    gathered.usable = false;
    exclusions.error(location, id, reason + "; the participant is left out");
  }

  private void complete(
      String id,
      SubjectRows gathered,
      List<Factor> within,
      List<Factor> between,
      List<Subject> complete) {
    if (!gathered.usable) {
      return;
    }
    List<List<String>> cells = columns.within().isEmpty() ? List.of(List.of()) : cells(within);
    List<String> wanting =
        cells.stream()
            .filter(cell -> !gathered.values.containsKey(cell))
            .map(cell -> String.join(", ", cell))
            .toList();
    List<String> unknown =
        columns.covariates().stream()
            .filter(name -> !gathered.covariates.containsKey(name))
            .toList();
    if (!wanting.isEmpty() || !unknown.isEmpty()) {
      exclusions.warning(
          gathered.location,
          id,
          "has no "
              + (wanting.isEmpty()
                  ? String.join(", ", unknown)
                  : columns.measure()
                      + (cells.size() > 1 ? " at " + String.join("; ", wanting) : ""))
              + "; the participant is left out");
      return;
    }
    int group = 0;
    for (int i = 0; i < gathered.group.size(); i++) {
      List<String> own = between.get(i).levels();
      group = group * own.size() + own.indexOf(gathered.group.get(i));
    }
    complete.add(
        new Subject(
            id,
            group,
            cells.stream().map(gathered.values::get).toList(),
            columns.covariates().stream().map(gathered.covariates::get).toList()));
  }

  /** Returns all combinations of levels; the last factor's level changes fastest. */
  private static List<List<String>> cells(List<Factor> factors) {
    List<List<String>> cells = List.of(List.of());
    for (Factor factor : factors) {
      List<List<String>> longer = new ArrayList<>();
      for (List<String> before : cells) {
        for (String level : factor.levels()) {
          List<String> next = new ArrayList<>(before);
          next.add(level);
          longer.add(next);
        }
      }
      cells = longer;
    }
    return cells;
  }
}
