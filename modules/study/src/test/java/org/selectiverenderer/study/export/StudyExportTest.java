package org.selectiverenderer.study.export;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.SpreadsheetText;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.dataset.RecordedStudyFixture;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PaperAnswers;
import org.selectiverenderer.testing.RequiresProgram;

class StudyExportTest {
  @TempDir private Path folder = Path.of("");
  private final ProblemCollector problems = new ProblemCollector();
  private Path tables = Path.of("");

  @BeforeEach
  void export() throws IOException {
    Path study = Files.createDirectory(folder.resolve("study"));
    RecordedStudyFixture.write(study);
    LoadedStudy material = RecordedStudyFixture.material(study);
    CollectedAnswers answers =
        CollectedAnswers.of(
            material, OptionalInt.empty(), PaperAnswers.none(), new ProblemCollector());
    tables = folder.resolve("tables");
    StudyExport written =
        StudyExport.write(
            RecordedStudy.read(material, problems),
            new StudyExport.Answers(
                answers.responses(), answers.ratings(), answers.others(), answers.scores()),
            Map.of("analysis.R", "print(1)\n"),
            tables,
            problems);
    assertThat(written.files())
        .containsExactly(
            "participants.csv",
            "sessions.csv",
            "exposures.csv",
            "gaze.csv",
            "eyes.csv",
            "events.csv",
            "responses.csv",
            "ratings.csv",
            "answers.csv",
            "scores.csv",
            "codebook.csv",
            "codebook.json",
            "tables.R",
            "tables.py",
            "analysis.R");
  }

  private List<String> lines(String file) throws IOException {
    return Files.readAllLines(tables.resolve(file));
  }

  @Test
  void eachObjectOfAnExposureHasARowAlsoOneThatWasNeverLookedAt() throws IOException {
    assertThat(lines("gaze.csv"))
        .containsExactly(
            "participant,session,condition,step,run,object,dwell,looks,first,longest",
            "001,1,selective,exposure-hall,1,Coat,3,1,1,3",
            "001,1,selective,exposure-hall,1,Boat,0,0,,0",
            "P2,1,high,exposure-hall,1,Coat,3,1,1,3",
            "P2,1,high,exposure-hall,1,Boat,0,0,,0");
  }

  @Test
  void theEyesHaveATableOfTheirOwnOfWhoHadAnEyeTracker() throws IOException {
    assertThat(lines("eyes.csv"))
        .containsExactly(
            "participant,session,condition,step,run,object,dwell,looks,first,longest,fixations",
            "P2,1,high,exposure-hall,1,Boat,1,1,1,1,1",
            "P2,1,high,exposure-hall,1,Coat,0,0,,0,0");
    assertThat(lines("exposures.csv").get(0)).contains(",idle,eyes_tracked,fps,");
    assertThat(lines("exposures.csv").get(2)).contains(",0.230769,");
  }

  @Test
  void anExposureSaysHowItWasShown() throws IOException {
    assertThat(lines("exposures.csv").get(1))
        .isEqualTo(
            "001,1,selective,exposure-hall,1,yes,2026-03-01T10:00:12+02:00,1,7,5,2,15,0,,50,20,25,"
                + "0.0125,59.95,yes,8.5,14,GeForce,Linux 6.1 amd64 8 processors,,"
                + "low-frame-rate,sub-001/ses-01/head/exposure-hall_run-01.csv");
    assertThat(lines("exposures.csv").get(2)).startsWith("P2,1,high,exposure-hall,1,no,");
  }

  @Test
  void answersAreThoseThatCollectTakes() throws IOException {
    assertThat(lines("responses.csv").get(0))
        .startsWith("participant,condition,area,object,consistency,present,response,confidence");
    assertThat(lines("responses.csv"))
        .anyMatch(line -> line.contains("hall,boat,inconsistent,no,no,3"));
    assertThat(lines("answers.csv"))
        .containsExactly(
            "participant,session,condition,questionnaire,page,question,kind,value,response_ms,place",
            "001,1,selective,form,page-1,eyes,text,brown,1000,2",
            "001,1,selective,closing,p1,changes,yes-no,no,300,1",
            "001,1,selective,closing,p1,remarks,text,\"long, \"\"but\"\" fine\",9000,2");
    assertThat(lines("scores.csv"))
        .containsExactly("participant,session,condition,questionnaire,score,value");
  }

