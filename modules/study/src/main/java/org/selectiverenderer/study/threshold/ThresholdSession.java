package org.selectiverenderer.study.threshold;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;

/**
 * A running session of a participant in a threshold pilot, logged in {@code threshold/sub-ID}
 * beside the settings: an answer is on the disk before the next trial. Belongs to one thread at a
 * time.
 */
public final class ThresholdSession implements AutoCloseable {
  private final ThresholdStudy study;
  private final Map<String, StimulusLevels> ladders;
  private final InterleavedTracks pilot;
  private final TrialLog log;

  private ThresholdSession(
      ThresholdStudy study,
      Map<String, StimulusLevels> ladders,
      InterleavedTracks pilot,
      TrialLog log) {
    this.study = study;
    this.ladders = ladders;
    this.pilot = pilot;
    this.log = log;
  }

  /**
   * The options of a session.
   *
   * @param participant the participant's id: letters and digits
   * @param material checksum of the settings and of the pictures
   * @param software name and version of the program
   * @param unattended whether a simulated observer answers
   * @param resume whether to resume an interrupted session
   */
  public record Opening(
      String participant, String material, String software, boolean unattended, boolean resume) {}

  /**
   * Begins or resumes a session.
   *
   * @param ladders the versions of all objects of the study
   * @param problems receives damaged lines of the log
   * @throws IOException if the session was begun before or is complete, its settings have changed,
   *     or a file cannot be written
   */
  public static ThresholdSession open(
      ThresholdStudy study,
      Map<String, StimulusLevels> ladders,
      Opening opening,
      ProblemCollector problems)
      throws IOException {
    Path folder = folder(study, opening.participant());
    boolean there = Files.isRegularFile(TrialLog.of(folder));
    if (there && !opening.resume()) {
      throw begunBefore(folder);
    }
    if (!there && opening.resume()) {
      throw new IOException(folder + " has no pilot to continue; leave --resume out");
    }
    InterleavedTracks pilot = new InterleavedTracks(study, ladders, opening.participant());
    TrialLog log = TrialLog.open(folder, opening.software(), problems);
    try {
      List<JsonNode> events = log.events();
      boolean begun =
          events.stream().anyMatch(event -> event.path("event").asText().equals("pilot-began"));
      if (begun && !opening.resume()) {
        throw begunBefore(folder); // Another program began it before this one had the lock.
      }
      for (JsonNode event : events) {
        check(folder, event, opening);
        if (event.path("event").asText().equals("trial")) {
          replay(folder, pilot, event);
        }
      }
      Map<String, Object> began = new LinkedHashMap<>();
      began.put("participant", opening.participant());
      began.put("pilot", study.name());
      began.put("task", study.task().spelling());
      began.put("material_sha256", opening.material());
      began.put("software", opening.software());
      began.put("unattended", opening.unattended());
      began.put("trials", pilot.trials());
      log.keep(begun ? "resumed" : "pilot-began", began);
      ThresholdSession session = new ThresholdSession(study, ladders, pilot, log);
      session.keepFound(events);
      return session;
    } catch (IOException e) {
      log.close();
      throw e;
    }
  }

  private static IOException begunBefore(Path folder) {
    return new IOException(
        folder + " exists already: --resume continues it, another --participant begins anew");
  }

  static Path folder(ThresholdStudy study, String participant) {
    return study.folder().resolve("sub-" + participant);
  }

  private static void check(Path folder, JsonNode event, Opening opening) throws IOException {
    String name = event.path("event").asText();
    if (name.equals("pilot-finished")) {
      throw new IOException(folder + " is complete; there is nothing to continue");
    }
    if (name.equals("pilot-began")
        && !event.path("material_sha256").asText().equals(opening.material())) {
      throw new IOException(
          folder
              + ": the settings or the pictures have changed since this participant began; begin"
              + " with another --participant");
    }
  }

  private static void replay(Path folder, InterleavedTracks pilot, JsonNode event)
      throws IOException {
    Optional<ThresholdTrial> next = pilot.next();
    if (next.isEmpty()
        || next.get().number() != event.path("number").asInt()
        || !next.get().object().equals(event.path("object").asText())
        || next.get().rung() != event.path("rung").asInt()) {
      throw new IOException(
          TrialLog.of(folder)
              + ": trial "
              + event.path("number").asInt()
              + " is not the one that came next; the file was changed or a line was lost. Begin"
              + " with another --participant");
    }
    pilot.answered(next.get(), event.path("response").asText());
  }

  /** Logs thresholds that were found before a crash but not logged. */
  private void keepFound(List<JsonNode> events) throws IOException {
    for (ThresholdStudy.Judged judged : study.objects()) {
      boolean told =
          events.stream()
              .anyMatch(
                  event ->
                      event.path("event").asText().equals("threshold")
                          && event.path("object").asText().equals(judged.object()));
      if (!told && pilot.over(judged.object())) {
        keepThreshold(judged.object());
      }
    }
    if (pilot.left() == 0) {
      keepFinished();
    }
  }

  /** Returns the next trial; empty after the last one. */
  public Optional<ThresholdTrial> next() {
    return pilot.next();
  }

  /** Returns the trials so far. */
  public InterleavedTracks pilot() {
    return pilot;
  }

  /**
   * Records an answer, which is on the disk when this method returns.
   *
   * @param ms response time in milliseconds from when the pictures were shown
   */
  public void answer(ThresholdTrial trial, String response, long ms) throws IOException {
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("number", trial.number());
    event.put("object", trial.object());
    event.put("rung", trial.rung());
    event.put("polygons", ladder(trial.object()).at(trial.rung()));
    event.put("view", trial.view());
    if (trial.catches()) {
      event.put("catch", trial.catching());
    }
    event.put("choices", trial.choices());
    event.put("right", trial.right());
    event.put("response", response);
    event.put("correct", response.equals(trial.right()));
    event.put("ms", ms);
    log.keep("trial", event);
    pilot.answered(trial, response);
    if (pilot.over(trial.object()) && !trial.catches()) {
      keepThreshold(trial.object());
    }
    if (pilot.left() == 0) {
      keepFinished();
    }
  }

  private void keepFinished() throws IOException {
    log.keep("pilot-finished", Map.of("trials", pilot.trials()));
  }

  private StimulusLevels ladder(String object) {
    StimulusLevels ladder = ladders.get(object);
    if (ladder == null) {
      throw new IllegalArgumentException("no versions of " + object);
    }
    return ladder;
  }

  private void keepThreshold(String object) throws IOException {
    ThresholdEstimate estimate = pilot.estimate(object);
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("object", object);
    event.put("outcome", estimate.kind().spelling());
    event.put("polygons", estimate.polygons());
    event.put("fewest", ladder(object).at(0));
    event.put("original", ladder(object).all());
    log.keep("threshold", event);
  }

  /** Records that the session is aborted; it can be resumed. */
  public void abort() throws IOException {
    log.keep("aborted", Map.of("trials", pilot.trials()));
  }

  @Override
  public void close() throws IOException {
    log.close();
  }
}
