package org.selectiverenderer.statistics.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.ObservationsReader.Columns;

class ObservationsReaderTest {
  @TempDir private Path folder;
  private static final Columns MIXED =
      new Columns("score", "id", Optional.of("type"), Optional.of("group"));
  private static final String GOOD = "id,group,type,score\na,x,one,1.5\nb,y,one,2\nb,y,two,-3e-1\n";

  private final ProblemCollector problems = new ProblemCollector();

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
  void rowsOfTrialsAreChosenByACellAndAveraged() throws IOException {
    Path file = folder.resolve("trials.csv");
    Files.writeString(
        file,
        """
        id,quality,correct,ms
        a,high,yes,100
        a,high,yes,300
        a,high,no,9000
        a,low,yes,400
        b,high,yes,500
        b,low,yes,600
        b,low,yes,700
        """);
    Columns columns = new Columns("ms", "id", Optional.of("quality"), Optional.empty());
    Observations found =
        ObservationsReader.read(
                file,
                columns,
                new ObservationsReader.Rows(Map.of("correct", "yes"), true),
                problems)
            .orElseThrow();
    assertThat(found.design().subjects())
        .containsExactly(
            new Subject("a", 0, List.of(200.0, 400.0)), new Subject("b", 0, List.of(500.0, 650.0)));
    assertThat(problems.list()).isEmpty();
    ObservationsReader.read(
        file, columns, new ObservationsReader.Rows(Map.of("correct", "yes"), false), problems);
    assertThat(problems.list().toString())
        .contains(
            "trials.csv:3:12: participant a: a second value at quality high; the participant is left out");
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
            "d.csv:6:3: the group a has one participant only, so its standard deviation is"
                + " undefined");
  }

  @Test
  void aColumnThatIsNotThereIsNamed() {
    assertThat(ObservationsReader.parse("d.csv", "id,group,score\n", MIXED, problems)).isEmpty();
    assertThat(problems.list()).singleElement().asString().contains("the header lacks type");
  }

  @Test
  void severalFactorsAndCovariatesMakeOneRowOfEachSubject() {
    Observations found =
        ObservationsReader.parse(
                "d.csv",
                "id,sex,group,type,size,age,score\n"
                    + "p,f,x,one,big,30,1\np,f,x,one,small,,2\np,f,x,two,big,30,3\n"
                    + "p,f,x,two,small,30,4\n"
                    + "q,m,x,two,small,41,8\nq,m,x,two,big,41,7\nq,m,x,one,small,41,6\n"
                    + "q,m,x,one,big,41,5\n"
                    + "r,m,y,one,big,50,1\nr,m,y,one,small,50,1\nr,m,y,two,big,51,1\n"
                    + "r,m,y,two,small,50,1\n"
                    + "s,f,y,one,big,50,1\ns,f,y,one,small,50,1\n"
                    + "t,f,y,one,big,,1\nt,f,y,one,small,,2\nt,f,y,two,big,,3\n"
                    + "t,f,y,two,small,,4\n",
                new Columns(
                    "score",
                    "id",
                    List.of("type", "size"),
                    List.of("sex", "group"),
                    List.of("age")),
                problems)
            .orElseThrow();
    assertThat(found.design().subjects())
        .containsExactly(
            new Subject("p", 0, List.of(1.0, 2.0, 3.0, 4.0), List.of(30.0)),
            new Subject("q", 2, List.of(5.0, 6.0, 7.0, 8.0), List.of(41.0)));
    assertThat(found.design().within().levels())
        .containsExactly("one, big", "one, small", "two, big", "two, small");
    assertThat(problems.list())
        .extracting(Object::toString)
        .containsExactly(
            "d.csv:12:15: participant r: another age than in a row before; a covariate is one number"
                + " for each participant; the participant is left out",
            "d.csv:14:1: participant s: has no score at two, big; two, small; the participant is left"
                + " out",
            "d.csv:16:1: participant t: has no age; the participant is left out");
  }

  private Observations parse(String text) {
    return ObservationsReader.parse("d.csv", text, MIXED, problems).orElseThrow();
  }
}
