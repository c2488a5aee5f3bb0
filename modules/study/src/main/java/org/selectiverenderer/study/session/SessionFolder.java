package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.study.definition.Study;

/**
 * The folder of a session, {@code sub-ID/ses-NN} in the study's folder, and the names of its files.
 *
 * @param participant the participant's id: letters and digits
 * @param number of the session, from 1
 */
public record SessionFolder(Path study, String participant, int number) {
  /** Pattern of a participant's id: a BIDS label. */
  public static final String LABEL = "[0-9A-Za-z]+";

  private static final Pattern HEAD_NAME = Pattern.compile("[^/\\\\:\\p{Cntrl}]+_run-\\d{2,9}");

  /** Returns the folders of all sessions of a study, in order. */
  public static List<SessionFolder> all(Study study) throws IOException {
    List<SessionFolder> all = new ArrayList<>();
    for (Path subject : named(study.folder(), "sub-" + LABEL)) {
      for (Path session : named(subject, "ses-\\d{2,9}")) {
        SessionFolder found =
            new SessionFolder(study.folder(), label(subject), Integer.parseInt(label(session)));
        if (Files.isRegularFile(found.journal())) {
          all.add(found);
        }
      }
    }
    return all;
  }

  /** Returns the folder of the session, with a journal, that has a head log; empty if none has. */
  public static Optional<SessionFolder> ofHeadLog(Path log) {
    Path head = log.toAbsolutePath().normalize().getParent();
    Path session = head == null ? null : head.getParent();
    Path subject = session == null ? null : session.getParent();
    Path study = subject == null ? null : subject.getParent();
    if (study == null
        || !String.valueOf(head.getFileName()).equals("head")
        || !String.valueOf(session.getFileName()).matches("ses-\\d{2,9}")
        || !String.valueOf(subject.getFileName()).matches("sub-" + LABEL)) {
      return Optional.empty();
    }
    SessionFolder found =
        new SessionFolder(study, label(subject), Integer.parseInt(label(session)));
    return Optional.of(found).filter(folder -> Files.isRegularFile(folder.journal()));
  }

  /** Returns the ids of the participants with a folder, as the folders spell them. */
  static List<String> participants(Study study) throws IOException {
    return named(study.folder(), "sub-" + LABEL).stream().map(SessionFolder::label).toList();
  }

  private static String label(Path path) {
    return path.getFileName().toString().substring(4);
  }

  /** Lists folders; a link to one would count the data of another study as this one's. */
  private static List<Path> named(Path folder, String pattern) throws IOException {
    List<Path> named;
    try (Stream<Path> found = Files.list(folder)) {
      named =
          found
              .filter(path -> path.getFileName().toString().matches(pattern))
              .filter(Files::isDirectory)
              .sorted()
              .toList();
    }
    for (Path path : named) {
      PrivateFiles.requireNoLink(path);
    }
    return named;
  }

  /** Returns the path of the folder. */
  public Path path() {
    return study
        .resolve("sub-" + participant)
        .resolve(String.format(Locale.ROOT, "ses-%02d", number));
  }

  /**
   * Creates the folders of the session where they do not exist, for the experimenter's account
   * only.
   *
   * @throws IOException if one of them is a link, by which data would end up elsewhere
   */
  void create() throws IOException {
    PrivateFiles.createFoldersIn(study, study.relativize(path().resolve("head")));
  }

  /** Returns the journal's file. */
  public Path journal() {
    return path().resolve("events.jsonl");
  }

  /**
   * Checks that the session can be begun.
   *
   * @throws IOException if the session was begun before, with a message that says what to do
   */
  void requireNew() throws IOException {
    if (Files.exists(journal())) {
      throw new IOException(
          path()
              + " exists already: --resume continues it, --session "
              + (number + 1)
              + " begins a new one");
    }
  }

  /** Returns the head log's file of a run of a step, from 1. */
  public Path headLog(SessionStep step, int run) {
    return path().resolve("head").resolve(headName(step, run) + ".csv");
  }

  static String headName(SessionStep step, int run) {
    return String.format(Locale.ROOT, "%s_run-%02d", step.id(), run);
  }

  /** Returns whether a text is the name of a head log: a step's id and the number of a run. */
  static boolean isHeadName(String name) {
    return HEAD_NAME.matcher(name).matches();
  }

  /** Returns the name of a head log's BIDS motion data, up to the suffix. */
  String motionStem(String headName) {
    int at = headName.lastIndexOf("_run-");
    return String.format(
        Locale.ROOT,
        "sub-%s_ses-%02d_task-%s_tracksys-head%s",
        participant,
        number,
        task(headName),
        headName.substring(at));
  }

  /** Returns the BIDS task label of a head log. */
  static String task(String headName) {
    return label(headName.substring(0, headName.lastIndexOf("_run-")));
  }

  /** Returns the BIDS label of a step: its letters and digits. */
  public static String label(String step) {
    return step.replaceAll("[^0-9A-Za-z]", "");
  }

  /**
   * Writes a file that is never overwritten. An existing file with the same text was written before
   * a crash, and stays.
   *
   * @throws IOException if the file exists with another text, or cannot be written
   */
  void writeOnce(String name, String text) throws IOException {
    AtomicFileWriter.writeOnce(path().resolve(name), text, FileOperations.PRIVATE_UNLINKED);
  }
}
