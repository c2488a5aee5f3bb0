package org.selectiverenderer.study.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
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
}
