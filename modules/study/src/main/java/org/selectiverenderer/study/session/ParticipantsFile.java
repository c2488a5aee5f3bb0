package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StudyGroup;

/**
 * The file {@code participants.tsv} in a study's folder (BIDS, "Participants file"), which records
 * the group of each participant. It is append-only and written under a lock, so that several
 * computers of a lab may share a folder.
 */
public final class ParticipantsFile {
  private static final String HEADER =
      "participant_id\tcondition\tplace\tassigned_by\tinstead_of\tage\tsimulated\n";

  private final Study study;
  private final Path file;

  /**
   * A row of the file: the assignment of a participant.
   *
   * @param place in the schedule, from 1
   * @param group name of the group; in a study without factors its condition
   * @param insteadOf the group of the schedule, if the experimenter chose another
   */
  public record Assigned(
      String participant,
      String group,
      int place,
      Optional<String> insteadOf,
      String age,
      boolean simulated) {
    private String line() {
      return String.join(
              "\t",
              "sub-" + participant,
              group,
              Integer.toString(place),
              insteadOf.isPresent() ? "experimenter" : "schedule",
              insteadOf.orElse("n/a"),
              age.isEmpty() ? "n/a" : age,
              Boolean.toString(simulated))
          + "\n";
    }
  }

  public ParticipantsFile(Study study) {
    this.study = study;
    file = study.folder().resolve("participants.tsv");
  }

  /**
   * Assigns a group to a participant; one who has a group keeps it.
   *
   * @param wanted the experimenter's choice; empty for the next group of the schedule
   * @throws IOException if the file cannot be read or written
   */
  Assigned assign(String participant, Optional<StudyGroup> wanted, String age, boolean simulated)
      throws IOException {
    PrivateFiles.requireNoLink(file);
    try (FileChannel channel =
        PrivateFiles.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
      lock(channel);
      String text = text(channel);
      List<Assigned> all = parse(text);
      for (Assigned known : all) {
        if (known.participant().equals(participant)) {
          return known;
        }
      }
      Set<Integer> taken = new HashSet<>();
      all.forEach(known -> taken.add(known.place()));
      RandomizationSchedule schedule = new RandomizationSchedule(study);
      StudyGroup turn = schedule.group(schedule.free(taken, Optional.empty()));
      int place = schedule.free(taken, wanted);
      Assigned assigned =
          new Assigned(
              participant,
              schedule.group(place).name(),
              place,
              wanted.filter(chosen -> !chosen.equals(turn)).map(chosen -> turn.name()),
              cell(age),
              simulated);
      String missing = text.isEmpty() ? HEADER : text.endsWith("\n") ? "" : "\n";
      channel.position(channel.size());
      DiskSync.write(channel, (missing + assigned.line()).getBytes(StandardCharsets.UTF_8));
      channel.force(true);
      DiskSync.forceFolder(study.folder());
      return assigned;
    }
  }

  /**
   * Records participants whose places another program has given away, such as a page in their
   * browsers; one who is recorded already keeps what is recorded.
   *
   * @throws IOException if the file cannot be read or written
   */
  public void record(List<Assigned> elsewhere) throws IOException {
    if (elsewhere.isEmpty()) {
      return;
    }
    PrivateFiles.requireNoLink(file);
    try (FileChannel channel =
        PrivateFiles.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
      lock(channel);
      String text = text(channel);
      Set<String> known = new HashSet<>();
      parse(text).forEach(one -> known.add(one.participant()));
      StringBuilder lines =
          new StringBuilder(text.isEmpty() ? HEADER : text.endsWith("\n") ? "" : "\n");
      boolean more = false;
      for (Assigned one : elsewhere) {
        if (known.add(one.participant())) {
          more = true;
          lines.append(
              new Assigned(
                      one.participant(),
                      one.group(),
                      one.place(),
                      one.insteadOf(),
                      cell(one.age()),
                      one.simulated())
                  .line());
        }
      }
      if (more) {
        channel.position(channel.size());
        DiskSync.write(channel, lines.toString().getBytes(StandardCharsets.UTF_8));
        channel.force(true);
        DiskSync.forceFolder(study.folder());
      }
    }
  }

  /**
   * Formats a text as a cell: without tabs and line ends, and {@code n/a} for an empty text (BIDS).
   */
  private static String cell(String text) {
    String line = text.strip().replaceAll("\\s+", " ");
    return line.isEmpty() ? "n/a" : line;
  }

  /**
   * Returns all assignments in order, without a line that a crash truncated.
   *
   * @throws IOException if the file exists and cannot be read
   */
  public List<Assigned> all() throws IOException {
    if (!Files.isRegularFile(file)) {
      return List.of();
    }
    return parse(InputFileReader.text(file));
  }

  /** Returns a participant's assignment; empty if there is none yet. */
  public Optional<Assigned> of(String participant) throws IOException {
    return all().stream().filter(known -> known.participant().equals(participant)).findFirst();
  }

  Path file() {
    return file;
  }

  /** Waits for the lock of the file; closing the channel releases it. */
  private void lock(FileChannel channel) throws IOException {
    try {
      channel.lock();
    } catch (IOException e) {
      throw SessionLock.noLocks(file, e);
    }
  }

  private static String text(FileChannel channel) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate((int) channel.size());
    while (bytes.hasRemaining() && channel.read(bytes) >= 0) {
      // Reads until the buffer is full.
    }
    return new String(bytes.array(), 0, bytes.position(), StandardCharsets.UTF_8);
  }

  private List<Assigned> parse(String text) {
    List<Assigned> all = new ArrayList<>();
    for (String line : text.split("\n")) {
      String[] cells = line.strip().split("\t", -1);
      if (cells.length >= 7
          && (Condition.of(cells[1]).isPresent() || study.design().group(cells[1]).isPresent())
          && cells[2].matches("\\d{1,9}")
          && cells[0].startsWith("sub-")) {
        all.add(
            new Assigned(
                cells[0].substring(4),
                cells[1],
                Integer.parseInt(cells[2]),
                Optional.of(cells[4]).filter(name -> !name.equals("n/a")),
                cells[5],
                Boolean.parseBoolean(cells[6])));
      }
    }
    return all;
  }
}
