package org.selectiverenderer.study.web;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PlannedSession;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.study.session.TrialEvents;

/** Tells the records of a session as the events of its journal, with the head logs beside it. */
final class WebSessionEvents {
  private final LoadedStudy material;
  private final String software;
  private final WebExposureFiles exposures;
  private final RecordFaults faults;
  private final PlannedSession planned;
  private final SessionFolder folder;
  private final List<WebRecord> records;
  private final Map<Path, String> files;
  private final Set<String> finished = new HashSet<>();
  private final Map<String, Integer> runs = new HashMap<>();
  private final WebBlockEvents blocks;
  private boolean assigned;

  /**
   * Prepares to tell a session.
   *
   * @param software name and version of the program
   * @param planned what the plan has for the session's place
   * @param records at least one, in order of time
   * @param files receives the head logs
   */
  WebSessionEvents(
      LoadedStudy material,
      String software,
      WebExposureFiles exposures,
      RecordFaults faults,
      PlannedSession planned,
      SessionFolder folder,
      List<WebRecord> records,
      Map<Path, String> files) {
    this.material = material;
    this.software = software;
    this.exposures = exposures;
    this.faults = faults;
    this.planned = planned;
    this.folder = folder;
    this.records = List.copyOf(records);
    this.files = files;
    blocks = new WebBlockEvents(material.study(), planned);
  }

  /** Returns the journal. */
  WebSessionJournal journal() {
    WebRecord first = records.get(0);
    Map<String, Object> began = new LinkedHashMap<>();
    began.put("participant", folder.participant());
    began.put("session", folder.number());
    began.put("study", material.study().name());
    began.put("study_sha256", first.identity().checksum());
    began.put("language", first.identity().language());
    began.put("software", software);
    began.put("source", "web");
    began.put(WebSessionFiles.SESSION, first.identity().session());
    began.put("planned_as", first.identity().participant());
    began.put("unattended", false);
    Map<String, Object> resumed =
        Map.of("study_sha256", first.identity().checksum(), "software", software);
    WebSessionJournal journal = new WebSessionJournal(first, began, resumed);
    Map<String, String> device = WebSessionFiles.device(records);
    if (!device.isEmpty()) {
      journal.add(
          0, "device", "", Map.of("device", device)); // no key of a stranger is one of the event
    }
    records.stream()
        .map(WebRecord::recruitment)
        .filter(ids -> !ids.isEmpty())
        .findFirst()
        .ifPresent(ids -> journal.add(0, "recruitment", "", Map.of("ids", ids)));
    for (WebRecord record : records) {
      if (record.step() instanceof SessionStep.Exposure || !finished.contains(id(record))) {
        tell(record, journal, device);
      } else {
        faults.tell(
            record.place(),
            "the step %s was done before in this session; this record of it is left out"
                .formatted(id(record)));
      }
    }
    List<String> all = material.steps().stream().map(SessionStep::id).toList();
    if (finished.containsAll(all)) {
      journal.add(records.get(records.size() - 1).seconds(), "session-finished", "", Map.of());
    }
    return journal;
  }

  private static String id(WebRecord record) {
    return record.step().id();
  }

