package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
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
import org.selectiverenderer.testing.RequiresProgram;

/** What becomes of the answers of a study with questionnaires of all kinds and moments. */
class ExperimentTablesTest extends CommandTestCase {
  private static final String NAME = "Evdokia Ntua";

  @TempDir Path folder;
  private Path study = Path.of("");
  private final List<String> steps = new ArrayList<>();

  @BeforeEach
  void sessions() throws IOException {
    study = Files.createDirectory(folder.resolve("study"));
    write(
        "rooms.x3d",
        "<X3D><Scene><Viewpoint DEF='Hall'/><Viewpoint DEF='Bath'/><Shape><Box/></Shape></Scene></X3D>");
    write(
        "study.json",
        """
        {"name": "Rooms", "scene": "rooms.x3d", "conditions": ["high", "selective"],
         "participants": 4, "form": "form.json",
         "practice": {"scene": "rooms.x3d", "viewpoint": "Hall"},
         "areas": [{"name": "hall", "viewpoint": "Hall", "seconds": 1},
                   {"name": "bath", "viewpoint": "Bath", "seconds": 1}],
         "questionnaires": [{"file": "tried.json", "when": "after-practice"},
                            {"file": "felt.json", "when": "after-area"},
                            {"kind": "recognition", "items": "r.csv", "name": "memory"},
                            {"template": "sus"}]}
        """);
    write(
        "form.json",
        """
        {"name": "me", "pages": [{"questions": [
          {"id": "name", "kind": "text", "personal": true, "text": "Name"},
          {"id": "sex", "kind": "text", "text": "Sex"}]}]}
        """);
    write(
        "tried.json",
        """
        {"name": "tried", "pages": [{"questions": [
          {"id": "sick", "kind": "yes-no", "text": "Sick?"},
          {"id": "how", "kind": "text", "text": "How?",
           "when": {"question": "sick", "is": ["yes"]}}]}]}
        """);
    write(
        "felt.json",
        """
        {"name": "felt", "pages": [{"questions": [
          {"id": "liked", "kind": "yes-no", "text": "Did you like the {area}?"}]}]}
        """);
    StringBuilder items = new StringBuilder("area,object,consistency,present,en\n");
    for (int i = 0; i < 16; i++) {
      items.append(
          "%s,o%d,%s,%s,Object %d\n"
              .formatted(
                  i < 8 ? "hall" : "bath",
                  i,
                  i % 4 < 2 ? "consistent" : "inconsistent",
                  i % 2 == 0 ? "yes" : "no",
                  i));
    }
    write("r.csv", items.toString());
    for (int i = 1; i <= 4; i++) {
      session("00" + i);
    }
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(study.resolve(name), text);
  }

  private void session(String id) throws IOException {
    LoadedStudy material =
        LoadedStudy.read(study.resolve("study.json"), new ProblemCollector()).orElseThrow();
    try (Session session =
        Session.begin(
            material,
            id,
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test 1"),
            new ProblemCollector())) {
      steps.clear();
      while (!session.remaining().isEmpty()) {
        SessionStep step = session.remaining().get(0);
        steps.add(step.id());
        session.began(step, false);
        if (!step.shows()) {
          int place = 0;
          for (Question question : session.questionnaire(step).questions()) {
            answer(session, step, question, ++place);
          }
        }
        if (step instanceof SessionStep.Form) {
          session.assign("18-22");
        }
        session.finished(step, Map.of());
      }
      session.end();
    }
  }

  private static void answer(Session session, SessionStep step, Question question, int place)
      throws IOException {
    String value =
        switch (question.id()) {
          case "name" -> NAME;
          case "sex" -> "female";
          case "how" -> "a word taken back";
          default -> question.kind().spelling().equals("scale") ? "6" : "yes";
        };
    boolean memory = step.id().startsWith("memory");
    String said =
        memory && (session.folder().participant() + question.id()).hashCode() % 3 == 0
            ? "no"
            : value;
    session.answer(
        step, question, new Answer(said, memory ? 3 : 0), OptionalLong.of(500L * place), place);
    if (question.id().equals("how")) {
      Question sick = session.questionnaire(step).question("sick").orElseThrow();
      session.answer(step, sick, Answer.of("no"), OptionalLong.of(9), 1);
    }
  }

