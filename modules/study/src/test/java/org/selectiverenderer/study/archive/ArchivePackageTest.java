package org.selectiverenderer.study.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.dataset.RecordedStudyFixture;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PaperAnswers;

/** Opens packages of the study with pauses, notes, a crash and personal answers. */
class ArchivePackageTest {
  @TempDir Path folder;
  private Path study = Path.of("");
  private final ProblemCollector problems = new ProblemCollector();

  @BeforeEach
  void write() throws IOException {
    study = Files.createDirectory(folder.resolve("hall"));
    RecordedStudyFixture.write(study);
    // A lab's own column, an error that names the machine, and one who refused.
    Path people = study.resolve("participants.tsv");
    Files.writeString(
        people,
        Files.readString(people)
            .replace("\tsex\n", "\tsex\tphone\n")
            .replace("\tfemale\n", "\tfemale\t6977001122\n")
            .replace("\trather not say\n", "\trather not say\t6977003344\n"));
    Path journal = study.resolve("sub-001/ses-01/events.jsonl");
    Files.writeString(
        journal,
        Files.readString(journal)
            .replace(
                "{\"time\":\"2026-03-01T10:00:19.000+02:00\"",
                "{\"time\":\"2026-03-01T10:00:18.700+02:00\",\"event\":\"problem\",\"step\":"
                    + "\"exposure-hall\",\"text\":\"/home/maria/lab-pc-7/x.png is missing\"}\n"
                    + "{\"time\":\"2026-03-01T10:00:19.000+02:00\""));
    Path refused = Files.createDirectories(study.resolve("sub-Nein/ses-01"));
    Files.writeString(
        refused.resolve("events.jsonl"),
        """
        {"time":"2026-03-02T10:00:00.000+02:00","event":"session-began","participant":"Nein","session":1,"software":"x"}
        {"time":"2026-03-02T10:00:05.000+02:00","event":"refused"}
        """);
  }

  private LoadedStudy material() throws IOException {
    return RecordedStudyFixture.material(study);
  }

