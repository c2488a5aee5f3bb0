package org.selectiverenderer.study.web;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.ParticipantsFile;
import org.selectiverenderer.study.session.PlannedSession;
import org.selectiverenderer.study.session.SessionAnswerFiles;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.SessionHistory;
import org.selectiverenderer.study.session.SessionLock;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.study.session.StudyChecksums;

/**
 * Writes the folder of a session that ran in a browser, with the files that the program's own
 * sessions leave; what a later import adds replaces them together.
 */
final class WebSessionFiles {
  /** The records themselves, to which a later import adds. */
  static final String RECORDS = "web-records.jsonl";

  /** Member of the first event that tells the page's id of the session. */
  static final String SESSION = "web_session";

  private final LoadedStudy material;
  private final String software;
  private final WebExposureFiles exposures;
  private final Map<Integer, PlannedSession> plan = new HashMap<>();
  private final String checksum;
  private final RecordFaults faults;

  /**
   * Prepares to write.
   *
   * @param software name and version of the program
   */
  WebSessionFiles(
      LoadedStudy material, String software, WebExposureFiles exposures, RecordFaults faults)
      throws IOException {
    this.material = material;
    this.software = software;
    this.exposures = exposures;
    this.faults = faults;
    PlannedSession.all(material).forEach(session -> plan.put(session.place(), session));
    checksum = StudyChecksums.ofStudyFile(material);
  }

  /** Returns whether a session ran the study as it is now. */
  boolean present(WebRecord.Identity identity) {
    return identity.checksum().equals(checksum)
        && plan.get(identity.slot()).group().name().equals(identity.group());
  }

  /**
   * Writes a session.
   *
   * @param records at least one, in order of time, all of one session
   * @param before lines of the records that are kept already, which stay
   * @return the row of the table of participants; empty for one who refused or never began
   * @throws IOException if a file cannot be written, or another program has the folder
   */
  Optional<ParticipantsFile.Assigned> write(
      SessionFolder folder, List<WebRecord> records, List<String> before) throws IOException {
    Study study = material.study();
    Path path = folder.path();
    PrivateFiles.createFoldersIn(study.folder(), study.folder().relativize(path.resolve("head")));
    SessionLock lock = SessionLock.take(path, software); // nobody else writes the session meanwhile
    try (lock) {
      Map<Path, String> files = new LinkedHashMap<>();
      WebSessionJournal journal =
          new WebSessionEvents(
                  material,
                  software,
                  exposures,
                  faults,
                  plan.get(records.get(0).identity().slot()),
                  folder,
                  records,
                  files)
              .journal();
      SessionHistory history = SessionHistory.of(journal.events());
      if (history.over()) {
        SessionAnswerFiles.of(material, folder, history)
            .forEach((name, text) -> files.put(path.resolve(name), text));
      }
      if (records.get(0).identity().checksum().equals(checksum)) {
        files.put(path.resolve("study.json"), InputFileReader.text(study.file()));
      }
      files.put(path.resolve("settings.json"), settings(records));
      Set<String> kept = new LinkedHashSet<>(before);
      records.forEach(record -> kept.add(record.text()));
      files.put(path.resolve(RECORDS), String.join("\n", kept) + "\n");
      files.put(folder.journal(), journal.text());
      FileTransaction writing = new FileTransaction(FileOperations.PRIVATE_UNLINKED);
      files.forEach((file, text) -> writing.add(file, text.getBytes(StandardCharsets.UTF_8)));
      writing.commit();
      WebRecord.Identity identity = records.get(0).identity();
      return history.group().isEmpty()
          ? Optional.empty()
          : Optional.of(
              new ParticipantsFile.Assigned(
                  folder.participant(),
                  identity.group(),
                  identity.slot(),
                  Optional.empty(),
                  age(material, records),
                  false));
    }
  }

  private String settings(List<WebRecord> records) {
    Map<String, Object> settings = new LinkedHashMap<>();
    settings.put("software", software);
    settings.put("source", "web");
    settings.put("language", records.get(0).identity().language());
    settings.put("device", device(records));
    return JsonWriter.of(JsonTree.of(settings));
  }

  /** Returns what the page told of the device. */
  static Map<String, String> device(List<WebRecord> records) {
    return records.stream()
        .map(WebRecord::device)
        .filter(device -> !device.isEmpty())
        .findFirst()
        .orElse(Map.of());
  }

  /** Returns the age that the participant gave; empty for none. */
  static String age(LoadedStudy material, List<WebRecord> records) {
    Map<String, Answer> form = new HashMap<>();
    records.stream()
        .filter(record -> record.step() instanceof SessionStep.Form)
        .flatMap(record -> record.answers().stream())
        .forEach(given -> form.putIfAbsent(given.question().id(), given.answer()));
    return material.form().set(Question.Sets.AGE, form).orElse("");
  }
}
