package org.selectiverenderer.study.web;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.session.JournalContent;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.ParticipantsFile;
import org.selectiverenderer.study.session.SessionFolder;

/**
 * Makes session folders of what browsers sent. A session's participant is {@code web} and the id of
 * its place in the plan, such as {@code web007}; a second session with the same place is {@code
 * web007b}. A session that was imported before gets what is new, and loses nothing.
 */
public final class WebSessionImport {
  /** Begins the ids of participants, so that nobody takes them for those of the laboratory. */
  public static final String PREFIX = "web";

  /** Ids by which a recruiting service names a person. */
  private static final Set<String> PEOPLE = Set.of("PROLIFIC_PID", "sona_id", "survey_code", "id");

  /**
   * A summary counts the sessions that were imported.
   *
   * @param added sessions that were not there before
   * @param changed sessions for which more records have come
   * @param unchanged sessions that were there already
   */
  public record Summary(int added, int changed, int unchanged) {}

  private final LoadedStudy material;
  private final ProblemCollector problems;
  private final RecordFaults faults;
  private final WebRecordParser parser;
  private final WebExposureFiles exposures;
  private final WebSessionFiles files;
  private final Set<String> taken = new HashSet<>();
  private final Set<String> registered = new HashSet<>();
  private final Map<String, SessionFolder> known = new HashMap<>();
  private final Map<String, String> people = new HashMap<>();
  private final List<ParticipantsFile.Assigned> assigned = new ArrayList<>();
  private final Map<String, Integer> otherVersions = new TreeMap<>();
  private int added;
  private int changed;
  private int unchanged;

  private WebSessionImport(
      LoadedStudy material, String software, ExposureReplay replay, ProblemCollector problems)
      throws IOException {
    this.material = material;
    this.problems = problems;
    faults = new RecordFaults(problems);
    parser = new WebRecordParser(material, faults);
    exposures = new WebExposureFiles(material, replay, problems);
    files = new WebSessionFiles(material, software, exposures, faults);
  }

  /**
   * Imports all sessions of a study that are in files.
   *
   * @param paths files of records or of parts, and folders of such files
   * @param software name and version of the program
   * @param replay finds what was in view
   * @param problems receives what is wrong or missing, each with its file
   * @throws IOException if a file cannot be read or written
   */
  public static Summary run(
      LoadedStudy material,
      List<Path> paths,
      String software,
      ExposureReplay replay,
      ProblemCollector problems)
      throws IOException {
    WebSessionImport running = new WebSessionImport(material, software, replay, problems);
    WebRecordIndex index = new WebRecordIndex(material.study().name(), running.faults);
    for (Path path : paths) {
      index.add(path);
    }
    running.lookRound();
    List<WebSessionLines> sessions = new ArrayList<>(index.sessions().values());
    sessions.sort(
        Comparator.comparing(WebSessionLines::first).thenComparing(WebSessionLines::session));
    try {
      for (WebSessionLines session : sessions) {
        running.session(session);
      }
    } finally {
      new ParticipantsFile(material.study()).record(running.assigned);
    }
    running.tellVersions();
    running.exposures.tellUnlisted();
    running.tellPlaces();
    return new Summary(running.added, running.changed, running.unchanged);
  }

  /** Finds the sessions that were imported before, and the ids that are taken. */
  private void lookRound() throws IOException {
    new ParticipantsFile(material.study())
        .all()
        .forEach(one -> registered.add(one.participant().toLowerCase(Locale.ROOT)));
    taken.addAll(registered);
    for (SessionFolder folder : SessionFolder.all(material.study())) {
      taken.add(folder.participant().toLowerCase(Locale.ROOT));
      if (!folder.participant().startsWith(PREFIX)) {
        continue;
      }
      for (JsonNode event : JournalContent.read(folder.journal()).events()) {
        String session = event.path(WebSessionFiles.SESSION).asText();
        if (!session.isEmpty()) {
          known.putIfAbsent(session, folder);
        }
        if (event.path("event").asText().equals("recruitment")) {
          people(event.path("ids"), folder.participant());
        }
        if (event.path("event").asText().equals("step-began")) {
          break; // What is looked for comes before.
        }
      }
    }
  }

  private void session(WebSessionLines lines) throws IOException {
    SessionFolder before = known.get(lines.session());
    Kept kept =
        before == null
            ? new Kept(List.of(), List.of())
            : kept(before.path().resolve(WebSessionFiles.RECORDS), lines);
    List<WebRecord> records = records(lines, kept.records());
    if (records.isEmpty()) {
      SourceLocation place =
          lines.lines().isEmpty()
              ? SourceLocation.of(material.study().folder().toString())
              : lines.lines().get(0).place();
      problems.info(place, "the session %s has no records that count".formatted(lines.session()));
      return;
    }
    WebRecord first = records.get(0);
    SessionFolder folder =
        before != null
            ? before
            : new SessionFolder(material.study().folder(), free(first.identity().participant()), 1);
    tellGaps(lines, first.place(), folder);
    if (!files.present(first.identity())) {
      otherVersions.merge(first.identity().checksum(), 1, Integer::sum);
    }
    boolean same = before != null && records.size() == kept.records().size();
    if (same && registered.contains(folder.participant().toLowerCase(Locale.ROOT))) {
      unchanged++;
      return;
    }
    // One without a row in the table of participants gets it, should that have failed before.
    Optional<ParticipantsFile.Assigned> row = files.write(folder, records, kept.lines());
    row.ifPresent(assigned::add);
    if (same && row.isEmpty()) {
      unchanged++;
      return;
    }
    known.put(lines.session(), folder);
    records.forEach(record -> people(JsonTree.of(record.recruitment()), folder.participant()));
    if (before == null) {
      added++;
    } else {
      changed++;
    }
  }

