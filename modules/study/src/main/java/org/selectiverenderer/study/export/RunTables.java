package org.selectiverenderer.study.export;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.JournalEvent;
import org.selectiverenderer.study.dataset.RecordedRun;
import org.selectiverenderer.study.dataset.RecordedSession;
import org.selectiverenderer.study.dataset.RunEventsTable;
import org.selectiverenderer.study.dataset.TableColumn;
import org.selectiverenderer.study.headlog.DwellSummary;
import org.selectiverenderer.study.headlog.EyeTrackingAnalysis;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogAnalysis;
import org.selectiverenderer.study.headlog.SceneMap;

/** The tables of all runs: exposures, dwell times of head and eyes by object, and events. */
final class RunTables {
  private final DataTable exposures =
      new DataTable(
          "exposures", "a scene that was shown: practice or an exposure", exposureColumns());
  private final DataTable gaze =
      new DataTable(
          "gaze",
          "an object of the scene in an exposure; also one that was never in the middle of the view",
          gazeColumns());
  private final DataTable eyes =
      new DataTable(
          "eyes",
          "an object of the scene in an exposure whose head log knows where the eyes looked; also"
              + " one that they never looked at",
          eyesColumns());
  private final DataTable events =
      new DataTable("events", "something that happened while a scene was shown", eventColumns());
  private final double fade;
  private final ProblemCollector problems;

  /**
   * @param fade seconds in which pictures fade in and out
   */
  RunTables(double fade, ProblemCollector problems) {
    this.fade = fade;
    this.problems = problems;
  }

  private static List<TableColumn> keys(List<TableColumn> more) {
    List<TableColumn> columns = new ArrayList<>();
    columns.add(TableColumn.text("participant", "the participant's id"));
    columns.add(TableColumn.whole("session", "number of the participant's session, from 1"));
    columns.add(TableColumn.text("condition", "how objects were rendered"));
    columns.add(TableColumn.text("step", "the step of the session, such as exposure-kitchen"));
    columns.add(
        TableColumn.whole("run", "how often the step was begun, this time counted; from 1"));
    columns.addAll(more);
    return columns;
  }

  private static List<Object> keys(RecordedRun run) {
    RecordedSession session = run.session();
    return List.of(
        session.folder().participant(),
        session.folder().number(),
        session.condition(),
        run.step(),
        run.number());
  }

  private static List<TableColumn> exposureColumns() {
    return keys(
        List.of(
            TableColumn.yesNo(
                "finished", "it was shown to its end", "something cut it off", "how it ended"),
            TableColumn.time("began", "when its first frame was shown"),
            TableColumn.number(
                "shown", "s", "when its picture was complete, in the head log's time"),
            TableColumn.number(
                "recorded", "s", "from the first sample of the head log to the last"),
            TableColumn.number(
                "in_view",
                "s",
                "time in view: the net exposure, from when the picture is complete until it begins"
                    + " to fade out, without pauses and without frames that nobody could see; dwell"
                    + " times, idle and eyes_tracked count it only"),
            TableColumn.number("paused", "s", "time in which the experimenter had it paused"),
            TableColumn.whole("samples", "rows of the head log"),
            TableColumn.number(
                "idle", "", "share of the time in view in which the head kept still, 0 to 1"),
            TableColumn.number(
                "eyes_tracked",
                "",
                "share of the time in view in which the eye tracker saw the eyes, 0 to 1;"
                    + " empty without one"),
            TableColumn.number("fps", "1/s", "frames per second, the mean"),
            TableColumn.number("frame_p50", "ms", "median of the times between frames"),
            TableColumn.number("frame_p99", "ms", "99th percentile of the times between frames"),
            TableColumn.number(
                "slow_frames",
                "",
                "share of the frames that took more than one and a half times frame_p50, 0 to 1"),
            TableColumn.number(
                "refresh_rate",
                "1/s",
                "of the headset, or of the monitor with the participant's window; empty if the"
                    + " system does not tell it"),
            TableColumn.yesNo(
                "vsync",
                "frames waited for the display's refresh",
                "they did not",
                "whether frames waited for the display, as the driver says; empty in a headset,"
                    + " which paces them itself"),
            TableColumn.number(
                "latency_p50",
                "ms",
                "median of the times from a record of the head tracker until the frame that shows"
                    + " it was handed to the display; empty without a tracker"),
            TableColumn.number("latency_p99", "ms", "99th percentile of these times"),
            TableColumn.text(
                "gpu", "the graphics card or the software that drew, as OpenGL names it"),
            TableColumn.text(
                "cpu", "operating system, its version, architecture and number of processors"),
            TableColumn.text(
                "shown_in",
                "webxr: a page showed it in a headset of the browser; empty otherwise"),
            TableColumn.text("flags", "what is to be known of its quality, joined by |"),
            TableColumn.text("head_log", "the head log's file in the study's folder")));
  }

  private static List<TableColumn> gazeColumns() {
    return keys(
        List.of(
            TableColumn.text("object", "the object's DEF, as the head log has it"),
            TableColumn.number(
                "dwell",
                "s",
                "time in view in which it was in the middle of the view; each moment counts for one"
                    + " object at most, so that the sum of all is at most in_view of exposures"),
            TableColumn.whole(
                "looks",
                "how often it came into the middle of the view; what is gone for up to 0.15 s goes on"),
            TableColumn.number("first", "s", "when first, in the head log's time"),
            TableColumn.number("longest", "s", "the longest look")));
  }

