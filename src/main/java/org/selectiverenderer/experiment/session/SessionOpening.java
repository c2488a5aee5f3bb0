package org.selectiverenderer.experiment.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.files.Disk;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.study.SessionFlag;

/**
 * Begins or resumes sessions, records this in their journals, and warns the experimenter of
 * changes.
 */
final class SessionOpening {
  private final StudyMaterial material;
  private final SessionFolder folder;
  private final SessionOptions options;
  private final SessionJournal journal;
  private final Session session;
  private final Problems problems;

  private SessionOpening(Session session, Problems problems) {
    this.session = session;
    this.problems = problems;
    material = session.material();
    folder = session.folder();
    options = session.options();
    journal = session.journal();
  }

  /** As {@link Session#begin}. */
  static Session begin(
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
        new SessionOpening(session, problems).tellBegun();
        return session;
      } catch (IOException e) {
        session.journal().close();
        throw e;
      }
    } catch (IOException e) {
      lock.close();
      throw e;
    }
  }

  private void tellBegun() throws IOException {
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
    settings().write();
    tellConditionKept(
        new Participants(material.study())
            .of(folder.participant())
            .map(Participants.Assigned::condition));
  }

  /** As {@link Session#resume}. */
  static Session resume(
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
        new SessionOpening(session, problems).tellResumed(mended);
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

  private void tellResumed(Optional<Map<String, Object>> mended) throws IOException {
    if (mended.isPresent()) {
      journal.keep("journal-mended", mended.get());
    }
    SessionHistory history = journal.history();
    String sum = Checksums.of(material.study().file());
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
    Files.createDirectories(folder.path().resolve("head"));
    if (!Files.exists(folder.path().resolve(SessionSettings.FILE))) {
      settings().write();
    }
    if (!history.checksum().equals(sum)) {
      problems.warning(
          Location.of(material.study().file().toString()),
          "the study has changed since this session began; the session continues "
              + "with the present study, and its events record this");
    }
    List<String> changed = settings().changedFiles();
    if (!changed.isEmpty()) {
      problems.warning(
          Location.of(folder.path().resolve(SessionSettings.FILE).toString()),
          ("%s changed since this session began; the session continues with the "
                      + "present files, and its events")
                  .formatted(String.join(", ", changed))
              + " record this");
      journal.keep("files-changed", Map.of("files", changed));
    }
    history.headLogs().forEach(session::writeMotion);
    tellConditionKept(history.condition());
  }

  /**
   * Warns that a participant keeps the condition of the first session if another one is requested.
   */
  private void tellConditionKept(Optional<Condition> kept) throws IOException {
    Optional<Condition> asked = options.condition();
    if (kept.isPresent() && asked.isPresent() && !kept.equals(asked)) {
      problems.warning(
          Location.of(new Participants(material.study()).file().toString()),
          "participant %s keeps the assigned condition %s; --condition %s is ignored"
              .formatted(folder.participant(), kept.get().spelling(), asked.get().spelling()));
      journal.keep("condition-kept", Map.of("asked_for", asked.get().spelling()));
    }
  }

  private SessionSettings settings() {
    return new SessionSettings(material, folder, options);
  }
}
