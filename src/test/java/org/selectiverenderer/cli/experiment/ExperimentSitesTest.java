package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.study.session.SessionStep;

/** What becomes of the sessions of a study that runs at several sites. */
class ExperimentSitesTest extends CommandTestCase {
  private static final String STUDY =
      """
      { // The comment is not a part of the study.
       "name": "Lists", "participants": 8, "seed": 5,
       "factors": [{"name": "shade", "varies": "within",
                    "levels": [{"name": "dim"}, {"name": "bright"}]}],
       "blocks": [{"name": "main", "stimuli": "words.csv",
                   "trial": [{"show": "blank", "seconds": 1, "keys": ["f", "j"]}]}],
       "questionnaires": [{"kind": "expectancy", "items": "e.csv", "name": "rate"},
                          {"file": "felt.json"}]}
      """;

  @TempDir Path folder;
  private Path study = Path.of("");
  private Path athens = Path.of("");
  private Path patras = Path.of("");

  @BeforeEach
  void sites() throws IOException {
    study = material("study");
    athens = material("athens");
    patras = material("patras");
    session(athens, "001", "3");
    session(athens, "002", "3");
    session(patras, "001", "6");
  }

  private Path material(String name) throws IOException {
    Path made = Files.createDirectory(folder.resolve(name));
    Files.writeString(made.resolve("study.json"), STUDY);
    Files.writeString(
        made.resolve("words.csv"), "word,shade,site\nlamp,dim,left\nsun,bright,right\n");
    Files.writeString(made.resolve("e.csv"), "area,schema,object,en\nhall,HallSchema,coat,Coat\n");
    Files.writeString(
        made.resolve("felt.json"),
        """
        {"name": "felt", "pages": [{"questions": [
          {"id": "liked", "kind": "yes-no", "text": "Did you like it?"}]}]}
        """);
    return made;
  }

  private static void session(Path site, String id, String rating) throws IOException {
    LoadedStudy material =
        LoadedStudy.read(site.resolve("study.json"), new ProblemCollector()).orElseThrow();
    try (Session session =
        Session.begin(
            material,
            id,
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test 1"),
            new ProblemCollector())) {
      while (!session.remaining().isEmpty()) {
        SessionStep step = session.remaining().get(0);
        session.began(step, false);
        if (step instanceof SessionStep.Questions) {
          int place = 0;
          for (Question question : session.questionnaire(step).questions()) {
            String value = question.id().equals("liked") ? "yes" : rating;
            session.answer(step, question, Answer.of(value), OptionalLong.of(500), ++place);
          }
        }
        if (step instanceof SessionStep.Form) {
          session.assign("18-22");
        }
        session.finished(step, Map.of());
      }
      session.end();
    }
    Files.writeString(
        site.resolve("sub-" + id + "/ses-01/events.jsonl"),
        """
        {"time":"2026-03-01T10:00:30.000+02:00","event":"step-finished","step":"main-1","block":"main","trial":1,"levels":{"shade":"dim"},"line":2,"response":"f","ms":412.5}
        """,
        StandardOpenOption.APPEND);
  }

  private String[] arguments(String command, Path other, String... more) {
    return Stream.concat(
            Stream.of(
                "experiment",
                command,
                study.toString(),
                "--from",
                "athens=" + athens,
                "--from",
                "patras=" + other),
            Stream.of(more))
        .toArray(String[]::new);
  }

  private List<String> collected(String option, Path other, String... more) throws IOException {
    Path table = folder.resolve("table.csv");
    execute(
        arguments(
            "collect",
            other,
            Stream.concat(Stream.of(option, table.toString()), Stream.of(more))
                .toArray(String[]::new)));
    return Files.exists(table) ? Files.readAllLines(table) : List.of();
  }

  @Test
  void tablesOfAllSitesHaveTheSiteAndIdsThatBeginWithIt() throws IOException {
    assertThat(collected("--answers", patras))
        .as(messages())
        .anyMatch(line -> line.startsWith("participant,session,") && line.endsWith(",site"))
        .anyMatch(line -> line.startsWith("athens001,1,") && line.endsWith(",athens"))
        .anyMatch(line -> line.startsWith("athens002,1,"))
        .anyMatch(line -> line.startsWith("patras001,1,") && line.endsWith(",patras"));
    assertThat(collected("--ratings", patras)).hasSize(4);
    assertThat(collected("--bands", patras)).last().asString().contains(",4.000000,3,");
  }

  @Test
  void aColumnOfTheStimuliThatIsCalledSiteStays() throws IOException {
    assertThat(collected("--trials", patras))
        .as(messages())
        .hasSize(4)
        .anyMatch(line -> line.endsWith(",correct,session_site"))
        .anyMatch(line -> line.startsWith("patras001,1,") && line.endsWith(",patras"))
        .allMatch(line -> line.contains("site") || line.contains(",left,"));
  }

