package org.selectiverenderer.study.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.bids.BidsDataset;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.export.StudyExport;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.PaperAnswers;

class WebSessionImportTest extends WebStudyFixture {
  private CollectedAnswers answers() throws IOException {
    return CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), problems);
  }

  private List<String> table(String name) throws IOException {
    return StudyExport.tables(
            RecordedStudy.read(material(), problems), StudyExport.Answers.of(answers()), problems)
        .stream()
        .filter(table -> table.name().equals(name))
        .findFirst()
        .map(DataTable::csv)
        .orElseThrow()
        .lines()
        .toList();
  }

  private Path ofSession(String participant, String name) {
    return folder.resolve("study").resolve("sub-" + participant).resolve("ses-01").resolve(name);
  }

  @Test
  void sessionsOfTheReceiverAreCollectedIntoTheSameTables() throws IOException {
    write(session(1) + ".jsonl", whole(1, 1));
    write(session(2) + ".jsonl", whole(2, 2));
    Files.writeString(
        data.resolve("sessions.csv"),
        "session,slot,parts,missing,final\n%s,1,1,,yes\n%s,2,1,,yes\n"
            .formatted(session(1), session(2)));

    assertThat(collect()).isEqualTo(new WebSessionImport.Summary(2, 0, 0));

    assertThat(told()).isEmpty();
    assertThat(answers().responses().lines())
        .containsExactly(
            "participant,condition,area,object,consistency,present,response,confidence,response_ms,place",
            "web001,%s,hall,boat,inconsistent,no,no,4,2000,1".formatted(group(1)),
            "web001,%s,hall,coat,consistent,yes,yes,5,3000,2".formatted(group(1)),
            "web002,%s,hall,boat,inconsistent,no,no,4,2000,1".formatted(group(2)),
            "web002,%s,hall,coat,consistent,yes,yes,5,3000,2".formatted(group(2)));
    assertThat(answers().others()).contains("eyes").doesNotContain("Maria");
    assertThat(table("sessions"))
        .element(1)
        .isEqualTo(
            "web001,1,2026-11-01T10:01Z,150,4,%s,en,finished,no,,program 1".formatted(group(1)));
    assertThat(table("gaze"))
        .contains("web001,1,%s,exposure-hall,1,Coat,4,1,1,4".formatted(group(1)));
    assertThat(Files.readAllLines(folder.resolve("study/participants.tsv")))
        .element(1)
        .isEqualTo("sub-web001\t%s\t1\tschedule\tn/a\tn/a\tfalse".formatted(group(1)));
  }

  @Test
  void theHeadLogHasAllColumnsAndTheEventsTheirTimes() throws IOException {
    write("all.jsonl", whole(1, 1));
    collect();
    assertThat(Files.readAllLines(ofSession("web001", "head/exposure-hall_run-01.csv")))
        .hasSize(362)
        .element(61)
        .isEqualTo(
            "1.000000,1.000000,1.600000,-0.100000,0.000000,0.000000,0.000000,moved,Coat,2.000,0,"
                + "Coat,HallSchema,16.667,1,2026-11-01T10:02:11.000Z,132.000000");
    assertThat(table("events"))
        .anyMatch(row -> row.contains(",enter,HallProx,HallSchema,"))
        .anyMatch(row -> row.contains(",switch,,,Coat,1,0,"));
  }

  @Test
  void partsThatCameTwiceCountOnceAndGapsAreTold() throws IOException {
    List<String> records = whole(1, 1);
    String first = part(1, 0, false, records.subList(0, 1));
    write(
        "jatos_results.txt",
        List.of(
            first, part(1, 2, false, records.subList(2, 3)), first, part(2, 0, true, whole(2, 2))));

    collect();

    assertThat(told())
        .containsExactly(
            "the session %s (web001) lacks the part 1, which may still come; what is there is used"
                .formatted(session(1)));
    assertThat(answers().participants()).isEqualTo(2);
    assertThat(table("sessions")).element(1).asString().contains(",unfinished,");
    assertThat(table("sessions")).element(2).asString().contains(",finished,");
  }

  @Test
  void aParticipantWhoLeftIsOneLineAndNoError() throws IOException {
    write("some.jsonl", List.of(form(1, 1)));
    collect();
    answers();
    assertThat(told())
        .containsExactly(
            "the participant has left, or not all has arrived; not answered: memory-hall");
    assertThat(problems.any()).isFalse();
  }

  @Test
  void aHeadsetThatWasLeftAndAnExposureThatNobodySawAreFlagged() throws IOException {
    write(
        "all.jsonl",
        List.of(
            form(1, 1),
            exposure(
                    1,
                    1,
                    "\"display\":\"webxr\",\"interruptions\":[{\"t\":12,\"event\":\"headset-left\"}]")
                .replaceAll(",1,([\\d.]+\\])", ",0,$1"),
            memory(1, 1, "yes")));
    collect();
    assertThat(Files.readString(ofSession("web001", "events.jsonl")))
        .contains("\"shown_in\":\"webxr\"");
    assertThat(table("exposures")).element(1).asString().contains(",webxr,not-seen|headset-lost,");
    assertThat(table("sessions")).element(1).asString().contains(",not-seen|headset-lost,");
  }

  @Test
  void anotherPartOfTheSameNumberIsRefused() throws IOException {
    write(
        "parts.txt",
        List.of(part(1, 0, true, whole(1, 1)), part(1, 0, true, List.of(memory(1, 1, "no")))));
    collect();
    assertThat(told())
        .containsExactly(
            "part 0 of the session %s is there with other content, in line 1 of %s; this one is left out"
                .formatted(session(1), data.resolve("parts.txt")));
    assertThat(answers().responses()).contains("coat,consistent,yes,yes,5");
  }

  @Test
  void whatComesLaterIsPutToTheSessionAndNothingIsCountedTwice() throws IOException {
    List<String> records = whole(1, 1);
    Path early = write("early.jsonl", records.subList(0, 2));
    Path rest = write(session(1) + "-rest.jsonl", records.subList(1, 3));

    assertThat(collect(early)).isEqualTo(new WebSessionImport.Summary(1, 0, 0));
    Files.writeString(ofSession("web001", "note-of-the-lab.txt"), "she had a headache");
    assertThat(collect(rest)).isEqualTo(new WebSessionImport.Summary(0, 1, 0));
    byte[] journal = Files.readAllBytes(ofSession("web001", "events.jsonl"));
    assertThat(collect(early, rest)).isEqualTo(new WebSessionImport.Summary(0, 0, 1));
    assertThat(collect(early)).isEqualTo(new WebSessionImport.Summary(0, 0, 1));

    assertThat(Files.readAllBytes(ofSession("web001", "events.jsonl"))).isEqualTo(journal);
    assertThat(ofSession("web001", "note-of-the-lab.txt")).exists();
    assertThat(table("sessions")).hasSize(2).element(1).asString().contains(",finished,");
    assertThat(table("exposures")).hasSize(2);
    assertThat(Files.readAllLines(folder.resolve("study/participants.tsv"))).hasSize(2);
  }

  @Test
  void halfACharacterIsNoOtherRecordWhenItComesAgain() throws IOException {
    write("a.jsonl", List.of(form(1, 1).replace("brown", "brown\\ud83d"), memory(1, 1, "yes")));
    collect();
    assertThat(collect()).isEqualTo(new WebSessionImport.Summary(0, 0, 1));
    assertThat(answers().others()).contains("brown?");
    assertThat(told()).isEmpty();
  }

  @Test
  void twoSessionsOfOnePlaceAreTwoParticipantsAndTold() throws IOException {
    write("a.jsonl", whole(5, 3));
    write("b.jsonl", whole(4, 3));
    collect();
    assertThat(told())
        .containsExactly(
            "these places of the plan were taken more than once: 3 (web003, web003b); the data counts, and the groups are not as balanced as planned");
    assertThat(collect()).isEqualTo(new WebSessionImport.Summary(0, 0, 2));
    assertThat(answers().participants()).isEqualTo(2);
  }

  @Test
  void onePersonWithTwoSessionsIsTold() throws IOException {
    write("a.jsonl", List.of(form(1, 1), form(2, 2).replace("person2", "person1")));
    collect();
    assertThat(told())
        .contains(
            "web001 and web002 have the same PROLIFIC_PID: one person may have taken part twice; both are kept");
  }

  @Test
  void aParticipantOfTheLaboratoryKeepsIdAndFolder() throws IOException {
    Path laboratory = Files.createDirectories(ofSession("web001", "").resolve("head"));
    Files.writeString(
        laboratory.resolveSibling("events.jsonl"),
        "{\"time\":\"2026-03-01T10:00:00.000Z\",\"event\":\"session-began\"}\n");
    write("a.jsonl", whole(1, 1));
    collect();
    assertThat(ofSession("web001b", "events.jsonl")).exists();
    assertThat(Files.readAllLines(laboratory.resolveSibling("events.jsonl"))).hasSize(1);
  }

  @Test
  void whoRefusesLeavesNoAnswersAndTakesNoPlace() throws IOException {
    write("a.jsonl", List.of(record(1, 1, "form", 1, "\"interruptions\":[],\"refused\":true")));
    collect();
    assertThat(table("sessions")).element(1).asString().contains(",refused,");
    assertThat(folder.resolve("study/participants.tsv")).doesNotExist();
  }

  @Test
  void leavingThePageDuringTheExposureIsFlaggedWithItsSeconds() throws IOException {
    // The exposure lasts from second 10 of its step to second 16.
    String left =
        "\"interruptions\":[{\"t\":2,\"event\":\"blur\"},{\"t\":3,\"event\":\"focus\"},"
            + "{\"t\":9,\"event\":\"fullscreenexit\"},{\"t\":10.5,\"event\":\"blur\"},"
            + "{\"t\":11,\"event\":\"fullscreenenter\"},{\"t\":12.25,\"event\":\"focus\"}]";
    write("a.jsonl", List.of(form(1, 1), exposure(1, 1, left), memory(1, 1, "yes")));
    collect();
    assertThat(Files.readString(ofSession("web001", "events.jsonl")))
        .contains("\"flag\":\"left-page\",\"seconds\":2.25");
    assertThat(table("sessions")).element(1).asString().contains(",left-page,");
  }

  @Test
  void aHeadsetThatIsTakenOffLosesNoInterruption() throws IOException {
    String events =
        "\"interruptions\":[{\"t\":12,\"event\":\"headset-off\"},"
            + "{\"t\":13,\"event\":\"headset-on\"},{\"t\":14,\"event\":\"blur\"},"
            + "{\"t\":15,\"event\":\"focus\"}]";
    write("all.jsonl", List.of(form(1, 1), exposure(1, 1, events), memory(1, 1, "yes")));
    collect();
    assertThat(told()).isEmpty();
    assertThat(table("sessions")).element(1).asString().contains("left-page");
  }

  @Test
  void aClockThatWasSetBackDuringAStepLosesNoRecord() throws IOException {
    List<String> records = new ArrayList<>(whole(1, 1));
    records.set(2, records.get(2).replace("10:03:30.000Z", "10:02:50.000Z"));
    write("all.jsonl", records);
    collect();
    assertThat(told()).isEmpty();
    assertThat(answers().responses()).contains("web001");
  }

  @Test
  void aRowThatIsLackingInTheTableOfParticipantsIsWrittenAgain() throws IOException {
    write("all.jsonl", whole(1, 1));
    collect();
    Path participants = folder.resolve("study/participants.tsv");
    String rows = Files.readString(participants);
    Files.delete(participants); // as if it could not be written
    assertThat(collect().changed()).isEqualTo(1);
    assertThat(participants).content().isEqualTo(rows);
    assertThat(collect()).isEqualTo(new WebSessionImport.Summary(0, 0, 1));
  }

  @Test
  void leavingThePageBeforeTheExposureIsNotFlagged() throws IOException {
    String left = "\"interruptions\":[{\"t\":2,\"event\":\"blur\"},{\"t\":3,\"event\":\"focus\"}]";
    write("a.jsonl", List.of(form(1, 1), exposure(1, 1, left), memory(1, 1, "yes")));
    collect();
    assertThat(Files.readString(ofSession("web001", "events.jsonl"))).doesNotContain("left-page");
  }

  @Test
  void aFrameRateBelowTwentyIsFlaggedWhereTheStudyNamesNone() throws IOException {
    String slow = record(1, 1, "exposure-hall", 2, "\"interruptions\":[],\"log\":" + log(15, 6));
    write("a.jsonl", List.of(form(1, 1), slow, memory(1, 1, "yes")));
    collect();
    assertThat(table("sessions")).element(1).asString().contains(",low-frame-rate,");
    assertThat(Files.readString(ofSession("web001", "events.jsonl")))
        .contains("15.0 frames per second on average, less than 20");
  }

  @Test
  void theStudysOwnFrameRateIsAskedFor() throws IOException {
    Path study = folder.resolve("study/study.json");
    String slow = record(1, 1, "exposure-hall", 2, "\"interruptions\":[],\"log\":" + log(15, 6));
    write("a.jsonl", List.of(form(1, 1), slow, memory(1, 1, "yes")));
    Files.writeString(
        study,
        Files.readString(study).replace("\"fade\"", "\"quality\": {\"min_fps\": 10}, \"fade\""));
    collect();
    assertThat(table("sessions")).element(1).asString().doesNotContain("low-frame-rate");
    assertThat(told())
        .anyMatch(text -> text.startsWith("1 session ran another version of the study"));
  }

  @Test
  void anExposureThatWasBegunTwiceIsFlagged() throws IOException {
    write(
        "a.jsonl",
        List.of(
            form(1, 1),
            exposure(1, 1, "\"repeated\":true,\"interruptions\":[]"),
            memory(1, 1, "yes")));
    collect();
    assertThat(table("sessions")).element(1).asString().contains(",repeated-exposure,");
  }

  @Test
  void aPageThatWasOpenedAnewResumesTheSession() throws IOException {
    String later = memory(1, 1, "yes").replace("1793527000000", "1793527999000");
    write("a.jsonl", List.of(form(1, 1), exposure(1, 1, "\"interruptions\":[]"), later));
    collect();
    assertThat(Files.readString(ofSession("web001", "events.jsonl")))
        .containsOnlyOnce("\"event\":\"resumed\"")
        .doesNotContain("clock-moved");
    assertThat(table("sessions")).element(1).asString().contains(",finished,");
  }

  @Test
  void aWallClockThatWasSetIsFlagged() throws IOException {
    String moved = memory(1, 1, "yes").replace("T10:03", "T11:03");
    write("a.jsonl", List.of(form(1, 1), exposure(1, 1, "\"interruptions\":[]"), moved));
    collect();
    assertThat(Files.readString(ofSession("web001", "events.jsonl")))
        .contains("\"flag\":\"clock-moved\",\"seconds\":3600");
  }

  @Test
  void whereTheSceneCannotBeReplayedTheColumnsStayEmpty() throws IOException {
    write("a.jsonl", whole(1, 1));
    WebSessionImport.run(
        material(),
        List.of(data),
        "program 1",
        (study, exposure) -> {
          throw new IOException("hall.x3d: is not there");
        },
        problems);
    assertThat(told())
        .containsExactly(
            "what was in view in exposures is not known, as the scene cannot be replayed: hall.x3d: is not there");
    assertThat(Files.readAllLines(ofSession("web001", "head/exposure-hall_run-01.csv")))
        .element(61)
        .asString()
        .contains(",moved,,,,,,16.667,");
    assertThat(table("exposures")).hasSize(2);
  }

  @Test
  void theBidsDatasetHasTheSessionAndNoRecruitment() throws IOException {
    write("a.jsonl", whole(1, 1));
    collect();
    Path dataset = folder.resolve("bids");
    BidsDataset.write(
        RecordedStudy.read(material(), problems),
        new BidsDataset.Origin("program", "1", List.of()),
        dataset,
        problems);
    List<Path> files;
    try (Stream<Path> all = Files.walk(dataset)) {
      files = all.filter(Files::isRegularFile).toList();
    }
    List<String> texts = new ArrayList<>();
    for (Path file : files) {
      texts.add(Files.readString(file));
    }
    assertThat(files)
        .anyMatch(
            file ->
                file.endsWith(
                    "sub-web001_ses-01_task-exposurehall_tracksys-head_run-01_motion.tsv"));
    assertThat(texts).noneMatch(text -> text.contains("person1") || text.contains("Maria"));
    assertThat(table("participants")).element(1).asString().contains("person1");
  }

  @Test
  void aFolderWithoutRecordsIsRefused() {
    assertThatThrownBy(this::collect)
        .isInstanceOf(IOException.class)
        .hasMessageContaining("has no files of records");
  }

  @Test
  void manySessionsAreAllThere() throws IOException {
    for (int i = 1; i <= 40; i++) {
      write(session(i) + ".jsonl", whole(i, i));
    }
    assertThat(collect().added()).isEqualTo(40);
    assertThat(answers().participants()).isEqualTo(40);
    assertThat(new ProblemCollector().any()).isFalse();
  }
}
