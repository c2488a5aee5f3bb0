package org.selectiverenderer.statistics.data;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.detection.Response;

/**
 * Reads a file of answers: {@code participant,condition,area,object,consistency,present,response,
 * confidence}, present and response {@code yes} or {@code no}, confidence 1 to 5.
 */
public final class ResponsesReader {
  private static final int NAMED_OBJECTS = 5;

  private record Question(String participant, String area, String object) {}

  private final ExclusionLog exclusions;
  private final Optional<ParticipantRoster> roster;
  private final boolean counterbalanced;

  private ResponsesReader(
      ProblemCollector problems, Optional<ParticipantRoster> roster, boolean counterbalanced) {
    exclusions = new ExclusionLog(problems, "the answer");
    this.roster = roster;
    this.counterbalanced = counterbalanced;
  }

  /**
   * Reads a file.
   *
   * @param roster the list of participants; without one, everyone with answers counts as a
   *     participant
   * @param counterbalanced whether objects are meant to be present for some participants only
   * @return empty when the file is not such a table, which is reported to {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<Responses> read(
      Path path,
      Optional<ParticipantRoster> roster,
      boolean counterbalanced,
      ProblemCollector problems)
      throws IOException {
    ResponsesReader reader = new ResponsesReader(problems, roster, counterbalanced);
    byte[] content = CsvTable.bytes(path);
    DataSource source = DataSource.of(path.getFileName().toString(), content);
    return CsvTable.parse(
            path.toString(),
            content,
            CsvColumnSpec.of(ResponseRowParser.COLUMNS),
            reader.exclusions)
        .flatMap(table -> reader.responses(source, table));
  }

  /** Reads a text as if it were a file of that name; objects are not {@code counterbalanced}. */
  public static Optional<Responses> parse(
      String file, String text, Optional<ParticipantRoster> roster, ProblemCollector problems) {
    ResponsesReader reader = new ResponsesReader(problems, roster, false);
    return CsvTable.parse(
            file, text, CsvColumnSpec.of(ResponseRowParser.COLUMNS), reader.exclusions)
        .flatMap(table -> reader.responses(DataSource.of(file, text), table));
  }

  private Optional<Responses> responses(DataSource source, CsvTable table) {
    if (!table.require(ResponseRowParser.COLUMNS, String.join(",", ResponseRowParser.COLUMNS))) {
      return Optional.empty();
    }
    List<Response> responses = new ArrayList<>();
    Set<Question> rows = new HashSet<>();
    Map<Response, CsvRow> places = new IdentityHashMap<>();
    for (CsvRow row : table.rows()) {
      rows.add(new Question(row.cell("participant"), row.cell("area"), row.cell("object")));
      Optional<Response> read = new ResponseRowParser(row, exclusions).read();
      read.ifPresent(
          response -> {
            responses.add(response);
            places.put(response, row);
          });
    }
    List<Response> single = withoutDoubles(ofOneCondition(known(responses)));
    lookAlike(single, places);
    List<Response> usable =
        new ObjectCodingCheck(exclusions, counterbalanced).consistent(single, places);
    if (usable.isEmpty()) {
      exclusions.fault(new SourceLocation(table.file(), 1, 1), "there is no usable answer");
      return Optional.empty();
    }
    missing(usable, rows);
    return Optional.of(new Responses(source, usable, exclusions.list()));
  }

  /** Reports names that are probably two spellings of one name. */
  private void lookAlike(List<Response> responses, Map<Response, CsvRow> rows) {
    SimilarNameDetector participants = new SimilarNameDetector("participant");
    SimilarNameDetector conditions = new SimilarNameDetector("condition");
    SimilarNameDetector areas = new SimilarNameDetector("area");
    Map<String, SimilarNameDetector> objects = new LinkedHashMap<>();
    for (Response response : responses) {
      CsvRow row = Objects.requireNonNull(rows.get(response));
      String id = response.participant();
      participants.add(id, id, row.location("participant"));
      conditions.add(response.condition(), id, row.location("condition"));
      areas.add(response.area(), id, row.location("area"));
      objects
          .computeIfAbsent(response.area(), area -> new SimilarNameDetector("object"))
          .add(response.object(), id, row.location("object"));
    }
    participants.tell(exclusions, "they count as two participants");
    conditions.tell(exclusions, "they are analysed as two conditions");
    conditions.tellLone(exclusions);
    areas.tell(exclusions, "they are analysed as two areas");
    objects.values().forEach(of -> of.tell(exclusions, "they count as two objects"));
  }

