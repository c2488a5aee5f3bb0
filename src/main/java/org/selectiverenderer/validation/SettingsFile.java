package org.selectiverenderer.validation;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.Problem.Severity;
import org.selectiverenderer.x3d.Spelling;

/**
 * Reads the settings that a project keeps beside its scenes:
 *
 * <pre>
 * {"ignore": ["SR2"],
 *  "severities": {"SR305": "error"},
 *  "budgets": [{"scope": "Office", "schemas": ["DeskSchema"], "polygons": 170000}],
 *  "megabytes": 50}
 * </pre>
 *
 * <p>Each key may be left out, and so may a budget's {@code scope} (the whole scene) and {@code
 * schemas} (the worst state). A key that is not known is an error: a slip would otherwise go
 * unnoticed.
 */
public final class SettingsFile {
  private final Path file;
  private final RuleCatalogue rules;

  /**
   * @param rules that the file may name
   */
  public SettingsFile(Path file, RuleCatalogue rules) {
    this.file = file;
    this.rules = rules;
  }

  /**
   * Reads the file.
   *
   * @throws IOException if it cannot be read or says something that has no meaning, with a message
   *     of one line
   */
  public ValidationSettings read() throws IOException {
    JsonNode json = JsonFile.read(file);
    known(json, List.of("ignore", "severities", "budgets", "megabytes"), "settings");
    Set<String> ignored = new HashSet<>();
    for (String id : texts(json, "ignore")) {
      ignored.add(rule(id));
    }
    Map<String, Severity> severities = new HashMap<>();
    for (Iterator<String> ids = json.path("severities").fieldNames(); ids.hasNext(); ) {
      String id = ids.next();
      severities.put(rule(id), severity(json.path("severities").path(id)));
    }
    List<Budget> budgets = new ArrayList<>();
    for (JsonNode budget : array(json, "budgets")) {
      budgets.add(budget(budget));
    }
    JsonNode megabytes = json.path("megabytes");
    if (!megabytes.isMissingNode() && !(megabytes.isNumber() && megabytes.asDouble() >= 0)) {
      throw fault("\"megabytes\" is a number from 0");
    }
    double most = megabytes.asDouble(ValidationSettings.MEGABYTES);
    return new ValidationSettings(ignored, severities, budgets, most);
  }

  private Budget budget(JsonNode json) throws IOException {
    known(json, List.of("scope", "schemas", "polygons"), "a budget");
    JsonNode polygons = json.path("polygons");
    if (!polygons.canConvertToLong() || !polygons.isIntegralNumber() || polygons.asLong() < 0) {
      throw fault("a budget needs \"polygons\", a whole number from 0");
    }
    return new Budget(json.path("scope").asText(), texts(json, "schemas"), polygons.asLong());
  }

  private Severity severity(JsonNode json) throws IOException {
    return switch (json.asText()) {
      case "error" -> Severity.ERROR;
      case "warning" -> Severity.WARNING;
      case "info" -> Severity.INFO;
      default ->
          throw fault(
              "a severity is \"error\", \"warning\" or \"info\", not "
                  + json
                  + "; what is not wanted goes into \"ignore\"");
    };
  }

  private String rule(String id) throws IOException {
    return rules.resolve(id).orElseThrow(() -> fault("there is no rule '" + id + "'"));
  }

  private List<String> texts(JsonNode json, String key) throws IOException {
    List<String> texts = new ArrayList<>();
    for (JsonNode text : array(json, key)) {
      if (!text.isTextual()) {
        throw fault("\"" + key + "\" is a list of words in quotes");
      }
      texts.add(text.asText());
    }
    return texts;
  }

  private JsonNode array(JsonNode json, String key) throws IOException {
    JsonNode array = json.path(key);
    if (!array.isMissingNode() && !array.isArray()) {
      throw fault("\"" + key + "\" is a list [...]");
    }
    return array;
  }

  private void known(JsonNode json, List<String> keys, String what) throws IOException {
    for (Iterator<String> names = json.fieldNames(); names.hasNext(); ) {
      String name = names.next();
      if (!keys.contains(name)) {
        throw fault(
            "\""
                + name
                + "\" means nothing in "
                + what
                + Spelling.nearest(name, keys)
                    .map(near -> "; did you mean " + near + "?")
                    .orElse(""));
      }
    }
  }

  private IOException fault(String sentence) {
    return new IOException(file + ": " + sentence);
  }
}
