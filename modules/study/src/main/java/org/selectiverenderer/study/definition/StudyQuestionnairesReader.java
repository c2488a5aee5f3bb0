package org.selectiverenderer.study.definition;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Content;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Moment;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Source;
import org.selectiverenderer.study.questionnaire.ItemQuestionnaireKind;
import org.selectiverenderer.study.questionnaire.read.StandardScales;

/** Reads the keys {@code form}, {@code questionnaires} and {@code item_areas} of a study. */
final class StudyQuestionnairesReader {
  /** Pattern of names, which become ids of steps. */
  private static final String NAME = "[0-9A-Za-z][0-9A-Za-z_-]*";

  private final FileOfKey files;
  private final Set<String> names = new HashSet<>();

  StudyQuestionnairesReader(FileOfKey files) {
    this.files = files;
  }

  /** Resolves the files that a study refers to. */
  interface FileOfKey {
    /** Returns the file with a name that is the value of a key; reports a missing file. */
    Path find(JsonObjectReader keys, String key, String name);
  }

  /**
   * Reads the keys.
   *
   * @param areas whether the study has areas
   * @param practice whether it has a practice
   */
  StudyQuestionnaires read(JsonObjectReader keys, boolean areas, boolean practice) {
    return new StudyQuestionnaires(
        keys.text("form", false).map(name -> files.find(keys, "form", name)),
        keys.objects("questionnaires", "a questionnaire", each -> source(each, areas, practice)),
        keys.texts("item_areas"));
  }

  private Source source(JsonObjectReader keys, boolean areas, boolean practice) {
    Moment moment = keys.choice("when", List.of(Moment.values()), Moment::spelling, Moment.END);
    if (moment == Moment.AFTER_AREA && !areas) {
      keys.fault("when", "the study has no areas to ask after");
    } else if (moment == Moment.AFTER_PRACTICE && !practice) {
      keys.fault(
          "when",
          "the study has no practice to ask after; add \"practice\", or ask at another time");
    }
    Optional<String> name = keys.text("name", false);
    name.filter(given -> !given.matches(NAME))
        .ifPresent(
            given ->
                keys.fault(
                    "name", "a name must consist of letters, digits, hyphens and underscores"));
    Content content = content(keys);
    name.or(() -> known(content))
        .filter(called -> !names.add(called))
        .ifPresent(
            called ->
                keys.fault(
                    "there are two questionnaires " + called + "; give one another \"name\""));
    return new Source(content, moment, name);
  }

  private static Optional<String> known(Content content) {
    return content instanceof Content.Items items
        ? Optional.of(items.kind().spelling())
        : content instanceof Content.Standard standard
            ? Optional.of(standard.template())
            : Optional.empty();
  }

  private Content content(JsonObjectReader keys) {
    boolean own = keys.has("file");
    boolean standard = keys.has("template");
    if ((own ? 1 : 0) + (standard ? 1 : 0) + (keys.has("kind") ? 1 : 0) > 1) {
      keys.fault("a questionnaire has one of \"kind\", \"file\" and \"template\"");
    }
    if (own) {
      return new Content.Own(files.find(keys, "file", keys.text("file")));
    }
    if (standard) {
      String template = keys.text("template");
      if (!StandardScales.NAMES.contains(template)) {
        keys.fault("template", unknown("template", template, StandardScales.NAMES));
      }
      return new Content.Standard(template);
    }
    String kind = keys.text("kind");
    List<String> kinds =
        List.of(ItemQuestionnaireKind.values()).stream()
            .map(ItemQuestionnaireKind::spelling)
            .toList();
    if (!kind.isEmpty() && !kinds.contains(kind)) {
      keys.fault("kind", unknown("kind of questionnaire", kind, kinds));
    }
    return new Content.Items(
        ItemQuestionnaireKind.values()[Math.max(0, kinds.indexOf(kind))],
        files.find(keys, "items", keys.text("items")));
  }

  private static String unknown(String what, String name, List<String> known) {
    return "there is no %s '%s'%s"
        .formatted(
            what,
            name,
            SpellingSuggester.nearest(name, known)
                .map(near -> "; did you mean '%s'?".formatted(near))
                .orElse(" (known: %s)".formatted(String.join(", ", known))));
  }
}
