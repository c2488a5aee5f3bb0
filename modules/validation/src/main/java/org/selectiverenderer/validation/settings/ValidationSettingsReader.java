package org.selectiverenderer.validation.settings;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.JsonSettingsReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CostKind;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessKeys;

/**
 * Reads the settings that a project keeps beside its scenes:
 *
 * <pre>
 * {"ignore": ["SR2"],
 *  "severities": {"SR305": "error"},
 *  "budgets": [{"file": "a.x3d", "scope": "Office", "schemas": ["Desk"], "polygons": 170000,
 *               "textureBytes": 64000000, "drawCalls": 500}],
 *  "megabytes": 50,
 *  "allow": ["../models"],
 *  "allowNet": ["example.org"]}
 * </pre>
 *
 * <p>Each key may be left out, and so may a budget's {@code file} (every scene), {@code scope} (the
 * whole scene), {@code schemas} (the worst state) and all limits but one. The file is read as
 * {@link org.selectiverenderer.formats.json} describes: an unknown key is an error, since a
 * misspelling would otherwise go unnoticed.
 */
public final class ValidationSettingsReader {
  private static final JsonSettingsReader JSON =
      new JsonSettingsReader("a settings file", "the settings are not used");

  private static final String SEVERITIES =
      "a severity must be \"error\", \"warning\" or \"info\"; to leave a rule out, "
          + "put it into \"ignore\"";

  private final Path file;
  private final RuleCatalogue rules;

  /**
   * @param rules the rules that the file may name
   */
  public ValidationSettingsReader(Path file, RuleCatalogue rules) {
    this.file = file;
    this.rules = rules;
  }

  /**
   * Reads the file.
   *
   * @return empty when the file has faults, which are reported to {@code problems}
   * @throws IOException if it cannot be read at all
   */
  public Optional<ValidationSettings> read(ProblemCollector problems) throws IOException {
    return JSON.read(file, problems, this::settings);
  }

  private ValidationSettings settings(JsonObjectReader settings) {
    Set<String> ignored = new HashSet<>();
    for (LocatedJsonValue id : settings.list("ignore", false)) {
      rules
          .resolve(id.toString())
          .ifPresentOrElse(ignored::add, () -> settings.fault(id, noRule(id.toString())));
    }
    return new ValidationSettings(
        ignored,
        settings.object("severities", "\"severities\"", this::severities).orElse(Map.of()),
        settings.objects("budgets", "a budget", ValidationSettingsReader::budget),
        settings.number("megabytes", 0, Double.POSITIVE_INFINITY, ValidationSettings.MEGABYTES),
        ContentAccessKeys.of(settings, file),
        file);
  }

  private Map<String, Severity> severities(JsonObjectReader wanted) {
    Map<String, Severity> severities = new HashMap<>();
    for (String id : wanted.names()) {
      Optional<String> rule = rules.resolve(id);
      Optional<Severity> severity =
          wanted.text(id, false).flatMap(ValidationSettingsReader::severity);
      if (rule.isEmpty()) {
        wanted.fault(id, noRule(id));
      } else if (severity.isEmpty()) {
        wanted.fault(id, SEVERITIES);
      } else {
        severities.put(rule.get(), severity.get());
      }
    }
    return severities;
  }

  private static Optional<Severity> severity(String word) {
    return Optional.ofNullable(
        switch (word) {
          case "error" -> Severity.ERROR;
          case "warning" -> Severity.WARNING;
          case "info" -> Severity.INFO;
          default -> null;
        });
  }

  private static CostBudget budget(JsonObjectReader budget) {
    return new CostBudget(
        budget.text("file", false).map(name -> file(budget, name)).orElse(""),
        budget.text("scope", false).orElse(""),
        budget.texts("schemas"),
        limits(budget));
  }

  private static Map<CostKind, Long> limits(JsonObjectReader budget) {
    Map<CostKind, Long> limits = new EnumMap<>(CostKind.class);
    for (CostKind kind : CostKind.values()) {
      double none = -1;
      long limit = budget.whole(kind.key(), 0, Double.POSITIVE_INFINITY, none);
      if (limit != none) {
        limits.put(kind, limit);
      }
    }
    if (limits.isEmpty()) {
      budget.fault("a budget needs \"polygons\", \"textureBytes\" or \"drawCalls\"");
    }
    return limits;
  }

  private static String file(JsonObjectReader budget, String name) {
    try {
      Path.of(name);
      return name;
    } catch (InvalidPathException e) {
      budget.fault("file", "this cannot be the name of a file");
      return "";
    }
  }

  private static String noRule(String id) {
    return "there is no rule '" + id + "'";
  }
}
