package org.selectiverenderer.study.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.PaperAnswers;

/** Trials of blocks, as the page sends them. */
class WebTrialImportTest extends WebStudyFixture {
  private static final String CELLS =
      "\"levels\":{\"coat\":\"red\"},\"line\":2,\"stimulus\":{\"side\":\"left\",\"answer\":\"f\"}";

  private String sha = "";

  @BeforeEach
  void blocks() throws IOException {
    Files.writeString(folder.resolve("study/sides.csv"), "side,answer\nleft,f\nright,j\n");
    Files.writeString(
        folder.resolve("study/sure.json"),
        """
        {"name": "sure", "pages": [{"questions": [
          {"id": "sure", "kind": "scale", "from": 1, "to": 5, "text": "Sure?"}]}]}
        """);
    Files.writeString(
        folder.resolve("study/study.json"),
        """
        {"name": "Hall", "scene": "hall.x3d", "participants": 40, "form": "form.json", "seed": 7,
         "factors": [{"name": "coat", "varies": "within",
           "levels": [{"name": "red"}, {"name": "blue"}]}],
         "blocks": [{"name": "main", "stimuli": "sides.csv", "practice": {"correct": 0.5, "rounds": 2},
           "trial": [{"show": "fixation", "seconds": 0.5},
             {"show": "exposure", "seconds": 6, "keys": ["f", "j"], "correct": "{answer}"},
             {"show": "questions", "questionnaire": "sure"}]}],
         "questionnaires": [{"file": "sure.json", "name": "sure", "when": "in-trials"}]}
        """);
    sha = Sha256.of(Files.readAllBytes(folder.resolve("study/study.json")));
  }

  @Override
  String record(int session, int slot, String step, int minute, String content) {
    return String.format(
        Locale.ROOT,
        "{\"study\":\"Hall\",\"checksum\":\"%s\",\"session\":\"%s\",\"slot\":%d,"
            + "\"participant\":\"%03d\",\"group\":\"all\",\"condition\":\"high\",\"language\":\"en\","
            + "\"step\":\"%s\",\"started\":\"2026-11-01T10:%02d:00.000Z\","
            + "\"ended\":\"2026-11-01T10:%02d:30.000Z\",\"origin\":1793527000000,\"mono\":%d,%s}",
        sha,
        session(session),
        slot,
        slot,
        step,
        minute,
        minute,
        60 * minute + 1,
        content);
  }

  private String trial(int number, String cells, String result) {
    return record(
        1,
        1,
        "main-%03d".formatted(number),
        2,
        "\"interruptions\":[],\"block\":\"main\",\"trial\":%d,\"round\":1,%s,%s,\"log\":%s"
            .formatted(number, cells, result, log(60, 6)));
  }

  private static String result(String response) {
    return ("\"response\":\"%s\",\"ms\":512.3,\"correct\":true,\"phases\":["
            + "{\"phase\":\"fixation\",\"began\":0,\"seconds\":0.5},"
            + "{\"phase\":\"exposure\",\"began\":0.5,\"seconds\":5.5}],\"answers\":[{\"page\":\"p\","
            + "\"question\":\"sure\",\"kind\":\"scale\",\"value\":\"4\",\"ms\":900,\"place\":1}]")
        .formatted(response);
  }

  private List<String> trials() throws IOException {
    return CollectedAnswers.of(
            material(), OptionalInt.empty(), true, one -> true, PaperAnswers.none(), problems)
        .trials()
        .lines()
        .toList();
  }

  private String journal() throws IOException {
    return Files.readString(folder.resolve("study/sub-web001/ses-01/events.jsonl"));
  }

  @Test
  void trialsAreRowsAsThoseOfTheLaboratory() throws IOException {
    String silent =
        "\"phases\":[{\"phase\":\"exposure\",\"began\":0,\"seconds\":6}],\"answers\":[],\"correct\":false";
    write(
        "all.jsonl",
        List.of(
            form(1, 1),
            trial(1, CELLS, result("f")),
            trial(
                2,
                CELLS.replace("\"red\"", "\"blue\"").replace("\"line\":2", "\"line\":9"),
                silent),
            record(1, 1, "main", 3, "\"interruptions\":[],\"block\":\"main\",\"failed\":true")));
    collect();
    assertThat(told()).isEmpty();
    assertThat(trials())
        .containsExactly(
            "participant,session,group,block,trial,round,coat,side,answer,response,ms,correct,sure.sure",
            "web001,1,all,main,1,1,red,left,f,f,512.3,yes,4",
            "web001,1,all,main,2,1,blue,left,f,,,no,");
    assertThat(journal())
        .contains("\"event\":\"step-began\",\"step\":\"main\"")
        .contains("\"event\":\"trial-order\",\"step\":\"main\"")
        .contains("\"flag\":\"practice-failed\"")
        .contains("\"event\":\"shown\",\"step\":\"main-001\",\"t\":0.5")
        .contains("\"event\":\"session-finished\"");
    assertThat(folder.resolve("study/sub-web001/ses-01/head/main-001_run-01.csv")).exists();
  }