  @Test
  void theCodebookDescribesTheAgeAsTheFormAsksIt() throws IOException {
    assertThat(age("")).isEqualTo("the participant's age; the form does not ask it");
    assertThat(
            age(
                """
                {"id": "years", "kind": "number", "sets": "age", "text": "How old are you?",
                 "min": 18, "max": 99}
                """))
        .isEqualTo(
            "age, a number as the participant wrote it, the answer to the form's question:"
                + " How old are you?");
    assertThat(
            age(
                """
                {"id": "age", "kind": "single", "sets": "age", "text": "Age",
                 "options": [{"value": "18-22", "text": "18 to 22"}, {"value": "23", "text": "more"}]}
                """))
        .isEqualTo("age, as the participant answered the form's question: Age");
  }

  private String age(String question) throws IOException {
    Path study = folder.resolve("study");
    Files.writeString(
        study.resolve("form.json"),
        """
        {"name": "form", "pages": [{"questions": [
          {"id": "eyes", "kind": "text", "text": "Colour of the eyes"}%s]}]}
        """
            .formatted(question.isEmpty() ? "" : "," + question));
    RecordedStudy read = RecordedStudy.read(RecordedStudyFixture.material(study), problems);
    return read.participantsTable().columns().stream()
        .filter(column -> column.name().equals("age"))
        .findFirst()
        .orElseThrow()
        .meaning();
  }

  @Test
  void theCodebookExplainsEveryColumnOfEveryTable() throws IOException {
    JsonNode book = JsonTree.parse(Files.readString(tables.resolve("codebook.json")));
    assertThat(book).hasSize(10);
    book.properties()
        .forEach(
            file -> {
              try {
                List<String> header = List.of(lines(file.getKey()).get(0).split(","));
                JsonNode columns = file.getValue().path("columns");
                assertThat(columns.fieldNames()).toIterable().containsExactlyElementsOf(header);
                assertThat(columns).allMatch(column -> !column.path("meaning").asText().isEmpty());
                assertThat(file.getValue().path("rows").asInt())
                    .as(file.getKey())
                    .isEqualTo(lines(file.getKey()).size() - 1);
              } catch (IOException e) {
                throw new AssertionError(e);
              }
            });
    assertThat(lines("codebook.csv")).hasSize(1 + book.findValues("meaning").size());
  }

  private String run(String... command) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command).directory(tables.toFile()).redirectErrorStream(true).start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(said).isZero();
    return said.strip();
  }

  /** Has somebody answer with what a spreadsheet would calculate, marked as tables mark it. */
  private void answerByFormula() throws IOException {
    Path answers = tables.resolve("answers.csv");
    String cell = SpreadsheetText.marked("\u00a0\uff1dSUM(1);=2");
    Files.writeString(answers, Files.readString(answers).replace("brown", cell));
  }

  @Test
  @RequiresProgram("Rscript")
  void rReadsTheTablesWithTheirTypes() throws Exception {
    answerByFormula();
    String said =
        run(
            "Rscript",
            "-e",
            """
            source("tables.R"); t <- read_tables()
            cat(nrow(t$gaze), sum(t$gaze$dwell), t$sessions$participant[1],
                levels(t$participants$condition), sep = ",")
            cat("\\n", as.numeric(difftime(t$events$wall[2], t$events$wall[1], units = "secs")),
                t$answers$value[3], is.na(t$gaze$first[2]), class(t$gaze$looks), sep = ",")
            cat("\\n", utf8ToInt(t$answers$value[1]))
            """);
    assertThat(said.lines())
        .containsExactly(
            "4,6,001,high,high-low,selective,random",
            ",1,long, \"but\" fine,TRUE,integer",
            " 160 65309 83 85 77 40 49 41 59 61 50");
  }

  @Test
  @RequiresProgram("python3")
  void pandasReadsTheTablesWithTheirTypes() throws Exception {
    Assumptions.assumeTrue(
        new ProcessBuilder("python3", "-c", "import pandas")
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("said").toFile())
                .start()
                .waitFor()
            == 0,
        "python3 has no pandas");
    answerByFormula();
    String said =
        run(
            "python3",
            "-c",
            """
            from tables import read_tables
            t = read_tables()
            print(len(t["gaze"]), t["gaze"]["dwell"].sum(), t["sessions"]["participant"][0])
            print(list(t["participants"]["condition"].cat.categories), t["gaze"]["looks"].dtype)
            print((t["events"]["wall"][1] - t["events"]["wall"][0]).total_seconds())
            print([ord(letter) for letter in t["answers"]["value"][0]])
            """);
    assertThat(said.lines())
        .containsExactly(
            "4 6.0 001",
            "['high', 'high-low', 'selective', 'random'] Int64",
            "1.0",
            "[160, 65309, 83, 85, 77, 40, 49, 41, 59, 61, 50]");
  }
}
