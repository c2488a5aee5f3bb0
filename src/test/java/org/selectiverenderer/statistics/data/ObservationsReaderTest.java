package org.selectiverenderer.statistics.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.ObservationsReader.Columns;

class ObservationsReaderTest {
  private static final Columns MIXED =
      new Columns("score", "id", Optional.of("type"), Optional.of("group"));
  private static final String GOOD = "id,group,type,score\na,x,one,1.5\nb,y,one,2\nb,y,two,-3e-1\n";

  private final Problems problems = new Problems();

  @Test
  void rowsBecomeSubjectsInTheOrderOfTheFile() {
    Observations found = parse(GOOD + "a,x,two,4\n");
    assertThat(found.design().within().levels()).containsExactly("one", "two");
    assertThat(found.design().between().levels()).containsExactly("x", "y");
    assertThat(found.design().subjects())
        .containsExactly(
            new Subject("a", 0, List.of(1.5, 4.0)), new Subject("b", 1, List.of(2.0, -0.3)));
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void withoutAColumnTheDesignLacksTheFactor() {
    Observations found =
        ObservationsReader.parse(
                "d.csv",
                "id,group,score\na,x,1\nb,y,2\n",
                new Columns("score", "id", Optional.empty(), Optional.of("group")),
                problems)
            .orElseThrow();
    assertThat(found.design().within().varies()).isFalse();
    assertThat(found.design().subjects()).hasSize(2);
  }

  /** The fifth line is bad; participant a is left out. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "a,x,two,\"1,500\"|5:9: participant a: '1,500' is not a number (write it with a decimal point",
        "a,x,two,NaN|5:9: participant a: 'NaN' is not a number",
        "a,x,one,2|5:9: participant a: a second value at type one",
        "a,y,two,2|5:3: participant a: is in the group y here and in x before",
        "a,x,two,|2:1: participant a: has no score at two",
        "a,x,,3|5:5: participant a: the type is missing; the row is left out",
        "a,x,two,3,5|5:1: the row has 5 values, but the header has 4 columns",
      })
  void badValuesCostTheParticipantAndAreFlagged(String row, String message) {
    Observations found = parse(GOOD + row + "\n");
    assertThat(problems.list())
        .extracting(Object::toString)
        .anyMatch(line -> line.startsWith("d.csv:" + message));
    assertThat(found.design().subjects()).extracting(Subject::id).containsExactly("b");
    assertThat(found.exclusions()).isNotEmpty();
  }

  @Test
  void oneGroupOnlyIsSaid() {
    Observations found = parse("id,group,type,score\na,x,one,1\na,x,two,2\nb,x,one,1\nb,x,two,3\n");
    assertThat(found.design().between().varies()).isFalse();
    assertThat(problems.list())
        .singleElement()
        .asString()
        .isEqualTo("d.csv:1:4: group has only one level, x; its effect is not tested");
  }

  @Test
  void groupsThatDifferByCaseAreAnErrorAndAGroupOfOneAWarning() {
    parse(
        "id;group;type;score\na;A;one;1,5\na;A;two;2\nb;A;one;1\nb;A;two;3\nc;a;one;1\nc;a;two;3\n");
    assertThat(problems.list())
        .extracting(Object::toString)
        .containsExactly(
            "d.csv:6:3: the group 'a' (1 participant) looks like 'A' (2, first in line 2); they are"
                + " analysed as two groups; write both alike if they are one",
            "d.csv:6:3: the group a has one participant only, so it has no spread of its own");
  }

  @Test
  void aColumnThatIsNotThereIsNamed() {
    assertThat(ObservationsReader.parse("d.csv", "id,group,score\n", MIXED, problems)).isEmpty();
    assertThat(problems.list()).singleElement().asString().contains("the header lacks type");
  }

  private Observations parse(String text) {
    return ObservationsReader.parse("d.csv", text, MIXED, problems).orElseThrow();
  }
}