  private static List<TableColumn> eyesColumns() {
    return keys(
        List.of(
            TableColumn.text("object", "the object's DEF, as the head log has it"),
            TableColumn.number(
                "dwell",
                "s",
                "time in view in which the eyes looked at it; each moment counts for one object at"
                    + " most"),
            TableColumn.whole(
                "looks", "how often the eyes came to it; what is gone for up to 0.15 s goes on"),
            TableColumn.number("first", "s", "when first, in the head log's time"),
            TableColumn.number("longest", "s", "the longest look"),
            TableColumn.whole(
                "fixations", "how often the eyes rested on it for at least a tenth of a second")));
  }

  private static List<TableColumn> eventColumns() {
    return keys(RunEventsTable.columns());
  }

  List<DataTable> tables() {
    return List.of(exposures, gaze, eyes, events);
  }

  void add(RecordedRun run) throws IOException {
    Optional<HeadLog> log = run.head(problems);
    Optional<HeadLogAnalysis> seen = log.map(read -> HeadLogAnalysis.of(run.inView(read, fade)));
    exposure(run, log, seen);
    seen.ifPresent(analysis -> gaze(run, analysis));
    for (List<@Nullable Object> event : RunEventsTable.rows(run, log, fade)) {
      List<@Nullable Object> row = new ArrayList<>(keys(run));
      row.addAll(event);
      events.add(row);
    }
  }

  private void exposure(RecordedRun run, Optional<HeadLog> log, Optional<HeadLogAnalysis> seen) {
    JsonNode figures =
        run.events().stream()
            .filter(line -> line.event().equals("step-finished"))
            .map(line -> line.members().path("figures"))
            .findFirst()
            .orElse(run.events().get(0).members().path("figures"));
    List<String> flags =
        run.events().stream()
            .filter(line -> line.event().equals("flag"))
            .map(line -> line.text("flag"))
            .distinct()
            .toList();
    List<@Nullable Object> row = new ArrayList<>(keys(run));
    row.add(run.finished() ? "yes" : "no");
    row.add(run.started(log).map(Object::toString).orElse(null));
    row.add(run.shown().orElse(null));
    row.add(log.map(HeadLog::duration).orElse(null));
    row.add(seen.map(all -> DecimalRounding.to(3, all.seconds())).orElse(null));
    row.add(DecimalRounding.to(3, run.paused()));
    row.add(log.map(read -> read.samples().size()).orElse(null));
    row.add(seen.map(HeadLogAnalysis::idle).orElse(null));
    row.add(seen.flatMap(HeadLogAnalysis::eyes).map(EyeTrackingAnalysis::tracked).orElse(null));
    row.add(number(figures.path("fps")));
    row.add(number(figures.path("frame_ms").path("p50")));
    row.add(number(figures.path("frame_ms").path("p99")));
    row.add(number(figures.path("frame_ms").path("slow_share")));
    row.add(rate(figures));
    row.add(
        figures.path("display").has("vsync")
            ? figures.path("display").path("vsync").asBoolean() ? "yes" : "no"
            : null);
    row.add(number(figures.path("latency_ms").path("p50")));
    row.add(number(figures.path("latency_ms").path("p99")));
    row.add(figures.path("gl").path("renderer").asText(""));
    row.add(machine(run));
    row.add(
        run.events().stream()
            .filter(line -> line.event().equals("step-finished"))
            .map(line -> line.text("shown_in"))
            .findFirst()
            .orElse(""));
    row.add(String.join("|", flags));
    row.add(
        log.isPresent()
            ? run.session().folder().study().relativize(run.headLog()).toString().replace('\\', '/')
            : null);
    exposures.add(row);
  }

  private static @Nullable Double rate(JsonNode figures) {
    Double worn = number(figures.path("headset").path("rate_hz"));
    Double shown = number(figures.path("display").path("refresh_hz"));
    return worn != null ? worn : shown != null && shown > 0 ? shown : null;
  }

  /** Returns the machine of the program that showed the run: a session may go on elsewhere. */
  private static String machine(RecordedRun run) {
    String machine = "";
    for (JournalEvent line : run.session().events()) {
      if (line.members().has("machine")) {
        machine = line.text("machine");
      }
      if (line.equals(run.events().get(0))) {
        break;
      }
    }
    return machine;
  }

  private static @Nullable Double number(JsonNode node) {
    return node.isNumber() ? node.asDouble() : null;
  }

  private void gaze(RecordedRun run, HeadLogAnalysis analysis) {
    looks(run, analysis, analysis.head(), gaze, object -> List.of());
    analysis
        .eyes()
        .ifPresent(
            seen ->
                looks(
                    run,
                    analysis,
                    seen.looks(),
                    eyes,
                    object -> List.of(seen.fixations(object).size())));
  }

  /**
   * Adds a row for each object that was looked at, then for each other object.
   *
   * @param more further cells of an object
   */
  private void looks(
      RecordedRun run,
      HeadLogAnalysis analysis,
      DwellSummary looks,
      DataTable table,
      Function<String, List<Object>> more) {
    Set<String> seen = new HashSet<>();
    List<DwellSummary.ObjectView> all = new ArrayList<>(looks.objects());
    all.forEach(view -> seen.add(view.object()));
    for (SceneMap.Box object : analysis.log().description().map().objects()) {
      if (seen.add(object.name())) {
        all.add(new DwellSummary.ObjectView(object.name(), 0, 0, Double.NaN, 0));
      }
    }
    for (DwellSummary.ObjectView view : all) {
      List<@Nullable Object> row = new ArrayList<>(keys(run));
      row.addAll(
          List.of(view.object(), view.seconds(), view.looks(), view.first(), view.longest()));
      row.addAll(more.apply(view.object()));
      table.add(row);
    }
  }
}
