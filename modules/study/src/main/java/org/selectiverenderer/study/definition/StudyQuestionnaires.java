package org.selectiverenderer.study.definition;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.study.questionnaire.ItemQuestionnaireKind;

/**
 * The questionnaires that a study refers to.
 *
 * @param form file of the form at the beginning: consent and questions about the person; empty for
 *     the built-in form, consent and age
 * @param list the other questionnaires, in the study's order
 * @param itemAreas areas that tables of items may name besides those of the study and its scene
 */
public record StudyQuestionnaires(Optional<Path> form, List<Source> list, List<String> itemAreas) {
  public StudyQuestionnaires {
    itemAreas = List.copyOf(itemAreas);
    list = List.copyOf(list);
  }

  /** The source of a questionnaire's questions. */
  public sealed interface Content {
    /** A table of items, with one question about each object, by area. */
    record Items(ItemQuestionnaireKind kind, Path file) implements Content {}

    /** A JSON file of the study's author. */
    record Own(Path file) implements Content {}

    /** A standard questionnaire that comes with the program. */
    record Standard(String template) implements Content {}
  }

  /** The moment at which a questionnaire is asked. */
  public enum Moment {
    /** Before the practice. */
    BEGIN,
    AFTER_PRACTICE,
    /** After every area; a recognition list of an area after that area. */
    AFTER_AREA,
    /** In trials, which name it. */
    IN_TRIALS,
    /** After all areas and blocks. */
    END;

    /** Returns the spelling in the study file. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  /**
   * A questionnaire of the study.
   *
   * @param name its name in the study; empty for the name in its file
   */
  public record Source(Content content, Moment moment, Optional<String> name) {}

  /** Returns the files of the questionnaires by their names, each once. */
  public Map<String, Path> files() {
    Map<String, Path> files = new LinkedHashMap<>();
    form.ifPresent(file -> files.put(String.valueOf(file.getFileName()), file));
    for (Source source : list) {
      Optional<Path> file =
          source.content() instanceof Content.Items items
              ? Optional.of(items.file())
              : source.content() instanceof Content.Own own
                  ? Optional.of(own.file())
                  : Optional.empty();
      file.ifPresent(found -> files.put(String.valueOf(found.getFileName()), found));
    }
    return files;
  }
}
