package org.selectiverenderer.study.session;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.definition.Study;

/**
 * Begins or resumes sessions, records this in their journals, and warns the experimenter of
 * changes.
 */
final class SessionStarter {
  private final LoadedStudy material;
  private final SessionFolder folder;
  private final SessionOptions options;
  private final SessionJournal journal;
  private final Session session;
  private final Optional<Map<String, String>> checksums;
  private final ProblemCollector problems;

  private SessionStarter(Session session, ProblemCollector problems) {
    this(session, Optional.empty(), problems);
  }

  private SessionStarter(
      Session session, Optional<Map<String, String>> checksums, ProblemCollector problems) {
    this.session = session;
    this.checksums = checksums;
    this.problems = problems;
    material = session.material();
    folder = session.folder();
    options = session.options();
    journal = session.journal();
  }

  /** As {@link Session#begin}. */
  static Session begin(
      LoadedStudy material,
      String participant,
      int number,
      SessionOptions options,
      Optional<Map<String, String>> checksums,
      ProblemCollector problems)
      throws IOException {
    SessionFolder folder = new SessionFolder(material.study().folder(), participant, number);
    folder.create();
    SessionLock lock = SessionLock.take(folder.path(), options.software());
    boolean fresh = false;
    try {
      folder.requireNew();
      fresh = true;
      Session session =
          new Session(material, folder, options, lock, SessionJournal.begin(folder.journal()));
      try {
        new SessionStarter(session, checksums, problems).tellBegun();
        return session;
      } catch (IOException e) {
        try {
          session.journal().close();
        } catch (IOException again) {
          e.addSuppressed(again); // A full disk fails twice.
        }
        throw e;
      }
    } catch (IOException e) {
      lock.close();
      if (fresh) {
        withdraw(folder);
      }
      throw e;
    }
  }

  /**
   * Deletes what a failed start has written, which is nobody's data yet, so that a rerun begins
   * anew. What cannot be deleted, or holds anything else, stays.
   */
  private static void withdraw(SessionFolder folder) {
    for (Path made :
        List.of(
            folder.journal(),
            folder.path().resolve("study.json"),
            folder.path().resolve(SessionSettings.FILE),
            folder.path().resolve(SessionLock.HOLDER),
            folder.path().resolve(SessionLock.LOCK),
            folder.path().resolve("head"),
            folder.path(),
            folder.study().resolve("sub-" + folder.participant()))) {
      try {
        Files.deleteIfExists(made);
      } catch (IOException e) {
        continue; // Another file is in the folder, or the disk cannot be written at all.
      }
    }
  }

  private void tellBegun() throws IOException {
    for (Path made = folder.path();
        !made.equals(folder.study().getParent());
        made = made.getParent()) {
      DiskSync.forceFolder(made);
    }
    Map<String, Object> began = new LinkedHashMap<>();
    began.put("participant", folder.participant());
    began.put("session", folder.number());
    began.put("study", material.study().name());
    began.put("study_sha256", FileChecksumCalculator.of(material.study().file()));
    began.put("language", material.study().language());
    began.putAll(options.recorded());
    journal.keep("session-began", began);
    options.flags().forEach(flag -> journal.flag(flag, Map.of()));
    settings().write();
    tellConditionKept(
        new ParticipantsFile(material.study())
            .of(folder.participant())
            .map(ParticipantsFile.Assigned::group));
  }

