package org.selectiverenderer.study.questionnaire.read;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.study.questionnaire.QuestionKind;

/**
 * Reads texts in one language: a JSON string is the text in all languages, an object has a text for
 * each, {@code {"en": "Yes", "el": "Ναι"}}.
 */
public final class LocalizedTexts implements QuestionKind.Texts {
  private final String language;
  private final List<String> languages;

  /** Makes a reader of texts that need one language. */
  public LocalizedTexts(String language) {
    this(language, List.of(language));
  }

  /**
   * Makes a reader.
   *
   * @param language of the texts that are returned
   * @param languages all languages in which texts are needed
   */
  public LocalizedTexts(String language, List<String> languages) {
    this.language = language;
    this.languages = List.copyOf(languages);
  }

  @Override
  public String text(JsonObjectReader keys, String key) {
    return keys.hasObject(key) ? chosen(keys, key, each -> each.text(language)) : keys.text(key);
  }

  @Override
  public String optional(JsonObjectReader keys, String key) {
    return keys.hasObject(key)
        ? chosen(keys, key, each -> each.text(language))
        : keys.text(key, false).orElse("");
  }

  @Override
  public List<String> list(JsonObjectReader keys, String key) {
    if (!keys.hasObject(key)) {
      return keys.texts(key);
    }
    List<String> texts = new ArrayList<>();
    chosen(
        keys,
        key,
        each -> {
          texts.addAll(each.texts(language));
          return "";
        });
    return texts;
  }

  private String chosen(
      JsonObjectReader keys, String key, Function<JsonObjectReader, String> text) {
    return keys.object(
            key,
            "the texts of \"" + key + "\"",
            each -> {
              List<String> known = each.names();
              for (String needed : languages) {
                if (!known.contains(needed)) {
                  each.fault(
                      "\"%s\" has no text in the study's language '%s', only in %s"
                          .formatted(key, needed, String.join(", ", known)));
                }
              }
              return known.contains(language) ? text.apply(each) : "";
            })
        .orElse("");
  }
}
