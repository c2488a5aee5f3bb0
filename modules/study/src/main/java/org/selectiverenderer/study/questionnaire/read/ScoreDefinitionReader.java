package org.selectiverenderer.study.questionnaire.read;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.ScoreDefinition;

/** Reads the definitions of a questionnaire's scores, after its questions. */
final class ScoreDefinitionReader {
  private final Map<String, Question> questions;
  private final Set<String> earlier = new HashSet<>();

  ScoreDefinitionReader(Map<String, Question> questions) {
    this.questions = questions;
  }

  List<ScoreDefinition> scores(JsonObjectReader keys) {
    return keys.objects("scores", "a score", this::score);
  }

  private ScoreDefinition score(JsonObjectReader keys) {
    String name = keys.text("name");
    List<String> of = keys.texts("questions");
    List<String> scores = keys.texts("scores");
    List<String> reversed = keys.texts("reversed");
    ScoreDefinition.By by =
        keys.choice(
            "by",
            List.of(ScoreDefinition.By.values()),
            ScoreDefinition.By::spelling,
            ScoreDefinition.By.SUM);
    double least = keys.number("least", -1e9, 1e9, 0);
    double weight = keys.number("weight", -1e6, 1e6, 1);
    of.forEach(question -> known(keys, "questions", question, questions.keySet()));
    scores.forEach(score -> known(keys, "scores", score, earlier));
    reversed.forEach(question -> known(keys, "reversed", question, of));
    reversed.stream()
        .filter(questions::containsKey)
        .filter(question -> !turns(questions.get(question)))
        .forEach(
            question ->
                keys.fault("reversed", "the question " + question + " has no scale to reverse"));
    if (by == ScoreDefinition.By.COUNT && !keys.has("least")) {
      keys.fault("a score that counts needs \"least\", the lowest value that is counted");
    }
    if (of.isEmpty() && scores.isEmpty()) {
      keys.fault("a score needs \"questions\" or \"scores\"");
    }
    if (!earlier.add(name)) {
      keys.fault("name", "the score " + name + " is defined twice");
    }
    return new ScoreDefinition(
        name, by, of, scores, Set.copyOf(new ArrayList<>(reversed)), least, weight);
  }

  private static boolean turns(Question question) {
    return question.kind().scale().isPresent();
  }

  private static void known(
      JsonObjectReader keys, String key, String name, Collection<String> all) {
    if (!all.contains(name)) {
      keys.fault(
          key,
          "\"%s\" names '%s', which does not exist%s"
              .formatted(
                  key,
                  name,
                  SpellingSuggester.nearest(name, all)
                      .map(near -> "; did you mean '%s'?".formatted(near))
                      .orElse("")));
    }
  }
}
