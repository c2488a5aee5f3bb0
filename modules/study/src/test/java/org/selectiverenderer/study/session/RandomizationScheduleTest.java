package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.definition.StudyReader;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.design.StudyGroup;

class RandomizationScheduleTest {
  @TempDir Path folder;

  private Study study() throws IOException {
    return StudyReader.read(
            StudyTemplate.write(folder, Path.of("scenes/apartment.x3d")), new ProblemCollector())
        .orElseThrow();
  }

  @Test
  void everyBlockHoldsEachConditionAsOften() throws IOException {
    RandomizationSchedule schedule = new RandomizationSchedule(study());
    Set<List<StudyGroup>> orders = new HashSet<>();
    for (int block = 0; block < 9; block++) {
      List<StudyGroup> places = new ArrayList<>();
      for (int place = 1; place <= 6; place++) {
        places.add(schedule.group(6 * block + place));
      }
      for (Condition condition : List.of(Condition.HIGH, Condition.HIGH_LOW, Condition.SELECTIVE)) {
        assertThat(places).filteredOn(StudyGroup.of(condition)::equals).hasSize(2);
      }
      orders.add(places);
    }
    assertThat(orders).as("blocks differ").hasSizeGreaterThan(5);
  }

  @Test
  void aLatinSquareHasEachConditionAtEachPlaceOfABlockOnce() throws IOException {
    Path file = StudyTemplate.write(folder, Path.of("scenes/apartment.x3d"));
    Files.writeString(
        file,
        Files.readString(file)
            .replace("\"blocked\"", "\"latin-square\"")
            .replace("\"block\": 6", "\"block\": 4")
            .replace("\"selective\"]", "\"selective\", \"random\"]"));
    Study study = StudyReader.read(file, new ProblemCollector()).orElseThrow();
    RandomizationSchedule schedule = new RandomizationSchedule(study);
    Set<List<StudyGroup>> squares = new HashSet<>();
    for (int square = 0; square < 5; square++) {
      List<StudyGroup> places = new ArrayList<>();
      for (int place = 1; place <= 16; place++) {
        places.add(schedule.group(16 * square + place));
      }
      for (int i = 0; i < 4; i++) {
        int column = i;
        assertThat(places.subList(4 * i, 4 * i + 4)).doesNotHaveDuplicates();
        assertThat(IntStream.range(0, 4).mapToObj(row -> places.get(4 * row + column)).toList())
            .doesNotHaveDuplicates();
      }
      squares.add(places);
    }
    assertThat(squares).as("squares differ").hasSize(5);
  }

  @Test
  void fiftyFourParticipantsMakeThreeGroupsOfEighteen() throws IOException {
    ParticipantsFile participants = new ParticipantsFile(study());
    for (int i = 1; i <= 54; i++) {
      participants.assign("p" + i, Optional.empty(), "18-22", false);
    }
    for (StudyGroup group : study(participants).design().groups()) {
      assertThat(participants.all())
          .filteredOn(assigned -> assigned.group().equals(group.name()))
          .hasSize(18);
    }
  }

  private Study study(ParticipantsFile participants) throws IOException {
    assertThat(participants.all()).hasSize(54);
    return StudyReader.read(folder.resolve("study.json"), new ProblemCollector()).orElseThrow();
  }

  @Test
  void theExperimentersChoiceIsRecordedAndKeepsTheBalance() throws IOException {
    Study study = study();
    ParticipantsFile participants = new ParticipantsFile(study);
    StudyGroup turn = new RandomizationSchedule(study).group(1);
    StudyGroup other =
        study.design().groups().stream()
            .filter(group -> !group.equals(turn))
            .findFirst()
            .orElseThrow();
    ParticipantsFile.Assigned chosen = participants.assign("a", Optional.of(other), "18-22", false);
    assertThat(chosen.group()).isEqualTo(other.name());
    assertThat(chosen.insteadOf()).contains(turn.name());
    for (String next : List.of("b", "c", "d", "e", "f")) {
      participants.assign(next, Optional.empty(), "18-22", false);
    }
    for (StudyGroup group : study.design().groups()) {
      assertThat(participants.all())
          .filteredOn(assigned -> assigned.group().equals(group.name()))
          .hasSize(2);
    }
  }

  @Test
  void anAgeInOnesOwnWordsKeepsToItsCell() throws IOException {
    ParticipantsFile participants = new ParticipantsFile(study());
    ParticipantsFile.Assigned first =
        participants.assign("a", Optional.empty(), "thirty\tor\r\nso ", false);
    assertThat(participants.assign("b", Optional.empty(), " ", false).age()).isEqualTo("n/a");
    assertThat(participants.all()).hasSize(2).first().isEqualTo(first);
    assertThat(first.age()).isEqualTo("thirty or so");
  }

  @Test
  void whoIsThereAlreadyKeepsTheConditionAndATornLineIsNobody() throws IOException {
    ParticipantsFile participants = new ParticipantsFile(study());
    ParticipantsFile.Assigned first = participants.assign("a", Optional.empty(), "", false);
    Files.writeString(folder.resolve("participants.tsv"), "sub-b\thi", StandardOpenOption.APPEND);
    assertThat(participants.assign("a", Optional.empty(), "", false).place())
        .isEqualTo(first.place());
    assertThat(participants.assign("b", Optional.empty(), "", false).place()).isEqualTo(2);
    assertThat(participants.all()).hasSize(2);
  }
}