  @Test
  void whatIsNotOfTheStudyIsLeftOut() throws IOException {
    write(
        "all.jsonl",
        List.of(
            form(1, 1),
            trial(1, CELLS.replace("red", "green"), result("f")),
            trial(1, CELLS, result("x")),
            trial(1, CELLS, result("f")).replace("\"block\":\"main\"", "\"block\":\"other\""),
            trial(1, CELLS, result("f")).replace("\"step\":\"main-001\"", "\"step\":\"main-002\""),
            trial(1, CELLS, result("f").replace("512.3", "-1")),
            trial(1, CELLS, result("f").replace("\"began\":0,", "\"began\":\"x\",")),
            trial(1, CELLS, result("f").replace("\"sure\"", "\"other\""))));
    collect();
    assertThat(told())
        .containsExactly(
            "the factor coat has no level 'green'; the record is left out",
            "'x' is no key of the trial (f, j); the record is left out",
            "the study has no block 'other'; the record is left out",
            "\"step\" is not the trial that \"block\", \"trial\" and \"round\" name; the record is left out",
            "\"ms\" is not the time of a response, in milliseconds; the record is left out",
            "phase 1 of the trial is not as the page writes it; the record is left out",
            "the questionnaire has no question 'other'; the answer is left out");
    assertThat(trials()).hasSize(2);
  }

  @Test
  void anExposureThatNobodySawIsFlagged() throws IOException {
    write(
        "all.jsonl",
        List.of(
            form(1, 1),
            trial(1, CELLS, result("f"))
                .replaceAll("(\\[\\d[^\\[\\]]*),1,([\\d.]+\\])", "$1,0,$2")));
    collect();
    assertThat(journal()).contains("\"flag\":\"not-seen\"");
  }

  @Test
  void whoRefusesConsentInTheQuestionsOfATrialHasRefused() throws IOException {
    Files.writeString(
        folder.resolve("study/sure.json"),
        """
        {"name": "sure", "pages": [{"questions": [
          {"id": "on", "kind": "yes-no", "text": "May we go on?", "must": "yes"}]}]}
        """);
    String refused =
        record(
            1,
            1,
            "main-002",
            3,
            "\"interruptions\":[],\"block\":\"main\",\"trial\":2,\"round\":1,%s,\"refused\":true"
                .formatted(CELLS));
    String first =
        result("f")
            .replace("\"sure\",\"kind\":\"scale\"", "\"on\",\"kind\":\"yes-no\"")
            .replace("\"value\":\"4\"", "\"value\":\"yes\"");
    write("all.jsonl", List.of(form(1, 1), trial(1, CELLS, first), refused));
    collect();
    assertThat(told()).isEmpty();
    assertThat(journal())
        .contains("\"event\":\"step-began\",\"step\":\"main-002\"")
        .contains("\"event\":\"refused\"")
        .doesNotContain("\"event\":\"step-finished\",\"step\":\"main-002\"");
  }

  @Test
  void aTrialThatAsksForNoConsentIsNotRefused() throws IOException {
    write("all.jsonl", List.of(form(1, 1), trial(1, CELLS, result("f") + ",\"refused\":true")));
    collect();
    assertThat(journal())
        .contains("\"event\":\"step-finished\",\"step\":\"main-001\"")
        .doesNotContain("\"event\":\"refused\"");
  }

  /** Collects, and tells the scene of each replay with the Viewpoint at which it began. */
  private List<String> replayed() throws IOException {
    List<String> shown = new ArrayList<>();
    WebSessionImport.run(
        material(),
        List.of(data),
        "program 1",
        (study, exposure) -> {
          shown.add(exposure.scene().orElseThrow().getFileName() + " " + exposure.viewpoint());
          return COAT.of(study, exposure);
        },
        problems);
    return shown;
  }

