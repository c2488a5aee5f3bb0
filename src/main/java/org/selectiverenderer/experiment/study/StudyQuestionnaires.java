package org.selectiverenderer.experiment.study;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.experiment.questionnaire.ItemsKind;

/**
 * What a study asks its participants.
 *
 * @param form consent and what is asked of the person, at the very beginning; empty for consent and
 *     age alone
 * @param list in the study's order
 */
public record StudyQuestionnaires(Optional<Path> form, List<Source> list) {
  public StudyQuestionnaires {
    list = List.copyOf(list);
  }

  /** Where a questionnaire comes from. */
  public sealed interface Content {
    /** One question of each object in a table, area by area. */
    record Items(ItemsKind kind, Path file) implements Content {}

    /** A file of the author's own. */
    record Own(Path file) implements Content {}

    /** One that comes with the program. */
    record Standard(String template) implements Content {}
  }

  /** When a questionnaire is asked. */
  public enum Moment {
    /** Before the practice. */
    BEGIN,
    AFTER_PRACTICE,
    /** After every area; memory lists of an area after theirs. */
    AFTER_AREA,
    /** After all areas. */
    END;

    /** As the study file spells it. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  /**
   * A questionnaire of the study.
   *
   * @param name that it has in the study; empty for its own
   */
  public record Source(Content content, Moment moment, Optional<String> name) {}

  /** The files that are asked from, by their names, each once. */
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
