package org.selectiverenderer.study.archive;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.random.RandomGenerator;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileWriteException;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.ParticipantsTable;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.session.LoadedStudy;

/**
 * A study written as an anonymised package.
 *
 * @param participants number of participants in it
 * @param files number of files in it
 * @param outside names of files of the study that are not in it, since they are not in its folder
 */
public record ArchivePackage(int participants, int files, List<String> outside) {
  /** No date of the machine is in the package. */
  private static final LocalDateTime TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

  public ArchivePackage {
    outside = List.copyOf(outside);
  }

  /**
   * What is told about a package.
   *
   * @param authors of the study; may be empty
   * @param program name and version of the program
   * @param freeTexts whether free texts that participants wrote are in it, personal ones never
   */
  public record Origin(
      ArchiveLicence licence, List<String> authors, String program, boolean freeTexts) {
    public Origin {
      authors = List.copyOf(authors);
    }
  }

  /**
   * Writes the package, replacing an existing file.
   *
   * @param tables those of {@code study.export}, of one folder or of several sites
   * @param more further files of the tables by their names, such as scripts
   * @param random gives the new ids
   * @throws IOException if a file cannot be read or written
   */
  public static ArchivePackage write(
      LoadedStudy material,
      List<DataTable> tables,
      Map<String, String> more,
      Origin origin,
      RandomGenerator random,
      Path output,
      ProblemCollector problems)
      throws IOException {
    AnonymousTables anonymous = anonymous(material, tables, origin, random);
    List<DataTable> made = tables.stream().map(anonymous::of).toList();
    ArchivedFiles study = ArchivedFiles.of(material, System.getProperty("user.home", ""), problems);
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put(
        "README.md",
        utf8(
            new ArchiveReadme(material.study(), origin, anonymous.participants(), made, study)
                .text()));
    files.put("LICENSE.txt", utf8(origin.licence().text()));
    StudyExport.files(made).forEach((name, text) -> files.put("tables/" + name, utf8(text)));
    more.forEach((name, text) -> files.put("tables/" + name, utf8(text)));
    files.putAll(study.inside());
    StringBuilder sums = new StringBuilder();
    files.forEach(
        (name, content) -> sums.append(Sha256.of(content)).append("  ").append(name).append('\n'));
    files.put("SHA256SUMS", utf8(sums.toString()));
    try {
      AtomicFileWriter.write(output, zip(files), FileOperations.PRIVATE);
    } catch (FileWriteException e) {
      throw new IOException(output + ": " + e.reason(), e);
    }
    return new ArchivePackage(
        anonymous.participants(), files.size(), List.copyOf(study.outside().keySet()));
  }

  private static AnonymousTables anonymous(
      LoadedStudy material, List<DataTable> tables, Origin origin, RandomGenerator random) {
    Set<String> kinds = new HashSet<>();
    Set<String> columns = new HashSet<>();
    if (!origin.freeTexts()) {
      free(material, material.form(), kinds, columns);
      material.asked().forEach(asked -> free(material, asked.questionnaire(), kinds, columns));
    }
    Set<String> hidden = new HashSet<>();
    for (Question question : material.form().questions()) {
      if (!question.inTables() || kinds.contains(question.kind().spelling())) {
        hidden.add(question.id());
      }
    }
    return new AnonymousTables(
        tables,
        random,
        name -> ParticipantsTable.documented(name, material.form()) && !hidden.contains(name),
        kinds,
        columns);
  }

  /** Adds the kinds and columns of questions that are answered by words of one's own. */
  private static void free(
      LoadedStudy material, Questionnaire asked, Set<String> kinds, Set<String> columns) {
    for (Question question : asked.questions()) {
      if (question.kind().numbers().isEmpty()
          && question.kind().fields(material.wording()).stream()
              .anyMatch(AnswerField.Line.class::isInstance)) {
        kinds.add(question.kind().spelling());
        columns.add(asked.name() + "." + question.id());
      }
    }
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] zip(Map<String, byte[]> files) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes, StandardCharsets.UTF_8)) {
      for (Map.Entry<String, byte[]> file : files.entrySet()) {
        ZipEntry entry = new ZipEntry(file.getKey());
        entry.setTimeLocal(TIME);
        zip.putNextEntry(entry);
        zip.write(file.getValue());
        zip.closeEntry();
      }
    }
    return bytes.toByteArray();
  }
}
