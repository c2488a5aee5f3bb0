package org.selectiverenderer.experiment.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.questionnaire.Answer;
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

  /** A session that {@link SessionOpening} has begun or goes on with, and tells of. */
  Session(
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
    return SessionOpening.begin(material, participant, number, options, problems);
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
    return SessionOpening.resume(material, participant, number, options, problems);
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

  /** Writes the motion data of a head log, beside what is done. */
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
    new SessionTables(material, folder).write(history);
    journal.keep("session-finished", Map.of());
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
