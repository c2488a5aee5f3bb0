package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.BlockProgress;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * A running session. For each step the caller reports its begin, its events and its end; once
 * {@link #finished} returns, the step is on the disk and will not be repeated. Belongs to one
 * thread, except for the journal, which accepts events from any thread.
 */
public final class Session implements AutoCloseable {
  private final LoadedStudy material;
  private final SessionFolder folder;
  private final SessionOptions options;
  private final SessionLock lock;
  private final SessionJournal journal;
  private final SessionHistory history;
  private final BidsMotionConverter motion;
  private boolean closed;

  /** Makes a session that {@link SessionStarter} begins or resumes. */
  Session(
      LoadedStudy material,
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
    motion = new BidsMotionConverter(folder, journal);
  }

  /**
   * Checks that a session can be begun, before anything is written.
   *
   * @param software name and version of the program
   * @throws IOException if another program is running the session, or it was begun before
   */
  public static void requireNew(SessionFolder folder, String software) throws IOException {
    if (Files.isDirectory(folder.path())) {
      SessionLock.take(folder.path(), software).close();
      folder.requireNew();
    }
  }

  /**
   * Begins a session: creates its folder and records its settings.
   *
   * @param problems receives a warning if the participant already has another group
   * @throws IOException if the session was begun before, or a file cannot be written
   */
  public static Session begin(
      LoadedStudy material,
      String participant,
      int number,
      SessionOptions options,
      ProblemCollector problems)
      throws IOException {
    return SessionStarter.begin(material, participant, number, options, Optional.empty(), problems);
  }

  /**
   * Begins one of many sessions that follow each other at once, as {@link #begin(LoadedStudy,
   * String, int, SessionOptions, ProblemCollector)}.
   *
   * @param checksums those of {@link StudyChecksums#of}, which take longest
   */
  public static Session begin(
      LoadedStudy material,
      String participant,
      int number,
      SessionOptions options,
      Map<String, String> checksums,
      ProblemCollector problems)
      throws IOException {
    return SessionStarter.begin(
        material, participant, number, options, Optional.of(checksums), problems);
  }

  /**
   * Resumes a session after its last finished step.
   *
   * @param problems receives a warning if the study, its scenes or its questionnaires have changed
   * @throws IOException if there is no such session, it is complete, or a file cannot be written
   */
  public static Session resume(
      LoadedStudy material,
      String participant,
      int number,
      SessionOptions options,
      ProblemCollector problems)
      throws IOException {
    return SessionStarter.resume(material, participant, number, options, problems);
  }

  /** Returns the steps that are not finished, in order. */
  public List<SessionStep> remaining() {
    return steps().stream().filter(step -> !history.finished(step)).toList();
  }

  /**
   * Returns all steps, the areas in the participant's order; an area that was added to the study
   * later comes last.
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

  /** Converts a head log to motion data in the background. */
  void writeMotion(String headLog) {
    motion.write(headLog);
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

  public LoadedStudy material() {
    return material;
  }

  /** Returns the head tracker: that of the options if they have one, else the study's. */
  public TrackerSpec tracker() {
    return options.tracker().orElse(material.study().tracker());
  }

  /** Returns the participant's group, once it is assigned. */
  public Optional<StudyGroup> group() {
    return history.group().flatMap(material.study().design()::group);
  }

  /**
   * Returns the head log's file for the next run of a step.
   *
   * @throws IOException if the file exists: it would be overwritten
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
   * Records the begin of a step.
   *
   * @param headLog whether the step writes a head log
   */
  public void began(SessionStep step, boolean headLog) throws IOException {
    began(step, headLog, Map.of());
  }

  private void began(SessionStep step, boolean headLog, Map<String, ?> more) throws IOException {
    int run = history.runs(step) + 1;
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("step", step.id());
    event.put("run", run);
    if (headLog) {
      event.put("head_log", SessionFolder.headName(step, run));
    }
    event.putAll(more);
    journal.keep("step-began", event);
    boolean exposes = step instanceof SessionStep.Exposure || step instanceof SessionStep.OneTrial;
    if (exposes && run > 1) {
      journal.flag(SessionFlag.REPEATED_EXPOSURE, Map.of("step", step.id(), "run", run));
    }
  }

  /**
   * Returns the participant's progress through a block.
   *
   * @throws IllegalStateException if the participant has no group yet
   */
  public BlockProgress progress(SessionStep.Block step) throws IOException {
    Study study = material.study();
    StudyGroup group =
        group().orElseThrow(() -> new IllegalStateException("no group is assigned yet"));
    BlockProgress progress;
    try {
      progress =
          new BlockProgress(
              step.block(),
              group,
              AreaSequence.turn(study, Math.max(1, history.place())),
              study.seed(),
              history.orders(step.id()));
    } catch (IllegalArgumentException e) {
      throw new IOException(study.file() + ": " + e.getMessage(), e);
    }
    history.results().stream()
        .filter(result -> result.block().equals(step.block().name()))
        .forEach(
            result -> {
              progress.next();
              progress.add(result);
            });
    return progress;
  }

  /** Records the begin of a trial, and before the first one of a round the order of all. */
  public void began(SessionStep.OneTrial step, BlockProgress progress) throws IOException {
    Trial trial = step.trial();
    if (!history.orders(trial.block()).containsKey(trial.round()) && !progress.order().isEmpty()) {
      journal.keep(
          "trial-order", TrialEvents.order(trial.block(), trial.round(), progress.order()));
    }
    began(step, true, TrialEvents.members(trial));
  }

  /**
   * Records the end of a trial.
   *
   * @param more further members of the event
   */
  public void finished(SessionStep.OneTrial step, TrialResult result, Map<String, ?> more)
      throws IOException {
    Map<String, Object> event = new LinkedHashMap<>(TrialEvents.members(step.trial()));
    event.putAll(TrialEvents.members(result));
    event.putAll(more);
    finished(step, event);
  }

  /**
   * Records the end of a step.
   *
   * @param more further members of the event
   */
  public void finished(SessionStep step, Map<String, ?> more) throws IOException {
    if (step.shows() && !(step instanceof SessionStep.Block)) {
      motion.write(SessionFolder.headName(step, history.runs(step)));
    }
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("step", step.id());
    event.putAll(more);
    journal.keep("step-finished", event);
  }

  /** Assigns a group after the form, first in {@code participants.tsv}, then in the journal. */
  public void assign(String age) throws IOException {
    ParticipantsFile.Assigned assigned =
        new ParticipantsFile(material.study())
            .assign(
                folder.participant(),
                options.group().flatMap(material.study().design()::group),
                age,
                options.unattended());
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("condition", assigned.group());
    event.put("place", assigned.place());
    event.put("assigned_by", assigned.insteadOf().isPresent() ? "experimenter" : "schedule");
    assigned.insteadOf().ifPresent(turn -> event.put("instead_of", turn));
    event.put("age", age);
    journal.keep("assigned", event);
    order(assigned);
  }

  /** Records the order of the areas, which later changes of the study's file do not alter. */
  private void order(ParticipantsFile.Assigned assigned) throws IOException {
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

  /** Records that the participant refuses consent. */
  public void refuse() throws IOException {
    journal.keep("refused", Map.of());
  }

  /** Returns whether the participant refused consent. */
  public boolean refused() {
    return history.refused();
  }

  /** Records that the experimenter aborts the session in a step. */
  public void abort(String step) throws IOException {
    journal.keep("aborted", Map.of("step", step));
  }

  /** Records that the experimenter aborts the session, in the first step that is not finished. */
  public void abort() throws IOException {
    List<SessionStep> left = remaining();
    journal.keep("aborted", left.isEmpty() ? Map.of() : Map.of("step", left.get(0).id()));
  }

  /** Returns the questionnaire of a step. */
  public Questionnaire questionnaire(SessionStep step) {
    return material.questionnaire(step, folder.participant());
  }

  /** Returns the answers of a step so far, by the questions' ids. */
  public Map<String, Answer> answers(SessionStep step) {
    return history.answers(step);
  }

  /**
   * Returns the id of the page of a step that was shown last, where an interrupted session
   * continues.
   */
  public Optional<String> lastPage(SessionStep step) {
    return history.page(step);
  }

  /**
   * Records that a page of a step is shown.
   *
   * @param questions the questions on the page, in order
   */
  public void shown(SessionStep step, QuestionnairePage page, List<Question> questions) {
    Map<String, Object> event = new LinkedHashMap<>();
    event.put("step", step.id());
    event.put("page", page.id());
    event.put("questions", questions.stream().map(Question::id).toList());
    journal.tell("page", event);
  }

  /**
   * Records an answer, or the change of an answer; it is on the disk when this method returns.
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
      event.put("personal", true); // A later change of the study does not unmark it.
    }
    journal.keep("answer", event);
  }

  /**
   * Returns the participant's interpupillary distance in millimetres if the form asks for it; else
   * the study's.
   */
  public double ipd() {
    return material
        .form()
        .set(Question.Sets.IPD, history.answers(new SessionStep.Form()))
        .map(Double::parseDouble)
        .orElse(material.study().display().ipd());
  }

  /**
   * Ends a session whose steps are all finished: waits for the motion data and writes the tables of
   * answers.
   */
  public void end() throws IOException {
    motion.close();
    for (Map.Entry<String, String> table :
        SessionAnswerFiles.of(material, folder, history).entrySet()) {
      folder.writeOnce(table.getKey(), table.getValue());
    }
    journal.keep("session-finished", Map.of());
  }

  /**
   * Waits for files that are being written and releases the lock; a second call does nothing.
   *
   * @throws IOException if a file could not be written
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