  private List<Response> known(List<Response> responses) {
    if (roster.isEmpty()) {
      return responses;
    }
    Set<String> unknown = new HashSet<>();
    Set<String> seen = new HashSet<>();
    List<Response> known = new ArrayList<>();
    for (Response response : responses) {
      seen.add(response.participant());
      if (roster.get().has(response.participant())) {
        known.add(response);
      } else if (unknown.add(response.participant())) {
        exclusions.error(
            response.location(),
            response.participant(),
            "is not in the list of participants; all answers are left out");
      }
    }
    roster
        .get()
        .places()
        .forEach(
            (id, place) -> {
              if (!seen.contains(id)) {
                exclusions.warning(place, id, "has no answers");
              }
            });
    return known;
  }

  private List<Response> ofOneCondition(List<Response> responses) {
    Map<String, String> conditions = new LinkedHashMap<>();
    Set<String> torn = new LinkedHashSet<>();
    for (Response response : responses) {
      String id = response.participant();
      String condition =
          conditions.computeIfAbsent(
              id,
              first -> roster.flatMap(known -> known.condition(id)).orElse(response.condition()));
      if (!condition.equals(response.condition()) && torn.add(id)) {
        exclusions.error(
            response.location(),
            id,
            "is in the condition %s here and in %s elsewhere; all answers are left out"
                .formatted(response.condition(), condition));
      }
    }
    return responses.stream().filter(response -> !torn.contains(response.participant())).toList();
  }

  /**
   * Removes repeated answers to an object: of identical ones the first is kept, of contradictory
   * ones none.
   */
  private List<Response> withoutDoubles(List<Response> responses) {
    Map<Question, Response> first = new LinkedHashMap<>();
    Set<Question> contradicted = new HashSet<>();
    for (Response response : responses) {
      Question question = new Question(response.participant(), response.area(), response.object());
      Response earlier = first.putIfAbsent(question, response);
      if (earlier != null) {
        boolean alike =
            earlier.yes() == response.yes()
                && earlier.confidence() == response.confidence()
                && earlier.present() == response.present()
                && earlier.type().equals(response.type());
        exclusions.error(
            response.location(),
            response.participant(),
            "a second answer to %s; line %d has the first%s"
                .formatted(
                    response.object(),
                    earlier.location().line(),
                    alike ? "; it is left out" : "; they differ, so both are left out"));
        if (!alike) {
          contradicted.add(question);
        }
      }
    }
    first.keySet().removeAll(contradicted);
    return List.copyOf(first.values());
  }

  /**
   * Reports participants without a row for objects that others were asked about in the same area.
   */
  private void missing(List<Response> responses, Set<Question> rows) {
    Map<String, Set<String>> asked = new LinkedHashMap<>();
    Map<String, Map<String, Set<String>>> answered = new LinkedHashMap<>();
    Map<String, SourceLocation> places = new LinkedHashMap<>();
    for (Response response : responses) {
      asked.computeIfAbsent(response.area(), area -> new LinkedHashSet<>()).add(response.object());
      answered
          .computeIfAbsent(response.participant(), id -> new LinkedHashMap<>())
          .computeIfAbsent(response.area(), area -> new HashSet<>())
          .add(response.object());
      places.putIfAbsent(response.participant(), response.location());
    }
    answered.forEach(
        (id, areas) ->
            asked.forEach(
                (area, objects) -> {
                  Set<String> wanting = new LinkedHashSet<>(objects);
                  wanting.removeAll(areas.getOrDefault(area, Set.of()));
                  wanting.removeIf(object -> rows.contains(new Question(id, area, object)));
                  if (!wanting.isEmpty()) {
                    exclusions.warning(places.get(id), id, lacks(area, wanting, objects.size()));
                  }
                }));
  }

  private static String lacks(String area, Set<String> wanting, int asked) {
    if (wanting.size() == asked) {
      return "has no answers about the area "
          + area
          + "; the area is analysed without this participant";
    }
    List<String> named = wanting.stream().limit(NAMED_OBJECTS).toList();
    return "of the %d objects of the area %s, %d are not in the file (%s%s); the others count"
        .formatted(
            asked,
            area,
            wanting.size(),
            String.join(", ", named),
            wanting.size() > named.size() ? " ..." : "");
  }
}
