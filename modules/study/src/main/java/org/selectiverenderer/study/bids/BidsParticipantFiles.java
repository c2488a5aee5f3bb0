package org.selectiverenderer.study.bids;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.ParticipantsTable;
import org.selectiverenderer.study.dataset.RecordedSession;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.dataset.SessionsTable;
import org.selectiverenderer.study.dataset.TableColumn;

/**
 * Builds {@code participants.tsv} and {@code sessions.tsv}. BIDS reserves some column names, such
 * as {@code age} and {@code sex}, for values of a fixed form: a column of the study with other
 * values is renamed.
 */
final class BidsParticipantFiles {
  private static final Set<String> SEX =
      Set.of(
          "f", "female", "m", "male", "o", "other", "F", "FEMALE", "Female", "M", "MALE", "Male",
          "O", "OTHER", "Other");
  private static final Set<String> HAND =
      Set.of(
          "l",
          "left",
          "r",
          "right",
          "a",
          "ambidextrous",
          "L",
          "LEFT",
          "Left",
          "R",
          "RIGHT",
          "Right",
          "A",
          "AMBIDEXTROUS",
          "Ambidextrous");

  private BidsParticipantFiles() {}

  static void participants(RecordedStudy study, BidsFileSet files) {
    ParticipantsTable people = study.participants();
    List<TableColumn> columns = new ArrayList<>();
    for (String name : people.columns()) {
      columns.add(
          renamed(ParticipantsTable.column(name, study.material().form()), values(people, name)));
    }
    DataTable table = new DataTable("participants", "", columns);
    Set<String> known = new LinkedHashSet<>();
    for (Map<String, String> row : people.rows()) {
      known.add(String.valueOf(row.get(people.columns().get(0))));
      table.add(people.columns().stream().map(row::get).toList());
    }
    // Each participant with data needs a row, also one without an assigned condition.
    for (RecordedSession session : study.sessions()) {
      String id = "sub-" + session.folder().participant();
      if (known.add(id)) {
        List<String> row = new ArrayList<>(List.of(id));
        people.columns().stream().skip(1).forEach(column -> row.add(""));
        table.add(row);
      }
    }
    files.add("participants", table, BidsFileSet.nothing());
  }

  private static List<String> values(ParticipantsTable people, String column) {
    return people.rows().stream()
        .map(row -> row.getOrDefault(column, ""))
        .filter(value -> !value.isEmpty())
        .toList();
  }

  private static TableColumn renamed(TableColumn column, List<String> values) {
    boolean fits =
        switch (column.name().toLowerCase(Locale.ROOT)) {
          case "age" -> values.stream().allMatch(value -> value.matches("\\d+(\\.\\d+)?"));
          case "sex" -> SEX.containsAll(values);
          case "handedness" -> HAND.containsAll(values);
          case "species", "strain", "strain_rrid" -> false;
          default -> true;
        };
    String name =
        fits ? column.name() : column.name() + (column.name().equals("age") ? "_band" : "_answer");
    return new TableColumn(name, column.type(), column.unit(), column.levels(), column.meaning());
  }

  static void sessions(
      String participant, List<RecordedSession> sessions, double fade, BidsFileSet files)
      throws IOException {
    // The id is in the file's name, and BIDS wants session_id first.
    List<TableColumn> columns = new ArrayList<>(SessionsTable.columns());
    Map<String, String> names = new LinkedHashMap<>();
    names.put("session", "session_id");
    names.put("began", "acq_time");
    columns.remove(0);
    columns.replaceAll(
        column ->
            new TableColumn(
                names.getOrDefault(column.name(), column.name()),
                column.type(),
                column.unit(),
                column.levels(),
                column.meaning()));
    DataTable table = new DataTable("sessions", "", columns);
    for (RecordedSession session : sessions) {
      List<@Nullable Object> row = new ArrayList<>(SessionsTable.row(session, fade));
      row.remove(0);
      row.set(0, session.folder().path().getFileName());
      row.set(1, BidsSessionFiles.time(session.began()));
      table.add(row);
    }
    files.add("sub-%1$s/sub-%1$s_sessions".formatted(participant), table, BidsFileSet.nothing());
  }
}
