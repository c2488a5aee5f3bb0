package org.selectiverenderer.app.studies;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.ParticipantIds;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.SessionLock;
import org.selectiverenderer.study.session.StudyPlan;
import org.selectiverenderer.study.session.StudyStatus;

/**
 * The state of a study: its plan, its sessions, and who comes next. It is what {@code experiment
 * plan} and {@code experiment status} tell.
 *
 * @param runs the sessions that run now, in whatever process
 * @param free free bytes of the disk with the study's folder
 * @param problems what is wrong with the study or with journals, no errors of the study's
 */
public record StudyOverview(
    LoadedStudy material,
    StudyPlan plan,
    StudyStatus status,
    ParticipantIds ids,
    Set<SessionFolder> runs,
    long free,
    List<Problem> problems) {
  /** Most places of the plan that are read; the command shows more. */
  static final int MOST_PLACES = 1_000;

  /** Free bytes below which a session may end too early, as {@code experiment check} has it. */
  public static final long LEAST_FREE = 200L << 20;

  public StudyOverview {
    runs = Set.copyOf(runs);
    problems = List.copyOf(problems);
  }

  /**
   * Reads a study and its sessions.
   *
   * @param trusted as in {@link LoadedStudy#read(Path, Predicate, ProblemCollector)}
   * @param problems receives what is wrong
   * @return empty if the study has errors
   * @throws IOException if a file cannot be read
   */
  public static Optional<StudyOverview> read(
      Path file, Predicate<Study> trusted, ProblemCollector problems) throws IOException {
    Optional<LoadedStudy> material = LoadedStudy.read(file, trusted, problems);
    return material.isEmpty() ? Optional.empty() : Optional.of(of(material.get(), problems.list()));
  }

  /** Reads the sessions of a study anew. */
  public StudyOverview again() throws IOException {
    return of(material, problems);
  }

  private static StudyOverview of(LoadedStudy material, List<Problem> known) throws IOException {
    Study study = material.study();
    ProblemCollector problems = new ProblemCollector();
    StudyStatus status = StudyStatus.of(material, problems);
    Set<SessionFolder> runs = new HashSet<>();
    for (SessionFolder folder : SessionFolder.all(study)) {
      if (SessionLock.held(folder.path())) {
        runs.add(folder);
      }
    }
    List<Problem> all = new ArrayList<>(known);
    problems.list().stream().filter(problem -> !all.contains(problem)).forEach(all::add);
    return new StudyOverview(
        material,
        StudyPlan.of(study, Math.max(1, Math.min(MOST_PLACES, study.participants()))),
        status,
        ParticipantIds.of(study),
        runs,
        Files.getFileStore(study.folder()).getUsableSpace(),
        all);
  }

  public Study study() {
    return material.study();
  }

  /** Returns whether conditions are hidden from the experimenter, unless they are asked for. */
  public boolean blind() {
    return study().course().blind();
  }

  /** Returns the status as the experimenter may see it. */
  public StudyStatus status(boolean showCondition) {
    return blind() && !showCondition ? status.blinded() : status;
  }

  /** Returns the place of the plan that comes next; empty if the plan is full. */
  public Optional<StudyPlan.Place> next() {
    return plan.places().stream().filter(place -> place.number() == plan.next()).findFirst();
  }

  /** Returns whether a session runs now. */
  public boolean running(String participant, int session) {
    return runs.stream()
        .anyMatch(folder -> folder.participant().equals(participant) && folder.number() == session);
  }

  /** Returns whether the disk has too little room for a session. */
  public boolean diskLow() {
    return free < LEAST_FREE;
  }

  /** Returns whether the study has blocks of trials. */
  public boolean trials() {
    return !study().design().blocks().isEmpty();
  }
}
