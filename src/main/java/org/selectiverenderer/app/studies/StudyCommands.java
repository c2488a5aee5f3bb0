package org.selectiverenderer.app.studies;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.process.ProgramCommand;

/** The commands of a study's window, for one study file. */
public final class StudyCommands {
  /** Name of the table of recognition answers in a folder of results. */
  public static final String RESPONSES = "responses.csv";

  /** Name of the table of trials in a folder of results. */
  public static final String TRIALS = "trials.csv";

  /** Name of the report in a folder of results. */
  public static final String REPORT = "report.html";

  /** Name of the page of a preview in its folder. */
  public static final String PREVIEW = "index.html";

  private final String study;

  public StudyCommands(Path study) {
    this.study = study.toString();
  }

  /** Creates a study in a folder; with a scene of the user's own, or with the program's. */
  public static ProgramCommand create(Path folder, Optional<Path> scene) {
    List<String> words = words("new", folder.toString());
    scene.ifPresent(file -> words.addAll(List.of("--scene", file.toString())));
    return new ProgramCommand(words);
  }

  /**
   * Copies an example of a design into a folder.
   *
   * @param design its name, as {@code experiment new --design} knows it
   */
  public static ProgramCommand copy(Path folder, String design) {
    List<String> words = words("new", folder.toString());
    words.addAll(List.of("--design", design));
    return new ProgramCommand(words);
  }

  /** Runs or resumes a session. */
  public ProgramCommand run(SessionRequest wanted) {
    List<String> words = words("run", study);
    words.addAll(List.of("--participant", wanted.participant()));
    if (wanted.session() != 1) {
      words.addAll(List.of("--session", Integer.toString(wanted.session())));
    }
    flag(words, wanted.resume(), "--resume");
    flag(words, wanted.somebodyNew(), "--new-participant");
    wanted.language().ifPresent(code -> words.addAll(List.of("--language", code)));
    flag(words, wanted.options().view(), "--operator");
    flag(words, wanted.options().withoutTracker(), "--without-tracker");
    flag(words, wanted.options().showCondition(), "--show-condition");
    flag(words, wanted.options().unattended(), "--unattended");
    return new ProgramCommand(words);
  }

  public ProgramCommand plan() {
    return new ProgramCommand(words("plan", study));
  }

  /** Writes the plan, with its picture, as a page. */
  public ProgramCommand planPage(Path page) {
    List<String> words = words("plan", study);
    words.addAll(List.of("--format", "html", "--output", page.toString()));
    return new ProgramCommand(words);
  }

  public ProgramCommand status(boolean showCondition) {
    List<String> words = words("status", study);
    flag(words, showCondition, "--show-condition");
    return new ProgramCommand(words);
  }

  public ProgramCommand check() {
    return new ProgramCommand(words("check", study));
  }

  /** Writes a page with all screens into a folder. */
  public ProgramCommand preview(Path folder) {
    List<String> words = words("preview", study);
    words.addAll(List.of("--output", folder.toString()));
    return new ProgramCommand(words);
  }

  /** Runs a session from a step on, with times shortened, apart from the data. */
  public ProgramCommand previewFrom(String step, int speed) {
    List<String> words = words("preview", study);
    words.addAll(List.of("--from", step, "--speed", Integer.toString(speed)));
    return new ProgramCommand(words);
  }

  /**
   * Collects the answers into tables of a folder.
   *
   * @param trials whether the study has blocks of trials
   */
  public ProgramCommand collect(Path folder, boolean trials) {
    List<String> words = words("collect", study);
    words.addAll(List.of("--responses", folder.resolve(RESPONSES).toString()));
    words.addAll(List.of("--answers", folder.resolve("answers.csv").toString()));
    words.addAll(List.of("--scores", folder.resolve("scores.csv").toString()));
    if (trials) {
      words.addAll(List.of("--trials", folder.resolve(TRIALS).toString()));
    }
    return new ProgramCommand(words);
  }

  /**
   * Analyses the recognition answers that were collected into a folder, or the trials, and writes
   * the report there.
   *
   * @param trials whether the study has blocks of trials
   */
  public ProgramCommand analyse(Path folder, boolean trials) {
    List<String> words = words("analyse", trials ? study : folder.resolve(RESPONSES).toString());
    if (trials) {
      words.addAll(List.of("--data", folder.resolve(TRIALS).toString()));
    }
    words.addAll(List.of("--format", "html", "--output", folder.resolve(REPORT).toString()));
    return new ProgramCommand(words);
  }

  private static List<String> words(String command, String first) {
    return new ArrayList<>(List.of("experiment", command, first));
  }

  private static void flag(List<String> words, boolean set, String name) {
    if (set) {
      words.add(name);
    }
  }
}
