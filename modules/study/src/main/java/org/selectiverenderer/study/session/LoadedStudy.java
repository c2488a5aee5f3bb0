package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Moment;
import org.selectiverenderer.study.definition.StudyReader;
import org.selectiverenderer.study.design.PlannedAnalysis;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSequencer;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;

/**
 * A study with its questionnaires and messages, loaded and checked.
 *
 * @param form consent and questions about the person; the questionnaire of the step {@code form}
 * @param asked all other questionnaires, in the study's order
 */
public record LoadedStudy(
    Study study, Questionnaire form, List<Asked> asked, ParticipantMessages wording) {

  /** What analyses compare beside the answers to questions. */
  private static final List<String> MEASURES =
      List.of(
          PlannedAnalysis.MILLISECONDS,
          PlannedAnalysis.CORRECT,
          PlannedAnalysis.D_PRIME,
          PlannedAnalysis.THRESHOLD);

  /** A questionnaire with the moment at which it is asked. */
  public record Asked(Questionnaire questionnaire, Moment moment) {
    SessionStep.Questions step() {
      return new SessionStep.Questions(questionnaire.name(), questionnaire.area());
    }
  }

  public LoadedStudy {
    asked = List.copyOf(asked);
  }

  /** Reads a study of one's own, which may have what it asks for. */
  public static Optional<LoadedStudy> read(Path file, ProblemCollector problems)
      throws IOException {
    return read(file, Optional.empty(), study -> true, problems);
  }

  /**
   * Reads a study file and the files that it refers to. The texts of all languages of the study are
   * checked.
   *
   * @param language one of the study's languages; empty for the first
   * @param check is called before any other file is read; it throws an exception if the study must
   *     not have what it asks for, and returns whether the text of scenes outside of its folder and
   *     project may be read
   * @return empty if there are faults, which are then in {@code problems}
   * @throws IOException if a file cannot be read
   */
  public static Optional<LoadedStudy> read(
      Path file, Optional<String> language, Predicate<Study> check, ProblemCollector problems)
      throws IOException {
    return readAll(file, language, check, problems).map(all -> all.get(0));
  }

  /**
   * Reads a study in all of its languages.
   *
   * @param first the language that comes first in the result; empty for the first of the study. The
   *     others follow in the study's order.
   * @param check as for {@link #read(Path, Optional, Predicate, ProblemCollector)}
   * @return empty if there are faults in any language
   * @throws IOException if a file cannot be read
   */
  public static Optional<List<LoadedStudy>> readAll(
      Path file, Optional<String> first, Predicate<Study> check, ProblemCollector problems)
      throws IOException {
    AtomicBoolean readable = new AtomicBoolean();
    Optional<Study> study =
        StudyReader.read(
            file,
            first,
            read -> {
              readable.set(check.test(read));
              return readable.get();
            },
            problems);
    if (study.isEmpty()) {
      return Optional.empty();
    }
    Set<String> told = new HashSet<>();
    ProblemCollector once =
        new ProblemCollector(
            problem -> {
              if (told.add(problem.toString())) { // Most faults are those of all languages.
                problems.add(problem);
              }
            });
    List<LoadedStudy> all = new ArrayList<>();
    boolean whole = load(study.get(), once, all);
    for (String other : study.get().languages()) {
      if (!other.equals(study.get().language())) {
        Optional<Study> translated =
            StudyReader.read(file, Optional.of(other), read -> readable.get(), once);
        whole &= translated.isPresent() && load(translated.get(), once, all);
      }
    }
    return whole ? Optional.of(List.copyOf(all)) : Optional.empty();
  }

  private static boolean load(Study study, ProblemCollector problems, List<LoadedStudy> all)
      throws IOException {
    Optional<LoadedStudy> loaded = load(study, problems);
    loaded.ifPresent(all::add);
    return loaded.isPresent();
  }

  private static Optional<LoadedStudy> load(Study study, ProblemCollector problems)
      throws IOException {
    Optional<ParticipantMessages> wording =
        ParticipantMessages.of(study.language(), study.folder(), problems);
    if (wording.isEmpty()) {
      return Optional.empty();
    }
    StudyQuestionnaireLoader all = new StudyQuestionnaireLoader(study, wording.get(), problems);
    Optional<Questionnaire> form = all.form();
    Optional<List<Asked>> asked = all.asked();
    if (form.isEmpty() || asked.isEmpty()) {
      return Optional.empty();
    }
    LoadedStudy material = new LoadedStudy(study, form.get(), asked.get(), wording.get());
    material.tellDesk(problems);
    return material.distinct(problems)
            && material.asksKnown(problems)
            && material.analysesKnown(problems)
        ? Optional.of(material)
        : Optional.empty();
  }

  /** As {@link Study#at}. */
  public LoadedStudy at(Path file) {
    return new LoadedStudy(study.at(file), form, asked, wording);
  }

  /** Returns whether the questions of a step are answered inside the headset. */
  public boolean insideHeadset(SessionStep step) {
    return study.display().worn().asked()
        && scenery().isPresent()
        && asked.stream().anyMatch(each -> each.step().equals(step));
  }

  /**
   * Returns the scene that is shown behind questions inside the headset: that of the practice, else
   * that of the study.
   */
  public Optional<Path> scenery() {
    return study.practice().map(Study.Practice::scene).or(study::scene);
  }

  /** Returns a sentence if there is no scene in which the trials of a block could be shown. */
  public Optional<String> lackingScene() {
    if (scenery().isPresent()) {
      return Optional.empty();
    }
    return study.design().blocks().stream()
        .filter(
            block ->
                study.design().groups().stream()
                    .flatMap(
                        group ->
                            new TrialSequencer(block, group, study.seed())
                                .trials(0, 1).orElse(List.of()).stream())
                    .anyMatch(trial -> study.scene(trial).isEmpty()))
        .findFirst()
        .map(
            block ->
                "the block %s has trials without a scene in which they could be shown; name a \"scene\" in the study, in its levels or in its stimuli"
                    .formatted(block.name()));
  }

  /** Warns if the study wants questions inside the headset but has no scene to show them in. */
  private void tellDesk(ProblemCollector problems) {
    if (study.display().worn().asked() && scenery().isEmpty()) {
      problems.warning(
          SourceLocation.of(study.file().toString()),
          "questions in the headset need the study's \"scene\" or \"practice\" as background, and"
              + " there is neither; all questions are asked at the desk");
    }
  }

  /** Checks that the ids of the steps, and their BIDS labels, are unique. */
  private boolean distinct(ProblemCollector problems) {
    Map<String, String> ids = new HashMap<>();
    for (SessionStep step : steps()) {
      String other = ids.put(SessionFolder.label(step.id()), step.id());
      if (other != null) {
        problems.error(
            SourceLocation.of(study.file().toString()),
            (other.equals(step.id())
                    ? "two steps of a session would have the id %s; give one of the questionnaires"
                        + " another \"name\". The study is not used"
                    : "the steps %s and %s would have the same file names, which contain letters and"
                        + " digits only; give one of the questionnaires another \"name\". The study"
                        + " is not used")
                .formatted(other, step.id()));
        return false;
      }
    }
    return true;
  }

  /** Checks that the questionnaires that trials name are there. */
  private boolean asksKnown(ProblemCollector problems) {
    boolean known = true;
    for (TrialBlock block : study.design().blocks()) {
      for (TrialPhase phase : block.phases()) {
        if (phase instanceof TrialPhase.Questions questions
            && inTrials(questions.questionnaire()).isEmpty()) {
          problems.error(
              SourceLocation.of(study.file().toString()),
              ("the block %s asks the questionnaire '%s', which the study's \"questionnaires\" do"
                      + " not have with \"when\": \"in-trials\". The study is not used")
                  .formatted(block.name(), questions.questionnaire()));
          known = false;
        }
      }
    }
    return known;
  }

  /** Checks that the questions that planned analyses name are asked in trials. */
  private boolean analysesKnown(ProblemCollector problems) {
    boolean known = true;
    Set<String> columns = trialQuestions().keySet();
    for (PlannedAnalysis analysis : study.design().analyses()) {
      List<String> named = new ArrayList<>(List.of(analysis.measure()));
      named.addAll(analysis.exclude().keySet());
      analysis.where().keySet().stream().filter(name -> name.indexOf('.') >= 0).forEach(named::add);
      named.removeAll(MEASURES);
      for (String name : named) {
        if (!columns.contains(name)) {
          problems.error(
              analysis.place(),
              "'%s' is none of %s and the questions that trials ask%s the study is not used"
                  .formatted(
                      name,
                      String.join(", ", MEASURES),
                      SpellingSuggester.nearest(name, List.copyOf(columns))
                          .map(near -> ", such as '" + near + "';")
                          .orElse(
                              columns.isEmpty() ? ";" : " (" + String.join(", ", columns) + ");")));
          known = false;
        }
      }
    }
    return known;
  }

  /** Returns the questions that trials ask by their columns in the table of trials. */
  public Map<String, Question> trialQuestions() {
    Map<String, Question> columns = new LinkedHashMap<>();
    questionsInTrials()
        .forEach(
            (name, questions) ->
                questions.forEach(question -> columns.put(name + "." + question.id(), question)));
    return columns;
  }

  /** Returns the questions that trials ask and tables have, by the names of the questionnaires. */
  Map<String, List<Question>> questionsInTrials() {
    Map<String, List<Question>> questions = new LinkedHashMap<>();
    for (TrialBlock block : study.design().blocks()) {
      for (TrialPhase phase : block.phases()) {
        if (phase instanceof TrialPhase.Questions named) {
          questions.put(
              named.questionnaire(),
              inTrials(named.questionnaire()).stream()
                  .flatMap(questionnaire -> questionnaire.questions().stream())
                  .filter(Question::inTables)
                  .toList());
        }
      }
    }
    return questions;
  }

  /** Returns a questionnaire that trials ask, by its name. */
  public Optional<Questionnaire> inTrials(String name) {
    return asked.stream()
        .filter(each -> each.moment() == Moment.IN_TRIALS)
        .map(Asked::questionnaire)
        .filter(each -> each.name().equals(name))
        .findFirst();
  }

  /** Returns the sound files that are played to participants, each once. */
  public Set<Path> audio() {
    Set<Path> files = new LinkedHashSet<>(study.design().audio());
    Stream.concat(Stream.of(form), asked.stream().map(Asked::questionnaire))
        .flatMap(one -> one.pages().stream())
        .forEach(page -> page.audio().ifPresent(files::add));
    return files;
  }

  /** Returns the steps of a session, with the areas in the order of the study file. */
  public List<SessionStep> steps() {
    return steps(study.areas());
  }

  /**
   * Returns the steps of a session, in order.
   *
   * @param areas all areas of the study, in the order in which they are shown
   */
  List<SessionStep> steps(List<Study.Area> areas) {
    List<SessionStep> steps = new ArrayList<>();
    steps.add(new SessionStep.Form());
    steps.addAll(asked(Moment.BEGIN));
    study.practice().ifPresent(practice -> steps.add(new SessionStep.Practice(practice)));
    steps.addAll(asked(Moment.AFTER_PRACTICE));
    study.design().blocks().forEach(block -> steps.add(new SessionStep.Block(block)));
    List<SessionStep.Questions> after = new ArrayList<>(asked(Moment.AFTER_AREA));
    // In a study with blocks the areas are shown by trials.
    for (Study.Area area : study.design().blocks().isEmpty() ? areas : List.<Study.Area>of()) {
      steps.add(new SessionStep.Exposure(area));
      List<SessionStep.Questions> now =
          after.stream().filter(step -> step.area().equals(area.name())).toList();
      steps.addAll(now);
      after.removeAll(now);
    }
    steps.addAll(after); // Questionnaires about parts of areas, which have no exposure.
    steps.addAll(asked(Moment.END));
    return List.copyOf(steps);
  }

  private List<SessionStep.Questions> asked(Moment moment) {
    return asked.stream().filter(each -> each.moment() == moment).map(Asked::step).toList();
  }

  /** Returns the questionnaire of a step in a participant's order of questions. */
  public Questionnaire questionnaire(SessionStep step, String participant) {
    if (step instanceof SessionStep.Form) {
      return form;
    }
    return asked.stream()
        .filter(each -> each.step().equals(step))
        .findFirst()
        .map(each -> each.questionnaire().ordered(study.seed(), participant))
        .orElseThrow(() -> new IllegalArgumentException("no questions in " + step.id()));
  }

  /**
   * Returns the questionnaire of a step by the step's id; empty if the study has no such step, or
   * it has no questionnaire.
   */
  public Optional<Questionnaire> questionnaire(String step, String participant) {
    return steps().stream()
        .filter(one -> asks(one) && one.id().equals(step))
        .findFirst()
        .map(one -> questionnaire(one, participant));
  }

  /** Returns all questionnaires of a participant, in order, without the form. */
  public List<Questionnaire> questionnaires(String participant) {
    return steps().stream()
        .filter(SessionStep.Questions.class::isInstance)
        .map(step -> questionnaire(step, participant))
        .toList();
  }

  /** Returns whether a step has a questionnaire: the form, and questions. */
  static boolean asks(SessionStep step) {
    return step instanceof SessionStep.Form || step instanceof SessionStep.Questions;
  }
}
