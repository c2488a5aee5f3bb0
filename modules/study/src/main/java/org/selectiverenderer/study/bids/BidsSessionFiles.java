package org.selectiverenderer.study.bids;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.RecordedRun;
import org.selectiverenderer.study.dataset.RecordedSession;
import org.selectiverenderer.study.dataset.RunEventsTable;
import org.selectiverenderer.study.dataset.SessionAnswersTable;
import org.selectiverenderer.study.dataset.TableColumn;
import org.selectiverenderer.study.headlog.BidsMotionFiles;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.session.LoadedStudy;

/**
 * Adds the files of one session to a dataset: motion data with events, answers to questionnaires,
 * and {@code scans.tsv} with the time of each recording.
 */
final class BidsSessionFiles {
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("yyyy-MM-dd'T'HH:mm:ss.SSS'Z'", Locale.ROOT);

  private final LoadedStudy material;
  private final RecordedSession session;
  private final BidsDataset.Origin origin;
  private final BidsFileSet files;
  private final ProblemCollector problems;
  private final String folder;
  private final String stem;
  private final DataTable scans =
      new DataTable(
          "scans",
          "",
          List.of(
              TableColumn.text("filename", "the data file, as seen from this one"),
              TableColumn.time("acq_time", "when its first sample was taken, UTC")));

  BidsSessionFiles(
      LoadedStudy material,
      RecordedSession session,
      BidsDataset.Origin origin,
      BidsFileSet files,
      ProblemCollector problems) {
    this.material = material;
    this.session = session;
    this.origin = origin;
    this.files = files;
    this.problems = problems;
    String subject = "sub-" + session.folder().participant();
    String number = String.valueOf(session.folder().path().getFileName());
    folder = subject + "/" + number + "/";
    stem = subject + "_" + number;
  }

  /** Formats a time as BIDS requires it: in UTC, with a trailing Z. */
  static String time(OffsetDateTime time) {
    return TIME.format(time.withOffsetSameInstant(ZoneOffset.UTC));
  }

  /** Returns the BIDS task label of a step: its letters and digits. */
  private static String task(String step) {
    return step.replaceAll("[^0-9A-Za-z]", "");
  }

  void add() throws IOException {
    for (RecordedRun run : session.runs()) {
      run(run);
    }
    answers();
    if (!scans.rows().isEmpty()) {
      files.add(folder + stem + "_scans", scans, BidsFileSet.nothing());
    }
  }

  private void run(RecordedRun run) throws IOException {
    Optional<HeadLog> log = run.head(problems);
    if (log.isEmpty()) {
      problems.warning(
          SourceLocation.of(run.headLog().toString()),
          "the head log of this run is missing or has faults; the run is left out");
      return;
    }
    String task = task(run.step());
    String name = "%s_task-%s".formatted(stem, task);
    String number = String.format(Locale.ROOT, "_run-%02d", run.number());
    String motion = name + "_tracksys-head" + number;
    BidsMotionFiles.files(log.get(), motion, task, origin.program() + " " + origin.version())
        .forEach((file, text) -> files.add(folder + "motion/" + file, text));
    BidsMotionFiles.eyes(log.get(), motion, task, origin.program() + " " + origin.version())
        .forEach((file, bytes) -> files.add(folder + "motion/" + file, bytes));
    DataTable events = new DataTable("events", "", RunEventsTable.columns());
    RunEventsTable.rows(run, log, material.study().fade()).forEach(events::add);
    files.add(folder + "motion/" + name + number + "_events", events, stimulus(task));
    scans.add(
        "motion/" + motion + BidsMotionFiles.DATA,
        run.started(log).map(BidsSessionFiles::time).orElse(null));
    tracker(run, name + "_tracksys-tracker" + number, task, log.get().description().tracker());
  }

  /** Returns the members of the events' sidecar other than the columns. */
  private ObjectNode stimulus(String task) {
    ObjectNode root = BidsFileSet.nothing().put("TaskName", task);
    root.putObject("StimulusPresentation")
        .put("SoftwareName", origin.program())
        .put("SoftwareVersion", session.software());
    return root;
  }

  private void tracker(RecordedRun run, String name, String task, String model) throws IOException {
    String records = "motion/" + name;
    if (BidsTrackerMotion.add(run, folder + records, task, model, files, problems)) {
      scans.add(records + BidsMotionFiles.DATA, null);
    }
  }

  private void answers() {
    for (Map.Entry<String, List<List<@Nullable Object>>> screen :
        SessionAnswersTable.rows(material, session, problems).entrySet()) {
      String task = task(screen.getKey());
      DataTable table = new DataTable("beh", "", SessionAnswersTable.columns());
      screen.getValue().forEach(table::add);
      ObjectNode more = BidsFileSet.nothing();
      more.put("TaskName", task);
      more.put("TaskDescription", "a screen of a questionnaire, " + screen.getKey());
      String name = "beh/%s_task-%s_beh".formatted(stem, task);
      files.add(folder + name, table, more);
    }
  }
}