  /** All that stands below a folder. */
  private static String all(Path folder) throws IOException {
    StringBuilder text = new StringBuilder();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        text.append(folder.relativize(file)).append('\n').append(Files.readString(file));
      }
    }
    return text.toString();
  }

  @Test
  void questionnairesAreAskedAtTheMomentsThatTheStudyNames() throws IOException {
    assertThat(steps)
        .containsExactly(
            "form",
            "practice",
            "tried",
            "exposure-hall",
            "felt-hall",
            "exposure-bath",
            "felt-bath",
            "memory-hall",
            "memory-bath",
            "sus");
    LoadedStudy material =
        LoadedStudy.read(study.resolve("study.json"), new ProblemCollector()).orElseThrow();
    assertThat(material.questionnaires("001").get(2).questions().get(0).text())
        .isEqualTo("Did you like the bath?");
  }

  @Test
  void collectGathersOtherAnswersAndScores() throws IOException {
    Path answers = folder.resolve("answers.csv");
    Path scores = folder.resolve("scores.csv");
    assertThat(
            execute(
                "experiment",
                "collect",
                study.toString(),
                "--answers",
                answers.toString(),
                "--scores",
                scores.toString()))
        .as(messages())
        .isZero();
    assertThat(answers)
        .content()
        .startsWith(
            "participant,session,condition,questionnaire,page,question,kind,value,response_ms,place\n")
        .contains("004,1,", ",form,page-1,sex,text,female,1000,2\n")
        .contains(
            ",felt-bath,page-1,liked,yes-no,yes,500,1\n", ",tried,page-1,sick,yes-no,no,9,1\n")
        .doesNotContain(NAME, "taken back", "memory-hall");
    assertThat(Files.readAllLines(scores))
        .hasSize(1 + 4 * 2)
        .anyMatch(line -> line.endsWith("sus,mean,6"));
  }

  @Test
  void aBidsDatasetHasTheAnswersButNoPersonalOnesAndNothingOfTheProgramsOwn() throws IOException {
    // Said only after the sessions: it is personal all the same.
    write(
        "form.json",
        Files.readString(study.resolve("form.json"))
            .replace("\"sex\",", "\"sex\", \"personal\": true,"));
    Path session = study.resolve("sub-001/ses-01");
    Files.writeString(session.resolve("events-cut-off-01.txt"), "{\"half");
    Files.writeString(session.resolve("running.json"), "{}");
    Path dataset = folder.resolve("bids");
    execute("experiment", "bids", study.toString(), "--output", dataset.toString());
    assertThat(all(dataset))
        .doesNotContain(
            NAME,
            "taken back",
            "female",
            "events.jsonl",
            "cut-off",
            "running.json",
            "session.lock");
    assertThat(dataset.resolve("sub-001/ses-01/beh/sub-001_ses-01_task-form_beh.tsv"))
        .doesNotExist();
    assertThat(dataset.resolve("sub-001/ses-01/beh/sub-001_ses-01_task-feltbath_beh.tsv"))
        .content()
        .endsWith("\nliked\tyes\tn/a\t0.5\t1\tbath\tn/a\tn/a\n");
    assertThat(dataset.resolve("sub-001/ses-01/beh/sub-001_ses-01_task-memoryhall_beh.tsv"))
        .content()
        .containsPattern("\no0\t(yes|no)\t3\t[0-9.]+\t[0-9]\thall\tconsistent\tyes\n");
    assertThat(dataset.resolve("sub-001/ses-01/beh/sub-001_ses-01_task-sus_beh.tsv")).exists();
  }

  private Path export() {
    Path tables = folder.resolve("tables");
    execute("experiment", "export", study.toString(), "--output", tables.toString());
    return tables;
  }

  @Test
  void tablesHaveTheAnswersButNoPersonalOnes() throws IOException {
    // Said only after the sessions: it is personal all the same.
    write(
        "form.json",
        Files.readString(study.resolve("form.json"))
            .replace("\"sex\",", "\"sex\", \"personal\": true,"));
    Path tables = export();
    assertThat(all(tables)).doesNotContain(NAME, "taken back", "female", "cut-off");
    assertThat(tables.resolve("answers.csv")).content().contains(",felt-hall,page-1,liked,");
    assertThat(Files.readAllLines(tables.resolve("responses.csv"))).hasSize(1 + 4 * 16);
  }

  @Test
  void whatWasPersonalWhenItWasAnsweredStaysSo() throws IOException {
    write(
        "form.json",
        Files.readString(study.resolve("form.json")).replace("\"personal\": true, ", ""));
    Path collected = folder.resolve("collected.csv");
    execute(
        "experiment",
        "collect",
        study.toString(),
        "--responses",
        folder.resolve("responses.csv").toString(),
        "--answers",
        collected.toString());
    assertThat(collected).content().contains(",form,page-1,sex,").doesNotContain(NAME);
    assertThat(all(export())).contains(",form,page-1,sex,").doesNotContain(NAME);
    Path dataset = folder.resolve("bids");
    execute("experiment", "bids", study.toString(), "--output", dataset.toString());
    assertThat(all(dataset)).contains("\nsex\t").doesNotContain(NAME);
  }

  @Test
  @RequiresProgram("Rscript")
  void theScriptThatComesWithTheTablesAnalysesThem() throws IOException, InterruptedException {
    Path tables = export();
    Process r =
        new ProcessBuilder("Rscript", "analysis.R")
            .directory(tables.toFile())
            .redirectErrorStream(true)
            .start();
    String said = new String(r.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(r.waitFor()).as(said).isZero();
    assertThat(said).contains("hall", "bath", "consistent", "d'");
  }
}
