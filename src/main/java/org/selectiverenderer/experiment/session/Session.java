package org.selectiverenderer.experiment.session;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.selectiverenderer.base.files.Disk;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.AnswerTable;
import org.selectiverenderer.experiment.questionnaire.AnswersCsv;
import org.selectiverenderer.experiment.questionnaire.AskedBy;
import org.selectiverenderer.experiment.questionnaire.Page;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Questionnaire;
import org.selectiverenderer.experiment.study.SessionFlag;
import org.selectiverenderer.experiment.study.Study;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * A session under way. A step is begun, told of, and finished; once {@link #finished} returns it is
 * on the disk and will not be done again. Belongs to one thread but for the journal, which takes
 * events from any.
 */
public final class Session implements AutoCloseable {
  private final StudyMaterial material;
  private final SessionFolder folder;
  private final SessionOptions options;
  private final SessionLock lock;
  private final SessionJournal journal;
  private final SessionHistory history;
  private final MotionFiles motion;
  private boolean closed;

  private Session(
      StudyMaterial material,
      SessionFolder folder,
      SessionOptions options,
      SessionLock lock,
      SessionJournal journal) {
    this.material = material;
    this.folder = folder;
    this.options = options;
    this.lock = lock;
    this.journal = journal;
    history = journal.history();
    motion = new MotionFiles(folder, journal);
  }

  /**
   * Whether a session can be begun; for what is to be looked at before.
   *
   * @param software name and version of the program
   * @throws IOException if another program is running it, or it was begun before
   */
  public static void requireNew(SessionFolder folder, String software) throws IOException {
    if (Files.isDirectory(folder.path())) {
      SessionLock.take(folder.path(), software).close();
      folder.requireNew();
    }
  }

  /**
   * Begins a session: makes its folder, writes what it is begun with.
   *
   * @param problems hears when the participant has another condition already
   * @throws IOException if it was begun before, or the disk fails
   */
  public static Session begin(
      StudyMaterial material,
      String participant,
      int number,
      SessionOptions options,
      Problems problems)
      throws IOException {
    SessionFolder folder = new SessionFolder(material.study().folder(), participant, number);
    Files.createDirectories(folder.path().resolve("head"));
    SessionLock lock = SessionLock.take(folder.path(), options.software());
    try {
      folder.requireNew();
      Session session =
          new Session(material, folder, options, lock, SessionJournal.begin(folder.journal()));
      try {
        session.tellBegun(problems);
        return session;
      } catch (IOException e) {
        session.journal.close();
        throw e;
      }
    } catch (IOException e) {
      lock.close();
      throw e;
    }
  }

  private void tellBegun(Problems problems) throws IOException {
    for (Path made = folder.path();
        !made.equals(folder.study().getParent());
        made = made.getParent()) {
      Disk.forceFolder(made);
    }
    Map<String, Object> began = new LinkedHashMap<>();
    began.put("participant", folder.participant());
    began.put("session", folder.number());
    began.put("study", material.study().name());
    began.put("study_sha256", Checksums.of(material.study().file()));
    began.putAll(options.recorded());
    journal.keep("session-began", began);
    options.flags().forEach(flag -> journal.flag(flag, Map.of()));
    writeSettings();
    tellConditionKept(
        new Participants(material.study())
            .of(folder.participant())
            .map(Participants.Assigned::condition),
        problems);
  }

  /** The study as it was, what the session was begun with, and checksums of what was shown. */
  private void writeSettings() throws IOException {
    folder.writeOnce("study.json", Files.readString(material.study().file()));
    Map<String, Object> settings = new LinkedHashMap<>(options.recorded());
    settings.put("sha256", checksums());
    folder.writeOnce("settings.json", JsonText.of(JsonTree.of(settings)));
  }

  /** SHA-256 of what is shown and asked, by the names of the files. */
  private Map<String, String> checksums() throws IOException {
    Map<String, String> sums = new LinkedHashMap<>();
    if (material.study().scene().isPresent()) {
      sums.putAll(Checksums.ofScene(material.study().scene().get()));
    }
    if (material.study().practice().isPresent()) {
      sums.putAll(Checksums.ofScene(material.study().practice().get().scene()));
    }
    for (Map.Entry<String, Path> file : material.study().questionnaires().files().entrySet()) {
      sums.put(file.getKey(), Checksums.of(file.getValue()));
    }
    return sums;
  }

  /** The files among those that have changed since the session began. */
  private List<String> changedFiles() throws IOException {
    JsonNode before = JsonTree.read(folder.path().resolve("settings.json")).path("sha256");
    return checksums().entrySet().stream()
        .filter(sum -> !before.path(sum.getKey()).asText().equals(sum.getValue()))
        .map(Map.Entry::getKey)
        .toList();
  }

  /**
   * Goes on with a session after its last finished step.
   *
   * @param problems hears when the study or what it shows and asks has changed meanwhile
   * @throws IOException if there is none, it is complete, or the disk fails
   */
  public static Session resume(
      StudyMaterial material,
      String participant,
      int number,
      SessionOptions options,
      Problems problems)
      throws IOException {
    SessionFolder folder = new SessionFolder(material.study().folder(), participant, number);
    if (!Files.isRegularFile(folder.journal())) {
      throw new IOException(folder.path() + " has no session to continue; leave --resume out");
    }
    SessionLock lock = SessionLock.take(folder.path(), options.software());
    try {
      Optional<Map<String, Object>> mended = JournalMending.mend(folder.journal(), problems);
      SessionJournal journal = SessionJournal.resume(folder.journal());
      try {
        if (journal.history().over() || journal.history().refused()) {
          throw new IOException(folder.path() + " is complete; there is nothing to continue");
        }
        Session session = new Session(material, folder, options, lock, journal);
        session.tellResumed(mended, problems);
        return session;
      } catch (IOException e) {
        journal.close();
        throw e;
      }
    } catch (IOException e) {
      lock.close();
      throw e;
    }
  }

  private void tellResumed(Optional<Map<String, Object>> mended, Problems problems)
      throws IOException {
    if (mended.isPresent()) {
      journal.keep("journal-mended", mended.get());
    }
    String sum = Checksums.of(material.study().file());
    Map<String, Object> resumed = new LinkedHashMap<>();
    resumed.put(
        "finished",
        material.steps().stream().filter(history::finished).map(SessionStep::id).toList());
    resumed.put("study_sha256", sum);
    resumed.putAll(options.recorded());
    journal.keep("resumed", resumed);
    boolean shows = remaining().stream().anyMatch(SessionStep::shows);
    for (SessionFlag flag : options.flags()) {
      if (flag != SessionFlag.TRACKER_ABSENT || shows) { // Questions need no tracker.
        journal.flag(flag, Map.of());
      }
    }
    Files.createDirectories(folder.path().resolve("head"));
    if (!Files.exists(folder.path().resolve("settings.json"))) {
      writeSettings();
    }
    if (!history.checksum().equals(sum)) {
      problems.warning(
          Location.of(material.study().file().toString()),
          "the study has changed since this session began; the session continues "
              + "with the present study, and its events record this");
    }
    List<String> changed = changedFiles();
    if (!changed.isEmpty()) {
      problems.warning(
          Location.of(folder.path().resolve("settings.json").toString()),
          ("%s changed since this session began; the session continues with the "
                      + "present files, and its events")
                  .formatted(String.join(", ", changed))
              + " record this");
      journal.keep("files-changed", Map.of("files", changed));
    }
    history.headLogs().forEach(motion::write);
    tellConditionKept(history.condition(), problems);
  }

  /**
   * A participant keeps the condition of the first session; one that is asked for now is too late.
   */
  private void tellConditionKept(Optional<Condition> kept, Problems problems) throws IOException {
    Optional<Condition> asked = options.condition();
    if (kept.isPresent() && asked.isPresent() && !kept.equals(asked)) {
      problems.warning(
          Location.of(new Participants(material.study()).file().toString()),
          "participant %s keeps the assigned condition %s; --condition %s is ignored"
              .formatted(folder.participant(), kept.get().spelling(), asked.get().spelling()));
      journal.keep("condition-kept", Map.of("asked_for", asked.get().spelling()));
    }
  }

  /** The steps that are still to be done, in order. */
  public List<SessionStep> remaining() {
    return steps().stream().filter(step -> !history.finished(step)).toList();
  }

  /**
   * All steps, the areas in the participant's order; an area that the study has got since comes
   * last.
   */
  private List<SessionStep> steps() {
    List<String> order = history.areaOrder();
    return material.steps(
        material.study().areas().stream()
            .sorted(
                Comparator.comparing(
                    area ->
                        order.contains(area.name()) ? order.indexOf(area.name()) : order.size()))
            .toList());
  }

  public SessionJournal journal() {
    return journal;
  }

  public SessionFolder folder() {
    return folder;
  }

  public SessionOptions options() {
    return options;
  }

  public StudyMaterial material() {
    return material;
  }

  /** The head tracker: the study's, unless the session has another, or goes on without it. */
  public TrackerSpec tracker() {
    return options.tracker().orElse(material.study().tracker());
  }

  /** The participant's condition, once it is assigned. */
  public Optional<Condition> condition() {
    return history.condition();
  }

  /**
   * The head log that the next run of a step writes.
   *
   * @throws IOException if it is there, whoever made it: it would be written over
   */
  public Path headLog(SessionStep step) throws IOException {
    Path log = folder.headLog(step, history.runs(step) + 1);
    if (Files.exists(log)) {
      throw new IOException(
          log + " exists already and is not overwritten. Move it away, then use --resume");
    }
    return log;
  }

  /**
   * A step begins.
   *
   * @param headLog whether it writes one
   */
  public void began(SessionStep step, boolean headLog) throws IOException {
    int run = history.runs(step) + 1;
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("step", step.id());
    event.put("run", run);
    if (headLog) {
      event.put("head_log", SessionFolder.headName(step, run));
    }
    journal.keep("step-began", event);
    if (step instanceof SessionStep.Exposure && run > 1) {
      journal.flag(SessionFlag.REPEATED_EXPOSURE, Map.of("step", step.id(), "run", run));
    }
  }

  /**
   * A step is done.
   *
   * @param more what there is to say of it
   */
  public void finished(SessionStep step, Map<String, ?> more) throws IOException {
    if (step instanceof SessionStep.Practice || step instanceof SessionStep.Exposure) {
      motion.write(SessionFolder.headName(step, history.runs(step)));
    }
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("step", step.id());
    event.putAll(more);
    journal.keep("step-finished", event);
  }

  /** The form is filled in: the condition is assigned, in the study's list first. */
  public void assign(String age) throws IOException {
    Participants.Assigned assigned =
        new Participants(material.study())
            .assign(folder.participant(), options.condition(), age, options.unattended());
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("condition", assigned.condition().spelling());
    event.put("place", assigned.place());
    event.put("assigned_by", assigned.insteadOf().isPresent() ? "experimenter" : "schedule");
    assigned.insteadOf().ifPresent(turn -> event.put("instead_of", turn.spelling()));
    event.put("age", age);
    journal.keep("assigned", event);
    order(assigned);
  }

  /** The order of the areas is said once and kept, whatever becomes of the study's file. */
  private void order(Participants.Assigned assigned) throws IOException {
    Study study = material.study();
    if (study.areas().isEmpty()) {
      return;
    }
    int turn = AreaSequence.turn(study, assigned.place());
    journal.keep(
        "area-order",
        Map.of(
            "order",
            study.course().order().spelling(),
            "areas",
            AreaSequence.of(study, folder.participant(), turn).stream()
                .map(Study.Area::name)
                .toList()));
  }

  /** The participant does not take part. */
  public void refuse() throws IOException {
    journal.keep("refused", Map.of());
  }

  /** Whether the participant does not take part. */
  public boolean refused() {
    return history.refused();
  }

  /** The experimenter ends it before its end. */
  public void abort(String step) throws IOException {
    journal.keep("aborted", Map.of("step", step));
  }

  /** What a step asks: the form, or questions. */
  public Questionnaire questionnaire(SessionStep step) {
    return material.questionnaire(step, folder.participant());
  }

  /** The answers that a step has so far, by the questions' ids. */
  public Map<String, Answer> answers(SessionStep step) {
    return history.answers(step);
  }

  /** The page of a step that was shown last, where a session that was cut off goes on. */
  public Optional<String> lastPage(SessionStep step) {
    return history.page(step);
  }

  /**
   * A page of a step is shown.
   *
   * @param questions that are on it, in order
   */
  public void shown(SessionStep step, Page page, List<Question> questions) {
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("step", step.id());
    event.put("page", page.id());
    event.put("questions", questions.stream().map(Question::id).toList());
    journal.tell("page", event);
  }

  /**
   * The participant answers, or answers otherwise; on the disk when it returns.
   *
   * @param milliseconds from when the question came into view
   * @param place of the question on its page, from 1
   */
  public void answer(
      SessionStep step, Question question, Answer answer, OptionalLong milliseconds, int place)
      throws IOException {
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("step", step.id());
    event.put("object", question.id());
    event.put("value", answer.value());
    if (answer.confidence() > 0) {
      event.put("confidence", answer.confidence());
    }
    milliseconds.ifPresent(ms -> event.put("ms", ms));
    event.put("place", place);
    if (question.personal()) {
      event.put("personal", true); // Whatever becomes of the study's file: for no table.
    }
    journal.keep("answer", event);
  }

  /**
   * The distance of this participant's pupils in millimetres, where the form asks for it; else the
   * study's.
   */
  public double ipd() {
    return material
        .form()
        .set(Question.Sets.IPD, history.answers(new SessionStep.Form()))
        .map(Double::parseDouble)
        .orElse(material.study().display().ipd());
  }

  /** All steps are done: writes the answers as tables, and waits for the motion data. */
  public void end() throws IOException {
    motion.close();
    AnswersCsv tables = new AnswersCsv();
    for (SessionStep step : material.steps()) {
      if (StudyMaterial.asks(step)) {
        tables.add(by(step), questionnaire(step), history.given(step));
      }
    }
    for (AnswerTable table : AnswerTable.values()) {
      if (tables.has(table)) {
        folder.writeOnce(table.file(), tables.text(table));
      }
    }
    if (tables.hasScores()) {
      folder.writeOnce("scores.csv", tables.scores());
    }
    journal.keep("session-finished", Map.of());
  }

  private AskedBy by(SessionStep step) {
    return new AskedBy(
        folder.participant(),
        Integer.toString(folder.number()),
        condition().map(Condition::spelling).orElse(""),
        step.id());
  }

  /**
   * Waits for what is still being written and lets go of the session; once more does nothing.
   *
   * @throws IOException if something could not be written
   */
  @Override
  public void close() throws IOException {
    if (closed) {
      return;
    }
    closed = true;
    try (lock;
        journal) {
      motion.close();
    }
  }
}
