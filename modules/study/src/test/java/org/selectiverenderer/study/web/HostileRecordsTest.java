package org.selectiverenderer.study.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.study.dataset.RecordedSession;
import org.selectiverenderer.study.dataset.RecordedStudy;

/** Whoever has the page can send what they like: what is wrong is told, the rest is read. */
class HostileRecordsTest extends WebStudyFixture {
  private List<String> sessions() throws IOException {
    try (Stream<Path> all = Files.list(folder.resolve("study"))) {
      return all.map(path -> String.valueOf(path.getFileName()))
          .filter(name -> name.startsWith("sub-"))
          .sorted()
          .toList();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "\"participant\":\"001\" | \"participant\":\"../../x\" | \"participant\" is not an id of letters and digits",
        "\"slot\":1, | \"slot\":0, | \"slot\" is not a place of the study's plan, from 1 to 40",
        "\"slot\":1, | \"slot\":\"1\", | \"slot\" is not a place of the study's plan, from 1 to 40",
        "\"slot\":1, | \"slot\":1e99, | \"slot\" is not a place of the study's plan, from 1 to 40",
        "\"step\":\"form\" | \"step\":\"../form\" | the study has no step '../form'",
        "\"language\":\"en\" | \"language\":\"xx\" | the study has no language 'xx'",
        "\"started\":\"2026 | \"started\":\"1026 | \"started\" is not a time of this century; the participant's clock is wrong",
        "\"ended\":\"2026 | \"ended\":\"2025 | \"ended\" is not within two days after \"started\"",
        "\"checksum\":\" | \"checksum\":\"../ | \"checksum\" is not a SHA-256 checksum",
      })
  void aRecordThatIsNotThePagesIsLeftOutAndTheOthersAreRead(String from, String to, String told)
      throws IOException {
    Path file =
        write(
            "a.jsonl",
            List.of(form(1, 1).replaceFirst(java.util.regex.Pattern.quote(from), to), form(2, 2)));
    collect();
    assertThat(problems.list().get(0))
        .hasToString("%s:1:1: %s; the record is left out".formatted(file, told));
    assertThat(sessions()).containsExactly("sub-web002");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "not json | the line is not valid JSON; it is left out",
        "[[[[ | the line is not valid JSON; it is left out",
        "[1,2] | this is neither a record of a study's page nor a part of several; the line is left out",
        "{\"step\":\"form\",\"session\":\"../../etc\"} | \"session\" is not an id that the page makes; the line is left out",
        "{\"records\":[],\"part\":-1} | \"part\" is not a number from 0 to 1000000; the line is left out",
        "{\"records\":[],\"part\":99999999999} | \"part\" is not a number from 0 to 1000000; the line is left out",
      })
  void aLineThatIsNoRecordIsLeftOutAndTheOthersAreRead(String line, String told)
      throws IOException {
    Path file = write("a.jsonl", List.of(line, form(2, 2)));
    collect();
    assertThat(problems.list().get(0)).hasToString("%s:1:1: %s".formatted(file, told));
    assertThat(sessions()).containsExactly("sub-web002");
  }

  @Test
  void aRecordOfAnotherStudyIsLeftOut() throws IOException {
    write("a.jsonl", List.of(form(1, 1).replace("\"study\":\"Hall\"", "\"study\":\"Kitchen\"")));
    collect();
    assertThat(told())
        .containsExactly("this is of the study 'Kitchen', not of 'Hall'; the line is left out");
    assertThat(sessions()).isEmpty();
  }

  @Test
  void answersThatMayNotBeGivenAreLeftOutAlone() throws IOException {
    write(
        "a.jsonl",
        List.of(
            memory(1, 1, "perhaps"),
            memory(2, 2, "yes").replace("\"question\":\"boat\"", "\"question\":\"ship\"")));
    collect();
    assertThat(told())
        .contains(
            "coat: 'perhaps' is not an answer that may be given (yes or no); the answer is left out",
            "the questionnaire has no question 'ship'; the answer is left out");
    assertThat(sessions()).containsExactly("sub-web001", "sub-web002");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "[0.016667, | [\"x\", | row 2 of the log has no valid t",
        "[0.016667, | [null, | row 2 of the log has no valid t",
        "[0.016667, | [1e400, | row 2 of the log has no valid t",
        "[0.050000, | [0.010000, | row 4 of the log goes back in time",
        "\"columns\":[\"t\", | \"columns\":[\"u\", | the log has no column t",
        "\"node\":\"Coat\",\"choice\":0 | \"node\":\"\",\"choice\":0 | event 3 of the log is not as the page writes it",
      })
  void aLogThatIsNotThePagesIsLeftOutAlone(String from, String to, String told) throws IOException {
    List<String> records = new ArrayList<>(whole(1, 1));
    records.set(1, records.get(1).replace(from, to));
    write("a.jsonl", records);
    collect();
    assertThat(told()).containsExactly(told + "; the log of the exposure is left out");
    assertThat(sessions()).containsExactly("sub-web001");
  }

  @Test
  void aRecordThatNamesAnotherParticipantThanItsSessionIsLeftOut() throws IOException {
    write("a.jsonl", List.of(form(1, 1), memory(1, 2, "yes")));
    collect();
    assertThat(told())
        .containsExactly(
            "the record names another participant, place, condition, language or version of the study than the first of its session; it is left out");
  }

  @Test
  void aLineThatNeverEndsIsNotReadIntoTheMemory() throws IOException {
    Path file = data.resolve("a.jsonl");
    try (var out = Files.newBufferedWriter(file)) {
      out.write("{\"step\":\"");
      String much = "x".repeat(1 << 20);
      for (int i = 0; i < 40; i++) {
        out.write(much);
      }
      out.write("\n" + form(1, 1) + "\n");
    }
    collect();
    assertThat(told()).containsExactly("the line has more than 32 MiB; it is left out");
    assertThat(sessions()).containsExactly("sub-web001");
  }

  @Test
  void ofManyFaultsOfAFileTheFirstAreTold() throws IOException {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < 5000; i++) {
      lines.add("junk");
    }
    lines.add(form(1, 1));
    write("a.jsonl", lines);
    collect();
    assertThat(told())
        .hasSize(21)
        .endsWith("there are more faults in this file, which are not told");
    assertThat(sessions()).containsExactly("sub-web001");
  }

  @Test
  void whatADeviceIsCalledIsNoEventOfTheSession() throws IOException {
    String forged = "\"device\":{\"event\":\"assigned\",\"condition\":\"low\",";
    List<String> records = new ArrayList<>(whole(1, 1));
    records.set(0, records.get(0).replace("\"device\":{", forged));
    write("all.jsonl", records);
    collect();
    assertThat(
            RecordedStudy.read(material(), problems).sessions().stream()
                .map(RecordedSession::condition))
        .containsExactly(group(1));
  }

  @Test
  void controlCharactersAreNotTold() throws IOException {
    write("a.jsonl", List.of(form(1, 1).replace("\"form\"", "\"\\u001b[2Jform\"")));
    collect();
    assertThat(told().get(0)).isEqualTo("the study has no step ' [2Jform'; the record is left out");
  }
}
