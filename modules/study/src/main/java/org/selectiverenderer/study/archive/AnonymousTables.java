package org.selectiverenderer.study.archive;

import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.ParticipantsTable;
import org.selectiverenderer.study.dataset.TableColumn;

/**
 * Makes the tables of a study anonymous. Participants get new ids by chance, by which the rows are
 * sorted, so that neither ids nor rows tell who came when. The order of a participant's trials may
 * still tell the place in the schedule to those who compute the plan; the package says so.
 */
final class AnonymousTables {
  /** When the first session of each participant begins, long before any did (as BIDS advises). */
  private static final Instant BEGIN = Instant.parse("1900-01-01T00:00:00Z");

  /** Columns that tell who came when, or that name files with ids in them. */
  private static final Map<String, Set<String>> LEFT_OUT =
      Map.of(
          "participants",
          Set.of("place", ParticipantsTable.RECRUITMENT),
          "exposures",
          Set.of("head_log"));

  private final Predicate<String> column;
  private final Set<String> freeKinds;
  private final Set<String> freeColumns;
  private final Map<String, String> ids = new HashMap<>();
  private final Map<String, Duration> shifts = new HashMap<>();

  /**
   * Reads who took part.
   *
   * @param column which columns of the table of participants may be told
   * @param freeKinds kinds of questions with free texts as answers, which are left out
   * @param freeColumns columns of the table of trials with such answers
   */
  AnonymousTables(
      List<DataTable> tables,
      RandomGenerator random,
      Predicate<String> column,
      Set<String> freeKinds,
      Set<String> freeColumns) {
    this.column = column;
    this.freeKinds = Set.copyOf(freeKinds);
    this.freeColumns = Set.copyOf(freeColumns);
    Set<String> people = new TreeSet<>();
    Set<String> refused = new HashSet<>();
    for (DataTable table : tables) {
      Cells cells = new Cells(table);
      for (List<@Nullable String> row : table.rows()) {
        String id = cells.participant(row);
        people.add(id);
        if (table.name().equals("sessions")) {
          if ("refused".equals(cells.of(row, "outcome"))) {
            refused.add(id);
          }
          begin(id, cells.of(row, "began"));
        }
      }
    }
    people.removeAll(refused);
    List<String> order = new ArrayList<>(people);
    for (int i = order.size() - 1; i > 0; i--) {
      Collections.swap(order, i, random.nextInt(i + 1));
    }
    int digits = Math.max(3, String.valueOf(order.size()).length());
    for (int i = 0; i < order.size(); i++) {
      ids.put(order.get(i), "P" + String.format(Locale.ROOT, "%0" + digits + "d", i + 1));
    }
  }

  /** The cells of a table by the names of their columns. */
  private record Cells(DataTable table, Map<String, Integer> at) {
    Cells(DataTable table) {
      this(table, new LinkedHashMap<>());
      for (TableColumn each : table.columns()) {
        at.putIfAbsent(each.name(), at.size());
      }
    }

    @Nullable String of(List<@Nullable String> row, String column) {
      Integer index = at.get(column);
      return index == null ? null : row.get(index);
    }

    /** Returns the participant's id, without the prefix of BIDS; empty if there is none. */
    String participant(List<@Nullable String> row) {
      String id = of(row, at.containsKey("participant") ? "participant" : "participant_id");
      return id == null ? "" : id.replaceFirst("^sub-", "");
    }
  }

  private void begin(String id, @Nullable String began) {
    Instant time = instant(began);
    if (time != null) {
      shifts.merge(
          id,
          Duration.between(time, BEGIN),
          (one, other) -> one.compareTo(other) > 0 ? one : other);
    }
  }

  private static @Nullable Instant instant(@Nullable String time) {
    try {
      return time == null ? null : OffsetDateTime.parse(time).toInstant();
    } catch (DateTimeException e) {
      return null;
    }
  }

  /** Returns the number of participants. */
  int participants() {
    return ids.size();
  }

  /** Returns the table without what could tell who took part. */
  DataTable of(DataTable table) {
    Cells cells = new Cells(table);
    List<TableColumn> columns = new ArrayList<>();
    List<TableColumn> told = new ArrayList<>();
    for (TableColumn each : table.columns()) {
      if (tells(table, each.name())) {
        columns.add(each);
        told.add(meaning(each));
      }
    }
    List<List<@Nullable String>> rows = new ArrayList<>();
    for (List<@Nullable String> row : table.rows()) {
      String id = cells.participant(row);
      if (ids.containsKey(id) && !free(table, cells, row)) {
        List<@Nullable String> made = new ArrayList<>();
        for (TableColumn each : columns) {
          made.add(cell(id, each, cells, row));
        }
        rows.add(made);
      }
    }
    DataTable anonymous = new DataTable(table.name(), table.meaning(), told);
    int id =
        names(told)
            .indexOf(cells.at().containsKey("participant") ? "participant" : "participant_id");
    rows.sort(Comparator.comparing(row -> String.valueOf(row.get(id))));
    rows.forEach(anonymous::add);
    return anonymous;
  }

  private static List<String> names(List<TableColumn> columns) {
    return columns.stream().map(TableColumn::name).toList();
  }

  private boolean tells(DataTable table, String name) {
    if (LEFT_OUT.getOrDefault(table.name(), Set.of()).contains(name)) {
      return false;
    }
    return switch (table.name()) {
      case "participants" -> name.equals("site") || column.test(name);
      case "trials" -> !freeColumns.contains(name);
      default -> true;
    };
  }

  /** Returns whether a row is the experimenter's or a participant's own text. */
  private boolean free(DataTable table, Cells cells, List<@Nullable String> row) {
    return switch (table.name()) {
      case "events" -> "note".equals(cells.of(row, "trial_type"));
      case "answers" -> freeKinds.contains(String.valueOf(cells.of(row, "kind")));
      default -> false;
    };
  }

  private static TableColumn meaning(TableColumn column) {
    String more =
        column.type() == TableColumn.Type.TIME
            ? ", moved by a constant for each participant: the first session begins on 1900-01-01"
            : column.name().equals("participant") || column.name().equals("participant_id")
                ? ", given by chance for this package"
                : "";
    return new TableColumn(
        column.name(), column.type(), column.unit(), column.levels(), column.meaning() + more);
  }

  private @Nullable String cell(
      String id, TableColumn column, Cells cells, List<@Nullable String> row) {
    String cell = cells.of(row, column.name());
    if (cell == null) {
      return null;
    }
    if (column.name().equals("participant")) {
      return ids.get(id);
    }
    if (column.name().equals("participant_id")) {
      return "sub-" + ids.get(id);
    }
    if (column.type() == TableColumn.Type.TIME) {
      Instant time = instant(cell);
      Duration shift = shifts.get(id);
      return time == null || shift == null ? null : time.plus(shift).toString();
    }
    // Problems name files and devices of the machine.
    return column.name().equals("text") && "problem".equals(cells.of(row, "trial_type"))
        ? null
        : cell;
  }
}