  @Test
  void cellsOfSeveralLinesAndLongOnesAreThoseOfTheList() throws IOException {
    String text = "Look.\nThen\tanswer. " + "Wait. ".repeat(400).strip();
    Files.writeString(
        folder.resolve("study/sides.csv"), "side,answer\n\"" + text + "\",f\n\"r\u0007g\",j\n");
    String cells = CELLS.replace("left", text.replace("\n", "\\n").replace("\t", "\\t"));
    write(
        "all.jsonl",
        List.of(
            form(1, 1),
            trial(1, cells, result("f")),
            trial(2, CELLS.replace("left", "r\\u0007g").replace("\"f\"", "\"j\""), result("j"))));
    List<String> shown = replayed();
    assertThat(told()).isEmpty();
    assertThat(shown).hasSize(2);
    assertThat(String.join("\n", trials())).contains("\"" + text + "\",f,f,").contains("r g,j,j,");
  }

  private void scenes() throws IOException {
    for (String name : List.of("left", "right", "new")) {
      Files.copy(folder.resolve("study/hall.x3d"), folder.resolve("study/" + name + ".x3d"));
    }
    Files.writeString(
        folder.resolve("study/sides.csv"),
        """
        side,answer,scene,viewpoint
        new,j,new.x3d,HallView
        right,j,right.x3d,HallView
        left,f,left.x3d,HallView
        """);
  }

  private static final String LEFT =
      CELLS.replace("\"f\"}", "\"f\",\"scene\":\"left.x3d\",\"viewpoint\":\"HallView\"}");

  @Test
  void aStimulusIsFoundByItsCellsWhereTheListWasSorted() throws IOException {
    scenes();
    write("all.jsonl", List.of(form(1, 1), trial(1, LEFT, result("f"))));
    assertThat(replayed()).containsExactly("left.x3d HallView");
    assertThat(told()).isEmpty();
    assertThat(journal()).doesNotContain("trial-order"); // nobody knows that of the list then
  }

  @Test
  void anExposureIsNotReplayedInTheSceneOfAnotherStimulus() throws IOException {
    scenes();
    write(
        "all.jsonl",
        List.of(
            form(1, 1),
            trial(1, LEFT.replace("left.x3d", "gone.x3d"), result("f")),
            trial(2, CELLS, result("f")))); // columns were added since
    assertThat(replayed()).isEmpty();
    assertThat(told())
        .containsExactly(
            "what was in view in 2 trials of the block main is not known, as the list of its stimuli"
                + " no longer has the rows that were shown; all else of the records is used");
    assertThat(trials()).hasSize(3);
    assertThat(folder.resolve("study/sub-web001/ses-01/head/main-001_run-01.csv")).exists();
  }

  @Test
  void trialsThatThePlanDoesNotHaveAreRefused() throws IOException {
    String third =
        trial(1, CELLS, result("f"))
            .replace("\"round\":1", "\"round\":3")
            .replace("\"step\":\"main-001\"", "\"step\":\"main-round3-001\"");
    write(
        "all.jsonl",
        List.of(form(1, 1), trial(4, CELLS, result("f")), trial(5, CELLS, result("f")), third));
    collect();
    assertThat(told())
        .containsExactly(
            "the block main has no trial 5, only 4; if its list of stimuli has lost rows, put them"
                + " back; the record is left out",
            "the block main has no round 3; the record is left out");
    assertThat(trials()).hasSize(2);
  }

  @Test
  void aTrialWithoutAListIsThatOfItsPlaceInThePlan() throws IOException {
    Path file = folder.resolve("study/study.json");
    Files.writeString(
        file,
        Files.readString(file)
            .replace("\"stimuli\": \"sides.csv\", ", "\"order\": \"fixed\", ")
            .replace("{answer}", "f"));
    sha = Sha256.of(Files.readAllBytes(file));
    String red = "\"levels\":{\"coat\":\"red\"}";
    write("all.jsonl", List.of(form(1, 1), trial(1, red, result("f")), trial(2, red, result("f"))));
    collect();
    assertThat(told())
        .containsExactly(
            "the participant's plan has another trial 2 of the block main; the record is left out");
    sha = "0".repeat(64); // of another version, whose plan nobody knows
    write(
        "all.jsonl",
        List.of(
            form(2, 2),
            trial(2, red, result("f"))
                .replace(session(1), session(2))
                .replace(
                    "\"slot\":1,\"participant\":\"001\"", "\"slot\":2,\"participant\":\"002\"")));
    collect();
    assertThat(told()).hasSize(2).last().asString().contains("ran another version of the study");
  }
}
