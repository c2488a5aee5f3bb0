package org.selectiverenderer.experiment.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.AnswersCsv;
import org.selectiverenderer.experiment.questionnaire.Item;
import org.selectiverenderer.experiment.questionnaire.Screen;
import org.selectiverenderer.schema.Band;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * The answers of all of a study's sessions, from their journals. Screens that were finished count,
 * of sessions that were not, too; what does not count, or counts and is not what it seems, is said.
 *
 * @param responses as {@code experiment analyse} reads them
 * @param ratings as {@code enrich --ratings} reads them
 * @param bands means of the ratings with their bands, for people
 */
public record CollectedAnswers(String responses, String ratings, String bands) {

  private record Rated(String area, String schema, String object) {}

  /**
   * Collects them.
   *
   * @param number of the sessions that count: two of a participant would answer everything twice
   * @throws IOException if a journal cannot be read
   */
  public static CollectedAnswers of(StudyMaterial material, int number, Problems problems)
      throws IOException {
    StringBuilder responses = new StringBuilder(AnswersCsv.responsesHeader());
    StringBuilder ratings = new StringBuilder(AnswersCsv.RATINGS);
    Map<Rated, List<Integer>> all = new LinkedHashMap<>();
    for (SessionFolder folder : SessionFolder.all(material.study())) {
      SessionHistory history = SessionHistory.read(folder.journal());
      Location place = Location.of(folder.journal().toString());
      if (folder.number() != number) {
        problems.info(place, "this is not session " + number + "; its answers are left out");
        continue;
      }
      tell(history, place, problems);
      for (SessionStep step : material.steps()) {
        if (step instanceof SessionStep.Questions questions) {
          add(material, folder, history, questions, responses, ratings, all, problems);
        }
      }
    }
    return new CollectedAnswers(responses.toString(), ratings.toString(), bands(all));
  }

  private static void tell(SessionHistory history, Location place, Problems problems) {
    if (history.unattended()) {
      problems.info(place, "the participant of this session was simulated; the answers are kept");
    } else if (history.shortened()) {
      problems.info(place, "exposures of this session were shortened; the answers are kept");
    }
  }

  private static void add(
      StudyMaterial material,
      SessionFolder folder,
      SessionHistory history,
      SessionStep.Questions step,
      StringBuilder responses,
      StringBuilder ratings,
      Map<Rated, List<Integer>> all,
      Problems problems) {
    if (!history.finished(step)) {
      problems.warning(
          Location.of(folder.journal().toString()),
          "the questions of %s were not finished; their answers are left out".formatted(step.id()));
      return;
    }
    Screen screen = material.screen(step, folder.participant());
    Map<String, Answer> answers = history.answers(step);
    String condition = history.condition().map(Condition::spelling).orElse("");
    (screen.withConfidence() ? responses : ratings)
        .append(AnswersCsv.lines(screen, folder.participant(), condition, answers));
    if (!screen.withConfidence()) {
      for (Item item : screen.items()) {
        Optional.ofNullable(answers.get(item.object()))
            .ifPresent(
                answer ->
                    all.computeIfAbsent(
                            new Rated(item.area(), item.schema(), item.object()),
                            key -> new ArrayList<>())
                        .add(Integer.parseInt(answer.value())));
      }
    }
  }

  private static String bands(Map<Rated, List<Integer>> all) {
    StringBuilder text = new StringBuilder("area,schema,object,mean,count,band,consistency\n");
    all.entrySet().stream()
        .sorted(
            Comparator.comparing((Map.Entry<Rated, List<Integer>> entry) -> entry.getKey().area())
                .thenComparing(entry -> entry.getKey().object()))
        .forEach(
            entry -> {
              double mean =
                  entry.getValue().stream().mapToInt(Integer::intValue).average().orElseThrow();
              Band band = Band.of(mean);
              text.append(
                  String.format(
                      Locale.ROOT,
                      "%s,%s,%s,%.6f,%d,%s,%s\n",
                      entry.getKey().area(),
                      entry.getKey().schema(),
                      entry.getKey().object(),
                      mean,
                      entry.getValue().size(),
                      band.name().toLowerCase(Locale.ROOT).replace('_', '-'),
                      band.consistency().name().toLowerCase(Locale.ROOT)));
            });
    return text.toString();
  }
}