  @Test
  void doubledIdsAndPlacesAreTold() throws IOException {
    collected("--answers", patras);
    assertThat(messages())
        .contains("there is a participant 001 both at athens and patras")
        .contains("athens001 and patras001")
        .contains("the place 1 of the schedule was given away more than once, at athens, patras");
  }

  @Test
  void sessionsOfAnotherVersionAreLeftOutUntilAnOptionTakesThem() throws IOException {
    Path other = material("other");
    Files.writeString(other.resolve("study.json"), STUDY.replace("\"seed\": 5", "\"seed\": 6"));
    Files.writeString(
        other.resolve("words.csv"), "word,shade,site\nlamp,dim,up\nsun,bright,down\n");
    session(other, "001", "6");
    assertThat(collected("--answers", other)).noneMatch(line -> line.startsWith("patras"));
    assertThat(messages())
        .contains("the study file differs in seed")
        .contains("this file differs: words.csv")
        .contains("--any-version takes it");
    assertThat(collected("--answers", other, "--any-version"))
        .anyMatch(line -> line.startsWith("patras001"));
    assertThat(messages()).contains("the study file differs in seed");
  }

  @Test
  void aStudyFileThatIsOnlyWrittenOtherwiseIsTheSameStudy() throws IOException {
    Path other = material("other");
    Files.writeString(other.resolve("study.json"), STUDY.replace("\n", "\r\n"));
    session(other, "001", "6");
    assertThat(collected("--answers", other))
        .as(messages())
        .anyMatch(line -> line.startsWith("patras001"));
  }

  @Test
  void aCopyOfASessionCountsOnce() throws IOException {
    Path copy = patras.resolve("sub-009/ses-01");
    Files.createDirectories(copy);
    Files.copy(athens.resolve("sub-002/ses-01/events.jsonl"), copy.resolve("events.jsonl"));
    assertThat(collected("--answers", patras)).noneMatch(line -> line.startsWith("patras009"));
    assertThat(messages())
        .contains("this is a copy of the session 1 of sub-002 of athens, which is taken");
  }

  @Test
  void idsThatWouldBeTheSameAreRefused() throws IOException {
    session(study, "2", "1");
    session(athens, "12", "1");
    assertThat(
            execute(
                "experiment",
                "collect",
                study.toString(),
                "--from",
                "s=" + athens,
                "--from",
                "s1=" + study))
        .isNotZero();
    assertThat(messages()).contains("12 of s", "2 of s1", "would both be s12");
  }

  @Test
  void theStudysOwnSessionsNeedANameToo() throws IOException {
    session(study, "001", "1");
    assertThat(collected("--answers", patras)).isEmpty();
    assertThat(messages()).contains("the study's own folder has sessions, too");
  }

  @Test
  void wrongNamesAndFoldersAreToldInOneSentence() {
    assertThat(execute("experiment", "collect", study.toString(), "--from", "a b=x")).isEqualTo(2);
    assertThat(messages()).contains("write the site's name in letters and digits");
    assertThat(
            execute("experiment", "collect", study.toString(), "--from", "a=" + folder + "/none"))
        .isNotZero();
    assertThat(messages()).contains("is no folder").doesNotContain("Exception");
    assertThat(execute("experiment", "collect", study.toString(), "--any-version")).isEqualTo(2);
  }

  @Test
  void anExportHasTheSiteInEveryTable() throws IOException {
    Path tables = folder.resolve("tables");
    execute(arguments("export", patras, "--output", tables.toString()));
    for (String table : List.of("participants", "sessions", "ratings", "answers", "trials")) {
      assertThat(Files.readAllLines(tables.resolve(table + ".csv")))
          .as(table)
          .hasSize(
              table.equals("answers")
                  ? Files.readAllLines(tables.resolve("answers.csv")).size()
                  : 4)
          .last()
          .asString()
          .endsWith(",patras");
    }
    assertThat(tables.resolve("participants.csv")).content().contains("sub-athens002,");
    assertThat(tables.resolve("codebook.csv")).content().contains("trials.csv,session_site,");
  }

  @Test
  void anArchiveOfSeveralSitesHasTheirTables() throws IOException {
    Path output = folder.resolve("all.zip");
    assertThat(
            execute(
                arguments(
                    "archive", patras, "--output", output.toString(), "--licence", "cc-by-4.0")))
        .as(messages())
        .isZero();
    try (FileSystem zip = FileSystems.newFileSystem(output)) {
      assertThat(Files.readAllLines(zip.getPath("tables/trials.csv")))
          .hasSize(4)
          .anyMatch(line -> line.startsWith("P001,1,"))
          .anyMatch(line -> line.endsWith(",patras"))
          .noneMatch(line -> line.contains("athens0"));
      assertThat(Files.exists(zip.getPath("study/words.csv"))).isTrue();
    }
    assertThat(execute(arguments("archive", patras, "--output", "a.zip", "--licence", "mine")))
        .isEqualTo(2);
    assertThat(messages()).contains("--licence mine: is none of CC0-1.0, CC-BY-4.0");
  }
}
