package org.selectiverenderer.study.definition;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;

class StudyStreamsReaderTest {
  @TempDir private Path folder = Path.of("");
  private final ProblemCollector problems = new ProblemCollector();

  private Optional<Study> read(String streams) throws IOException {
    Path file = StudyTemplate.write(folder.resolve("study"), Path.of("scenes/apartment.x3d"));
    Files.writeString(
        file, Files.readString(file).replaceFirst("\\{", "{\"streams\": " + streams + ","));
    return StudyReader.read(file, problems);
  }

  @Test
  void whatIsSentAndWhatIsRecordedAreSaidApart() throws IOException {
    LslSettings streams = read("{\"record\": [\"type='EEG'\"]}").orElseThrow().streams();
    assertThat(streams).isEqualTo(new LslSettings(false, List.of("type='EEG'")));
    assertThat(streams.wanted()).isTrue();
    assertThat(streams.sending().lsl()).isTrue();
  }

  @Test
  void aStudyThatSaysNothingNeedsNoLibrary() throws IOException {
    assertThat(read("null").orElseThrow().streams().wanted()).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{\"lsl\": \"yes\"} | \"lsl\" must be true or false",
        "{\"record\": [\" \"]} | a condition such as \"type='EEG'\" is needed, not an empty text",
        "{\"record\": [3]} | \"record\" must be a list of texts in quotes",
        "{\"recrod\": []} | the streams has no \"recrod\"; did you mean \"record\"?"
      })
  void whatCannotBeIsAnErrorWithItsPlace(String streams, String message) throws IOException {
    assertThat(read(streams)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .anyMatch(line -> line.contains("study.json:1:") && line.contains(message));
  }
}