  private Map<String, String> opened(boolean freeTexts, long seed) throws IOException {
    Path output = folder.resolve("hall.zip");
    CollectedAnswers answers =
        CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), problems);
    ArchivePackage.write(
        material(),
        StudyExport.tables(
            RecordedStudy.read(material(), problems), StudyExport.Answers.of(answers), problems),
        Map.of(),
        new ArchivePackage.Origin(
            ArchiveLicence.CC_BY, List.of("A. Zotos"), "selective-renderer 1", freeTexts),
        new Random(seed * 0x9E3779B97F4A7C15L),
        output,
        problems);
    Map<String, String> files = new LinkedHashMap<>();
    try (InputStream in = Files.newInputStream(output);
        ZipInputStream zip = new ZipInputStream(in, StandardCharsets.UTF_8)) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        assertThat(entry.getTimeLocal().getYear()).isEqualTo(1980);
        files.put(entry.getName(), new String(zip.readAllBytes(), StandardCharsets.UTF_8));
      }
    }
    return files;
  }

  @Test
  void aPackageHasAllThatAnArchiveAsksFor() throws IOException {
    Map<String, String> files = opened(false, 1);
    assertThat(files)
        .containsKeys(
            "README.md",
            "LICENSE.txt",
            "SHA256SUMS",
            "tables/codebook.csv",
            "tables/codebook.json",
            "tables/tables.R",
            "tables/participants.csv",
            "tables/sessions.csv",
            "tables/exposures.csv",
            "tables/gaze.csv",
            "tables/events.csv",
            "tables/responses.csv",
            "study/study.json",
            "study/form.json",
            "study/r.csv",
            "study/hall.x3d");
    assertThat(files.get("README.md"))
        .contains("# Hall, tried", "By A. Zotos", "2 participants", "CC-BY-4.0");
    assertThat(files.get("LICENSE.txt")).contains("creativecommons.org/licenses/by/4.0/");
    assertThat(files.get("SHA256SUMS").lines())
        .hasSize(files.size() - 1)
        .allSatisfy(
            line -> {
              String[] parts = line.split("  ", 2);
              byte[] content = files.get(parts[1]).getBytes(StandardCharsets.UTF_8);
              assertThat(parts[0]).isEqualTo(Sha256.of(content));
            });
  }

  @Test
  void nothingInItTellsWhoTookPart() throws IOException {
    Map<String, String> files = opened(false, 1);
    String names = String.join("\n", files.keySet());
    String all = String.join("\n", files.values());
    String tables =
        files.entrySet().stream()
            .filter(file -> file.getKey().startsWith("tables/") && file.getKey().endsWith(".csv"))
            .map(Map.Entry::getValue)
            .collect(Collectors.joining("\n"));
    assertThat(names).doesNotContain("sub-", "participants.tsv", "events.jsonl", "head");
    // Personal answers, notes, free texts, telephone numbers, machines, paths, who refused.
    assertThat(all)
        .doesNotContain(
            "Maria Nobody",
            "sneezed",
            "brown",
            "but\" fine",
            "697700",
            "maria",
            "lab-pc-7",
            "Nein",
            "sub-001",
            "sub-P2",
            folder.toString(),
            System.getProperty("user.dir"));
    assertThat(tables)
        .doesNotContainPattern("(?m)^(001|P2),")
        .doesNotContain("2026", "place,assigned_by", "events.jsonl", "phone", "head_log")
        .contains("1900-01-01T00:00:00Z");
  }

  @Test
  void durationsAndDifferencesAreAsTheyWere() throws IOException {
    Map<String, String> files = opened(false, 1);
    assertThat(files.get("tables/sessions.csv"))
        .containsPattern("P00[12],1,1900-01-01T00:00:00Z,30,");
    // The first frame was 12 seconds after the session's beginning.
    assertThat(files.get("tables/exposures.csv")).contains("1900-01-01T00:00:12Z");
    assertThat(files.get("tables/events.csv")).contains(",exposure,", ",problem,");
    assertThat(files.get("tables/codebook.csv"))
        .contains("moved by a constant for each participant", "given by chance");
  }

  @Test
  void idsAreByChanceAndRowsAreSortedByThem() throws IOException {
    boolean first = false;
    boolean second = false;
    for (int seed = 0; seed < 20; seed++) {
      List<String> lines = opened(false, seed).get("tables/participants.csv").lines().toList();
      assertThat(lines).hasSize(3);
      assertThat(lines.get(1)).startsWith("sub-P001,");
      assertThat(lines.get(2)).startsWith("sub-P002,");
      first |= lines.get(1).contains(",selective,");
      second |= lines.get(1).contains(",high,");
    }
    assertThat(first && second).as("both are P001 at times").isTrue();
  }

  @Test
  void freeTextsAreTakenOnlyOnDemandAndPersonalOnesNever() throws IOException {
    String answers = opened(true, 1).get("tables/answers.csv");
    assertThat(answers).contains("fine", "brown").doesNotContain("Maria Nobody");
  }

  @Test
  void pathsOfTheMachineAreTakenOutOfTheStudysFiles() throws IOException {
    Path form = study.resolve("form.json");
    Files.writeString(
        form,
        Files.readString(form)
            .replace("Colour of the eyes", "/home/maria/pictures/eyes.png")
            .replace("\"Name\"", "\"C:\\\\Users\\\\maria\\\\name.png\""));
    Map<String, String> files = opened(false, 1);
    assertThat(files.get("study/form.json"))
        .contains("\"eyes.png\"", "\"name.png\"")
        .doesNotContain("maria");
    assertThat(problems.list().toString()).contains("the file names absolute paths");
  }

  @Test
  void filesOutsideOfTheFolderAreToldByNameAndChecksum() throws IOException {
    Files.move(study.resolve("hall.x3d"), folder.resolve("hall.x3d"));
    Path file = study.resolve("study.json");
    Files.writeString(file, Files.readString(file).replace("\"hall.x3d\"", "\"../hall.x3d\""));
    Map<String, String> files = opened(false, 1);
    assertThat(files).doesNotContainKey("study/hall.x3d");
    assertThat(files.get("README.md"))
        .contains("| hall.x3d | " + Sha256.of(Files.readAllBytes(folder.resolve("hall.x3d"))));
  }
}
