package org.selectiverenderer.study.design;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;

class StimulusListReaderTest {
  @TempDir private Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  private Optional<StimulusList> read(String text) throws IOException {
    Path file = folder.resolve("list.csv");
    Files.writeString(file, text);
    return StimulusListReader.read(file, problems);
  }

  @Test
  void columnsDetermineWhatATrialShowsAndOthersStayFree() throws IOException {
    Files.writeString(folder.resolve("night.x3d"), "<X3D/>");
    StimulusList list =
        read("item;condition;scene;seconds;light;choices;objects\n"
                + "a;high;night.x3d;1,5;off;Vase=1 Lamp=-1;Cup\n"
                + "b;;;;;;Plate Cup\n")
            .orElseThrow();
    TrialSettings first = list.rows().get(0).settings();
    assertThat(first.condition()).contains(Condition.HIGH);
    assertThat(first.scene()).contains(folder.toAbsolutePath().resolve("night.x3d"));
    assertThat(first.seconds()).hasValue(1.5);
    assertThat(first.headlight()).contains(false);
    assertThat(first.choices()).isEqualTo(Map.of("Vase", 1, "Lamp", -1, "Plate", -1));
    assertThat(list.rows().get(1).settings().choices()).isEmpty();
    assertThat(list.rows().get(1).cells()).containsEntry("item", "b");
    assertThat(list.rows()).extracting(StimulusList.Stimulus::line).containsExactly(2, 3);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void whatCannotBeIsAnErrorWithItsPlace() throws IOException {
    assertThat(
            read(
                "condition,scene,seconds,light,choices\n"
                    + "medium,none.x3d,0,dim,Vase\n"
                    + "high,,soon,on,Vase=x\n"))
        .isEmpty();
    assertThat(problems.list())
        .extracting(Object::toString)
        .extracting(line -> line.substring(line.indexOf("list.csv") + 9))
        .containsExactlyInAnyOrder(
            "2:1: 'medium' is not a condition (high, high-low, selective or random); the list is"
                + " not used",
            "2:8: there is no file 'none.x3d' relative to the list; the list is not used",
            "2:17: '0' is no number of seconds above 0 and up to 36000; the list is not used",
            "2:19: 'dim' is not on or off; the list is not used",
            "2:23: 'Vase' is no choice of a Switch; write its DEF, an equals sign and a number, as"
                + " in Vase=1; the list is not used",
            "3:7: 'soon' is no number of seconds above 0 and up to 36000; the list is not used",
            "3:15: 'Vase=x' is no choice of a Switch; write its DEF, an equals sign and a number,"
                + " as in Vase=1; the list is not used");
  }

  @Test
  void aListWithoutStimuliIsNotUsed() throws IOException {
    assertThat(read("item,object\n")).isEmpty();
    assertThat(problems.list()).singleElement().asString().contains("there are no stimuli");
    assertThat(List.of(problems.any())).containsExactly(true);
  }

  @Test
  void aColumnThatTheTableOfTrialsHasIsRefusedWithItsPlace() throws IOException {
    assertThat(read("item,Round,ms\n1,2,3\n")).isEmpty();
    assertThat(problems.list())
        .extracting(Object::toString)
        .extracting(line -> line.substring(line.indexOf("list.csv") + 9))
        .containsExactly(
            "1:6: the column 'Round' cannot be told from that of the table of trials; give it"
                + " another name; the list is not used",
            "1:12: the column 'ms' cannot be told from that of the table of trials; give it another"
                + " name; the list is not used");
  }
}
