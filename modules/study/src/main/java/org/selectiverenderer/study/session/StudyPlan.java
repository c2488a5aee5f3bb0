package org.selectiverenderer.study.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.csv.SpreadsheetText;
import org.selectiverenderer.study.definition.AreaOrder;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialSequencer;

/**
 * The plan of a study: of each place of the schedule, the group, the participant who has it, and
 * the order of areas or trials. It is known before anybody comes; only a staircase chooses its
 * trials by the responses.
 *
 * @param study its name
 * @param places the places, from the first
 */
public record StudyPlan(String study, List<Place> places) {

  /**
   * A place of the schedule.
   *
   * @param number from 1
   * @param participant who has the place; empty while nobody has
   * @param areas the areas in order, of a study without blocks whose order does not depend on the
   *     participant
   * @param trials the trials of all blocks, in order
   */
  public record Place(
      int number,
      StudyGroup group,
      Optional<String> participant,
      List<String> areas,
      List<Trial> trials) {
    public Place {
      areas = List.copyOf(areas);
      trials = List.copyOf(trials);
    }
  }

  /** Number of trials of a block that the text lists; the table has all. */
  private static final int LISTED = 12;

  public StudyPlan {
    places = List.copyOf(places);
  }

  /**
   * Returns the plan.
   *
   * @param count number of places
   * @throws IOException if the file of participants cannot be read
   */
  public static StudyPlan of(Study study, int count) throws IOException {
    RandomizationSchedule schedule = new RandomizationSchedule(study);
    Map<Integer, String> taken = new HashMap<>();
    for (ParticipantsFile.Assigned assigned : new ParticipantsFile(study).all()) {
      taken.put(assigned.place(), assigned.participant());
    }
    Map<String, Integer> turns = new HashMap<>();
    List<Place> places = new ArrayList<>();
    for (int number = 1; number <= count; number++) {
      StudyGroup group = schedule.group(number);
      int turn = turns.merge(group.name(), 1, Integer::sum) - 1;
      Optional<String> participant = Optional.ofNullable(taken.get(number));
      List<Trial> trials = new ArrayList<>();
      for (TrialBlock block : study.design().blocks()) {
        if (block.staircase().isEmpty()) {
          new TrialSequencer(block, group, study.seed()).trials(turn, 1).ifPresent(trials::addAll);
        }
      }
      boolean known =
          study.design().blocks().isEmpty()
              && (study.course().order() != AreaOrder.RANDOM || participant.isPresent());
      places.add(
          new Place(
              number,
              group,
              participant,
              known
                  ? AreaSequence.of(study, participant.orElse(""), turn).stream()
                      .map(Study.Area::name)
                      .toList()
                  : List.of(),
              trials));
    }
    return new StudyPlan(study.name(), places);
  }

  /** Returns the plan as text for people: a line for each block of each place. */
  public String text() {
    StringBuilder text = new StringBuilder();
    text.append(ControlCharacterEscaper.line(study)).append("\n\n");
    text.append(
        String.format(Locale.ROOT, "%5s  %-12s %-16s %s%n", "place", "who", "group", "order"));
    for (Place place : places) {
      String head =
          String.format(
              Locale.ROOT,
              "%5d  %-12s %-16s ",
              place.number(),
              place.participant().map(id -> "sub-" + id).orElse("-"),
              place.group().name());
      Map<String, List<String>> blocks = new LinkedHashMap<>();
      for (Trial trial : place.trials()) {
        blocks.computeIfAbsent(trial.block(), name -> new ArrayList<>()).add(label(trial));
      }
      if (blocks.isEmpty()) {
        text.append((head + String.join(", ", place.areas())).stripTrailing()).append('\n');
      }
      String start = head;
      for (Map.Entry<String, List<String>> block : blocks.entrySet()) {
        List<String> labels = block.getValue();
        text.append(start)
            .append(block.getKey())
            .append(": ")
            .append(
                ControlCharacterEscaper.line(
                    String.join(", ", labels.subList(0, Math.min(LISTED, labels.size())))))
            .append(labels.size() > LISTED ? " ... (" + labels.size() + " trials)\n" : "\n");
        start = " ".repeat(head.length());
      }
    }
    return text.toString().replace("\r\n", "\n");
  }

  /** Returns the levels of a trial, and the line of its stimulus. */
  private static String label(Trial trial) {
    List<String> parts = new ArrayList<>();
    trial.levels().forEach((factor, level) -> parts.add(level));
    if (trial.line() > 0) {
      parts.add("line " + trial.line());
    }
    return parts.isEmpty() ? Integer.toString(trial.number()) : String.join(" ", parts);
  }

  /** Returns the plan as CSV: a row for each trial, or each area, of each place. */
  public String csv(Study study) {
    List<String> factors = study.design().factors().stream().map(Factor::name).toList();
    Set<String> stimuli = new LinkedHashSet<>();
    study.design().blocks().stream()
        .flatMap(block -> block.stimuli().stream())
        .map(StimulusList::columns)
        .forEach(stimuli::addAll);
    factors.forEach(stimuli::remove);
    List<String> header =
        new ArrayList<>(List.of("place", "participant", "group", "block", "trial", "area"));
    header.addAll(factors);
    header.addAll(stimuli);
    CsvWriter table = CsvWriter.bare();
    table.row(header);
    for (Place place : places) {
      List<Object> head =
          List.of(place.number(), place.participant().orElse(""), place.group().name());
      for (int area = 0; area < place.areas().size(); area++) {
        List<Object> row = new ArrayList<>(head);
        row.addAll(List.of("", area + 1, place.areas().get(area)));
        factors.forEach(factor -> row.add(place.group().levels().getOrDefault(factor, "")));
        table.row(row);
      }
      for (Trial trial : place.trials()) {
        List<Object> row = new ArrayList<>(head);
        row.addAll(List.of(trial.block(), trial.number(), trial.settings().area().orElse("")));
        factors.forEach(factor -> row.add(trial.levels().getOrDefault(factor, "")));
        stimuli.forEach(
            column -> row.add(SpreadsheetText.marked(trial.stimulus().getOrDefault(column, ""))));
        table.row(row);
      }
    }
    return table.toString();
  }
}