  private void tell(WebRecord record, WebSessionJournal journal, Map<String, String> device) {
    journal.begin(record);
    if (record.refused()) {
      blocks.began(record, journal);
      Map<String, Object> began = new LinkedHashMap<>(Map.of("run", 1));
      if (record.step() instanceof SessionStep.OneTrial trial) {
        began.putAll(TrialEvents.members(trial.trial()));
      }
      journal.add(0, "step-began", id(record), began);
      journal.add(record.seconds(), "refused", "", Map.of());
      return;
    }
    if (!assigned && !(record.step() instanceof SessionStep.Form)) {
      assign(0, journal); // The record of the form is missing.
    }
    blocks.began(record, journal);
    int run = runs.merge(id(record), 1, Integer::sum);
    Map<String, Object> began = new LinkedHashMap<>();
    began.put("run", run);
    Map<String, Object> ended = new LinkedHashMap<>();
    if (record.step() instanceof SessionStep.OneTrial trial) {
      began.putAll(TrialEvents.members(trial.trial()));
      ended.putAll(TrialEvents.members(trial.trial()));
    }
    record.trial().ifPresent(outcome -> ended.putAll(TrialEvents.members(outcome.result())));
    record.trial().ifPresent(outcome -> ended.put("phases", outcome.phases()));
    if (record.headset()) {
      ended.put("shown_in", "webxr");
    }
    if (record.log().isPresent()) {
      String log = folder.headLog(record.step(), run).getFileName().toString();
      began.put("head_log", log.substring(0, log.lastIndexOf('.')));
    }
    if (record.step() instanceof SessionStep.Block) {
      blocks.finished(record, journal, finished);
      finished.add(id(record));
      return;
    }
    journal.add(0, "step-began", id(record), began);
    if (run > 1) {
      journal.flag(0, SessionFlag.REPEATED_EXPOSURE, Map.of("run", run));
    }
    record.log().ifPresent(log -> exposure(record, log, run, device, journal, ended));
    record.answers().forEach(given -> answer(record, given, journal));
    if (record.step() instanceof SessionStep.Form) {
      assign(record.seconds(), journal);
    }
    journal.add(record.seconds(), "step-finished", id(record), ended);
    finished.add(id(record));
  }

  private void exposure(
      WebRecord record,
      WebExposureLog log,
      int run,
      Map<String, String> device,
      WebSessionJournal journal,
      Map<String, Object> ended) {
    double began = record.logBegan(log);
    WebExposureFiles.HeadLogTexts texts = exposures.headLog(record, log, device);
    Path csv = folder.headLog(record.step(), run);
    String name = csv.getFileName().toString();
    files.put(csv, texts.csv());
    files.put(csv.resolveSibling(name.substring(0, name.lastIndexOf('.')) + ".json"), texts.json());
    double fades =
        record.trial().map(outcome -> outcome.exposed().orElse(0)).orElse(material.study().fade());
    double complete = Math.min(fades, log.end());
    boolean shown = false;
    for (Map<String, Object> event : texts.events()) {
      double t = (Double) event.get("t");
      if (!shown && t > complete) {
        shown = true;
        shown(record, began, complete, journal);
      }
      journal.add(began + t, "scene", id(record), Map.of("what", event));
    }
    if (!shown) {
      shown(record, began, complete, journal);
    }
    exposures.flag(record, log, journal);
    ended.put("frames", log.frames().size());
    ended.put("fps", DecimalRounding.to(1, log.framesPerSecond()));
  }

  private static void shown(WebRecord record, double began, double t, WebSessionJournal journal) {
    journal.add(began + t, "shown", id(record), Map.of("t", DecimalRounding.to(3, t)));
  }

  private static void answer(WebRecord record, WebRecord.Given given, WebSessionJournal journal) {
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("object", given.question().id());
    event.put("value", given.answer().value());
    if (given.answer().confidence() > 0) {
      event.put("confidence", given.answer().confidence());
    }
    given.milliseconds().ifPresent(ms -> event.put("ms", ms));
    event.put("place", given.place());
    if (given.question().personal()) {
      event.put("personal", true); // A later change of the study does not unmark it.
    }
    journal.add(record.seconds(), "answer", id(record), event);
  }

  private void assign(double seconds, WebSessionJournal journal) {
    assigned = true;
    WebRecord.Identity identity = records.get(0).identity();
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("condition", identity.group());
    event.put("place", identity.slot());
    event.put("assigned_by", "schedule");
    event.put("age", WebSessionFiles.age(material, records));
    journal.add(seconds, "assigned", "", event);
    if (!material.study().areas().isEmpty() && material.study().design().blocks().isEmpty()) {
      journal.add(
          seconds,
          "area-order",
          "",
          Map.of("order", material.study().course().order().spelling(), "areas", areas()));
    }
  }

  private List<String> areas() {
    List<String> areas = new ArrayList<>();
    for (SessionStep step : planned.steps()) {
      if (step instanceof SessionStep.Exposure exposure) {
        areas.add(exposure.area().name());
      }
    }
    return areas;
  }
}