  /** Returns the first free id of a place: web007, then web007b, web007c. */
  private String free(String planned) {
    String id = PREFIX + planned;
    for (int more = 1; !taken.add(id.toLowerCase(Locale.ROOT)); more++) {
      id = PREFIX + planned + (more < 25 ? String.valueOf((char) ('a' + more)) : "x" + more);
    }
    return id;
  }

  /**
   * The records that an earlier import has kept.
   *
   * @param lines all of them as they stand there, also what the present study does not take
   */
  private record Kept(List<WebRecord> records, List<String> lines) {}

  /** Reads the records that an earlier import has kept. */
  private Kept kept(Path file, WebSessionLines lines) throws IOException {
    List<WebRecord> records = new ArrayList<>();
    List<String> all = new ArrayList<>();
    if (Files.isRegularFile(file)) {
      int number = 0;
      for (String line : InputFileReader.text(file).split("\n")) {
        number++;
        if (line.isBlank()) {
          continue;
        }
        all.add(line);
        SourceLocation place = new SourceLocation(file.toString(), number, 1);
        try {
          parser.parse(lines.session(), JsonTree.parse(line), place).ifPresent(records::add);
        } catch (JsonProcessingException e) {
          faults.tell(place, "the line is damaged; it is left out");
        }
      }
    }
    return new Kept(records, all);
  }

  /** Returns the records of a session, those that were kept among them, in order of time. */
  private List<WebRecord> records(WebSessionLines lines, List<WebRecord> kept) throws IOException {
    Map<String, WebRecord> records = new LinkedHashMap<>();
    kept.forEach(record -> records.putIfAbsent(record.text(), record));
    for (WebRecordIndex.Line line : lines.lines()) {
      JsonNode json = line.json();
      for (JsonNode each : json.path("records").isArray() ? json.path("records") : List.of(json)) {
        if (!records.containsKey(each.toString())) {
          parser
              .parse(lines.session(), each, line.place())
              .ifPresent(record -> records.put(record.text(), record));
        }
      }
    }
    List<WebRecord> sorted = new ArrayList<>(records.values());
    sorted.sort(Comparator.comparing(WebRecord::started));
    List<WebRecord> same = new ArrayList<>();
    for (WebRecord record : sorted) {
      if (record.identity().equals((kept.isEmpty() ? sorted : kept).get(0).identity())) {
        same.add(record);
      } else {
        faults.tell(
            record.place(),
            "the record names another participant, place, condition, language or version of the"
                + " study than the first of its session; it is left out");
      }
    }
    return same;
  }

  private void tellGaps(WebSessionLines lines, SourceLocation place, SessionFolder folder) {
    SourceLocation file = SourceLocation.of(place.file());
    List<String> missing = lines.missing();
    if (!missing.isEmpty()) {
      problems.warning(
          file,
          "the session %s (%s) lacks the %s %s, which may still come; what is there is used"
              .formatted(
                  lines.session(),
                  folder.participant(),
                  missing.size() == 1 ? "part" : "parts",
                  String.join(", ", missing)));
    }
  }

  private void people(JsonNode ids, String participant) {
    ids.properties()
        .forEach(
            id -> {
              if (!PEOPLE.contains(id.getKey()) || id.getValue().asText().isEmpty()) {
                return;
              }
              String other =
                  people.putIfAbsent(id.getKey() + "=" + id.getValue().asText(), participant);
              if (other != null && !other.equals(participant)) {
                problems.warning(
                    SourceLocation.of(material.study().folder().toString()),
                    "%s and %s have the same %s: one person may have taken part twice; both are kept"
                        .formatted(other, participant, id.getKey()));
              }
            });
  }

  private void tellVersions() {
    otherVersions.forEach(
        (checksum, number) ->
            problems.warning(
                SourceLocation.of(material.study().file().toString()),
                ("%s ran another version of the study (its file had the checksum %s...); their"
                        + " records are read by the present one")
                    .formatted(
                        number == 1 ? "1 session" : number + " sessions",
                        checksum.substring(0, 8))));
  }

  /** Tells the places of the plan that several participants had. */
  private void tellPlaces() throws IOException {
    Map<Integer, Set<String>> at = new TreeMap<>();
    for (ParticipantsFile.Assigned one : new ParticipantsFile(material.study()).all()) {
      at.computeIfAbsent(one.place(), place -> new TreeSet<>()).add(one.participant());
    }
    at.values().removeIf(ids -> ids.size() < 2 || ids.stream().noneMatch(this::ofWeb));
    if (!at.isEmpty()) {
      List<String> places = new ArrayList<>();
      at.forEach((place, ids) -> places.add(place + " (" + String.join(", ", ids) + ")"));
      problems.info(
          SourceLocation.of(material.study().folder().resolve("participants.tsv").toString()),
          ("these places of the plan were taken more than once: %s; the data counts, and the groups"
                  + " are not as balanced as planned")
              .formatted(String.join(", ", places)));
    }
  }

  private boolean ofWeb(String participant) {
    return participant.startsWith(PREFIX);
  }
}