  /** As {@link Session#resume}. */
  static Session resume(
      LoadedStudy material,
      String participant,
      int number,
      SessionOptions options,
      ProblemCollector problems)
      throws IOException {
    SessionFolder folder = new SessionFolder(material.study().folder(), participant, number);
    if (Files.isRegularFile(folder.journal())) {
      folder.create(); // refuses links before anything is written
      PrivateFiles.requireNoLink(folder.journal());
    } else {
      throw new IOException(folder.path() + " has no session to continue; leave --resume out");
    }
    SessionLock lock = SessionLock.take(folder.path(), options.software());
    try {
      Optional<Map<String, Object>> mended = JournalRecovery.mend(folder.journal(), problems);
      SessionJournal journal = SessionJournal.resume(folder.journal());
      try {
        if (journal.history().over() || journal.history().refused()) {
          throw new IOException(folder.path() + " is complete; there is nothing to continue");
        }
        requireLanguage(journal.history().language(), material.study(), folder);
        Session session = new Session(material, folder, options, lock, journal);
        new SessionStarter(session, problems).tellResumed(mended);
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

  /** Refuses another language: the answers before and after would be to different texts. */
  private static void requireLanguage(Optional<String> began, Study study, SessionFolder folder)
      throws IOException {
    if (began.isPresent() && !began.get().equals(study.language())) {
      throw new IOException(
          study.languages().contains(began.get())
              ? "%s began in the language '%s', not in '%s'; it is continued in it if --language is left out"
                  .formatted(folder.path(), began.get(), study.language())
              : "%s began in the language '%s', which the study no longer has"
                  .formatted(folder.path(), began.get()));
    }
  }

  private void tellResumed(Optional<Map<String, Object>> mended) throws IOException {
    if (mended.isPresent()) {
      journal.keep("journal-mended", mended.get());
    }
    SessionHistory history = journal.history();
    String sum = FileChecksumCalculator.of(material.study().file());
    Map<String, Object> resumed = new LinkedHashMap<>();
    resumed.put(
        "finished",
        material.steps().stream().filter(history::finished).map(SessionStep::id).toList());
    resumed.put("study_sha256", sum);
    resumed.putAll(options.recorded());
    journal.keep("resumed", resumed);
    boolean shows = session.remaining().stream().anyMatch(SessionStep::shows);
    for (SessionFlag flag : options.flags()) {
      if (flag != SessionFlag.TRACKER_ABSENT || shows) { // Questions need no tracker.
        journal.flag(flag, Map.of());
      }
    }
    if (!Files.exists(folder.path().resolve(SessionSettings.FILE))) {
      settings().write();
    }
    if (!history.checksum().equals(sum)) {
      problems.warning(
          SourceLocation.of(material.study().file().toString()),
          "the study has changed since this session began; the session continues "
              + "with the present study, and its events record this");
    }
    List<String> changed = settings().changedFiles();
    if (!changed.isEmpty()) {
      problems.warning(
          SourceLocation.of(folder.path().resolve(SessionSettings.FILE).toString()),
          ("%s changed since this session began; the session continues with the "
                      + "present files, and its events")
                  .formatted(String.join(", ", changed))
              + " record this");
      journal.keep("files-changed", Map.of("files", changed));
    }
    history.headLogs().forEach(session::writeMotion);
    tellConditionKept(history.group());
  }

  /**
   * Warns that a participant keeps the condition of the first session if another one is requested.
   */
  private void tellConditionKept(Optional<String> kept) throws IOException {
    Optional<String> asked = options.group();
    if (kept.isPresent() && asked.isPresent() && !kept.equals(asked)) {
      problems.warning(
          SourceLocation.of(new ParticipantsFile(material.study()).file().toString()),
          "participant %s keeps the assigned condition %s; --condition %s is ignored"
              .formatted(folder.participant(), kept.get(), asked.get()));
      journal.keep("condition-kept", Map.of("asked_for", asked.get()));
    }
  }

  private SessionSettings settings() {
    return new SessionSettings(material, folder, options, checksums);
  }

  /**
   * The settings at the begin of a session: a copy of the study file, the options, and checksums of
   * scenes and questionnaires.
   */
  private record SessionSettings(
      LoadedStudy material,
      SessionFolder folder,
      SessionOptions options,
      Optional<Map<String, String>> checksums) {
    static final String FILE = "settings.json";

    /** Writes the settings into the session's folder. */
    void write() throws IOException {
      folder.writeOnce("study.json", InputFileReader.text(material.study().file()));
      Map<String, Object> settings = new LinkedHashMap<>(options.recorded());
      settings.put("language", material.study().language());
      settings.put("sha256", checksums.isPresent() ? checksums.get() : StudyChecksums.of(material));
      folder.writeOnce(FILE, JsonWriter.of(JsonTree.of(settings)));
    }

    /** Returns those of the files that have changed since the session began. */
    List<String> changedFiles() throws IOException {
      JsonNode before = JsonTree.read(folder.path().resolve(FILE)).path("sha256");
      return StudyChecksums.of(material).entrySet().stream()
          // An earlier version of the program recorded fewer files.
          .filter(sum -> before.has(sum.getKey()))
          .filter(sum -> !before.path(sum.getKey()).asText().equals(sum.getValue()))
          .map(Map.Entry::getKey)
          .toList();
    }
  }
}
